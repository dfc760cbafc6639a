"""GitHub Markdown to Doxygen Markdown.

Doxygen is given paragraphs, lists, tables and quotes to lay out. Everything that it would read
differently from GitHub (code, formulas, links, emphasis, HTML, special characters) is taken out
first: a mark of two private Unicode characters stays in its place, and finish.py puts the finished
HTML there. So nothing that Doxygen does to running text can hurt a formula or a piece of code.
"""
import html
import posixpath
import re
import struct

import course
from course import ROOT, SiteError
from svg import inline_svg

OPEN, CLOSE = "\ue000", "\ue001"            # OPEN number CLOSE: a fragment
SHIELD = 0xE100                             # chr(SHIELD + ord(c)): the character c, not markup
MARK = re.compile(f"{OPEN}(\\d+){CLOSE}")
EXACT = "\ue002"                            # before pictures shown pixel by pixel
SHIELDED = re.compile("[\ue100-\ue17f]")

INLINE_TAGS = {"br", "code", "kbd", "sub", "sup", "i", "b", "em", "strong", "small", "span", "a"}


def unshield(text):
    """HTML of shielded characters."""
    return SHIELDED.sub(lambda m: html.escape(chr(ord(m[0]) - SHIELD)), text)


def slug(text):
    """GitHub's anchor of a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"[^\w\- ]", "", text.lower())
    return text.strip().replace(" ", "-")


def png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    if head[:8] != b"\x89PNG\r\n\x1a\n":
        raise SiteError(f"{path}: not a PNG file")
    return struct.unpack(">II", head[16:24])


class Fragments:
    """Finished pieces that wait for finish.py."""

    def __init__(self):
        self.items = []

    def add(self, kind, **values):
        self.items.append({"kind": kind, **values})
        return f"{OPEN}{len(self.items) - 1}{CLOSE}"

    def html(self, text):
        return self.add("html", html=text)


class Links:
    """Where a path of the repository is on the site."""

    def __init__(self, pages):
        self.pages = {p.source: p.name for p in pages}
        self.pages.update(course.ALIASES)
        self.headers = {h: course.header_page(h) for h in course.headers()}
        self.sources = {}   # path -> page, of the files that some page links to
        self.assets = {}    # path -> path on the site, of the pictures that some page shows

    def page_of(self, path):
        """The page of a file of the repository; its source is shown where it has none."""
        full = ROOT / path
        if path not in self.pages and full.is_dir():
            path = f"{path}/README.md".removeprefix("./")
            full = ROOT / path
        if path in self.pages:
            return self.pages[path] + ".html"
        if path in self.headers:
            return self.headers[path] + ".html"
        if full.is_file():
            self.sources[path] = course.source_page(path)
            return self.sources[path] + ".html"
        return None

    def asset(self, path):
        if not (ROOT / path).is_file():
            return None
        self.assets[path] = "img/" + path.removeprefix("chapters/").replace("figures/", "")
        return self.assets[path]


class Translator:
    """Translates one file. `directives` are comments that stand for generated parts."""

    def __init__(self, page, fragments, links, directives):
        self.page = page
        self.fragments = fragments
        self.links = links
        self.directives = directives
        self.slugs = {}
        self.figures = 0

    # -- errors and paths ---------------------------------------------------------------------

    def fail(self, what):
        raise SiteError(f"{self.page.source}: {what}")

    def resolve(self, target):
        base = posixpath.dirname(self.page.source)
        return posixpath.normpath(posixpath.join(base, target))

    def href(self, target):
        """The site's address of a link of the text; None for a folder, which has no page."""
        if re.match(r"(https?:|mailto:)", target):
            return target
        path, _, anchor = target.partition("#")
        if not path:
            return "#" + anchor
        address = self.links.page_of(self.resolve(path))
        if address is None and (ROOT / self.resolve(path)).is_dir():
            return None
        if address is None:
            self.fail(f"links to {target}, which does not exist")
        is_line = re.fullmatch(r"L\d+(-L\d+)?", anchor)
        return address + (f"#{anchor}" if anchor and not is_line else "")

    # -- inline -------------------------------------------------------------------------------

    def code_span(self, match):
        text = match[2].replace("\n", " ")
        if text.startswith(" ") and text.endswith(" ") and text.strip():
            text = text[1:-1]
        return self.fragments.add("code_span", text=text.replace("\\|", "|"), linked=True)

    def unlinked(self, text):
        """The same text, its code spans without links of their own."""
        for mark in MARK.findall(text):
            self.fragments.items[int(mark)]["linked"] = False
        return text

    def formula(self, tex, display=False):
        return self.fragments.add("math", tex=tex.strip(), display=display)

    def image(self, alt, target, attributes=""):
        """HTML of a picture."""
        path = self.resolve(target)
        address = self.links.asset(path)
        if address is None:
            self.fail(f"shows {target}, which does not exist")
        if not alt.strip():
            self.fail(f"{target} has no alt text")
        if path.endswith(".svg"):
            self.figures += 1
            return inline_svg(ROOT / path, alt, f"fig{self.figures}")
        width, height = png_size(ROOT / path)
        return (f'<img src="{address}" alt="{html.escape(alt)}" width="{width}" '
                f'height="{height}" style="--w:{width}" loading="lazy"{attributes}>')

    def link(self, match):
        text, target = match[1], match[2]
        outside = ' class="outside"' if re.match(r"https?:", target) else ""
        address = self.href(target)
        if address is None:
            return text
        open_tag = f'<a href="{html.escape(address)}"{outside}>'
        return self.fragments.html(open_tag) + self.unlinked(text) + self.fragments.html("</a>")

    def tag(self, match):
        name = match[2].lower()
        if name not in INLINE_TAGS:
            self.fail(f"HTML tag {match[0]} is not one that the site knows")
        return self.fragments.html(match[0])

    def emphasis(self, name):
        def wrap(match):
            return (self.fragments.html(f"<{name}>") + match[1]
                    + self.fragments.html(f"</{name}>"))
        return wrap

    @staticmethod
    def typography(text):
        """What a typesetter would do to plain ASCII."""
        text = text.replace("...", "\u2026")
        text = re.sub(r"(?<=\d) %", "\u00a0%", text)
        text = re.sub(r"(?<=\d) x (?=\d)", " \u00d7 ", text)
        text = re.sub(r"(?<=[^\s|]) - (?=\S)", "\u00a0\u2013 ", text)
        text = re.sub(r"(?<=[^\s|]) -$", "\u00a0\u2013", text, flags=re.M)
        text = re.sub(r"(?<![\w.\u2026)-])-(?=\d)", "\u2212", text)
        text = re.sub(r'(^|[\s(\[|\u2013])"', "\\1\u201c", text, flags=re.M)
        text = text.replace('"', "\u201d")
        text = re.sub(r"(^|[\s(\[\u201c|])'(?=\w)", "\\1\u2018", text, flags=re.M)
        return text.replace("'", "\u2019")

    def shield(self, text):
        """Hides what Doxygen would take for markup, and nothing that lays out the page."""
        out = []
        for line in text.split("\n"):
            if re.fullmatch(r"\s*\|?[\s:|-]*-[\s:|-]*\|?\s*", line) and "|" in line:
                out.append(line)  # the line under a table's head
                continue
            indent, rest = re.match(r"(\s*(?:> ?)*\s*(?:[-+*] |\d+[.)] )?)(.*)", line, re.S).groups()
            rest = re.sub(r"[<>&@#%~\\_*`\"^]|-(?=-)|(?<=-)-|:(?=:)|(?<=:):",
                          lambda m: chr(SHIELD + ord(m[0])), rest)
            out.append(indent + rest)
        return "\n".join(out)

    def inline(self, text):
        """Text with all that is special in it taken out."""
        text = re.sub(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)", self.code_span, text, flags=re.S)
        text = re.sub(r"(?<![\\$\w])\$(?!\s)((?:[^$\\]|\\.)+?)(?<!\s)\$(?![\w$])",
                      lambda m: self.formula(m[1]), text)
        text = re.sub(r"\\([!-/:-@\[-`{-~])", lambda m: chr(SHIELD + ord(m[1])), text)
        text = re.sub(r"&(?:#\d+|#x[0-9a-f]+|\w+);", lambda m: html.unescape(m[0]), text)
        text = re.sub(r"!\[([^\]]*)\]\(([^)\s]+)\)",
                      lambda m: self.fragments.html(self.image(m[1], m[2])), text)
        text = re.sub(r"<(https?://[^>\s]+)>",
                      lambda m: self.link((m[0], m[1].split("://")[1], m[1])), text)
        text = re.sub(r"\[([^\[\]]+)\]\(([^)\s]+)\)", self.link, text)
        text = re.sub(r"<(/?)([a-zA-Z]+)[^<>]*>", self.tag, text)
        text = re.sub(r"\*\*(?!\s)([^|]+?)(?<!\s)\*\*", self.emphasis("strong"), text, flags=re.S)
        text = re.sub(r"(?<![\w*])\*(?![\s*])([^*|]+?)(?<!\s)\*(?![\w*])", self.emphasis("em"),
                      text, flags=re.S)
        text = re.sub(r"(?<![\w_])_(?![\s_])([^_|]+?)(?<!\s)_(?![\w_])", self.emphasis("em"), text)
        return self.shield(self.typography(text))

    def inline_html(self, text):
        """Inline Markdown as HTML, with marks left in it."""
        return unshield(self.inline(text.strip()))

    # -- blocks -------------------------------------------------------------------------------

    def block(self, text, indent=""):
        """A mark for HTML that stands alone."""
        return f"\n\n{indent}{self.fragments.html(text)}\n\n"

    def fence(self, match):
        indent, comment, info, body = match[1], match[2], match[4].strip(), match[5]
        body = re.sub(rf"^{indent}", "", body, flags=re.M).rstrip("\n")
        if info == "math":
            return f"\n\n{indent}{self.formula(body, display=True)}\n\n"
        code = {"lang": info or "text", "text": body, "file": "", "note": ""}
        snippet = re.match(r"<!--\s*snippet: (\S+) (\S+)\s*-->", comment or "")
        if snippet:
            is_rooted = re.match(r"(common|chapters)/", snippet[1])
            code["file"] = snippet[1] if is_rooted else self.resolve(snippet[1])
            code["tag"] = snippet[2]
            if not (ROOT / code["file"]).is_file():
                self.fail(f"snippet from {snippet[1]}, which does not exist")
            code["page"] = self.links.page_of(code["file"])
        refused = re.match(r"<!--\s*not compiled: (.+?)\s*-->", comment or "")
        if refused:
            code["note"] = refused[1]
        return f"\n\n{indent}{self.fragments.add('code', **code)}\n\n"

    def heading(self, match):
        level, text = len(match[1]), match[2].strip()
        if level == 1:
            self.page.title = self.unlinked(self.inline_html(text))
            return ""
        name = slug(re.sub(r"[`*$]", "", text))
        self.slugs[name] = self.slugs.get(name, -1) + 1
        if self.slugs[name]:
            name += f"-{self.slugs[name]}"
        content = self.unlinked(self.inline_html(text))
        self.page.headings.append((level, name, content))
        return self.block(f'<h{level} id="{name}">{content}'
                          f'<a class="anchor" href="#{name}" aria-label="Link to this section">'
                          f'#</a></h{level}>')

    def alert(self, match):
        kind, body = match[1].lower(), re.sub(r"^> ?", "", match[2], flags=re.M)
        title = {"note": "Note", "tip": "Tip", "important": "Important", "warning": "Mind",
                 "caution": "Careful"}[kind]
        in_print = re.match(r"\s*\*\*In print[.:]?\*\*\s*", body)
        if in_print:
            kind, title, body = "print", "In print", body[in_print.end():]
        return (self.block(f'<aside class="box {kind}" aria-label="{title}">'
                           f'<p class="box-title">{title}</p>') + body + self.block("</aside>"))

    def caption(self, text):
        """HTML of `*words* `command``; the command can be copied."""
        match = re.fullmatch(r"\*(?!\*)(.+?)\*\s*((?:`[^`]+`[\s,]*)*)\.?", text.strip(), re.S)
        if not match:
            return None
        commands = "".join(
            f'<span class="command"><code>{html.escape(c)}</code></span>'
            for c in re.findall(r"`([^`]+)`", match[2]))
        return f"<span>{self.inline_html(match[1])}</span>{commands}"

    def figure(self, match):
        images = re.findall(r"!\[([^\]]*)\]\(([^)\s]+)\)", match[2])
        caption = self.caption(match[3]) if match[3] else None
        if match[3] and caption is None:
            return match[0].removeprefix(EXACT)
        body = "".join(self.image(alt, target) for alt, target in images)
        exact = " exact" if match[1] else ""  # the page's width cuts it and never scales it
        several = " strip" if len(images) > 1 else ""
        drawn = " drawn" if all(t.endswith(".svg") for _, t in images) else ""
        text = f'<figure class="figure{several}{drawn}{exact}">{body}'
        return self.block(text + (f"<figcaption>{caption}</figcaption>" if caption else "")
                          + "</figure>")

    def compare(self, match):
        rows = [[c.strip() for c in r.strip().strip("|").split("|")]
                for r in match[1].strip().splitlines()]
        images = [re.fullmatch(r"!\[([^\]]*)\]\(([^)\s]+)\)", c) for c in rows[2]]
        if len(rows) != 3 or len(images) != 2 or not all(images):
            self.fail("a <!-- compare --> table has a head of two labels and one row of two pictures")
        labels = [self.inline_html(c) for c in rows[0]]
        caption = self.caption(match[2]) if match[2] else None
        first = self.image(*images[0].groups(), ' slot="first"')
        second = self.image(*images[1].groups(), ' slot="second"')
        width = max([int(w) for w in re.findall(r"--w:(\d+)", first + second)] or [480])
        return self.block(
            f'<figure class="figure compare" style="--w:{width}">'
            f'<div class="compare-labels" aria-hidden="true"><span>{labels[0]}</span>'
            f"<span>{labels[1]}</span></div>"
            f"<img-comparison-slider>{first}{second}</img-comparison-slider>"
            + (f"<figcaption>{caption}</figcaption>" if caption else "") + "</figure>"
        ) + ("" if caption or not match[2] else match[2])

    def directive(self, match):
        name = match[1]
        if name in self.directives:
            return self.block(self.directives[name]())
        return ""

    def translate(self, text):
        """The whole file, as Doxygen is to read it."""
        text = text.replace("\r\n", "\n") + "\n"
        text = re.sub(r"^( *)(?:(<!--\s*(?:snippet|not compiled):[^\n]*-->)\n(?: *\n)?\1)?"
                      r"(```+|~~~+)([^\n]*)\n(.*?)^\1\3[ \t]*$", self.fence, text,
                      flags=re.S | re.M)
        text = re.sub(r"^<!-- compare -->\n(.*?)^<!-- /compare -->\n(?:\n?(\*(?!\*|\s).*?)(?=\n\n|\Z))?",
                      self.compare, text, flags=re.S | re.M)
        text = re.sub(r"<!-- widget: (.*?) -->", lambda m: self.block(m[1]), text, flags=re.S)
        text = re.sub(r"^<!-- exact -->\n(?=!\[)", EXACT, text, flags=re.M)
        text = re.sub(r"<!-- (?:demo: )?([\w-]+) -->", self.directive, text)
        text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
        text = re.sub(r"^> \[!(NOTE|TIP|IMPORTANT|WARNING|CAUTION)\][ \t]*\n((?:>.*\n?)*)",
                      self.alert, text, flags=re.M)
        text = re.sub(r"^<details>\s*<summary>(.*?)</summary>",
                      lambda m: self.block(f"<details><summary>{self.unlinked(self.inline_html(m[1]))}</summary>"),
                      text, flags=re.S | re.M)
        text = re.sub(r"^</details>", lambda m: self.block("</details>"), text, flags=re.M)
        text = re.sub(rf"^({EXACT})?((?:!\[[^\]]*\]\([^)\s]+\)[ \t]*\n?)+)(?:\n?^(\*(?!\*|\s).*?))?(?=\n\n|\n*\Z)",
                      self.figure, text, flags=re.S | re.M)
        text = re.sub(r"^\$\$(.+?)\$\$[ \t]*$",
                      lambda m: f"\n\n{self.formula(m[1], display=True)}\n\n", text,
                      flags=re.S | re.M)
        text = re.sub(r"\$\$(.+?)\$\$",
                      lambda m: self.formula(m[1], display=True), text, flags=re.S)
        text = re.sub(r"^(#{1,6}) (.+?)[ \t]*#*[ \t]*$", self.heading, text, flags=re.M)
        text = re.sub(r"^(?:---+|\*\*\*+)[ \t]*$", lambda m: self.block("<hr>"), text, flags=re.M)
        chunks = re.split(r"(\n(?:[ \t]*\n)+)", text)
        return "".join(c if i % 2 else self.chunk(c) for i, c in enumerate(chunks)).strip() + "\n"

    def chunk(self, text):
        """One paragraph, table or list without blank lines."""
        caption = self.caption(text) if text.startswith("*") else None
        if caption:
            return self.fragments.html(f'<p class="caption">{caption}</p>')
        return self.inline(text)
