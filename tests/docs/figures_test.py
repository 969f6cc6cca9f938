# SPDX-License-Identifier: GPL-3.0-or-later
"""The scripts of the figures draw what the pages show: figures_test.py, with `brash` on PYTHONPATH."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

DOCS = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "docs"
THEORY = DOCS / "theory"


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

    def test_each_number_on_the_pictures_of_one_run_is_explained_below_its_picture(self):
        script = (DOCS / "figures/one_run.mjs").read_text(encoding="utf-8")
        page = (DOCS / "one-run-explained.md").read_text(encoding="utf-8")
        drawn = {name: re.findall(r'\[(\d+), "', marks)
                 for name, marks in re.findall(r'"(one-run-\w+)": \{(.*?)\n  \}', script, re.DOTALL)}
        explained = {name: re.findall(r"^- \*\*(\d+)\.\*\*", text, re.MULTILINE)
                     for name, text in re.findall(r"\(figures/([\w-]+)\.png\)(.*?)(?=\n!\[|\Z)", page, re.DOTALL)}
        self.assertEqual(drawn, explained)
        self.assertEqual(sum(drawn.values(), []), [str(n) for n in range(1, 14)])


if __name__ == "__main__":
    unittest.main()
