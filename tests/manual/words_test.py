# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the comments of public headers keep to the words of the glossary, as the pages do."""
import re
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402


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


class Words(unittest.TestCase):
    def test_headers_use_the_words_of_the_glossary(self):
        found = []
        for floor in ("core", "ui", "app"):
            for header in sorted((pages.ROOT / floor).rglob("*.h")):
                text = re.sub(r"^ *(?:///?)? ?", "", comments(header.read_text()), flags=re.M)
                found += faults(header.relative_to(pages.ROOT), text)
        self.assertEqual(found, [])


class Rules(unittest.TestCase):
    """The rules themselves, on planted faults."""

    def test_comments(self):
        self.assertEqual(comments('int a; // one\nf("// no"); /* two\nthree */ g();\n'), " one\n two\nthree \n")

    def test_faults(self):
        self.assertEqual(faults("a.h", comments("/// The verdict on `Verdict`.\nint verdict;\n")),
                         [f"a.h:1: 'verdict': {pages.BANNED[r'verdicts?']}"])


if __name__ == "__main__":
    unittest.main()
