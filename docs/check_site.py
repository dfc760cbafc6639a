#!/usr/bin/env python3
"""Reads every page of the finished site and fails on what a reader would stumble over: a broken
link, a missing picture or anchor, a request to another host, markup that was not translated.

usage: python3 docs/check_site.py SITE   (the last line counts pages: N passed, N failed)
"""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Attributes that make a browser load something, by element; <a href> only leads somewhere.
LOADS = {("img", "src"), ("img", "srcset"), ("script", "src"), ("link", "href"), ("source", "src"),
         ("source", "srcset"), ("video", "src"), ("video", "poster"), ("audio", "src"),
         ("iframe", "src"), ("embed", "src"), ("object", "data"), ("image", "href"),
         ("use", "href"), ("input", "src")}
LEFTOVERS = [
    (r"[\ue000-\uf8ff]", "a mark of the translation"),
    (r"\\f[\[$]|\\(?:html|end)only|\\ref\b", "a Doxygen command"),
    (r"\$\$|\$(?=[^\s$][^$\n]*[\\^_{][^$\n]*\$)", "a formula that was not set"),
    (r"\*\*\S|\S\*\*", "bold that was not set"),
    (r"\]\([\w./#-]+\)", "a link that was not made"),
    (r"\[!(?:NOTE|TIP|IMPORTANT|WARNING|CAUTION)\]", "a box that was not made"),
    (r"```", "a code fence"),
    (r"^\|.*\|$", "a table that was not made"),
]
HEADINGS = {"h1", "h2", "h3", "h4", "h5", "h6"}
VOID = {"area", "base", "br", "col", "embed", "hr", "img", "input", "link", "meta", "source",
        "track", "wbr"}


class Page(HTMLParser):
    """What one page has, leads to and loads."""

    def __init__(self, text):
        super().__init__(convert_charrefs=True)
        self.ids, self.links, self.loads, self.problems = [], [], [], []
        self.open, self.text, self.headings = [], [], []
        self.title, self.language = "", ""
        self.in_code = self.in_anchor = 0
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag not in VOID:
            self.open.append(tag)
        if tag in ("pre", "code", "script", "style", "annotation"):
            self.in_code += 1
        if tag == "html":
            self.language = values.get("lang", "")
        if "id" in values:
            self.ids.append(values["id"])
        if tag == "a" and "href" in values:
            if self.in_anchor:
                self.problems.append(f"a link inside a link ({values['href']})")
            self.in_anchor += 1
            self.links.append(values["href"])
        for name, value in attributes:
            if (tag, name) in LOADS and value is not None:
                self.loads.append(value)
            if name == "style" and "url(" in (value or ""):
                self.loads += re.findall(r"url\(['\"]?([^)'\"]+)", value)
        if tag == "img" and not (values.get("alt") or "data-alt" in values):
            self.problems.append(f"picture without alt text ({values.get('src')})")
        if tag == "svg" and values.get("role") == "img" and not values.get("aria-label"):
            self.problems.append("drawing without a label")
        if tag in HEADINGS:
            self.headings.append(int(tag[1]))

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        if tag in VOID:
            return
        if tag in ("pre", "code", "script", "style", "annotation"):
            self.in_code -= 1
        if tag == "a":
            self.in_anchor = max(0, self.in_anchor - 1)
        if not self.open or self.open[-1] != tag:
            opened = self.open[-1] if self.open else "nothing"
            self.problems.append(f"line {self.getpos()[0]}: </{tag}> closes <{opened}>")
            if tag in self.open:
                while self.open.pop() != tag:
                    pass
            return
        self.open.pop()

    def handle_data(self, data):
        if self.open and self.open[-1] == "title":
            self.title += data
        if not self.in_code and "math" not in self.open:
            self.text.append(data)


