# SPDX-License-Identifier: GPL-3.0-or-later
"""The ship's experiments: recorded means follow from recorded rows, rows of unfinished campaigns, friction by ITTC."""
import csv
import json
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
        for name, means in (("speeds", run.speeds_means), ("attained", run.attained_means), ("floe_sizes", run.floe_sizes_means)):
            table, remarks = means(study.read_rows(SHIPS / f"{name}.csv"))
            with open(SHIPS / f"{name}_means.csv", encoding="utf-8") as file:
                self.assertEqual(list(csv.DictReader(file)), table, name)
            self.assertIn(f"]({name}_means.csv)", page)
            for remark in remarks:
                self.assertIn(remark, page)

    def test_exponents_are_those_of_a_power_law(self):
        rows = [{run.SPEED: speed, run.THICKNESS: thickness, "horizontal.mean": 1e5 * speed**0.4 * thickness**1.5}
                for speed in (0.2, 1.0, 2.0, 4.0) for thickness in (0.8, 1.2) for _ in range(3)]
        rows[0]["horizontal.mean"] = 9e9  # below the slowest speed
        rows.append({run.SPEED: 2.0, run.THICKNESS: 0.3, "horizontal.mean": 1e5 * 2.0**0.4 * 0.3**1.5})  # one run alone
        lines = run.exponent_lines(rows)
        self.assertEqual(lines[0], "Exponents over all settings: 0.40 ± 0.00 of the speed, 1.50 ± 0.00 of the thickness (19 runs).")
        self.assertEqual(lines[1], "Exponent of the speed at 0.8 m: 0.40 ± 0.00 (9 runs).")
        self.assertEqual(lines[3:], [f"Exponent of the thickness at {v} m/s: 1.50 ± 0.00 (6 runs)." for v in (1, 2, 4)])

    def test_the_interval_of_an_exponent_is_students(self):
        rows = [{run.SPEED: math.exp(x), "horizontal.mean": math.exp(y)} for x, y in ((0, 0), (1, 1.5), (2, 1.5), (3, 3))]
        [(slope, half)] = run.exponents(rows, [run.SPEED])
        # Residuals -0.15, 0.45, -0.45, 0.15 about 0.15 + 0.9 x; the speeds' sum of squares is 5.
        self.assertAlmostEqual(slope, 0.9, 12)
        self.assertAlmostEqual(half, 4.30265 * math.sqrt(0.45 / 2 / 5), 4)

    def test_the_steady_speed_is_where_the_acceleration_vanishes(self):
        speed, lower, upper = run.steady_speed([1.0, 1.0, 3.0, 3.0], [0.011, 0.009, -0.011, -0.009])
        self.assertAlmostEqual(speed, 2.0, 12)
        # Residuals of 1 mm/s2 about a line of -10 mm/s2 to m/s, two degrees of freedom: 4.303 * 1.414 / sqrt(4) / 10.
        self.assertAlmostEqual(upper, 2.0 + 0.4303 * math.sqrt(2) / 2, 1)
        self.assertAlmostEqual(upper - 2.0, 2.0 - lower, 3)

    def test_the_towed_ship_needs_the_thrust_on_the_rising_branch(self):
        rows = [{run.SPEED: speed, run.THICKNESS: 0.8, "horizontal.mean": load}
                for speed, load in ((0.2, 390e3), (1.0, 300e3), (2.0, 380e3), (4.0, 500e3))]
        # 320 kN at 1 m/s and 420 kN at 2 m/s with the damping.
        self.assertAlmostEqual(run.towed_speed(rows), 1.8, 12)

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

    def test_friction_of_open_water_is_that_of_ittc_1957(self):
        ship = {"length": 100.0, "breadth": 20.0, "draught": 5.0}
        speed = 1e9 * run.VISCOSITY / 100.0  # Re = 1e9, where C_F = 0.075 / 7^2
        wetted = 1.7 * 500.0 + 0.6 * 100.0 * 20.0
        self.assertAlmostEqual(run.open_water_friction(ship, speed, 1000.0) / (500.0 * speed**2 * wetted), 0.075 / 49, 12)

    def test_an_unfinished_campaign_has_a_row_for_each_finished_case(self):
        with tempfile.TemporaryDirectory() as folder:
            output, label = Path(folder), "speed-2.0_thickness-0.3"
            (output / "settings").mkdir()
            (output / "settings" / f"icebreaker_{label}.toml").write_text("[structure]\nspeed = 2.0\n[ice]\nthickness = 0.3\n")
            for replicate in (0, 1):
                (output / "cases" / f"{label}-r000{replicate}").mkdir(parents=True)
            summary = {"horizontal": {"mean": 5.0, "standard_deviation": 1.0, "quantile_99": 7.0,
                                      "mean_by_cause": {"crushing": 1.0, "floe_normal": 3.0, "floe_friction": 1.0}},
                       "vertical": {"mean": 2.0}, "mean_by_region": {"bow": {"total": {"Fx": 4.0}}}, "n_breaks": 3,
                       "n_floes_broken": 0, "breaking_length_quantiles": [1, 2, 3, 4, 5], "piece_area_quantiles": [6, 7, 8, 9, 10]}
            (output / "cases" / f"{label}-r0001" / "summary.json").write_text(json.dumps(summary))
            rows = run.rows_of(output, "speeds")
        self.assertEqual([row["case"] for row in rows], [f"{label}-r0001"])
        expected = {"replicate": 1.0, run.SPEED: 2.0, run.THICKNESS: 0.3, "horizontal.mean": 5.0, "n_breaks": 3.0,
                    "mean_by_region.bow.total.Fx": 4.0, "mean_by_region.stern.total.Fx": 0.0,
                    "breaking_length_quantiles.50": 3.0, "piece_area_quantiles.50": 8.0}
        self.assertEqual({key: rows[0][key] for key in expected}, expected)
        self.assertFalse(any(math.isnan(value) for value in rows[0].values() if isinstance(value, float)))


if __name__ == "__main__":
    unittest.main()
