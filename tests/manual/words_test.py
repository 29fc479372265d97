# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the comments of public headers and the texts of the programs keep to the words of the glossary, as the pages
do."""
import html
import re
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402

sys.path.insert(0, str(pages.ROOT / "translations"))
import rename_texts  # noqa: E402

# Texts with a banned word that stays: (file, text) and the reason.
KEPT = {}
# Names that users write in scripts and projects: options and keys. They stay as they are.
NAME = r"(?<![\w-])--?\w[\w-]*|\b[a-z]+(?:_[a-z]+)+\b"


def comments(code):
    """The code with nothing but line ends in place of what is not a comment: `//` to the end of its line, and `/* */`."""
    found, end = [], 0
    # A text between quotation marks may hold what looks like a comment.
    for match in re.finditer(r'"(?:\\.|[^"\\\n])*"|//([^\n]*)|/\*(.*?)\*/', code, re.S):
        found.append(re.sub(r"[^\n]", "", code[end:match.start()]))
        found.append(match.group(1) or re.sub(r"[^\n]", "", match.group(0)) if match.group(2) is None else match.group(2))
        end = match.end()
    return "".join(found) + re.sub(r"[^\n]", "", code[end:])


def faults(name, text):
    return [f"{name}:{number}: '{word}': {better}" for number, word, better in pages.banned_words(text)]


def text_faults(name, source):
    """The faults of the C++ texts of a source file; names of options, keys and included files are left out."""
    found = []
    for start, _, text in rename_texts.literals(source):
        is_name = source[:start].rstrip(" <").endswith("#include") or text is None or (name, text) in KEPT
        if not is_name:
            line = source.count("\n", 0, start) + 1
            words = re.sub(NAME, "", text).replace("\n", " ")
            found += [fault.replace(f"{name}:1:", f"{name}:{line}:", 1) for fault in faults(name, words)]
    return found


def catalog_faults(name, catalog):
    """The faults of the English texts of a catalog of translations."""
    found = []
    for source in re.findall(r"<source>(.*?)</source>", catalog, re.S):
        text = html.unescape(source)
        if (name, text) not in KEPT:
            found += [f"{name}: {text!r}: '{word}': {better}" for _, word, better in pages.banned_words(text)]
    return found


class Words(unittest.TestCase):
    def test_headers_use_the_words_of_the_glossary(self):
        found = []
        for floor in ("core", "ui", "app"):
            for header in sorted((pages.ROOT / floor).rglob("*.h")):
                text = re.sub(r"^ *(?:///?)? ?", "", comments(header.read_text()), flags=re.M)
                found += faults(header.relative_to(pages.ROOT), text)
        self.assertEqual(found, [])

    def test_texts_of_programs_use_the_words_of_the_glossary(self):
        found = []
        for folder in ("app/dewpoint-cli", "app/python"):
            for file in sorted((pages.ROOT / folder).rglob("*.cpp")):
                found += text_faults(str(file.relative_to(pages.ROOT)), file.read_text())
        self.assertEqual(found, [])

    def test_texts_of_the_window_use_the_words_of_the_glossary(self):
        # The German catalog has all texts, the English one only those with numbers.
        for name in ("translations/dewpoint_de.ts", "translations/dewpoint_en.ts"):
            self.assertEqual(catalog_faults(name, (pages.ROOT / name).read_text()), [])

    def test_exceptions_are_needed(self):
        """Each text of KEPT still exists where it is said to be."""
        for file, text in KEPT:
            source = (pages.ROOT / file).read_text()
            texts = [html.unescape(one) for one in re.findall(r"<source>(.*?)</source>", source, re.S)]
            texts += [one for _, _, one in rename_texts.literals(source)] if not file.endswith(".ts") else []
            self.assertIn(text, texts, file)


class Rules(unittest.TestCase):
    """The rules themselves, on planted faults."""

    def test_comments(self):
        self.assertEqual(comments('int a; // one\nf("// no"); /* two\nthree */ g();\n'), " one\n two\nthree \n")

    def test_faults(self):
        self.assertEqual(faults("a.h", comments("/// The verdict on `Verdict`.\nint verdict;\n")),
                         [f"a.h:1: 'verdict': {pages.BANNED[r'verdicts?']}"])

    def test_texts(self):
        source = ('#include "app/twin.h"\n// A twin.\nf("The --look-alikes and look_alikes",\n  "two"\n  " look-alikes");\n'
                  'g("Verdict: {}\\n");\n')
        self.assertEqual(text_faults("a.cpp", source),
                         [f"a.cpp:4: 'look-alikes': {pages.BANNED[r'look-?alikes?']}",
                          f"a.cpp:6: 'Verdict': {pages.BANNED[r'verdicts?']}"])
        KEPT[("a.cpp", "Verdict: {}\n")] = "a planted exception"
        try:
            self.assertEqual(len(text_faults("a.cpp", source)), 1)
            self.assertEqual(len(text_faults("b.cpp", source)), 2)
        finally:
            del KEPT[("a.cpp", "Verdict: {}\n")]

    def test_catalogs(self):
        catalog = "<source>The verdict &amp;\nmore</source><translation>Twin</translation>\n<source>Fine</source>"
        self.assertEqual(catalog_faults("a.ts", catalog),
                         [f"a.ts: 'The verdict &\\nmore': 'verdict': {pages.BANNED[r'verdicts?']}"])


if __name__ == "__main__":
    unittest.main()
