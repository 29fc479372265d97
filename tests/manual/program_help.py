# SPDX-License-Identifier: GPL-3.0-or-later
"""What the programs say of their commands and options."""
import os
import re
import subprocess
import tempfile


def output_of(program, *arguments):
    """Everything that a program prints. It has no settings of the user."""
    with tempfile.TemporaryDirectory() as settings:
        done = subprocess.run([program, *arguments], capture_output=True, text=True,
                              env=dict(os.environ, XDG_CONFIG_HOME=settings, QT_QPA_PLATFORM="offscreen"))
    return done.stdout + done.stderr


class Help:
    """The help of the programs in a folder, each text asked for once."""

    def __init__(self, folder):
        self.folder = folder
        self.texts = {}

    def of(self, program, *commands):
        key = (program, *commands)
        if key not in self.texts:
            self.texts[key] = output_of(self.folder / program, *commands, "--help")
        return self.texts[key]

    def has_program(self, program):
        return (self.folder / program).is_file()

    def commands(self, *path):
        """The commands below one of dewpoint-cli, by their names and other names."""
        text = self.of(*path)
        below = text.split("\nSubcommands:\n", 1)
        names = re.findall(r"^  (\S[^\n]*?)(?:  |$)", below[1], re.M) if len(below) > 1 else []
        return [name.strip() for line in names for name in line.split(",")]

    def options(self, *path):
        return set(re.findall(r"(?<![\w-])--?[a-zA-Z][\w-]*", self.of(*path))) | {"--help"}
