"""Vector figures inside the page, so that they follow its light and dark."""
import html
import re

from course import SiteError

DARK = re.compile(r"@media\s*\(prefers-color-scheme:\s*dark\)\s*\{")


def matching_brace(text, start):
    """Index of the brace that closes the one before `start`."""
    depth = 1
    for i in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[i], 0)
        if depth == 0:
            return i
    raise SiteError("a figure's <style> has an unclosed brace")


def scoped(css, figure, root_class, inside=""):
    """Rules of a figure's style, for that figure only; `inside` is what it has to stand in."""
    root = rf"(?:svg|:root{f'|[.]{re.escape(root_class)}' if root_class else ''})(?![\w-])"

    def selector(text):
        text = re.sub(r"#([\w-]+)", rf"#{figure}-\1", text.strip())
        whole = re.match(root, text)
        rest = text[whole.end():] if whole else f" {text}"
        return f":where({inside}) #{figure}{rest}" if inside else f"#{figure}{rest}"

    def rule(match):
        return f"{','.join(selector(s) for s in match[1].split(','))}{{{match[2].strip()}}}"
    css = re.sub(r"/\*.*?\*/", "", css, flags=re.S)
    return re.sub(r"([^{}]+)\{([^{}]*)\}", rule, css).strip()


def themed_style(css, figure, root_class=""):
    """A figure's style with the system's dark mode turned into the page's."""
    light, dark = "", ""
    while match := DARK.search(css):
        end = matching_brace(css, match.end())
        light += css[:match.start()]
        dark += css[match.end():end]
        css = css[end + 1:]
    light += css
    if "@media" in light:
        raise SiteError("a figure's <style> has a media query that is not prefers-color-scheme: dark")
    style = scoped(light, figure, root_class)
    if dark.strip():
        style += scoped(dark, figure, root_class, "html.dark-mode")
        style += ("@media (prefers-color-scheme: dark){"
                  + scoped(dark, figure, root_class, "html:not(.light-mode)") + "}")
    return style


def inline_svg(path, alt, figure):
    """The <svg> element of a file, with ids and styles of its own, named by `alt`."""
    text = path.read_text(encoding="utf-8")
    try:
        start = text.index("<svg")
        text = text[start:text.rindex("</svg>") + len("</svg>")]
        text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
        root_class = re.search(r'\bclass="([\w-]+)"', text[:text.index(">")])
        root_class = root_class[1] if root_class else ""
        text = re.sub(r"<style[^>]*>(?:\s*<!\[CDATA\[)?(.*?)(?:\]\]>\s*)?</style>",
                      lambda m: f"<style>{themed_style(m[1], figure, root_class)}</style>", text, flags=re.S)
        text = re.sub(r"<(title|desc|metadata)\b[^>]*>.*?</\1>", "", text, flags=re.S)
        text = re.sub(r'\bid="([^"]+)"', rf'id="{figure}-\1"', text)
        text = re.sub(r"url\(#([^)]+)\)", rf"url(#{figure}-\1)", text)
        text = re.sub(r'href="#([^"]+)"', rf'href="#{figure}-\1"', text)
        head_end = text.index(">")
    except (ValueError, SiteError) as error:
        raise SiteError(f"{path}: {error}") from error
    head, body = text[4:head_end], text[head_end:]
    box = re.search(r'viewBox="([^"]+)"', head)
    if not box:
        raise SiteError(f"{path}: <svg> has no viewBox")
    width = float(box[1].split()[2])
    head = re.sub(r'\s(?:width|height|role|id|class|aria-\w+|version|xmlns:xlink|xmlns)="[^"]*"',
                  "", head)
    body = re.sub(r"\n\s*", "\n", body)
    return (f'<svg id="{figure}" class="drawing" role="img" aria-label="{html.escape(alt)}"'
            f' style="max-width:{width:g}px"{head}{body}')
