#!/usr/bin/env python3
"""Doxygen input filter for headers: comments are plain text, so <desc> in one is no HTML."""
import re
import sys


def plain_comments(text):
    return re.sub(r"(?<=///)(<?)([^\n]*)", lambda m: m[1] + m[2].replace("<", "&lt;"), text)


if __name__ == "__main__":
    for name in sys.argv[1:]:
        with open(name, encoding="utf-8") as file:
            sys.stdout.write(plain_comments(file.read()))
