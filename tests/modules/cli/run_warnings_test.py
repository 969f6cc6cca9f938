# SPDX-License-Identifier: GPL-3.0-or-later
"""The warnings of runs follow their histories into `stats`, `compare`, `design` and `trend`."""
import json
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

BRASH = os.environ["BRASH"]
NO_BREAKS = {"id": "no-breaks", "text": "the ice has not broken in this run"}
DENSITY = {"id": "density", "text": "the ice is light"}


class RunWarnings(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        # Two settings of a campaign with two runs each; three of the four have a warning.
        rows, settings = ["case,setting,replicate,status,structure.speed,horizontal.mean,warnings"], []
        self.runs = []
        for name, speed, found in (("slow", 0.5, [[NO_BREAKS], [NO_BREAKS, DENSITY]]), ("fast", 1.0, [[DENSITY], []])):
            settings.append({"setting": name, "values": {"structure.speed": speed}})
            for i, warnings in enumerate(found):
                self.runs.append(self.run_of(f"{name}-r000{i}", warnings))
                rows.append(f"{name}-r000{i},{name},{i},done,{speed},{speed + 0.1 * i},{' '.join(w['id'] for w in warnings)}")
        (self.folder / "campaign.csv").write_text("\n".join(rows) + "\n")
        (self.folder / "summary.json").write_text(json.dumps({"settings": settings}))

    def run_of(self, name, warnings):
        noise, place = random.Random(name), self.folder / "cases" / name
        place.mkdir(parents=True)
        rows = [f"{0.1 * i:.1f},{noise.gauss(50.0, 9.0)}" for i in range(1000)]
        (place / "history.csv").write_text("\n".join(["time [s],Fx [N]", *rows]) + "\n")
        (place / "summary.json").write_text(json.dumps({"statistics_from": 0.0, "warnings": warnings}))
        return place

    def brash(self, *arguments):
        done = subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_stats_tells_them_and_gives_no_interval_where_the_run_has_none(self):
        first, _, light, clean = (run / "history.csv" for run in self.runs)
        found = json.loads(self.brash("stats", first, "--json").stdout)
        self.assertEqual(found["warnings"], [f"of the run: no-breaks: {NO_BREAKS['text']}"])
        self.assertEqual(found["mean_95"], [None, None])
        self.assertIn("  warning: of the run: no-breaks: the ice has not broken in this run\n", self.brash("stats", first).stdout)
        # A filter keeps them, and a span of the user's own has its own interval.
        self.assertEqual(json.loads(self.brash("stats", first, "--low-pass", 1, "--json").stdout)["warnings"], found["warnings"])
        self.assertNotIn(None, json.loads(self.brash("stats", first, "--from", 0, "--json").stdout)["mean_95"])
        found = json.loads(self.brash("stats", light, "--json").stdout)
        self.assertEqual(found["warnings"], ["of the run: density: the ice is light"])
        self.assertNotIn(None, found["mean_95"])
        self.assertEqual(json.loads(self.brash("stats", clean, "--json").stdout)["warnings"], [])

    def test_a_copy_of_the_history_elsewhere_has_none(self):
        copy = self.folder / "measured.csv"
        copy.write_bytes((self.runs[0] / "history.csv").read_bytes())
        self.assertEqual(json.loads(self.brash("stats", copy, "--json").stdout)["warnings"], [])

    def test_compare_names_them_on_both_sides(self):
        done = self.brash("compare", self.runs[0], self.runs[2], "-o", "picture.svg")
        self.assertIn(f"note: {self.runs[0] / 'history.csv'}: of the run: no-breaks: the ice has not broken", done.stderr)
        self.assertIn(f"note: {self.runs[2] / 'history.csv'}: of the run: density: the ice is light", done.stderr)

    def test_design_counts_the_runs_of_a_setting(self):
        slow, fast = json.loads(self.brash("design", self.folder, "--hours", 0.02, "--json").stdout)["settings"]
        of_runs = [w for w in slow["warnings"] if w.startswith("of ")]
        self.assertEqual(of_runs, ["of 2 of 2 runs: no-breaks: the ice has not broken in this run",
                                   "of 1 of 2 runs: density: the ice is light"])
        self.assertEqual([w for w in fast["warnings"] if w.startswith("of ")], ["of 1 of 2 runs: density: the ice is light"])

    def test_trend_counts_the_cases(self):
        given = ["trend", self.folder, "--along", "structure.speed"]
        self.assertEqual(json.loads(self.brash(*given, "--json").stdout)["warnings"], {"density": 2, "no-breaks": 2})
        self.assertIn("warning: 2 of the cases have 'density'", self.brash(*given).stdout)


if __name__ == "__main__":
    unittest.main()
