# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether script/manual makes the site, which needs no network. Arguments: the folder of the programs, and
the folder of the site."""
import json
import pathlib
import re
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402

PROGRAMS, SITE = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))


class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        done = subprocess.run([pages.ROOT / "script" / "manual", "--bin", PROGRAMS, "--out", SITE], capture_output=True, text=True)
        if done.returncode != 0:
            raise AssertionError(done.stderr)

    def test_every_page_is_there(self):
        for page in pages.navigation(pages.NAVIGATION.read_text()):
            made = SITE / re.sub(r"(README)?\.md$", lambda match: "index.html" if match.group(1) else ".html", page)
            self.assertTrue(made.is_file(), page)

    def test_nothing_comes_from_the_network(self):
        for page in SITE.rglob("*.html"):
            text = page.read_text()
            loaded = re.findall(r"<(?:script|img|iframe|source)\b[^>]*\bsrc=[\"']?(https?:[^\"' >]+)", text)
            loaded += re.findall(r"<link\b[^>]*\brel=[\"']?(?:stylesheet|preconnect|preload|icon)[^>]*\bhref=[\"']?(https?:[^\"' >]+)", text)
            self.assertEqual(loaded, [], page.name)
        for sheet in SITE.rglob("*.css"):
            self.assertNotRegex(sheet.read_text(), r"(@import|url\()\s*[\"']?https?:", sheet.name)

    def test_links_lead_to_headings(self):
        """Of a sample: the site makes the same anchors as the tests of the pages expect."""
        for name in ("calibration", "method-dewpoint", "project-file"):
            text = (SITE / f"{name}.html").read_text()
            ids = set(re.findall(r"<h[1-6] id=\"([^\"]+)\"", text))
            self.assertEqual(set(pages.anchors((pages.DOCS / f"{name}.md").read_text())) - ids, set())

    def test_search_works_without_a_server(self):
        index = json.loads((SITE / "search" / "search_index.json").read_text())
        titles = {entry["title"] for entry in index["docs"]}
        self.assertTrue({"Glossary", "Calibration", "Methods and their parameters"} <= titles)
        script = (SITE / "search" / "search_index.js").read_text()
        self.assertTrue(script.startswith("var __search = {index: Promise.resolve({"))
        self.assertTrue((SITE / "search" / "page_worker.js").is_file())
        self.assertIn("search/page_worker.js", (SITE / "index.html").read_text())

    def test_another_folder_is_not_replaced(self):
        other = SITE.parent / (SITE.name + "-other")
        other.mkdir(parents=True, exist_ok=True)
        (other / "thesis.txt").write_text("mine")
        done = subprocess.run([pages.ROOT / "script" / "manual", "--bin", PROGRAMS, "--out", other], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("holds something else than a manual", done.stderr)
        self.assertEqual((other / "thesis.txt").read_text(), "mine")


if __name__ == "__main__":
    unittest.main()
