"""The reference of the code, from Doxygen's XML: one page for each header, and links into it."""
import html
import re
from dataclasses import dataclass, field
from xml.etree import ElementTree

import course
from course import SiteError

TOKEN = re.compile(r"(<[^>]+>)|([^<]+)")


@dataclass
class Entry:
    """Something that a header declares."""
    kind: str                 # function, variable, typedef, enum, define, class, struct, concept
    name: str
    line: int
    node: ElementTree.Element
    anchor: str = ""
    members: list = field(default_factory=list)


class Reference:
    def __init__(self, xml):
        self.entries = {}      # header -> entries in the order of the file
        self.addresses = {}    # Doxygen's id -> address on the site
        self.symbols = {}      # name -> [(header, address)]
        self.line_links = {}   # header -> {line: [(start, end, address)]}
        self.functions = set()  # ids of functions
        self.fields = set()    # ids of data members, which would make a page of links
        self.headers = {h.removeprefix("chapters/"): h for h in course.headers()}
        trees = [ElementTree.parse(p).getroot().find("compounddef")
                 for p in sorted(xml.glob("*.xml")) if p.stem not in ("index", "Doxyfile")]
        self.trees = [t for t in trees if t is not None]
        self.classes = {t.get("id"): t for t in self.trees if t.get("kind") in ("class", "struct")}
        self.collect()
        self.name_anchors()
        self.read_listings()

    def header_of(self, node):
        location = node.find("location")
        if location is None:
            return None
        return self.headers.get(location.get("declfile") or location.get("file"))

    @staticmethod
    def line_of(node):
        location = node.find("location")
        return int(location.get("declline") or location.get("line"))

    def collect(self):
        for tree in self.trees:
            self.functions.update(n.get("id") for n in tree.iter("memberdef")
                                  if n.get("kind") == "function")
            kind = tree.get("kind")
            if kind in ("class", "struct") and "::" in tree.findtext("compoundname"):
                self.collect_class(tree)
            elif kind in ("namespace", "file"):
                for node in tree.iter("memberdef"):
                    header = self.header_of(node)
                    if header and node.get("id") not in self.addresses:
                        self.addresses[node.get("id")] = ""
                        name = node.findtext("qualifiedname") or node.findtext("name")
                        self.add(header, Entry(node.get("kind"), name.removeprefix("lt::"),
                                               self.line_of(node), node))
        for entries in self.entries.values():
            entries.sort(key=lambda e: e.line)

    def collect_class(self, tree):
        header = self.header_of(tree)
        if not header:
            return
        name = tree.findtext("compoundname").removeprefix("lt::")
        entry = Entry(tree.get("kind"), name, self.line_of(tree), tree)
        for node in tree.iter("memberdef"):
            is_told = re.search(r"=\s*(delete|default)", node.findtext("argsstring") or "") is None
            if node.get("kind") == "variable":
                self.fields.add(node.get("id"))
            if node.get("prot") == "public" and is_told:
                entry.members.append(Entry(node.get("kind"), node.findtext("name"),
                                           self.line_of(node), node))
        entry.members.sort(key=lambda m: m.line)
        self.add(header, entry)

    def add(self, header, entry):
        self.entries.setdefault(header, []).append(entry)

    def name_anchors(self):
        """Readable anchors: closest_hit, intersect-2, Triangle.normal."""
        for header, entries in self.entries.items():
            page, used = course.header_page(header) + ".html", {}

            def give(entry, name):
                used[name] = used.get(name, 0) + 1
                entry.anchor = name if used[name] == 1 else f"{name}-{used[name]}"
                self.addresses[entry.node.get("id")] = f"{page}#{entry.anchor}"
            for entry in entries:
                give(entry, re.sub(r"\W+", "-", entry.name).strip("-"))
                self.symbols.setdefault(entry.name.split("::")[-1], []).append(
                    (header, f"{page}#{entry.anchor}"))
                for member in entry.members:
                    give(member, f"{entry.anchor}.{re.sub(r'[^a-zA-Z0-9_]+', '-', member.name)}")
        for tree in self.trees:
            if tree.get("kind") == "file" and self.header_of(tree):
                self.addresses[tree.get("id")] = course.header_page(self.header_of(tree)) + ".html"

    def read_listings(self):
        """Where in each line of a header a symbol stands."""
        for tree in self.trees:
            header = self.header_of(tree) if tree.get("kind") == "file" else None
            if not header:
                continue
            lines = self.line_links[header] = {}
            for codeline in tree.iter("codeline"):
                links, line = [], ""
                for highlight in codeline.iter("highlight"):
                    line += highlight.text or ""
                    for node in highlight:
                        text = " " if node.tag == "sp" else node.text or ""
                        target = node.get("refid")
                        address = self.addresses.get(target) if target not in self.fields else None
                        if node.tag == "ref" and address:
                            links.append((len(line), len(line) + len(text), address, target))
                        line += text + (node.tail or "")
                # Doxygen takes a local variable for a function of the same name.
                lines[int(codeline.get("lineno"))] = [
                    (start, end, address) for start, end, address, target in links
                    if target not in self.functions or line[end:end + 1] == "("]

    def symbol(self, name, near=""):
        """Where a name is documented; `near` is a header or folder to prefer. None if unclear."""
        found = self.symbols.get(name, [])
        here = [a for h, a in found if near and near in h]
        if here:
            return here[0]
        return found[0][1] if len({h for h, _ in found}) == 1 else None

    def links_of(self, header):
        """Links of each line of a header: {line: [(start, end, address)]}."""
        return self.line_links.get(header, {})


