#!/usr/bin/env python3
"""Adds the pages of the headers, from what Doxygen read, to the pages that prepare.py wrote.

usage: describe.py WORK   (reads WORK/doxygen/xml, adds to WORK/fragments.json and WORK/site.json)
"""
import html
import json
import sys
from pathlib import Path

import course
from course import SiteError
from markdown import Fragments
from reference import HeaderPage, Reference


def main(work):
    fragments = Fragments()
    fragments.items = json.loads((work / "fragments.json").read_text(encoding="utf-8"))
    site = json.loads((work / "site.json").read_text(encoding="utf-8"))
    reference = Reference(work / "doxygen/xml")

    def code(**values):
        return fragments.add("code", lang="cpp", note="", **values)

    for header in course.headers():
        title = html.escape(header.removeprefix("chapters/"))
        include = fragments.add("code", lang="cpp", note="", file="", text=f'#include "{title}"')
        site["pages"].append({
            "name": course.header_page(header), "kind": "api", "source": header, "title": title,
            "headings": [], "chapter": title.split("/")[0],
            "brief": html.escape(course.header_brief(header)),
            "body": include + HeaderPage(reference, header, code).body()})
    (work / "site.json").write_text(json.dumps(site), encoding="utf-8")
    (work / "fragments.json").write_text(json.dumps(fragments.items), encoding="utf-8")


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]))
    except SiteError as error:
        sys.exit(f"site: {error}")
