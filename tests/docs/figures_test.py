# SPDX-License-Identifier: GPL-3.0-or-later
"""The script of the figures draws every figure that a theory page shows: figures_test.py, with `brash` on PYTHONPATH."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

THEORY = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "docs/theory"


class Figures(unittest.TestCase):
    def test_the_script_draws_each_figure_that_a_page_shows(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-B", THEORY / "figures/draw.py", folder], check=True)
            drawn = {path.name for path in pathlib.Path(folder).iterdir()}
            for name in drawn:
                self.assertTrue(xml.etree.ElementTree.parse(pathlib.Path(folder) / name).getroot().tag.endswith("svg"))
        shown = {name for page in THEORY.glob("*.md") for name in re.findall(r"\(figures/([^)]*)\)", page.read_text())}
        self.assertEqual(shown - {"trapezoid-fit.svg"}, drawn)
        self.assertEqual({path.name for path in (THEORY / "figures").glob("*.svg")}, shown)


if __name__ == "__main__":
    unittest.main()
