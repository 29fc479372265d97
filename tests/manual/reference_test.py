# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the pages that are made from declarations have all of them: every parameter, command, option,
format and action. What there is, is found another way than by the pages: from messages and help of the
programs, and from the list of actions in the sources. Argument: the folder of the programs."""
import pathlib
import re
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402
from program_help import Help, output_of  # noqa: E402

PROGRAMS = pathlib.Path(sys.argv.pop(1))


def said(program, *arguments):
    return output_of(PROGRAMS / program, *arguments)


def page(name):
    return said("dewpoint-cli", "reference", name)


def section(text, heading):
    """What stands below a heading, up to the next one of its level."""
    level = heading.split(" ")[0]
    found = re.search(rf"^{re.escape(heading)}\n(.*?)(?=^#{{1,{len(level)}}} |\Z)", text, re.M | re.S)
    return found.group(1) if found else ""


class Reference(unittest.TestCase):
    def test_every_parameter_of_every_method(self):
        text = page("methods")
        methods = re.search(r"--method TEXT:\{([^}]*)\}", said("dewpoint-cli", "track", "--help")).group(1).split(",")
        methods += re.search(r"--method TEXT:\{([^}]*)\}", said("dewpoint-cli", "people", "--help")).group(1).split(",")
        self.assertIn("people", methods)
        for method in methods:
            of_people = "people" in method or "mohedano" in method
            # The message about an unknown key lists those that there are.
            command = ("people", "office") if of_people else ("track", "demo")
            message = said("dewpoint-cli", *command, "--out", "none", "--method", method, "--set", "nothing=1")
            known = re.search(r"known are ([a-z0-9_, ]+)", message)
            self.assertIsNotNone(known, message)
            keys = known.group(1).split(", ")
            rows = re.findall(r"^\| `([a-z0-9_]+)` \|(.*)\|$", section(text, f"### {method}"), re.M)
            self.assertEqual([key for key, _ in rows], keys, method)
            for key, cells in rows:
                label, group, _, span, value, meaning = [cell.strip() for cell in cells.split(" | ")]
                self.assertTrue(label and group and value and meaning, f"{method} {key}: {cells}")
                self.assertRegex(span, r"^(whole number, )?-?[\d.e+-]+ to -?[\d.e+-]+$")

    def test_every_command_and_option(self):
        text, asked = page("commands"), Help(PROGRAMS)
        paths = [["dewpoint-cli"]]
        for path in paths:
            paths += [[*path, name] for name in asked.commands(*path)]
        self.assertGreater(len(paths), 40)
        for path in paths[1:]:
            words = " ".join(path[1:])
            here = section(text, f"## {words}")
            if not here:  # another name of a command
                self.assertIn(f"`{path[-1]}`", text, words)
                continue
            for option in asked.options(*path) - {"--help", "-h"}:
                self.assertIn(option, here, f"{words} {option}")

    def test_every_format(self):
        text = page("formats")
        exports = said("dewpoint-cli", "export", "--help")
        formats = re.search(r"--format TEXT:\{([^}]*)\}", exports)
        names = formats.group(1).split(",") if formats else ["csv", "csv-wide", "tum", "trc", "c3d", "npz", "vtp", "pvd", "jsonl"]
        # The page on calibration lists the tools.
        tools = re.findall(r"^\| `([a-z0-9-]+)` \| ", section((pages.DOCS / "calibration.md").read_text(), "## Files of other tools"), re.M)
        self.assertGreater(len(tools), 10)
        for name in names:
            self.assertIn(f"| `{name}` |", section(text, "## Trajectories"))
        self.assertEqual(sorted(re.findall(r"^\| `([a-z0-9-]+)` \|", section(text, "## Calibrations"), re.M)), sorted(tools))

    def test_every_action(self):
        if not (PROGRAMS / "dewpoint").is_file():
            self.skipTest("built without the window")
        text = said("dewpoint", "--list-actions")
        names = re.findall(r'^    "(action[A-Za-z]+)",$', (pages.ROOT / "ui" / "actions" / "action_id.h").read_text(), re.M)
        rows = re.findall(r"^\| ([^|]+) \| ([^|]*) \| ([^|]+) \|$", text, re.M)
        rows = [row for row in rows if row[0] not in ("action", "---")]
        self.assertEqual(len(rows), len(names))
        self.assertIn("| Play | `Space` | Play or pause |", text)
        self.assertIn("## Calibration\n", text)


if __name__ == "__main__":
    unittest.main()
