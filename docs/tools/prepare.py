#!/usr/bin/env python3
"""Writes what Doxygen reads: every page of the site, translated, and the pages made from data.

usage: prepare.py WORK   (writes WORK/input/*.md, WORK/headers, fragments.json, site.json)
"""
import html
import json
import re
import sys
from dataclasses import asdict
from pathlib import Path

import course
from course import ROOT, SiteError
from markdown import Fragments, Links, Translator

LANGUAGE = {".hpp": "cpp", ".cpp": "cpp", ".cmake": "cmake", ".json": "json", ".yml": "yaml",
            ".sh": "sh", ".py": "python"}


class Directives:
    """The parts of pages that are made from the chapters' and exercises' own files."""

    def __init__(self, translator, links):
        self.translator = translator
        self.links = links

    def names(self):
        return {"chapters": self.chapters, "exercises": self.exercises,
                "gallery": self.gallery, "headers": self.headers, "licences": self.licences}

    def picture(self, chapter, entry):
        """HTML of a stored picture, named by its caption."""
        path = f"/chapters/{chapter}/figures/{entry['file']}"
        return self.rooted_image(path, re.sub(r"[*`$]", "", entry["caption"]))

    def rooted_image(self, path, alt):
        up = "../" * self.translator.page.source.count("/")
        return self.translator.image(alt, up + path.lstrip("/"))

    @staticmethod
    def cover(chapter):
        """The picture that stands for a chapter: its first one."""
        return next((e for e in course.pictures(chapter) if e["file"].endswith(".png")), None)

    def chapters(self):
        written = set(course.chapters())
        out = []
        for part, name, members in course.PARTS:
            cards = "".join(self.chapter_card(c) if c in written else self.planned_card(c)
                            for c in members)
            out.append(f'<section class="part"><h3>{part} <span>{name}</span></h3>'
                       f'<ol class="cards">{cards}</ol></section>')
        return "\n".join(out)

    def chapter_card(self, chapter):
        text = course.read(f"chapters/{chapter}/README.md")
        number, title = re.match(r"(\d+)\. (.+)", course.first_heading(text)).groups()
        able = re.search(r"you will be able to:?\*{0,2}:?\s*(.+)", text, flags=re.I)
        says = self.translator.inline_html(able[1]) if able else ""
        cover = self.cover(chapter)
        picture = self.picture(chapter, cover).replace('alt="', 'alt="" data-alt="') if cover else ""
        return (f'<li class="card"><a href="{chapter}.html">{picture}'
                f'<span class="card-title"><b>{number}</b> {html.escape(title)}</span></a>'
                f'<p class="says">{says}</p></li>')

    @staticmethod
    def planned_card(chapter):
        number, title = course.planned_title(chapter).split(". ")
        return (f'<li class="card planned"><span class="card-title"><b>{number}</b> '
                f'{html.escape(title)}</span><p class="says">{html.escape(course.PLANNED[chapter][1])} '
                f'<small>(to come)</small></p></li>')

    def exercises(self):
        rows, out, chapter = [], [], None

        def flush():
            if rows:
                out.append('<table class="exercises"><thead><tr><th scope="col">No.</th>'
                           '<th scope="col">Exercise</th><th scope="col">Minutes</th></tr></thead>'
                           f'<tbody>{"".join(rows)}</tbody></table>')
                rows.clear()
        for exercise in course.exercises():
            if exercise["chapter"] != chapter:
                flush()
                chapter = exercise["chapter"]
                title = (course.first_heading(course.read(f"chapters/{chapter}/README.md"))
                         if chapter in course.chapters() else course.planned_title(chapter))
                link = (f'<a href="{chapter}.html">{html.escape(title)}</a>'
                        if chapter in course.chapters() else html.escape(title))
                out.append(f'<h2 id="{chapter}">{link}</h2>')
            rows.append(f'<tr><td class="number">{exercise["id"]}</td>'
                        f'<td><a href="{course.exercise_page(exercise)}.html">'
                        f'{html.escape(exercise["title"])}</a></td>'
                        f'<td class="number">{exercise["minutes"]}</td></tr>')
        flush()
        return "\n".join(out)

    def gallery(self):
        out = []
        for chapter in course.chapters():
            entries = course.pictures(chapter)
            if not entries:
                continue
            title = course.first_heading(course.read(f"chapters/{chapter}/README.md"))
            out.append(f'<h2 id="{chapter}"><a href="{chapter}.html">{html.escape(title)}</a></h2>'
                       '<div class="gallery">')
            for entry in entries:
                command = html.escape(course.picture_command(chapter, entry))
                drawn = " drawn" if entry["file"].endswith(".svg") else ""
                out.append(f'<figure class="figure{drawn}">{self.picture(chapter, entry)}<figcaption>'
                           f'<span>{self.translator.inline_html(entry["caption"])}</span>'
                           f'<span class="command"><code>{command}</code></span>'
                           "</figcaption></figure>")
            out.append("</div>")
        return "\n".join(out)

    def headers(self):
        """All headers with what each is for."""
        sections = {}
        for header in course.headers():
            folder = header.removeprefix("chapters/").rsplit("/", 1)[0]
            sections.setdefault(folder, []).append(header)
        out = []
        for folder, members in sections.items():
            if folder in course.chapters():
                title = course.first_heading(course.read(f"chapters/{folder}/README.md"))
                name = f'<a href="{folder}.html">Chapter {html.escape(title)}</a>'
            elif folder == "common":
                name = "Plumbing that no chapter teaches"
            elif folder == "common/testkit":
                name = "The test kit"
            else:
                name = f"Chapter {html.escape(course.planned_title(folder))}"
            out.append(f'<h2 id="{folder.replace("/", "-")}">{name}</h2><dl class="headers">')
            for header in members:
                brief = self.translator.inline_html(course.header_brief(header))
                out.append(f'<dt><a href="{course.header_page(header)}.html"><code>'
                           f'{header.removeprefix("chapters/")}</code></a></dt><dd>{brief}</dd>')
            out.append("</dl>")
        return "\n".join(out)


    @staticmethod
    def licences():
        """Of what the site brings along; finish.py copies the texts."""
        return "<ul>" + "".join(f'<li><a href="licences/{name}.txt">{label}</a></li>'
                                for name, (label, _) in course.LICENCES.items()) + "</ul>"


