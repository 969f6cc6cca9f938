# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads whose larger end is the lower one: an ice sheet that is bent up pushes the structure down."""
import csv
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
UPWARD = ["structure.breaking=upward", "failure.model=wedge", "field.initial_crack=false", "output.statistics_from=0.5",
          "time.duration=3"]


class LowerEnd(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.folder = pathlib.Path(scratch.name)
        sets = [part for change in UPWARD for part in ("--set", change)]
        cls.table = cls.brash("run", SOURCE / "experiments/validation/cone.toml", *sets, "-o", "up")
        cls.summary = json.loads((cls.folder / "up/summary.json").read_text())
        with open(cls.folder / "up/history.csv", newline="", encoding="utf-8") as file:
            rows = [(float(row["time"]), float(row["Fz"])) for row in csv.DictReader(file)]
        cls.whole = [load for _, load in rows]
        cls.window = sorted(load for time, load in rows if time > 0.5)

    @classmethod
    def brash(cls, *arguments):
        done = subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, cwd=cls.folder)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def quantile(self, level):
        """Hyndman and Fan's type 7."""
        place = level * (len(self.window) - 1)
        i = int(place)
        return self.window[i] + (place - i) * (self.window[min(i + 1, len(self.window) - 1)] - self.window[i])

    def test_the_summary_has_both_ends(self):
        vertical = self.summary["vertical"]
        self.assertLess(vertical["mean"], 0.0)
        for level, key in ((0.01, "quantile_1"), (0.99, "quantile_99")):
            self.assertAlmostEqual(vertical[key], self.quantile(level), delta=1e-9 * abs(vertical["minimum"]))
        self.assertEqual(self.summary["minimum_whole_history"]["vertical"], min(self.whole))

    def test_the_table_of_a_run_shows_the_end_of_the_larger_loads(self):
        row = next(line for line in self.table.splitlines() if line.startswith("  vertical"))
        shown = row.replace("[no interval]", "").split()
        self.assertEqual(shown[4:6], [f"{self.quantile(0.01) / 1e3:.1f}", f"{self.window[0] / 1e3:.1f}"])
        self.assertIn("note: 99 % and max of a negative load are of its lower end", self.table)
        self.assertIn(f" horizontal, {min(self.whole) / 1e3:.1f} vertical\n", self.table)

    def test_stats_and_compare_show_both_ends(self):
        said = self.brash("stats", "up", "--column", "Fz")
        self.assertIn(f"  1, 50, 95, 99 %      {self.quantile(0.01):.6g} ", said)
        lines = self.brash("compare", "up", "up", "--column", "Fz").splitlines()
        numbers = {line[:19].strip(): line[19:].split() for line in lines}
        self.assertEqual(numbers["1 %"], 2 * [f"{self.quantile(0.01):.6g}"])
        self.assertEqual(numbers["minimum"], 2 * [f"{self.window[0]:.6g}"])
        upward = self.brash("compare", "up", "up", "--column", "Fx")
        self.assertNotIn("minimum", upward)


if __name__ == "__main__":
    unittest.main()
