# SPDX-License-Identifier: GPL-3.0-or-later
"""experiments/return_levels: the script's variants of a campaign whose peaks are exponential, and the numbers that are recorded."""
import csv
import importlib.util
import json
import math
import os
import pathlib
import random
import tempfile
import unittest

FOLDER = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/return_levels"
SPEC = importlib.util.spec_from_file_location("levels", FOLDER / "levels.py")
levels = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(levels)

EXCESS = {0.4: 40.0, 0.6: 60.0, 0.8: 80.0}  # thickness, mean excess of the peaks above 100
CYCLES, REPLICATES = 300, 4


def history(excess, generator):
    """A load that rises straight to an exponential peak in each second."""
    lines = ["time [s],Fx [N]"]
    for cycle in range(CYCLES):
        peak = 100.0 + generator.expovariate(1.0 / excess)
        lines += [f"{cycle + i / 10:.1f},{20.0 + (peak - 20.0) * i / 10:.4f}" for i in range(1, 11)]
    return "\n".join(lines) + "\n"


def write_campaign(folder):
    generator, rows = random.Random(11), ["case,setting,replicate,status"]
    for thickness, excess in EXCESS.items():
        for replicate in range(REPLICATES):
            run = folder / "cases" / f"thickness-{thickness}m-r{replicate:04d}"
            run.mkdir(parents=True)
            (run / "history.csv").write_text(history(excess, generator))
            (run / "summary.json").write_text('{"statistics_from": 0.0}')
            rows.append(f"{run.name},thickness-{thickness}m,{replicate},done")
    (folder / "campaign.csv").write_text("\n".join(rows) + "\n")
    settings = [{"setting": f"thickness-{t}m", "values": {"ice.thickness": t}} for t in EXCESS]
    (folder / "summary.json").write_text(json.dumps({"settings": settings}))


class Levels(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as place:
            write_campaign(pathlib.Path(place))
            cls.found = list(levels.variants(pathlib.Path(place)))

    def test_the_levels_of_known_peaks_are_within_their_intervals(self):
        hours = {float(row["ice.thickness"]): float(row["hours"]) for row in levels.rows_of(FOLDER / "states.csv")}
        for level in self.found[0][1]["annual"]:
            low, high = 100.0, 1e5
            for _ in range(80):
                x = 0.5 * (low + high)
                n = sum(3600 * hours[t] * math.exp(-(x - 100.0) / excess) for t, excess in EXCESS.items())
                low, high = (x, high) if n > 1 / level["years"] else (low, x)
            self.assertLess(level["level_95"][0], low)
            self.assertGreater(level["level_95"][1], low)

    def moved(self, rows):
        """Twice the hours are twice the period, and raise each level."""
        as_it_is, hours, without, *halves = rows
        self.assertAlmostEqual(hours[50][0] / as_it_is[100][0], 1.0, places=5)
        for years in levels.YEARS:
            self.assertGreater(hours[years][0], as_it_is[years][0])
        return as_it_is, without, halves

    def test_the_levels_move_as_they_should(self):
        rows = [{level["years"]: (level["level"], *level["level_95"]) for level in of["annual"]} for _, of in self.found]
        as_it_is, without, halves = self.moved(rows)
        self.assertEqual([name for name, _ in self.found][2], "without thickness-0.8m")
        self.assertLess(without[50][0], as_it_is[50][0])
        for half in halves:
            self.assertGreater(half[50][2] - half[50][1], as_it_is[50][2] - as_it_is[50][1])

    def test_the_recorded_levels_are_of_this_table_and_move_likewise(self):
        with open(FOLDER / "recorded.csv", newline="") as file:
            recorded = list(csv.DictReader(file))
        names = list(dict.fromkeys(row["variant"] for row in recorded))
        rows = [{float(row["years"]): tuple(float(row[key]) for key in ("level", "lower", "upper"))
                 for row in recorded if row["variant"] == name} for name in names]
        self.assertEqual([sorted(row) for row in rows], 5 * [levels.YEARS])
        self.moved(rows)


if __name__ == "__main__":
    unittest.main()