class Documentation:
    """Doxygen's descriptions as HTML."""

    def __init__(self, reference, header):
        self.reference = reference
        self.header = header

    def inner(self, node):
        parts = [self.text(node.text)]
        for child in node:
            parts.append(self.element(child))
            parts.append(self.text(child.tail))
        return "".join(parts)

    def text(self, text):
        """Plain text, in which `name()` leads to the function."""
        def link(match):
            address = self.reference.symbol(match[1], near=self.header)
            return f'<a href="{address}">{match[0]}</a>' if address else match[0]
        return re.sub(r"\b([A-Za-z_]\w*)\(\)", link, html.escape(text or "", quote=False))

    def element(self, node):
        simple = {"computeroutput": "code", "bold": "strong", "emphasis": "em",
                  "itemizedlist": "ul", "orderedlist": "ol", "listitem": "li", "para": "p",
                  "subscript": "sub", "superscript": "sup"}
        if node.tag in simple:
            name = simple[node.tag]
            return f"<{name}>{self.inner(node)}</{name}>"
        if node.tag in ("parameterlist", "simplesect"):
            return ""  # shown below the text, by details()
        if node.tag == "ref":
            address = self.reference.addresses.get(node.get("refid"))
            return f'<a href="{address}">{self.inner(node)}</a>' if address else self.inner(node)
        if node.tag == "verbatim":
            return f"</p><pre>{html.escape(node.text or '')}</pre><p>"
        characters = {"ndash": "\u2013", "mdash": "\u2014", "linebreak": "<br>", "nonbreakablespace":
                      "\u00a0", "minus": "\u2212", "times": "\u00d7", "hellip": "\u2026"}
        if node.tag in characters:
            return characters[node.tag]
        raise SiteError(f"{self.header}: a comment uses <{node.tag}>, which the site does not show")

    def paragraphs(self, node):
        """Brief and detailed description."""
        out = []
        for part in ("briefdescription", "detaileddescription"):
            for para in node.findall(f"{part}/para"):
                content = self.inner(para).strip()
                if content:
                    out.append(content if content.startswith("<ul") else f"<p>{content}</p>")
        return "".join(out).replace("<p></p>", "")

    def line(self, node):
        """A description of one line, for a table."""
        return re.sub(r"</?p>", "", self.paragraphs(node)).strip()

    def details(self, node):
        """Parameters, result and errors as a list."""
        rows = []
        lists = node.findall("briefdescription//parameterlist")
        lists += node.findall("detaileddescription//parameterlist")
        for kind, label in (("param", None), ("templateparam", None), ("exception", "throws")):
            for plist in lists:
                if plist.get("kind") != kind:
                    continue
                for item in plist.findall("parameteritem"):
                    names = ", ".join(f"<code>{html.escape(n.text or '')}</code>"
                                      for n in item.iter("parametername"))
                    text = " ".join(self.inner(p).strip()
                                    for p in item.findall("parameterdescription/para"))
                    rows.append((f"{label} {names}" if label else names, text))
        for sect in node.findall("detaileddescription//simplesect"):
            label = {"return": "returns", "see": "see", "note": "note", "pre": "needs",
                     "warning": "mind"}.get(sect.get("kind"), sect.get("kind"))
            rows.append((label, " ".join(self.inner(p).strip() for p in sect.findall("para"))))
        if not rows:
            return ""
        return "<dl class=\"facts\">" + "".join(
            f"<dt>{label}</dt><dd>{text}</dd>" for label, text in rows) + "</dl>"


