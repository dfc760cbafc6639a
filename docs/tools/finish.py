#!/usr/bin/env python3
"""Puts the site's pages together from what Doxygen laid out.

usage: finish.py WORK OUT
"""
import html
import json
import re
import shutil
import sys
from pathlib import Path
from string import Template

import course
from course import ROOT, SiteError
from markdown import MARK, unshield
from reference import Reference, region_lines, split_lines, with_links

DOCS = ROOT / "docs"
MODULES = DOCS / "node_modules"

FONTS = [("source-serif-4", "Source Serif 4 Variable", "opsz"), ("inter", "Inter Variable", "wght"),
         ("source-code-pro", "Source Code Pro Variable", "wght")]
RANGES = {  # as the packages' own style sheets have them
    "latin": "U+0000-00FF,U+0131,U+0152-0153,U+02BB-02BC,U+02C6,U+02DA,U+02DC,U+0304,U+0308,"
             "U+0329,U+2000-206F,U+20AC,U+2122,U+2191,U+2193,U+2212,U+2215,U+FEFF,U+FFFD",
    "greek": "U+0370-0377,U+037A-037F,U+0384-038A,U+038C,U+038E-03A1,U+03A3-03FF",
}


def plain_text(fragment):
    """Text of HTML, without formulas' drawings."""
    text = re.sub(r"<(svg|style)\b.*?</\1>|<a class=\"anchor\".*?</a>", "", fragment, flags=re.S)
    text = re.sub(r"</(p|li|h\d|tr|td|th|dt|dd|div|figcaption|summary)>", " ", text)
    text = html.unescape(re.sub(r"<[^>]+>", "", text))
    return re.sub(r"\s+", " ", text).strip()


