# SPDX-License-Identifier: GPL-3.0-or-later
"""translations/rename_texts.py on a small tree: sources, catalogs, tests and pages change together, nothing else does."""
import pathlib
import shutil
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "translations"))
import rename_texts  # noqa: E402

CATALOG = """<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Parameter</name>
    <message>
        <source>How far it is off: more is worse &amp; slower.</source>
        <translation>Wie weit es daneben liegt: mehr ist schlechter &amp; langsamer.</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Panel</name>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message numerus="yes">
        <source>%n things</source>
        <translation>
            <numerusform>%n Ding</numerusform>
            <numerusform>%n Dinge</numerusform>
        </translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Wave</source>
        <translation>Schwenken</translation>
    </message>
</context>
<context>
    <name>dewpoint::ui::Other</name>
    <message>
        <source>Wave</source>
        <translation>Welle</translation>
    </message>
</context>
</TS>
"""

PANEL = """// "Wave" in a comment
void Panel::retranslate() {
  tab_->setText(tr("Wave"));
  tab_->setObjectName("Wave");
  undo_->setText(tr("Take back"));
  count_->setText(tr("%n "
                     "things",
                     nullptr, 3));
}
"""

TABLE = [
    {"old": "Take back", "new": "Undo", "de": "Rückgängig"},
    {"old": "%n things", "new": "%n objects", "de": ["%n Objekt", "%n Objekte"]},
    {"old": "Wave", "new": "Wand", "de": "Stab", "context": "dewpoint::ui::Panel"},
    {"old": "How far it is off: more is worse & slower.",
     "new": "Error of the position in \"meters\": larger values are worse, and they need more time as well."},
    {"old": "Nowhere to be found", "new": "Found"},
]


@unittest.skipUnless(shutil.which("clang-format"), "needs clang-format")
class RenameTexts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copy(ROOT / ".clang-format", self.root)
        self.put("translations/dewpoint_de.ts", CATALOG)
        self.put("ui/panel.cpp", PANEL)
        self.put("ui/other.cpp", 'void Other::retranslate() { setText(tr("Wave")); }\n')
        self.put("core/pose_parameters.cpp",
                 'const Declaration kError{"error",\n                         "How far it is off: "\n'
                 '                         "more is worse & slower."};\n')
        self.put("tests/panel_test.cpp", 'const char* kUndo = "Take back";\nconst char* kTab = "Wave";\n')
        self.put("tests/cli/panel_test.sh", "expect 'Take back' \"Take back all\"\n")
        self.put("docs/page.md", "Choose *Edit › Take\nback*, `Take back` or the tab *Wave*. Take back nothing.\n\n| Take back | Z |\n")
        self.report = list(rename_texts.Renamer(self.root, TABLE).run())

    def put(self, name, text):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def read(self, name):
        return (self.root / name).read_text(encoding="utf-8")

    def test_window(self):
        panel = self.read("ui/panel.cpp")
        self.assertIn('tab_->setText(tr("Wand"));', panel)
        self.assertIn('setObjectName("Wave")', panel)
        self.assertIn('// "Wave" in a comment', panel)
        self.assertIn('tr("Undo")', panel)
        self.assertIn('tr("%n objects", nullptr, 3)', panel)
        self.assertIn('tr("Wave")', self.read("ui/other.cpp"))

    def test_core_is_split_again(self):
        source = self.read("core/pose_parameters.cpp")
        self.assertTrue(all(len(line) <= 100 for line in source.split("\n")))
        self.assertEqual([text for _, _, text in rename_texts.literals(source)][1], TABLE[3]["new"])

    def test_catalog(self):
        before, after = CATALOG.split("\n"), self.read("translations/dewpoint_de.ts").split("\n")
        self.assertIn("        <source>Error of the position in &quot;meters&quot;: larger values are worse, "
                      "and they need more time as well.</source>", after)
        self.assertIn("            <numerusform>%n Objekte</numerusform>", after)
        self.assertEqual(after.count("        <source>Undo</source>"), 1)  # two texts became one
        self.assertEqual(after.count("        <source>Wave</source>"), 1)  # that of the other context
        self.assertIn("        <translation>Wie weit es daneben liegt: mehr ist schlechter &amp; langsamer.</translation>", after)
        self.assertEqual(len(before) - len(after), 4)

    def test_tests_and_pages(self):
        self.assertEqual(self.read("tests/panel_test.cpp"), 'const char* kUndo = "Undo";\nconst char* kTab = "Wave";\n')
        self.assertEqual(self.read("tests/cli/panel_test.sh"), "expect 'Undo' \"Take back all\"\n")
        self.assertEqual(self.read("docs/page.md"),
                         "Choose *Edit › Undo*, `Undo` or the tab *Wand*. Take back nothing.\n\n| Undo | Z |\n")

    def test_report(self):
        report = "\n".join(self.report)
        self.assertIn("not in the sources: 'Nowhere to be found'", report)
        self.assertIn("not in the catalogs: 'Nowhere to be found'", report)
        self.assertIn("look at tests/panel_test.cpp:2: 'Wave'", report)
        self.assertIn("old text remains: tests/cli/panel_test.sh: 'Take back'", report)
        self.assertIn("old text remains: docs/page.md: 'Take back'", report)
        self.assertNotIn("old text remains: ui", report)


if __name__ == "__main__":
    unittest.main()
