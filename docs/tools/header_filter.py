#!/usr/bin/env python3
"""Doxygen input filter for headers: makes each header one page of the reference.

Whatever stands in the header's namespaces goes into a Doxygen group named after the header, so
that its functions and structs are on one page, as they are in the file. Line numbers do not change.
"""
import re
import sys


def group_name(path):
    """chapters/ch02_ray_casting/sphere.hpp -> ch02_ray_casting_sphere"""
    return re.sub(r"\W+", "_", path.removeprefix("chapters/").removesuffix(".hpp"))


def file_brief(text):
    """What the `/// @file` block at the top says."""
    block = re.match(r"/// @file\n((?:///.*\n)*)", text)
    if not block:
        return ""
    lines = [line.removeprefix("///").strip() for line in block[1].splitlines()]
    return " ".join(lines).strip()


def grouped(path, text):
    group = group_name(path)
    define = f"/** @defgroup {group} {path.removeprefix('chapters/')} */ "
    open_group = f" /** @addtogroup {group} */ /** @{{ */"
    # Comments are plain text: <desc> in one is no HTML.
    text = re.sub(r"(?<=///)<?[^\n]*", lambda m: m[0][0:1] + m[0][1:].replace("<", "&lt;"), text)
    text = re.sub(r"^(namespace [\w:]+ \{)$", rf"\1{open_group}", text, flags=re.M)
    text = re.sub(r"^(\}  // namespace)", r"/** @} */ \1", text, flags=re.M)
    return define + text


def main(paths):
    for path in paths:
        name = re.sub(r"^.*?(chapters|common)/", r"\1/", path)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        if not file_brief(text):
            sys.exit(f"{name}: no '/// @file' block at the top that says what the header is for")
        sys.stdout.write(grouped(name, text))


if __name__ == "__main__":
    main(sys.argv[1:])
