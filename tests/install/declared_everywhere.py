#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Every command and option that --help shows is in the manual page and in the completions.

Usage: declared_everywhere.py PROGRAM MAN-PAGE BASH ZSH FISH
"""
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

program, *files = sys.argv[1:]
man, bash, zsh, fish = (Path(file).read_text(encoding="utf-8") for file in files)
man = re.sub(r"\\f[BRI]", "", man).replace("\\-", "-")
name = Path(program).name
function = "_" + re.sub(r"\W", "_", name)
environment = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}


def expect(holds, sentence):
    if not holds:
        sys.exit(f"FAILED: {sentence}")


def read_help(path):
    """The long options and the commands that --help shows for a command, without a display."""
    text = subprocess.run([program, *path, "--help"], env=environment, check=True, capture_output=True, text=True).stdout
    commands = re.search(r"^Subcommands:\n((?:  .*\n)*)", text, re.M)
    return (set(re.findall(r"^ {2,4}(?:-\w,)?(--[\w-]+)", text, re.M)),
            set(re.findall(r"^  ([a-z][\w-]*)", commands[1], re.M)) if commands else set())


def all_commands(path=()):
    options, commands = read_help(path)
    yield path, options, commands
    for command in sorted(commands):
        yield from all_commands((*path, command))


def section(path):
    """The part of the manual page about a command."""
    title = f".SS {' '.join(path)}\n" if path else ".SH OPTIONS\n"
    parts = man.split(title)
    expect(len(parts) == 2, f"the manual page has no part about '{' '.join(path) or name}'")
    return re.split(r"^\.S[SH] ", parts[1], flags=re.M)[0]


def zsh_function(path):
    start = f"\n{'_'.join(('_' + name, *path))}() {{\n"
    expect(start in zsh, f"zsh does not know '{' '.join(path)}'")
    return zsh.split(start)[1].split("\n}\n")[0]


def complete_in_bash(lines):
    """What bash offers for the last word of each line: one process for all."""
    script = bash + "".join(
        f"COMP_WORDS=({' '.join(map(shlex.quote, words))}) COMP_CWORD={len(words) - 1}\n"
        f'{function}\necho "${{COMPREPLY[*]}}"\n' for words in lines)
    said = subprocess.run(["bash", "--norc"], input=script, check=True, capture_output=True, text=True).stdout
    return [set(line.split()) for line in said.splitlines()]


found = list(all_commands())
expect(len(found) > 20 or name == "dewpoint", "--help shows too few commands")
offered = complete_in_bash([[name, *path, word] for path, _, _ in found for word in ("--", "")])
for index, (path, options, commands) in enumerate(found):
    whole = " ".join((name, *path))
    condition = " ".join((f"_{function}_is_at", *path))
    rows = "".join(row for row in fish.splitlines(True) if f"-n '{condition}'" in row)
    page = section(path)
    zsh_part = zsh_function(path)
    expect("--help" in options, f"'{whole}' shows no options")
    expect(offered[2 * index] == options, f"bash offers {offered[2 * index] ^ options} for '{whole} --'")
    expect(offered[2 * index + 1] == commands, f"bash offers {offered[2 * index + 1] ^ commands} for '{whole}'")
    for option in options:
        expect(re.search(rf"(^|, ){option}( |$)", page, re.M), f"the manual page lacks {option} of '{whole}'")
        expect(f"{option}[" in zsh_part, f"zsh lacks {option} of '{whole}'")
        expect(f" -l {option[2:]} " in rows, f"fish lacks {option} of '{whole}'")
    for command in commands:
        expect(f"{command}) " in zsh_part, f"zsh lacks '{whole} {command}'")
        expect(f" -fa {command} " in rows, f"fish lacks '{whole} {command}'")
print(f"{name}: {len(found)} commands, {sum(len(options) for _, options, _ in found)} options")