def declaration(lines, first):
    """Lines of a declaration, from its first line to where its body begins."""
    depth, out = 0, []
    for number in range(first, min(first + 12, len(lines) + 1)):
        line = lines[number - 1]
        code = line.split("//")[0].rstrip()
        for i, character in enumerate(code):
            if depth == 0 and re.match(r"(?<!:):(?!:)", code[i:]) and re.search(r"\)\s*$", code[:i]):
                return out + [(number, code[:i].rstrip())]  # a constructor's first values
            depth += {"(": 1, ")": -1, "[": 1, "]": -1}.get(character, 0)
            is_default = character == "{" and re.search(r"=\s*$", code[:i])
            if depth == 0 and (character in ";" or (character == "{" and not is_default)):
                return out + [(number, code[:i].rstrip())]
        out.append((number, code))
    return out[:1]


class HeaderPage:
    """The page of one header; `fragment` keeps code for colouring and gives a mark for it."""

    def __init__(self, reference, header, fragment):
        self.reference, self.header, self.fragment = reference, header, fragment
        self.documentation = Documentation(reference, header)
        self.lines = course.read(header).split("\n")
        self.source = course.source_page(header)

    def signature(self, entry):
        first = entry.line
        while first > 1 and re.match(r"\s*template\b", self.lines[first - 2]):
            first -= 1
        parts = declaration(self.lines, first)
        while len(parts) == 1 and entry.name.split("::")[-1] not in parts[0][1] and first < entry.line:
            first += 1
            parts += declaration(self.lines, first)
        # What says nothing to a caller goes, and the lines below move with it.
        shown = re.sub(r"^\s*(?:\[\[nodiscard\]\] )?(?:inline )?", "", parts[0][1])
        cuts = [len(parts[0][1]) - len(shown)]
        cuts += [min(cuts[0], len(t) - len(t.lstrip())) for _, t in parts[1:]]
        text = "\n".join(t[cut:] for (_, t), cut in zip(parts, cuts))
        return self.fragment(text=text, file=self.header, numbers=[n for n, _ in parts], indents=cuts)

    def head(self, level, entry, label):
        return (f'<div class="entry-head"><h{level} id="{entry.anchor}">{label}<a class="anchor" '
                f'href="#{entry.anchor}" aria-label="Link to this entry">#</a></h{level}>'
                f'<a class="source" href="{self.source}.html#L{entry.line}">line {entry.line}</a></div>')

    def entry(self, entry, level=2):
        title = html.escape(entry.name)
        label = f"{title}()" if entry.kind in ("function", "define") else title
        out = [self.head(level, entry, f"<code>{label}</code>"), self.signature(entry),
               self.documentation.paragraphs(entry.node)]
        if entry.kind == "enum":
            out.append(self.enumerators(entry))
        out.append(self.fields([m for m in entry.members if m.kind == "variable"]))
        out.append(self.documentation.details(entry.node))
        functions = [m for m in entry.members if m.kind != "variable"]
        out += [self.entry(m, level + 1) for m in functions]
        return "\n".join(out)

    @staticmethod
    def table(head, rows):
        """Rows of (anchor, cells); a column without any text is left out."""
        kept = [i for i in range(len(head)) if any(cells[i] for _, cells in rows)]
        top = "".join(f"<th scope=col>{head[i]}</th>" for i in kept)
        body = "".join(f'<tr{f" id={chr(34)}{anchor}{chr(34)}" if anchor else ""}>'
                       + "".join(f"<td>{cells[i]}</td>" for i in kept) + "</tr>"
                       for anchor, cells in rows)
        return (f'<div class="table fields"><table><thead><tr>{top}</tr></thead>'
                f"<tbody>{body}</tbody></table></div>")

    def fields(self, members):
        if not members:
            return ""
        return self.table(("Field", "Type", "Meaning"), [
            (m.anchor, (f"<code>{html.escape(m.name)}</code>",
                        f"<code>{html.escape(self.type_of(m.node))}</code>",
                        self.documentation.line(m.node) + self.initial(m.node))) for m in members])

    @staticmethod
    def type_of(node):
        text = "".join(node.find("type").itertext())
        return re.sub(r"< (.*?) >", r"<\1>", text).replace(" &", "&") + (node.findtext("argsstring") or "")

    @staticmethod
    def initial(node):
        value = node.find("initializer")
        if value is None:
            return ""
        text = "".join(value.itertext()).strip().removeprefix("=").strip()
        return f'<span class="initial">{html.escape(text.strip("{}"))} at first</span>' if text else ""

    def enumerators(self, entry):
        return self.table(("Value", "Meaning"), [
            ("", (f"<code>{html.escape(v.findtext('name'))}</code>", self.documentation.line(v)))
            for v in entry.node.iter("enumvalue")])

    def body(self):
        entries = self.reference.entries.get(self.header, [])
        return "\n".join(f'<section class="entry">{self.entry(e)}</section>' for e in entries)


