# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the commands that the pages show exist: each program, command and option is one that --help lists,
and the quick ones run. Arguments: the folder of the programs, and an empty folder to run them in."""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
import pages  # noqa: E402
from program_help import Help  # noqa: E402

PROGRAMS, FOLDER = pathlib.Path(sys.argv.pop(1)), pathlib.Path(sys.argv.pop(1))
# Commands that run within seconds, on built-in scenes and files that commands before them wrote. Any command
# of the pages that begins so, and names all its files, is run as it stands.
QUICK = ("dewpoint-cli people --list", "dewpoint-cli suite --list", "dewpoint-cli experiment seeds",
         "dewpoint-cli calibration print-board chessboard", "dewpoint-cli calibration print-board charuco",
         "dewpoint-cli track demo --out", "dewpoint-cli evaluate out/demo/", "dewpoint-cli export out/demo")
PROGRAM = re.compile(r"(?:build/release/bin/)?(dewpoint-cli|dewpoint|[a-z_]+_bench)$|(script/[a-z]+)$")


def words_of(line):
    """The words of a command without its comment; brackets of what may be left out are no words."""
    line = re.sub(r"[\[\]|…]|\.\.\.", " ", re.sub(r"\s#.*$", "", line))
    try:
        return shlex.split(line)
    except ValueError:
        return line.split()


def commands_of(text):
    """(line number, command) of each command that a page shows, in blocks and within sentences."""
    found = []
    for number, line in pages.code_lines(text):
        line = re.sub(r"^\$ ", "", line.strip())
        found += [(number, part.strip()) for part in re.split(r"&&|;\s", line) if begins_command(part)]
    blocks = {number for number, _ in pages.code_lines(text)}
    for number, line in enumerate(text.split("\n"), 1):
        if number not in blocks:
            found += [(number, code) for code in re.findall(r"`([^`]+)`", line) if begins_command(code) and " " in code]
    return found


def begins_command(text):
    words = text.split()
    return bool(words) and PROGRAM.match(words[0]) is not None


def faults_of(command, asked):
    """Sentences about a command that no program has."""
    words = words_of(command)
    program = words[0].split("/")[-1]
    if words[0].startswith("script/"):
        file = pages.ROOT / words[0]
        text = file.read_text() if file.is_file() else ""
        options = [word for word in words[1:] if word.startswith("--")]
        return [f"{command}: {words[0]} has no {option}" for option in options if option not in text] + \
            ([] if text else [f"{command}: there is no {words[0]}"])
    if program.endswith("_bench"):
        return [] if list((pages.ROOT / "bench").rglob(f"{program}.cpp")) else [f"{command}: there is no {program}"]
    if not asked.has_program(program):
        return []  # built without the window
    path, rest = [program], words[1:]
    while asked.commands(*path) and rest:
        if rest[0] in asked.commands(*path):
            path.append(rest.pop(0))
        elif re.search(r"[A-Z]", rest[0]) or rest[0].startswith("-"):  # NAME, people-SCENE, --version
            break
        else:
            return [f"{command}: '{' '.join(path)}' has no command {rest[0]}"]
    known = asked.options(*path)
    if rest and re.search(r"[A-Z]", rest[0]):  # one of the commands below, whichever
        known = known.union(*(asked.options(*path, one) for one in asked.commands(*path)))
    used = [word.split("=")[0].rstrip(",") for word in rest if re.match(r"--?[a-zA-Z]", word)]
    return [f"{command}: '{' '.join(path)}' has no option {option}" for option in used if option not in known]


class Commands(unittest.TestCase):
    def test_pages_show_commands_that_exist(self):
        asked = Help(PROGRAMS)
        count = 0
        for page in pages.pages():
            faults = []
            for number, command in commands_of(page.read_text()):
                count += 1
                faults += [f"{page.name}:{number}: {fault}" for fault in faults_of(command, asked)]
            with self.subTest(page=page.name):
                self.assertEqual(faults, [])
        self.assertGreater(count, 80)

    def test_quick_commands_run(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        done = set()
        for page in pages.pages():
            for number, command in commands_of(page.read_text()):
                command = re.sub(r"\s+#.*$", "", command).replace("build/release/bin/", "")
                if not command.startswith(QUICK) or re.search(r"\[|[A-Z]{3}", command) or command in done:
                    continue
                done.add(command)
                words = shlex.split(command)
                run = subprocess.run([PROGRAMS / words[0], *words[1:]], cwd=FOLDER, capture_output=True, text=True)
                self.assertEqual(run.returncode, 0, f"{page.name}:{number}: {command}: {run.stderr}")
        self.assertGreaterEqual(len(done), 4, done)


class Rules(unittest.TestCase):
    """The rules themselves, on planted faults."""

    def test_commands_are_found(self):
        text = "Use `dewpoint-cli track demo` or `dewpoint`.\n\n    $ build/release/bin/dewpoint-cli plan X  # y\n    cd x && script/run\n"
        self.assertEqual(commands_of(text), [(3, "build/release/bin/dewpoint-cli plan X  # y"), (4, "script/run"),
                                             (1, "dewpoint-cli track demo")])

    def test_faults_are_found(self):
        asked = Help(PROGRAMS)
        self.assertEqual(faults_of("dewpoint-cli fly", asked), ["dewpoint-cli fly: 'dewpoint-cli' has no command fly"])
        self.assertEqual(faults_of("dewpoint-cli track demo --sed 1 # --x", asked),
                         ["dewpoint-cli track demo --sed 1 # --x: 'dewpoint-cli track' has no option --sed"])
        self.assertEqual(faults_of("dewpoint-cli calibrate wand P [--spoon]", asked),
                         ["dewpoint-cli calibrate wand P [--spoon]: 'dewpoint-cli calibrate wand' has no option --spoon"])
        self.assertEqual(faults_of("script/dance", asked), ["script/dance: there is no script/dance"])
        self.assertEqual(faults_of("dance_bench 1", asked), ["dance_bench 1: there is no dance_bench"])
        self.assertEqual(faults_of("dewpoint-cli track demo --out DIR [--seed K]", asked), [])


if __name__ == "__main__":
    unittest.main()