def code_of(exercise, name):
    text = course.read(f"{exercise['folder']}/{name}").rstrip("\n")
    return f"```cpp\n{text}\n```"


def exercise_meta(exercise):
    """The line under an exercise's title."""
    chapter, about = exercise["chapter"], f"Exercise {exercise['id']}"
    if chapter in course.chapters():
        title = course.first_heading(course.read(f"chapters/{chapter}/README.md"))
        about += f" of [chapter {title}](../../../chapters/{chapter}/README.md)"
    return about + f" - about {exercise['minutes']} minutes"


def exercise_text(exercise):
    """The exercise's README with what its exercise.json says."""
    folder, ident = exercise["folder"], exercise["id"]
    text = course.read(f"{folder}/README.md").rstrip("\n")
    title_line = re.search(r"^# .+\n", text, flags=re.M)
    if not re.search(r"^About \d+ minutes", text, flags=re.M):
        text = f"{text[:title_line.end()]}\n<!-- meta -->\n\n{text[title_line.end():]}"
    mine = f"my/{ident}-{exercise['name']}.cpp"
    parts = [text]
    if "./learn" not in text:
        parts.append(f"""## Do it

```sh
./learn run {ident}
```

The first time, this makes `{mine}` for you to edit.""")
    parts.append("## Hints\n\nOne at a time; each gives away a little more than the one before.")
    for number, hint in enumerate(exercise.get("hints", []), 1):
        parts.append(f"<details><summary>Hint {number}</summary>\n\n{hint}\n\n</details>")
    parts.append("## Mistakes that it knows\n\nWhen the check recognises one of these, it says so "
                 "by name.")
    says = "\n".join(f"- {m['says']}" for m in exercise.get("mutants", []))
    parts.append(f"<details><summary>Show the {len(exercise.get('mutants', []))} mistakes"
                 f"</summary>\n\n{says}\n\n</details>")
    parts.append("## A solution\n\n<details><summary>Show a solution - after yours passes, or "
                 "after a real try</summary>\n\n> [!WARNING]\n> Reading a solution feels like "
                 "understanding it. Write yours first; then compare.\n\n"
                 + code_of(exercise, "solution.cpp"))
    if (ROOT / folder / "other.cpp").exists():
        parts.append("Another way to the same answer, which the check must accept as well:\n\n"
                     + code_of(exercise, "other.cpp"))
    parts.append("</details>")
    return "\n\n".join(parts) + "\n"


def plain_comments(code):
    """A header as Doxygen is to read it: comments are plain text, so <desc> in one is no HTML."""
    return re.sub(r"(?<=///)(<?)([^\n]*)", lambda m: m[1] + m[2].replace("<", "&lt;"), code)


def doxygen_page(page, body):
    plain = re.sub(r"[^\w .,:'()/+-]", "", re.sub("\ue000\\d+\ue001", "", page.title)) or page.name
    label = "mainpage" if page.name == "index" else page.name
    return f"# {plain} {{#{label}}}\n\n{body}"


def main(work):
    (work / "input").mkdir(parents=True, exist_ok=True)
    pages = course.written_pages()
    links, fragments = Links(pages), Fragments()
    exercises = {course.exercise_page(e): e for e in course.exercises()}
    done = []

    def write(page, text):
        directives = {}
        translator = Translator(page, fragments, links, directives)
        directives.update(Directives(translator, links).names())
        if page.name in exercises:
            meta = exercise_meta(exercises[page.name])
            directives["meta"] = lambda: f'<p class="meta">{translator.inline_html(meta)}</p>'
        body = translator.translate(text)
        (work / "input" / f"{page.name}.md").write_text(doxygen_page(page, body), encoding="utf-8")
        done.append(page)

    for page in pages:
        if page.name in exercises:
            text = exercise_text(exercises[page.name])
        else:
            text = course.read(page.source)
        if page.name == "exercises":
            text = text.replace("\n## ", "\n<!-- exercises -->\n\n## ", 1)
        write(page, text)

    for header in course.headers():
        links.sources[header] = course.source_page(header)
    for path, name in sorted(links.sources.items()):
        page = course.Page(name, path, "source", title=html.escape(path.removeprefix("chapters/")))
        code = fragments.add("code", lang=LANGUAGE.get(Path(path).suffix, "text"), file=path,
                             text=course.read(path).rstrip("\n"), note="", numbered=True)
        (work / "input" / f"{name}.md").write_text(doxygen_page(page, code + "\n"),
                                                   encoding="utf-8")
        done.append(page)

    for header in course.headers():
        copy = work / "headers" / header.removeprefix("chapters/")
        copy.parent.mkdir(parents=True, exist_ok=True)
        copy.write_text(plain_comments(course.read(header)), encoding="utf-8")
    site = {"pages": [asdict(p) for p in done], "assets": links.assets}
    (work / "site.json").write_text(json.dumps(site, indent=1), encoding="utf-8")
    (work / "fragments.json").write_text(json.dumps(fragments.items), encoding="utf-8")


if __name__ == "__main__":
    try:
        main(Path(sys.argv[1]))
    except SiteError as error:
        sys.exit(f"site: {error}")