def with_links(colored, links):
    """Coloured HTML of one line with links put over ranges of its text."""
    out, position = [], 0
    for tag, escaped in TOKEN.findall(colored):
        if tag:
            out.append(tag)
            continue
        text = html.unescape(escaped)
        done = 0
        for start, end, address in links:
            start, end = start - position, end - position
            if start < done or end > len(text):
                continue
            out.append(html.escape(text[done:start], quote=False))
            out.append(f'<a href="{address}">{html.escape(text[start:end], quote=False)}</a>')
            done = end
        out.append(html.escape(text[done:], quote=False))
        position += len(text)
    return "".join(out)


def split_lines(colored):
    """Lines of coloured HTML, each with its own complete tags."""
    lines, open_tags, line = [], [], []
    for tag, text in TOKEN.findall(colored):
        if tag.startswith("</"):
            open_tags.pop()
            line.append(tag)
        elif tag:
            open_tags.append(tag)
            line.append(tag)
        else:
            parts = text.split("\n")
            for part in parts[:-1]:
                line.append(part + "</span>" * len(open_tags))
                lines.append("".join(line))
                line = list(open_tags)
            line.append(parts[-1])
    lines.append("".join(line))
    return lines


def region_lines(text, tag):
    """Numbers of the lines between the two `// [tag]` lines, and their common indent."""
    numbers, inside = [], False
    lines = text.split("\n")
    for number, line in enumerate(lines, 1):
        mark = re.fullmatch(r"\s*// \[([\w-]+)\]", line)
        if mark and mark[1] == tag:
            if inside:
                break
            inside = True
        elif inside and not mark:
            numbers.append(number)
    indents = [len(lines[n - 1]) - len(lines[n - 1].lstrip()) for n in numbers if lines[n - 1].strip()]
    return numbers, min(indents, default=0)
