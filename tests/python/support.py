# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of the Python package share."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCES = pathlib.Path(__file__).resolve().parents[2]
CLI = os.environ["DEWPOINT_CLI"]


def run_cli(*arguments):
    """The finished command line; its texts in stdout and stderr."""
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, check=False)


def cli(*arguments):
    """The same, which has to do its work."""
    done = run_cli(*arguments)
    if done.returncode != 0:
        raise AssertionError(f"dewpoint-cli {arguments}: {done.stderr}")
    return done


class InFolder(unittest.TestCase):
    """Tests that run in an empty folder of their own."""

    def setUp(self):
        before = os.getcwd()
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.chdir(folder.name)
        self.addCleanup(os.chdir, before)  # first of the two
