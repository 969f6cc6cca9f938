# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash pieces` of a field: its plates are floes too."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


class Pieces(unittest.TestCase):
    def test_a_map_knows_no_floes_that_are_gone(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "floes.wkt").write_text("POLYGON ((0 0, 1 0, 0 1, 0 0))")
            said = subprocess.run([BRASH, "pieces", "floes.wkt", "--born"], cwd=folder, capture_output=True, text=True)
            self.assertEqual(said.returncode, 2)
            self.assertIn("floes.wkt: is a map, which knows no floes that are gone", said.stderr)
            self.assertIn("remedy:  leave --born out", said.stderr)

    def test_plates_of_a_field_are_counted_at_the_start_and_at_the_end(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "floes.wkt").write_text("MULTIPOLYGON (((10 -20, 40 -20, 40 20, 10 20, 10 -20)),"
                                            "((42 -3, 48 -3, 48 3, 42 3, 42 -3)))")
            subprocess.run([BRASH, "run", SOURCE / "tests/experiments/field-of-file.toml", "-o", path / "run", "--set",
                            f"field.file={path / 'floes.wkt'}", "--set", "time.duration=0.05", "--set",
                            "output.statistics_from=0"], check=True, capture_output=True)
            for options in ([], ["--born"]):
                said = subprocess.run([BRASH, "pieces", path / "run", "--json", *options], check=True,
                                      capture_output=True, text=True)
                sizes = json.loads(said.stdout)
                self.assertEqual(sizes["n"], 2)
                self.assertAlmostEqual(sizes["area"], 1200 + 36, delta=1e-6)


if __name__ == "__main__":
    unittest.main()
