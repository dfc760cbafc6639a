"""What Doxygen knows about the code: where each symbol is documented, and the links in each line."""
import html
import re
from xml.etree import ElementTree

import course

TOKEN = re.compile(r"(<[^>]+>)|([^<]+)")


class Reference:
    """Doxygen's output, read for its links. `names` maps its file names to the site's."""

    def __init__(self, doxygen_html, tagfile):
        self.folder = doxygen_html
        self.names = {}
        self.symbols = {}      # name -> [(header, address)]
        self.line_links = {}   # header -> {line: [(start, end, address)]}
        headers = {course.group_name(h): h for h in course.headers()}
        tree = ElementTree.parse(tagfile).getroot()
        for compound in tree.iter("compound"):
            name, file = compound.findtext("name"), compound.findtext("filename")
            if compound.get("kind") == "file":
                path = self.path_of(compound.findtext("path"), name)
                if path in headers.values():
                    self.names[file] = course.header_page(path) + ".html"
                    source = re.sub(r"\.html$", "_source.html", file)
                    self.names[source] = course.source_page(path) + ".html"
            elif compound.get("kind") == "group" and name in headers:
                self.names[file] = course.header_page(headers[name]) + ".html"
        for compound in tree.iter("compound"):
            kind, name = compound.get("kind"), compound.findtext("name")
            if kind == "group" and name in headers:
                for member in compound.iter("member"):
                    self.add(member.findtext("name"), headers[name], member.findtext("anchorfile"),
                             member.findtext("anchor"))
            elif kind in ("class", "struct"):
                file, anchor = compound.findtext("filename"), compound.findtext("anchor")
                header = next((h for h in headers.values()
                               if course.header_page(h) + ".html" == self.names.get(file)), None)
                if header and anchor:
                    self.add(name.split("::")[-1], header, file, anchor)

    @staticmethod
    def path_of(folder, name):
        path = re.sub(r"^.*?(?=(chapters|common)/)", "", f"{folder}{name}")
        return path

    def add(self, name, header, file, anchor):
        if file in self.names:
            self.symbols.setdefault(name, []).append((header, f"{self.names[file]}#{anchor}"))

    def address(self, href):
        """The site's address of one of Doxygen's own links; None where the site has no such page."""
        file, _, anchor = href.partition("#")
        if not file:
            return href
        if file not in self.names:
            return None
        if file.endswith("_source.html"):
            anchor = re.sub(r"^l0*(\d+)$", r"L\1", anchor)
        return self.names[file] + (f"#{anchor}" if anchor else "")

    def symbol(self, name, near=""):
        """Where a name is documented; `near` is a header or folder to prefer. None if unclear."""
        found = self.symbols.get(name, [])
        here = [a for h, a in found if h == near] or [a for h, a in found if near and near in h]
        if here:
            return here[0]
        return found[0][1] if len({h for h, _ in found}) == 1 else None

    def links_of(self, header):
        """Links of each line of a header: {line: [(start, end, address)]}."""
        if header not in self.line_links:
            self.line_links[header] = {}
            page = course.source_page(header) + ".html"
            file = next((f for f, n in self.names.items() if n == page), None)
            if file and (self.folder / file).exists():
                text = (self.folder / file).read_text(encoding="utf-8")
                lines = re.findall(r'<div class="line"><a id="l(\d+)"[^>]*></a>'
                                   r'<span class="lineno">.*?\d+(?:</a>)?</span>(.*?)</div>', text)
                for number, line in lines:
                    self.line_links[header][int(number)] = self.links_in(line)
        return self.line_links[header]

    def links_in(self, line):
        links, position, start, href = [], 0, 0, None
        for tag, text in TOKEN.findall(line):
            if tag.startswith("<a "):
                start, href = position, re.search(r'href="([^"]+)"', tag)[1]
            elif tag == "</a>" and href:
                address = self.address(href)
                if address:
                    links.append((start, position, address))
                href = None
            elif text:
                position += len(html.unescape(text))
        return links


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
    for number, line in enumerate(text.split("\n"), 1):
        mark = re.fullmatch(r"\s*// \[([\w-]+)\]", line)
        if mark and mark[1] == tag:
            if inside:
                break
            inside = True
        elif inside and not mark:
            numbers.append(number)
    lines = text.split("\n")
    indents = [len(lines[n - 1]) - len(lines[n - 1].lstrip()) for n in numbers if lines[n - 1].strip()]
    return numbers, min(indents, default=0)
