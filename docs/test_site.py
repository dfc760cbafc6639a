#!/usr/bin/env python3
"""Tests of what builds the site. Quick, and without Doxygen or Node.

usage: python3 docs/test_site.py   (the last line counts them: N passed, N failed)
"""
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).parent), str(Path(__file__).parent / "tools")]

import check_site  # noqa: E402
import course  # noqa: E402
from markdown import MARK, Fragments, Links, Translator, slug, unshield  # noqa: E402
from reference import declaration, region_lines, split_lines, with_links  # noqa: E402
from svg import themed_style  # noqa: E402


class Translation(unittest.TestCase):
    """Markdown as GitHub reads it becomes what Doxygen and the site need."""

    def translated(self, text, source="chapters/ch02_ray_casting/README.md"):
        page = course.Page("sample", source, "chapter", chapter="ch02_ray_casting")
        self.fragments = Fragments()
        self.page = page
        translator = Translator(page, self.fragments, Links([course.Page("index", "x.md", "start")]), {})
        return translator.translate(text)

    def kinds(self):
        return [item["kind"] for item in self.fragments.items]

    def html_of(self, text):
        """Everything put back, code and formulas as their source."""
        text = self.translated(text)
        while MARK.search(text):
            text = MARK.sub(lambda m: self.source_of(self.fragments.items[int(m[1])]), text)
        return unshield(text)

    @staticmethod
    def source_of(item):
        return item.get("html") or item.get("text") or item.get("tex") or ""

    def test_a_heading_has_github_s_anchor_and_a_second_one_gets_a_number(self):
        html = self.html_of("# T\n\n## Does it hold?\n\n## Does it hold?\n")
        self.assertIn('<h2 id="does-it-hold">', html)
        self.assertIn('<h2 id="does-it-hold-1">', html)
        self.assertEqual([i for _, i, _ in self.page.headings], ["does-it-hold", "does-it-hold-1"])
        self.assertEqual(slug("The Hit & the ray"), "the-hit--the-ray")

    def test_formulas_and_code_are_taken_out_of_doxygen_s_way(self):
        text = self.translated("Is $a_1 < b^*$ or `x *= *p` here?\n\n$$\nx^2 \\tag{2.1}\n$$\n")
        self.assertEqual(sorted(self.kinds()), ["code_span", "math", "math"])
        self.assertEqual(self.fragments.items[0]["tex"], "x^2 \\tag{2.1}")
        for character in "$`*<_^":
            self.assertNotIn(character, text)

    def test_money_is_no_formula(self):
        self.translated("It costs 5$ here and 7$ there.\n")
        self.assertEqual(self.kinds(), [])

    def test_special_characters_survive(self):
        self.assertEqual(self.html_of("a < b & c @ d # e % f :: g\n"),
                         "a &lt; b &amp; c @ d # e % f :: g\n")

    def test_emphasis_becomes_html(self):
        self.assertEqual(self.html_of("**bold** and *soft* but 2 * 3 * 4\n"),
                         "<strong>bold</strong> and <em>soft</em> but 2 * 3 * 4\n")

    def test_a_snippet_names_its_file(self):
        self.translated("<!-- snippet: ray.hpp ray -->\n```cpp\nstruct Ray {};\n```\n")
        code = self.fragments.items[0]
        self.assertEqual((code["file"], code["tag"]), ("chapters/ch02_ray_casting/ray.hpp", "ray"))

    def test_a_fence_inside_a_list_stays_there(self):
        text = self.translated("1. One\n\n   ```sh\n   ./learn\n   ```\n\n2. Two\n")
        self.assertRegex(text, r"(?m)^   \ue000\d+\ue001$")
        self.assertEqual(self.fragments.items[0]["text"], "./learn")

    def test_an_in_print_box_is_told_from_other_boxes(self):
        html = self.html_of("> [!IMPORTANT]\n> **In print.** Wrong.\n>\n> More.\n\nText.\n")
        self.assertIn('<aside class="box print" aria-label="In print">', html)
        self.assertLess(html.index("More."), html.index("</aside>"))
        self.assertLess(html.index("</aside>"), html.index("Text."))

    def test_details_keep_what_they_hide(self):
        html = self.html_of("<details><summary>Hint 1</summary>\n\nA **hint**.\n\n</details>\n")
        self.assertIn("<details><summary>Hint 1</summary>", html)
        self.assertIn("<strong>hint</strong>", html)

    def test_links_lead_to_pages(self):
        html = self.html_of("[h](ray.hpp) [o](https://example.org) [s](#here)\n")
        self.assertIn('<a href="api_ch02_ray_casting_ray.html">h</a>', html)
        self.assertIn('<a href="https://example.org" class="outside">o</a>', html)
        self.assertIn('<a href="#here">s</a>', html)

    def test_a_link_to_nothing_is_refused(self):
        with self.assertRaisesRegex(course.SiteError, "nowhere.md, which does not exist"):
            self.translated("[x](nowhere.md)\n")

    def test_a_picture_that_is_missing_is_refused(self):
        with self.assertRaisesRegex(course.SiteError, "which does not exist"):
            self.translated("![A](figures/none.png)\n")

    def test_unknown_html_is_refused(self):
        with self.assertRaisesRegex(course.SiteError, "<marquee>"):
            self.translated("<marquee>no</marquee>\n")

    def test_a_picture_can_ask_never_to_be_scaled(self):
        picture = "![A](../ch01_pixels/figures/checker.png)\n*C.* `c`\n"
        self.assertIn('<figure class="figure exact">', self.html_of("<!-- exact -->\n" + picture))
        self.assertIn('<figure class="figure">', self.html_of(picture))

    def test_a_caption_holds_its_command(self):
        html = self.html_of("*The room.* `./learn chapter 2`\n")
        self.assertIn('<p class="caption"><span>The room.</span><span class="command">'
                      "<code>./learn chapter 2</code></span></p>", html)

    def test_ascii_is_typeset(self):
        self.assertEqual(self.html_of('It\'s "so" - 900 x 720, at -2 ...\n'),
                         "It\u2019s \u201cso\u201d\u00a0\u2013 900 \u00d7 720, at \u22122 \u2026\n")


