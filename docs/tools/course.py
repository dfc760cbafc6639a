"""What the repository holds: chapters, exercises, pictures, headers, and the page each one becomes."""
import json
import re
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# The course as planned; a chapter becomes a page when its README.md is there.
PARTS = [
    ("Part I", "Seeing", ["ch01_pixels", "ch02_ray_casting", "ch03_surfaces"]),
    ("Part II", "Estimating",
     ["ch04_monte_carlo", "ch05_rendering_equation", "ch06_importance_sampling"]),
    ("Part III", "Scattering",
     ["ch07_fresnel", "ch08_microfacets", "ch09_metal_and_plastic", "ch10_dielectric",
      "ch11_refraction"]),
    ("Part IV", "Path tracing", ["ch12_russian_roulette"]),
    ("Part V", "Distributed ray tracing, and the comparison",
     ["ch13_distributed_ray_tracing", "ch14_two_ways"]),
]
PLANNED = {
    "ch04_monte_carlo":
        ("Monte Carlo", "Random numbers, estimators, their error, and how to halve it"),
    "ch05_rendering_equation": ("The rendering equation", "Radiance, and the first light in the room"),
    "ch06_importance_sampling": ("Importance sampling", "Look where the light is"),
    "ch07_fresnel": ("Fresnel", "How much a surface mirrors: glass, water, gold"),
    "ch08_microfacets": ("Microfacets", "What roughness is"),
    "ch09_metal_and_plastic": ("Metal and plastic", "Sampling a rough surface well"),
    "ch10_dielectric": ("Dielectric", "Colour under a clear coat, and whose energy it is"),
    "ch11_refraction": ("Refraction", "Light through rough glass, and caustics"),
    "ch12_russian_roulette":
        ("Russian roulette", "Paths that end fairly: the path tracer, complete"),
    "ch13_distributed_ray_tracing":
        ("Distributed ray tracing", "Soft shadows and bounces as a tree of rays"),
    "ch14_two_ways": ("Two ways", "Which of the two is faster, and how to know"),
}


# What the site brings along, and where the text of its licence is, below node_modules.
LICENCES = {
    "source-serif-4": ("Source Serif 4", "@fontsource-variable/source-serif-4/LICENSE"),
    "inter": ("Inter", "@fontsource-variable/inter/LICENSE"),
    "source-code-pro": ("Source Code Pro", "@fontsource-variable/source-code-pro/LICENSE"),
    "img-comparison-slider": ("img-comparison-slider", "img-comparison-slider/package.json"),  # has no other
    "minisearch": ("MiniSearch", "minisearch/LICENSE.txt"),
    "mathjax": ("MathJax, whose letters are in the formulas", "mathjax/LICENSE"),
}


class SiteError(Exception):
    """Something in the repository that the site cannot be built from."""


@dataclass
class Page:
    """One page of the site that is written in Markdown."""
    name: str              # the file is <name>.html
    source: str            # path from the root, or a made-up one for generated pages
    kind: str              # start, chapter, exercise, reference, source
    title: str = ""
    headings: list = field(default_factory=list)  # (level, id, html), from the translation
    chapter: str = ""
    text: str | None = None  # generated pages only


def first_heading(text):
    match = re.search(r"^# (.+)$", text, flags=re.M)
    return match[1].strip() if match else ""


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


def planned_title(chapter):
    """Title of a chapter that has no text yet."""
    number, name = re.match(r"ch(\d+)_(.+)", chapter).groups()
    title, _ = PLANNED.get(chapter, (name.replace("_", " ").capitalize(), ""))
    return f"{int(number)}. {title}"


def chapters():
    """Folders of the chapters that have a text, in order."""
    return sorted(p.parent.name for p in ROOT.glob("chapters/ch*/README.md"))


def exercises():
    """The exercises that have a page, in order of their numbers."""
    found = []
    for path in ROOT.glob("exercises/*/*/exercise.json"):
        folder = path.parent
        if not (folder / "README.md").exists():
            continue
        data = json.loads(path.read_text(encoding="utf-8"))
        data["folder"] = folder.relative_to(ROOT).as_posix()
        data["chapter"] = folder.parent.name
        found.append(data)
    return sorted(found, key=lambda e: e["id"])


def pictures(chapter):
    """Entries of pictures.json that are stored and there."""
    path = ROOT / "chapters" / chapter / "pictures.json"
    if not path.exists():
        return []
    entries = json.loads(path.read_text(encoding="utf-8"))
    return [e for e in entries
            if "stored" in e and (path.parent / "figures" / e["file"]).exists()]


def picture_command(chapter, entry):
    """The command that a reader types to make a picture."""
    words = ["./learn", "chapter", str(int(chapter[2:4]))] + entry.get("args", [])
    return " ".join(f"'{w}'" if re.search(r"[^\w./:=,+-]", w) else w for w in words)


def headers():
    """Headers with a page in the reference: what the chapters teach, and the plumbing."""
    found = [p.relative_to(ROOT).as_posix()
             for pattern in ("chapters/ch*/*.hpp", "common/*.hpp", "common/testkit/*.hpp")
             for p in sorted(ROOT.glob(pattern))]
    return [h for h in found if h != "common/testkit/catch.hpp"]


def page_name(prefix, path):
    return prefix + re.sub(r"\W+", "_", path.removeprefix("chapters/"))


def header_page(header):
    return page_name("api_", header.removesuffix(".hpp"))


def header_brief(header):
    """What the `/// @file` block at the top of a header says it is for."""
    block = re.match(r"/// @file\n((?:///.*\n)*)", read(header))
    if not block or not block[1].strip("/ \n"):
        raise SiteError(f"{header}: no '/// @file' block at the top that says what it is for")
    return " ".join(line.removeprefix("///").strip() for line in block[1].splitlines()).strip()


def source_page(path):
    return page_name("source_", path)


def exercise_page(exercise):
    return f"exercise_{exercise['id'].replace('.', '_')}_{exercise['name'].replace('-', '_')}"


# Files that GitHub shows under a name of their own and the site as part of another page.
ALIASES = {
    "README.md": "index", "chapters/README.md": "index",
    "LICENSE": "about", "docs/pages/index.md": "index",
}


def written_pages():
    """All pages that come from a Markdown file, in reading order."""
    pages = [Page("index", "docs/pages/index.md", "start")]
    pages += [Page(c, f"chapters/{c}/README.md", "chapter", chapter=c) for c in chapters()]
    pages.append(Page("exercises", "exercises/README.md", "reference"))
    pages += [Page(exercise_page(e), f"{e['folder']}/README.md", "exercise", chapter=e["chapter"])
              for e in exercises()]
    pages += [Page(n, f"docs/pages/{n}.md", "reference")
              for n in ("gallery", "notation", "errata", "bibliography", "api", "about")]
    pages += [Page(n.lower(), f"{n}.md", "reference")
              for n in ("CONTRIBUTING", "CHANGELOG") if (ROOT / f"{n}.md").exists()]
    for page in pages:
        page.title = first_heading(read(page.source))
        if not page.title:
            raise SiteError(f"{page.source}: no '# Title' line")
    return pages