class Fragments:
    """Fragments as finished HTML."""

    def __init__(self, work, reference):
        self.items = json.loads((work / "fragments.json").read_text(encoding="utf-8"))
        set_by_node = json.loads((work / "typeset.json").read_text(encoding="utf-8"))
        self.formulas, self.code = set_by_node["formulas"], set_by_node["code"]
        self.glyphs = set_by_node["glyphs"]
        self.reference = reference

    def render(self, index, page):
        item = self.items[index]
        render = {"html": self.html, "math": self.math, "code": self.code_block,
                  "code_span": self.code_span}[item["kind"]]
        return render(index, item, page)

    @staticmethod
    def html(_index, item, _page):
        return item["html"]

    def math(self, index, item, _page):
        formula = self.formulas[str(index)]
        svg = formula["svg"].replace("<svg", '<svg class="mj"', 1)
        body = f'{svg}<span class="mml">{formula["mathml"]}</span>'
        if not item["display"]:
            return f'<span class="math">{body}</span>'
        number = formula["number"]
        if not number:
            return f'<div class="math-block"><div class="math-body">{body}</div></div>'
        anchor = "eq-" + re.sub(r"[^\w.-]", "", number)
        return (f'<div class="math-block" id="{anchor}"><div class="math-body">{body}</div>'
                f'<a class="math-number" href="#{anchor}">({html.escape(number)})</a></div>')

    def lines(self, index, item):
        """Coloured lines of a code block, with links to the reference."""
        lines = split_lines(self.code[str(index)])
        file = item["file"]
        if not file:
            return lines
        if "numbers" in item:
            numbers, indents = item["numbers"], item["indents"]
        elif item.get("tag"):
            numbers, indent = region_lines(course.read(file), item["tag"])
            indents = [indent] * len(numbers)
        else:
            numbers, indents = list(range(1, len(lines) + 1)), [0] * len(lines)
        if len(numbers) != len(lines):
            return lines
        known = self.reference.links_of(file)
        out = []
        for number, line, indent in zip(numbers, lines, indents):
            links = [(s - indent, e - indent, a) for s, e, a in known.get(number, [])]
            out.append(with_links(line, links) if known else self.linked_by_name(line, file))
        return out

    def linked_by_name(self, line, file):
        if not re.match(r"(chapters|common)/", file):
            return line
        text = html.unescape(re.sub(r"<[^>]+>", "", line))
        code = text.split("//")[0]
        links = []
        for match in re.finditer(r'"[^"]*"|(?<![\w.>:])(?:lt::)?([A-Za-z_]\w*)', code):
            address = match[1] and self.reference.symbol(match[1])
            is_call = code[match.end():match.end() + 1] in ("(", "{", " ", ">", "&")
            if address and is_call:
                links.append((match.start(1), match.end(1), address))
        return with_links(line, links)

    def code_block(self, index, item, _page):
        lines = self.lines(index, item)
        if item.get("numbered"):
            body = "\n".join(f'<span class="line" id="L{n}">{line}</span>'
                             for n, line in enumerate(lines, 1))
            return f'<div class="code numbered"><pre><code>{body}</code></pre></div>'
        lang = item["lang"]
        caption = ""
        if item.get("tag"):
            numbers, _ = region_lines(course.read(item["file"]), item["tag"])
            line = f"#L{numbers[0]}" if numbers else ""
            page = course.source_page(item["file"])
            name = item["file"].removeprefix("chapters/")
            caption = f'<div class="code-file"><a href="{page}.html{line}">{name}</a></div>'
        elif item["note"]:
            caption = f'<div class="code-file refused">not compiled: {html.escape(item["note"])}</div>'
        shell = " shell" if lang in ("sh", "bash", "console", "shell") else ""
        body = "\n".join(lines)
        return f'<div class="code{shell}">{caption}<pre><code>{body}</code></pre></div>'

    def code_span(self, _index, item, page):
        text = item["text"]
        code = f"<code>{html.escape(text, quote=False)}</code>"
        if not item["linked"] or page["kind"] not in ("chapter", "reference"):
            return code
        address = None
        name = re.fullmatch(r"(?:lt::)?([A-Za-z_]\w{2,})(\(\))?", text)
        if re.fullmatch(r"[\w/]+\.hpp", text):
            for path in (f"chapters/{page['chapter']}/{text}", f"chapters/{text}", text):
                if path in course.headers():
                    address = course.header_page(path) + ".html"
                    break
        elif name and (name[2] or name[1][0].isupper() or "_" in name[1]):
            address = self.reference.symbol(name[1], near=f"chapters/{page['chapter']}/")
        return f'<a class="symbol" href="{address}">{code}</a>' if address else code

    def fill(self, text, page):
        """Text with every mark replaced, also those inside replacements."""
        text = re.sub(rf"<p ?>({MARK.pattern})\s*</p>", r"\1", text)
        while MARK.search(text):
            text = MARK.sub(lambda m: self.render(int(m[1]), page), text)
        return unshield(text)

    def glyph_defs(self, text):
        """Shapes of the letters that the formulas of a page use."""
        used = sorted(set(re.findall(r'href="#(MJX-[^"]+)"', text)))
        if not used:
            return ""
        paths = "".join(f'<path id="{g}" d="{self.glyphs[g]}"/>' for g in used)
        return f'<svg class="glyphs" aria-hidden="true"><defs>{paths}</defs></svg>'


