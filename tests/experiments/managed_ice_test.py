# SPDX-License-Identifier: GPL-3.0-or-later
"""The analysis of experiments/managed_ice against closed forms."""
import os
import sys
import tomllib
import unittest
from pathlib import Path

import numpy as np

ROOT = Path(os.environ["BRASH_SOURCE_DIR"])
FOLDER = ROOT / "experiments" / "managed_ice"
sys.path[:0] = [str(FOLDER), str(FOLDER.parent)]
import mooring
import study
import surge
import verdicts

LINES = [[212, 212, -60, 6, 6, -1, 305, 2e3, 7e8], [-212, 212, -60, -6, 6, -1, 305, 2e3, 7e8],
         [-212, -212, -60, -6, -6, -1, 305, 2e3, 7e8], [212, -212, -60, 6, -6, -1, 305, 2e3, 7e8]]
CASE = {"structure": {"motion": {"lines": LINES}}}


class Mooring(unittest.TestCase):
    def test_the_pull_of_the_lines_is_the_slope_of_their_energy(self):
        x, step = np.array([-4.0, -1.0, 0.0, 2.0]), 1e-2
        places = np.array([[at, 0.3, 0.1] for at in np.concatenate([x - step, x, x + step])])
        held = mooring.Mooring(places, np.zeros_like(places), 0.0, np.array(LINES, dtype=float))
        before, _, after = held.energy.reshape(3, -1)
        # The energy is summed over 4000 pieces of a line and differs over 2 cm.
        np.testing.assert_allclose(held.pull.reshape(3, -1)[1], -(after - before) / (2 * step), rtol=1e-3, atol=100.0)

    def test_lines_hold_against_a_way_to_either_side(self):
        self.assertGreater(mooring.surge_stiffness(CASE), 0.0)
        self.assertAlmostEqual(mooring.surge_stiffness(CASE, 0.05) / mooring.surge_stiffness(CASE, 0.1), 1.0, places=3)


class Surge(unittest.TestCase):
    def test_a_steady_load_swings_the_oscillator_about_its_static_way(self):
        period, damping, stiffness, load, dt = 20.0, 4e4, 1.4e5, 3e5, 0.02
        mass = stiffness * (period / (2 * np.pi)) ** 2
        time = np.arange(5000) * dt
        decay, natural = damping / (2 * mass), 2 * np.pi / period
        damped = np.sqrt(natural**2 - decay**2)
        exact = load / stiffness * (1 - np.exp(-decay * time) * (np.cos(damped * time) + decay / damped * np.sin(damped * time)))
        found = surge.oscillator(np.full(len(time), load), dt, period, damping, stiffness)
        np.testing.assert_allclose(found, exact, atol=1e-9 * load / stiffness)

    def test_pooled_bands_hold_the_density_of_white_noise(self):
        random, dt = np.random.default_rng(1), 0.1
        frequency, density, lower, upper = surge.pooled_spectrum(
            study.brash_module(), [random.standard_normal(4000) for _ in range(20)], dt, 40.0)
        inner = slice(2, -2)
        within = (lower[inner] <= 2 * dt) & (2 * dt <= upper[inner])
        # 95 % of 197 lines that are nearly independent: 0.95 with a deviation of 0.02.
        self.assertGreater(within.mean(), 0.88)
        self.assertAlmostEqual(density[inner].mean() / (2 * dt), 1.0, delta=0.03)
        self.assertAlmostEqual(frequency[1], 1 / 40.0)


class Verdicts(unittest.TestCase):
    def rows(self, slope):
        settings = ((1.0, 10.0), (0.5, 10.0), (1.5, 10.0), (1.0, 7.0), (1.0, 14.0))
        return [{"ice.thickness": h, "field.size.median": size, "horizontal.mean": 1e5 * offset + i,
                 "mean_offset": offset + 1e-6 * i}
                for h, size in settings for offset in [2 + slope * (h - 1 + (size - 10) / 10)] for i in range(5)]

    def test_only_rising_results_meet_the_trends(self):
        self.assertTrue(all(row["met"] for row in verdicts.trends(self.rows(1.0), 0.05)))
        self.assertFalse(any(row["met"] for row in verdicts.trends(self.rows(-1.0), 0.05)))

    def test_the_highest_line_is_compared_with_the_natural_period(self):
        frequency = np.arange(10) * 0.01
        spectra = {"offset": (frequency, np.where(np.arange(10) == 6, 2.0, 1.0))}
        self.assertTrue(verdicts.resonance(spectra, 20.0, 1)["met"])
        self.assertFalse(verdicts.resonance(spectra, 40.0, 1)["met"])

    def test_recorded_rows_meet_what_verdicts_says(self):
        criteria = tomllib.loads((FOLDER / "criteria.toml").read_text(encoding="utf-8"))
        rows = study.read_rows(FOLDER / "recorded.csv")
        twenty = [row for row in rows if row["plan"] == "twenty"]
        self.assertEqual(len(twenty), 20)
        found = verdicts.trends(rows, criteria["trends"]["level"]) + [
            verdicts.precision(twenty, criteria["precision"]["half_width"]),
            verdicts.balance(rows, criteria["balance"]["share"]),
            verdicts.oscillator(twenty, criteria["oscillator"]["share"])]
        known = {row["criterion"]: (row["found"], row["met"]) for row in study.read_rows(FOLDER / "verdicts.csv")}
        for row in found:
            self.assertEqual(known[row["criterion"]], (row["found"], str(row["met"])))


if __name__ == "__main__":
    unittest.main()
