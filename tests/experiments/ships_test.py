# SPDX-License-Identifier: GPL-3.0-or-later
"""The ship's experiments: recorded means follow from recorded rows."""
import csv
import math
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SHIPS = Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/ships"
sys.path.insert(0, str(SHIPS))
import run
import study


class Ships(unittest.TestCase):
    def test_recorded_means_and_the_page_follow_from_the_recorded_rows(self):
        page = " ".join((SHIPS / "README.md").read_text().split())
        for name, means in (("attained", run.attained_means), ("floe_sizes", run.floe_sizes_means)):
            table, remarks = means(study.read_rows(SHIPS / f"{name}.csv"))
            with open(SHIPS / f"{name}_means.csv", encoding="utf-8") as file:
                self.assertEqual(list(csv.DictReader(file)), table, name)
            self.assertIn(f"]({name}_means.csv)", page)
            for remark in remarks:
                self.assertIn(remark, page)

    def test_the_steady_speed_is_where_the_acceleration_vanishes(self):
        speed, lower, upper = run.steady_speed([1.0, 1.0, 3.0, 3.0], [0.011, 0.009, -0.011, -0.009])
        self.assertAlmostEqual(speed, 2.0, 12)
        # Residuals of 1 mm/s2 about a line of -10 mm/s2 to m/s, two degrees of freedom: 4.303 * 1.414 / sqrt(4) / 10.
        self.assertAlmostEqual(upper, 2.0 + 0.4303 * math.sqrt(2) / 2, 1)
        self.assertAlmostEqual(upper - 2.0, 2.0 - lower, 3)

    def test_a_study_goes_on_without_refused_cases_where_it_expects_them(self):
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder) / "brash"
            for code, may_fail, is_fine in ((0, False, True), (1, True, True), (1, False, False), (3, True, False)):
                program.write_text(f"#!/bin/sh\nexit {code}\n")
                program.chmod(0o755)
                try:
                    study.campaign(program, "plan.toml", Path(folder) / "none", may_fail=may_fail)
                    self.assertTrue(is_fine, code)
                except subprocess.CalledProcessError:
                    self.assertFalse(is_fine, code)

    def test_a_ride_is_taken_over_its_way_alone(self):
        with tempfile.TemporaryDirectory() as folder:
            times = [0.1 * i for i in range(400)]
            lines = ["time,structure_x,structure_vx"]
            lines += [f"{t},{-45.5 + 2.0 * t - 0.005 * t * t},{2.0 - 0.01 * t}" for t in times]
            (Path(folder) / "history.csv").write_text("\n".join(lines) + "\n")
            speed, acceleration = run.ride(Path(folder))
        self.assertAlmostEqual(acceleration, -0.01, 9)
        # 46 m after 24.5 s, 66 m after 36.3 s.
        self.assertAlmostEqual(speed, 2.0 - 0.01 * 0.5 * (24.5 + 36.3), 2)


if __name__ == "__main__":
    unittest.main()