class Figures(unittest.TestCase):
    def test_a_style_stays_in_its_figure_and_follows_the_page(self):
        css = themed_style(".p,text{fill:#000} #tip{x:y} @media (prefers-color-scheme: dark)"
                           "{text{fill:#fff}}", "fig1", "p")
        self.assertIn("#fig1,#fig1 text{fill:#000}", css)
        self.assertIn("#fig1 #fig1-tip{x:y}", css)
        self.assertIn(":where(html.dark-mode) #fig1 text{fill:#fff}", css)
        self.assertIn("@media (prefers-color-scheme: dark){:where(html:not(.light-mode)) #fig1 text", css)

    def test_another_media_query_is_refused(self):
        with self.assertRaises(course.SiteError):
            themed_style("@media print{text{fill:#000}}", "fig1")


class Code(unittest.TestCase):
    def test_links_go_over_colours(self):
        self.assertEqual(with_links("<span>const</span> Ray&amp; r", [(6, 9, "ray.html")]),
                         '<span>const</span> <a href="ray.html">Ray</a>&amp; r')

    def test_a_comment_of_two_lines_is_coloured_in_both(self):
        self.assertEqual(split_lines("<i>a\nb</i>c".replace("i>", "span>")),
                         ["<span>a</span>", "<span>b</span>c"])

    def test_a_region_knows_its_lines_and_indent(self):
        text = "x\n  // [a]\n  one\n  // [b]\n    two\n  // [a]\n  // [b]\ny"
        self.assertEqual(region_lines(text, "a"), ([3, 5], 2))

    def test_a_declaration_ends_where_the_body_begins(self):
        lines = ["int f(int a,", "      vec3 b = {1, 2}) {  // c", "}"]
        self.assertEqual(declaration(lines, 1), [(1, lines[0]), (2, "      vec3 b = {1, 2})")])
        self.assertEqual(declaration(["T(int x) : x_{x} {}"], 1), [(1, "T(int x)")])


GOOD = ('<!DOCTYPE html><html lang="en"><head><title>{title}</title></head><body>'
        '<h1>T</h1><h2 id="a">A</h2>{body}</body></html>')


class Checker(unittest.TestCase):
    """Each planted fault is found, and a good site has none."""

    def found(self, body, css=""):
        with tempfile.TemporaryDirectory() as folder:
            site = Path(folder)
            (site / "index.html").write_text(GOOD.format(title="One", body=body), encoding="utf-8")
            (site / "two.html").write_text(GOOD.format(title="Two", body=""), encoding="utf-8")
            (site / "p.png").write_bytes(b"")
            (site / "s.css").write_text(css, encoding="utf-8")
            return [p for problems in check_site.check(site).values() for p in problems]

    def test_a_good_site_passes(self):
        self.assertEqual(self.found('<a href="two.html#a">x</a> <a href="https://example.org">o</a>'
                                    '<img src="p.png" alt="P">'), [])

    def test_planted_faults_are_found(self):
        for body, fault in {
            '<a href="three.html">x</a>': "which is not there",
            '<a href="two.html#b">x</a>': "no such anchor",
            '<a href="../up.html">x</a>': "which is not there",
            '<img src="q.png" alt="Q">': "which is not there",
            '<img src="p.png">': "without alt text",
            '<script src="https://example.org/x.js"></script>': "another host",
            '<img src="//example.org/x.png" alt="X">': "another host",
            '<p id="a">twice</p>': "occurs 2 times",
            "<h1>again</h1>": "2 headings of the first level",
            "<h4>deep</h4>": "follows one of level",
            "<p><b>x</p>": "closes <b>",
            '<a href="two.html">x<a href="two.html">y</a></a>': "link inside a link",
            "<p>left **over**</p>": "bold",
            "<p>left $x_1$ over</p>": "formula",
            "<p>[left](over.md)</p>": "link that was not made",
            "<p>> [!NOTE]</p>": "box that was not made",
            "<p>\ue00012\ue001</p>": "mark of the translation",
        }.items():
            with self.subTest(body):
                self.assertTrue(any(fault in p for p in self.found(body)), self.found(body))

    def test_style_sheets_are_read_too(self):
        self.assertIn("another host", self.found("", "@import 'https://example.org/x.css';")[0])
        self.assertIn("not there", self.found("", "a{background:url(none.png)}")[0])


if __name__ == "__main__":
    result = unittest.TextTestRunner(verbosity=1).run(
        unittest.defaultTestLoader.loadTestsFromModule(sys.modules[__name__]))
    wrong = len(result.failures) + len(result.errors)
    print(f"{result.testsRun - wrong} passed, {wrong} failed")
    sys.exit(1 if wrong or not result.testsRun else 0)
