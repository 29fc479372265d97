# SPDX-License-Identifier: GPL-3.0-or-later
"""The notebook of the documentation runs from its first cell to its last.

Its code cells run one after the other in one namespace, as a kernel would run them: nothing of
Jupyter is needed. Without Matplotlib it prints numbers instead of drawing.
"""

import contextlib
import importlib.util
import io
import json
import os
import pathlib
import unittest

import dewpoint
from support import CLI, SOURCES, InFolder

NOTEBOOK = SOURCES / "docs" / "examples" / "two_videos.ipynb"


class Notebook(InFolder):
    def setUp(self):
        super().setUp()
        path = os.environ["PATH"]
        os.environ["PATH"] = os.pathsep.join([str(pathlib.Path(CLI).parent), path])
        self.addCleanup(os.environ.update, PATH=path)

    def test_all_cells_run(self):
        notebook = json.loads(NOTEBOOK.read_text(encoding="utf-8"))
        self.assertEqual(notebook["nbformat"], 4)
        names = {}
        with contextlib.redirect_stdout(io.StringIO()) as said:
            for cell in notebook["cells"]:
                self.assertEqual(cell.get("outputs", []), [], "results are not kept in the file")
                if cell["cell_type"] == "code":
                    exec(compile("".join(cell["source"]), cell["id"], "exec"), names)
        self.assertIn("root mean square error", said.getvalue())
        self.assertLess(names["found"].rmse, 0.01)
        if importlib.util.find_spec("matplotlib"):
            self.assertTrue(pathlib.Path("path.png").exists())
        self.assertEqual(dewpoint.open("two_videos.toml").targets[0].name, "pink ball")


if __name__ == "__main__":
    unittest.main()