def own_problems(page):
    """What is wrong with a page by itself."""
    yield from page.problems
    if page.open:
        yield f"<{page.open[-1]}> is never closed"
    for name in sorted({i for i in page.ids if page.ids.count(i) > 1}):
        yield f"id '{name}' occurs {page.ids.count(name)} times"
    if page.headings.count(1) != 1:
        yield f"{page.headings.count(1)} headings of the first level"
    for before, after in zip(page.headings, page.headings[1:]):
        if after > before + 1:
            yield f"a heading of level {after} follows one of level {before}"
    if not page.title.strip() or not page.language:
        yield "no title or no language"
    text = "".join(page.text)
    for pattern, name in LEFTOVERS:
        found = re.search(pattern, text, flags=re.M)
        if found:
            around = " ".join(text[max(0, found.start() - 30):found.end() + 30].split())
            yield f"{name}: ...{around}..."


def target_problem(site, pages, source, target, loads):
    """What is wrong with where a link leads, or None."""
    parts = urlsplit(target)
    if parts.scheme == "data":
        return None
    if parts.scheme or parts.netloc:
        if loads:
            return f"loads {target} from another host"
        return None if parts.scheme in ("https", "http", "mailto") else f"odd link {target}"
    path = site / source if not parts.path else (site / source).parent / unquote(parts.path)
    if not path.resolve().is_relative_to(site.resolve()) or not path.is_file():
        return f"leads to {target}, which is not there"
    if parts.fragment:
        page = pages.get(path.resolve().relative_to(site.resolve()).as_posix())
        if page is not None and unquote(parts.fragment) not in page.ids:
            return f"leads to {target}, which has no such anchor"
    return None


def style_problems(site):
    """Style sheets load nothing from elsewhere and nothing that is not there; scripts neither."""
    for path in sorted(site.rglob("*.css")):
        text = re.sub(r"/\*.*?\*/", "", path.read_text(encoding="utf-8"), flags=re.S)
        for target in re.findall(r"url\(['\"]?([^)'\"]+)|@import ['\"]([^'\"]+)", text):
            target = target[0] or target[1]
            if re.match(r"(https?:)?//", target):
                yield path, f"loads {target} from another host"
            elif not target.startswith("data:") and not (path.parent / target.split("#")[0]).is_file():
                yield path, f"loads {target}, which is not there"
    for path in sorted(site.rglob("*.js")):
        if path.name == "search-data.js":
            continue
        text = path.read_text(encoding="utf-8")
        for target in re.findall(r"(?:src|href|fetch|import|open)\s*(?:=|\()\s*['\"`](?:https?:)?//[^'\"`]+",
                                 text):
            yield path, f"loads {target} from another host"


def check(site):
    """Problems by file: {name: [problem]}; every page has an entry."""
    pages = {p.relative_to(site).as_posix(): Page(p.read_text(encoding="utf-8"))
             for p in sorted(site.rglob("*.html"))}
    found = {name: list(own_problems(page)) for name, page in pages.items()}
    titles = {}
    for name, page in pages.items():
        for loads, targets in ((False, page.links), (True, page.loads)):
            for target in dict.fromkeys(targets):
                problem = target_problem(site, pages, name, target, loads)
                if problem:
                    found[name].append(problem)
        if page.title in titles:
            found[name].append(f"has the same title as {titles[page.title]}")
        titles[page.title] = name
    for path, problem in style_problems(site):
        found.setdefault(path.relative_to(site).as_posix(), []).append(problem)
    return found


def main(arguments):
    if len(arguments) != 1 or not Path(arguments[0]).is_dir():
        print("usage: check_site.py SITE   (the folder of a built site)", file=sys.stderr)
        return 2
    found = check(Path(arguments[0]))
    failed = {name: problems for name, problems in found.items() if problems}
    for name, problems in failed.items():
        for problem in problems:
            print(f"site: {name}: {problem}", file=sys.stderr)
    if not found:
        print(f"site: no pages in {arguments[0]}", file=sys.stderr)
    print(f"{len(found) - len(failed)} passed, {len(failed)} failed")
    return 1 if failed or not found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
