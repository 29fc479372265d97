# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the pages of the manual hold together: links, headings, pictures, navigation and words."""
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402

# Pages written in the words of the glossary. A page that is rewritten joins them, and none leaves.
IN_PLAIN_WORDS = ("../README.md", "architecture.md", "calibration.md", "changelog.md", "color.md", "command-line.md",
                  "concepts.md", "contributing.md", "examples/README.md", "export.md", "first-ten-minutes.md",
                  "glossary.md", "how-to-cite.md", "install.md", "life-of-a-frame.md", "limitations.md",
                  "many-recordings.md", "people.md", "plots.md", "project-file.md", "python.md", "quick-start.md",
                  "style.md", "testing.md", "time-travel.md", "translations.md", "troubleshooting.md",
                  "tutorial-board.md", "tutorial-changing-light.md", "tutorial-grid-by-hand.md",
                  "tutorial-one-camera-box.md", "tutorial-people.md", "tutorial-several-targets.md",
                  "tutorial-two-videos.md", "tutorial-wand.md", "window.md")
# Those of methods and measurements.
IN_PLAIN_WORDS += ("measurements-calibration.md", "measurements-color.md", "method-calibration.md", "method-color.md",
                   "method-dewpoint.md", "method-dynamics.md", "method-people.md", "method-smoothing.md", "metrics.md",
                   "scenarios.md", "speed.md")
# Pages with measured tables, whose texts come from the programs: only the text around the tables is checked.
WITH_TABLES_IN_PLAIN_WORDS = ("accuracy.md", "fidelity.md", "measurements-dewpoint.md",
                              "measurements-people.md", "method-sugandi.md")


class Pages(unittest.TestCase):
    def test_links_lead_somewhere(self):
        for page in pages.pages():
            with self.subTest(page=page.name):
                self.assertEqual(pages.link_faults(page, page.read_text()), [])

    def test_pictures_are_used(self):
        used = {(page.parent / target).resolve() for page in pages.pages() for _, target in pages.links(page.read_text())}
        unused = [file.name for file in sorted((pages.DOCS / "images").iterdir()) if file not in used]
        self.assertEqual(unused, [])

    def test_pages_are_in_the_navigation(self):
        listed = pages.navigation(pages.NAVIGATION.read_text())
        there = {str(page.relative_to(pages.DOCS)) for page in pages.pages() if page.is_relative_to(pages.DOCS)}
        self.assertEqual(sorted(set(listed)), sorted(there | set(pages.MADE)))
        self.assertEqual(len(listed), len(set(listed)), "a page has two places")

    def test_pages_begin_with_their_title(self):
        for page in pages.pages():
            first, *others = re.findall(r"^# .*$", pages.without_code_blocks(page.read_text()), re.M) or [""]
            self.assertTrue(page.read_text().startswith(first) and first, page.name)
            self.assertEqual(others, [], page.name)

    def test_how_to_pages_use_the_words_of_the_glossary(self):
        for name in (*IN_PLAIN_WORDS, *WITH_TABLES_IN_PLAIN_WORDS):
            with self.subTest(page=name):
                text = pages.without_tables((pages.DOCS / name).read_text())
                faults = [f"{name}:{number}: '{word}': {better}"
                          for number, word, better in pages.banned_words(text)]
                self.assertEqual(faults, [])

    def test_how_to_pages_hold_no_measured_tables(self):
        for name in IN_PLAIN_WORDS:
            self.assertNotIn("<!-- table:", pages.without_code((pages.DOCS / name).read_text()), name)

    def test_glossary_is_in_order_and_plain(self):
        rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \|$", (pages.DOCS / "glossary.md").read_text(), re.M)[2:]
        words = [word for word, _ in rows]
        self.assertGreater(len(words), 80)
        self.assertEqual(words, sorted(words, key=str.lower))
        self.assertEqual([word for word, meaning in rows if not meaning.endswith(".")], [])

    def test_citation_and_version_agree(self):
        version = re.search(r"project\(Dewpoint VERSION ([\d.]+)", (pages.ROOT / "CMakeLists.txt").read_text()).group(1)
        self.assertIn(f"\nversion: {version}\n", (pages.DOCS / "CITATION.cff").read_text())
        # As the window says it (Help › About Dewpoint).
        line = "Dewpoint: color particle filters that track in 3D with ordinary cameras."
        self.assertIn(line, (pages.ROOT / "ui" / "help" / "about_dialog.cpp").read_text())
        self.assertIn(f"{line} Version {version}, ", (pages.DOCS / "how-to-cite.md").read_text())


class Rules(unittest.TestCase):
    """The rules themselves, on planted faults."""

    def test_anchors(self):
        self.assertEqual(pages.slug("`barrera`: the color filter (sections II, III-A)"),
                         "barrera-the-color-filter-sections-ii-iii-a")
        self.assertEqual(pages.slug("[[target.other_color]]"), "targetother_color")
        self.assertEqual(pages.slug("It *is* here – now"), "it-is-here--now")
        self.assertEqual(pages.anchors("# A\n## B\n```\n# no heading\n```\n## B\n"), ["a", "b", "b_1"])

    def test_links(self):
        here = pages.DOCS / "window.md"
        self.assertEqual(pages.link_faults(here, "# T\n[a](calibration.md) [b](#t) [c](https://x.y/z) `[d](e.md)`"), [])
        self.assertEqual(pages.link_faults(here, "[a](nowhere.md)"), [
            "window.md: 'a' leads to nowhere.md, which does not exist"])
        self.assertEqual(pages.link_faults(here, "[a](calibration.md#nowhere)"), [
            "window.md: 'a' leads to calibration.md#nowhere, but calibration.md has no such heading"])
        self.assertEqual(pages.links("x\n\n    [in](code.md)\n\n![p](q.png)<img src=\"r.png\">"), [("p", "q.png"), ("", "r.png")])

    def test_navigation(self):
        self.assertEqual(pages.navigation("x: y.md\nnav:\n  - A: a.md\n  - B:\n      - C: d/e.md\n"), ["a.md", "d/e.md"])

    def test_words(self):
        self.assertEqual(pages.banned_words("One\nthe Verdict, `verdict`, *Show the verdict*\n"),
                         [(2, "Verdict", pages.BANNED[r"verdicts?"])])
        self.assertEqual(pages.banned_words("Hold it for a moment. See [x](verdict.md#moments)."), [])
        self.assertEqual([word for _, word, _ in pages.banned_words("moments; it is said; taken back, surely")],
                         ["moments", "surely", "taken back", "is said"])
        self.assertEqual(pages.banned_words("Its second moments are large."), [])

    def test_words_of_measured_tables_do_not_count(self):
        text = pages.without_tables("a thing\n<!-- table: x -->\n| a thing |\n<!-- /table -->\ntwo things\n")
        self.assertEqual([(number, word) for number, word, _ in pages.banned_words(text)], [(1, "thing"), (5, "things")])

    def test_code(self):
        text = "a\n\n    one\n    two\n\nb\n    not code\n```sh\nthree\n```\n"
        self.assertEqual(pages.code_lines(text), [(3, "one"), (4, "two"), (9, "three")])
        text = "1. a\n\n    of the item\n\n        code\n\nb\n\n    code\n"
        self.assertEqual(pages.code_lines(text), [(5, "code"), (9, "code")])
        self.assertEqual(pages.links("1. a\n\n    ![p](q.png)\n"), [("p", "q.png")])


if __name__ == "__main__":
    unittest.main()