class Site:
    def __init__(self, work, out):
        self.work, self.out = work, out
        data = json.loads((work / "site.json").read_text(encoding="utf-8"))
        self.pages = {p["name"]: p for p in data["pages"]}
        self.assets = data["assets"]
        self.reference = Reference(work / "doxygen/xml")
        self.fragments = Fragments(work, self.reference)
        for page in self.pages.values():
            page["title"] = self.fragments.fill(page["title"], page)
            page["headings"] = [(level, anchor, self.fragments.fill(text, page))
                                for level, anchor, text in page["headings"]]
        self.template = Template((DOCS / "theme/page.html").read_text(encoding="utf-8"))
        self.search = []
    # -- reading Doxygen's pages ----------------------------------------------------------------

    def doxygen_body(self, file):
        path = self.work / "doxygen/html" / file
        if not path.exists():
            raise SiteError(f"Doxygen made no page {file}")
        text = path.read_text(encoding="utf-8")
        match = re.search(r'<div class="contents">(.*)</div><!-- contents -->', text, re.S)
        if not match:
            raise SiteError(f"Doxygen's page {file} has no contents")
        return match[1]

    def written_body(self, page):
        text = self.doxygen_body(f"{page['name']}.html")
        text = text.partition('<div class="textblock">')[2]
        text = re.sub(r"(?:\s*</div>\s*(?:<!-- PageDoc -->)?)+$", "", text)
        text = re.sub(r'<a class="anchor" id="[^"]*"></a>', "", text)
        text = re.sub(r'<a class="anchor" id="md_[^"]*"></a>', "", text)
        text = text.replace('<p >', "<p>")
        text = self.fragments.fill(text, page)
        return self.tables(text)

    @staticmethod
    def tables(text):
        """Doxygen's tables with a head, and a frame that can scroll."""
        def table(match):
            rows = re.findall(r"<tr[^>]*>(.*?)</tr>", match[1], re.S)
            align = {"Right": "right", "Center": "center"}
            out = []
            for row in rows:
                cells = re.findall(r'<(t[hd]) class="markdownTable(?:Head|Body)(\w+)">(.*?)</t[hd]>',
                                   row, re.S)
                out.append("<tr>" + "".join(
                    f'<{tag}{" scope=col" if tag == "th" else ""}'
                    f'{f" class={align[a]}" if a in align else ""}>{content.strip()}</{tag}>'
                    for tag, a, content in cells) + "</tr>")
            head, body = out[0], "".join(out[1:])
            shows = r"<img|class=\"drawing\""
            kind = " pictures" if re.search(shows, match[1]) else ""
            if not kind and rows[0].count("</t") > 4:
                kind = " wide"
            if re.search(shows, head):  # a row of pictures, labels below
                body, head = head.replace("<th scope=col", "<td").replace("</th>", "</td>") + body, ""
            elif not plain_text(head):
                head = ""
            else:
                head = f"<thead>{head}</thead>"
            return f'<div class="table{kind}"><table>{head}<tbody>{body}</tbody></table></div>'
        return re.sub(r'<table class="markdownTable">(.*?)</table>', table, text, flags=re.S)

    def api_body(self, page):
        header, folder = page["source"], page["chapter"]
        where = "Plumbing"
        if folder in self.pages:
            where = f'<a href="{folder}.html">Chapter {self.pages[folder]["title"]}</a>'
        elif folder != "common":
            where = f"Chapter {course.planned_title(folder)}"
        lead = (f'<p class="meta">{where} \u2013 <a href="{course.source_page(header)}.html">'
                f"source</a></p><p>{page['brief']}</p>")
        return f'<div class="api">{lead}{page["body"]}</div>'

    # -- around the text ------------------------------------------------------------------------

    def sidebar(self, page):
        def item(name, label=None, children=""):
            here = ' aria-current="page"' if name == page["name"] else ""
            title = label or self.pages[name]["title"]
            return f'<li><a href="{name}.html"{here}>{title}</a>{children}</li>'

        def sections(name):
            if name != page["name"]:
                return ""
            entries = "".join(f'<li><a href="#{i}">{t}</a></li>'
                              for level, i, t in page["headings"] if level == 2)
            return f"<ol>{entries}</ol>" if entries else ""

        out = [f'<ul class="nav-top">{item("index", "Start")}</ul>']
        for part, name, members in course.PARTS:
            written = [m for m in members if m in self.pages]
            if written:
                entries = "".join(item(m, children=sections(m)) for m in written)
                out.append(f'<p class="nav-part">{part} <span>{html.escape(name)}</span></p>'
                           f"<ul>{entries}</ul>")
        inner = ""
        if page["kind"] == "exercise" or page["name"] == "exercises":
            inner = "<ol>" + "".join(
                item(n) for n in self.pages if self.pages[n]["kind"] == "exercise") + "</ol>"
        out.append('<p class="nav-part">Practice</p><ul>' + item("exercises", children=inner) + "</ul>")
        inner = ""
        if page["kind"] in ("api", "source") or page["name"] == "api":
            folder = page["chapter"] if page["kind"] == "api" else None
            inner = "".join(item(n, self.pages[n]["title"].split("/")[-1]) for n in self.pages
                            if self.pages[n]["kind"] == "api" and folder
                            and self.pages[n]["chapter"] == folder)
            inner = f"<ol>{inner}</ol>" if inner else ""
        rest = [item(n, children=sections(n)) for n in ("gallery", "notation", "errata",
                                                        "bibliography")]
        rest.append(item("api", children=inner))
        rest += [item(n) for n in ("about", "contributing", "changelog") if n in self.pages]
        out.append(f'<p class="nav-part">Reference</p><ul>{"".join(rest)}</ul>')
        return "\n".join(out)

    def previous_next(self, page):
        kinds = {"start": ("start", "chapter"), "chapter": ("start", "chapter"),
                 "exercise": ("exercise",)}
        if page["kind"] not in kinds:
            return ""
        row = [p for p in self.pages.values() if p["kind"] in kinds[page["kind"]]]
        if page["kind"] == "chapter" or page["kind"] == "start":
            row.append(self.pages["exercises"])
        else:
            row.insert(0, self.pages["exercises"])
        i = next(i for i, p in enumerate(row) if p["name"] == page["name"])

        def card(side, label, other):
            title = "Start" if other["kind"] == "start" else other["title"]
            return (f'<a class="{side}" rel="{side}" href="{other["name"]}.html"><small>{label}</small>'
                    f"{title}</a>")
        before = card("prev", "Previous", row[i - 1]) if i else "<span></span>"
        after = card("next", "Next", row[i + 1]) if i + 1 < len(row) else "<span></span>"
        return f'<nav class="prevnext" aria-label="Previous and next page">{before}{after}</nav>'

    def description(self, body):
        first = re.search(r"<p>(?!<)(.{40,}?)</p>", body, re.S)
        text = plain_text(first[1]) if first else "A step-by-step course in C++20."
        return html.escape(text[:200])

    def index_page(self, page, body):
        """Sections of a page, for the search."""
        if page["kind"] == "source":
            return
        title = plain_text(page["title"])
        if page["kind"] == "api":
            self.search.append([f"{page['name']}.html", title, title, ""])
            for match in re.finditer(r'<h[23] id="([^"]+)">(.*?)</h[23]>(.*?)(?=<h[23] id="|\Z)',
                                     body, re.S):
                text = re.sub(r'<div class="code">.*?</div>', "", match[3], flags=re.S)
                self.search.append([f"{page['name']}.html#{match[1]}", title,
                                    plain_text(match[2]), plain_text(text)[:300]])
            return
        parts = re.split(r'<h[23] id="([^"]+)">(.*?)</h[23]>', body, flags=re.S)
        self.search.append([f"{page['name']}.html", title, title, plain_text(parts[0])])
        for anchor, heading, text in zip(parts[1::3], parts[2::3], parts[3::3]):
            self.search.append([f"{page['name']}.html#{anchor}", title, plain_text(heading),
                                plain_text(text)])

    def write_page(self, page):
        api = page["kind"] == "api"
        body = self.fragments.fill(self.api_body(page), page) if api else self.written_body(page)
        page_title = page["title"]
        if page["kind"] in ("api", "source"):
            page_title = re.sub(r"([/_])", r"\1<wbr>", page_title)
        body = self.hinted(body)
        self.index_page(page, body)
        name = plain_text(page["title"])
        if page["kind"] == "source":
            name = f"{name} (source)"
        start = page["kind"] == "start"
        values = {
            "title": "Tracing Light" if start else f"{html.escape(name)} \u2013 Tracing Light",
            "description": self.description(body),
            "heading": self.chapter_heading(page, page_title),
            "kind": page["kind"],
            "slider": ('<link rel="stylesheet" href="style/slider.css">'
                       '<script src="script/slider.js" defer></script>')
                      if "<img-comparison-slider" in body else "",
            "sidebar": self.sidebar(page),
            "body": body,
            "prevnext": self.previous_next(page),
        }
        text = self.template.substitute(values)
        text = text.replace("<!-- glyphs -->", self.fragments.glyph_defs(text))
        (self.out / f"{page['name']}.html").write_text(text, encoding="utf-8")

    @staticmethod
    def chapter_heading(page, title):
        number = re.match(r"(\d+)\. ", title)
        if page["kind"] == "source":
            return f'<span class="chapter-number">Source</span> {title}'
        if page["kind"] != "chapter" or not number:
            return title
        return f'<span class="chapter-number">Chapter {number[1]}</span> {title[number.end():]}'

    @staticmethod
    def hinted(body):
        """The first picture of a page is wanted at once."""
        return body.replace(' loading="lazy"', "", 2)

    # -- files beside the pages -----------------------------------------------------------------

    def copy_files(self):
        for folder in ("style", "script", "font", "licences"):
            (self.out / folder).mkdir(parents=True)
        for name, (_, text) in course.LICENCES.items():
            shutil.copyfile(MODULES / text, self.out / "licences" / f"{name}.txt")
        for path, target in self.assets.items():
            if not path.endswith(".svg"):
                (self.out / target).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(ROOT / path, self.out / target)
        css = "".join(self.font_faces()) + (DOCS / "theme/book.css").read_text(encoding="utf-8")
        (self.out / "style/book.css").write_text(css, encoding="utf-8")
        shutil.copyfile(MODULES / "img-comparison-slider/dist/styles.css", self.out / "style/slider.css")
        slider = (MODULES / "img-comparison-slider/dist/index.js").read_text(encoding="utf-8")
        (self.out / "script/slider.js").write_text(
            re.sub(r"//# sourceMappingURL=.*", "", slider), encoding="utf-8")
        search = (MODULES / "minisearch/dist/umd/index.js").read_text(encoding="utf-8")
        (self.out / "script/minisearch.js").write_text(
            re.sub(r"//# sourceMappingURL=.*", "", search), encoding="utf-8")
        for script in ("theme.js", "book.js", "search.js"):
            shutil.copyfile(DOCS / "theme" / script, self.out / "script" / script)
        shutil.copyfile(DOCS / "theme/icon.svg", self.out / "icon.svg")

    def font_faces(self):
        for package, family, axis in FONTS:
            for style in ("normal", "italic"):
                for subset, characters in RANGES.items():
                    name = f"{package}-{subset}-{axis}-{style}.woff2"
                    shutil.copyfile(MODULES / "@fontsource-variable" / package / "files" / name,
                                    self.out / "font" / name)
                    yield (f"@font-face{{font-family:'{family}';font-style:{style};"
                           f"font-weight:200 900;font-display:swap;"
                           f"src:url(../font/{name}) format('woff2');unicode-range:{characters}}}\n")

    def build(self):
        self.out.mkdir(parents=True)
        self.copy_files()
        for page in self.pages.values():
            self.write_page(page)
        data = json.dumps(self.search, ensure_ascii=False, separators=(",", ":"))
        (self.out / "script/search-data.js").write_text(f"window.searchData={data};\n",
                                                        encoding="utf-8")


if __name__ == "__main__":
    try:
        Site(Path(sys.argv[1]), Path(sys.argv[2])).build()
    except SiteError as error:
        sys.exit(f"site: {error}")
