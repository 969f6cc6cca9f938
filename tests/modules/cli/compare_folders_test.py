# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash compare` on folders: two runs, and the folder of a campaign."""
import json
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

BRASH = os.environ["BRASH"]


class Folders(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def run_of(self, name, mean, start):
        """The folder of a run whose load has `mean` after `start` and is zero before."""
        noise = random.Random(name)
        place = self.folder / name
        place.mkdir()
        rows = [f"{0.1 * i:.1f},{noise.gauss(mean, 1.0) if 0.1 * i >= start else 0.0},{noise.gauss(-5.0, 1.0)}"
                for i in range(1000)]
        (place / "history.csv").write_text("time,Fy,Fx\n" + "\n".join(row for row in rows) + "\n")
        (place / "summary.json").write_text(json.dumps({"statistics_from": start}))
        return place

    def compare(self, *arguments):
        return subprocess.run([BRASH, "compare", *map(str, arguments), "-o", str(self.folder / "picture.svg")],
                              capture_output=True, text=True)

    def test_two_runs_are_compared_in_one_column_each_from_its_own_start(self):
        runs = self.run_of("first", 40.0, 10.0), self.run_of("second", 20.0, 30.0)
        done = self.compare(*runs, "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertAlmostEqual(found["run"]["mean"], 40.0, delta=0.2)       # five errors of the mean
        self.assertAlmostEqual(found["measured"]["mean"], 20.0, delta=0.2)
        self.assertAlmostEqual(found["measured"]["duration"], 70.0, delta=0.2)

    def campaign(self, means, **counts):
        """A campaign of two settings with four replicates each, whose loads have these means."""
        (self.folder / "cases").mkdir()
        for setting, mean in means.items():
            for replicate in range(4):
                self.run_of(f"cases/{setting}-r{replicate:04d}", mean + 0.3 * replicate, 5.0)
        settings = [{"setting": setting, "values": {"ice.thickness": i}, **counts} for i, setting in enumerate(means)]
        (self.folder / "summary.json").write_text(json.dumps({"settings": settings}))

    def test_replicates_beyond_those_that_the_summary_counts_are_left_out(self):
        self.campaign({"thin": 20.0, "thick": 40.0}, n_done=2, n_failed=1)
        measured = self.run_of("measured", 20.2, 0.0)
        done = self.compare(self.folder, measured, "--where", "thin", "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["run"]["histories"], 3)

    def test_the_replicates_of_a_setting_are_compared_with_several_measurements(self):
        self.campaign({"thin": 20.0, "thick": 40.0})
        measured = [self.run_of(f"measured-{i}", 20.2 + 0.3 * i, 0.0) for i in range(3)]
        done = self.compare(self.folder, *measured, "--where", "thin", "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual((found["run"]["histories"], found["measured"]["histories"]), (4, 3))
        self.assertAlmostEqual(found["run"]["mean"], 20.45, delta=0.1)
        # The spread of four means 0, 0.3, 0.6 and 0.9 apart: an error of 0.19, and Student's 3.18.
        self.assertAlmostEqual(found["run"]["mean_95"][1] - found["run"]["mean"], 3.18 * 0.194, delta=0.1)
        self.assertNotIn("mean", found["differs"])
        self.assertGreater(found["could_hide"]["mean"], 0.01)
        other = self.compare(self.folder, *measured, "--where", "thick", "--column", "Fy", "--json")
        self.assertIn("mean", json.loads(other.stdout)["differs"])

    def test_no_difference_says_what_could_hide(self):
        runs = self.run_of("first", 40.0, 0.0), self.run_of("second", 40.0, 0.0)
        done = self.compare(*runs, "--column", "Fy")
        self.assertRegex(done.stdout, r"no difference at 5 %; differences of this size could hide: mean [\d.]+ %, deviation")

    def test_a_campaign_needs_one_setting_and_its_files(self):
        self.campaign({"thin": 20.0, "thick": 40.0})
        measured = self.run_of("measured", 1.0, 0.0)
        done = self.compare(self.folder, measured)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is the folder of a campaign with 2 settings", done.stderr)
        self.assertIn("choose one with --where: thin, thick", done.stderr)
        (self.folder / "summary.json").write_text("{}")
        done = self.compare(self.folder, measured)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is no summary of a campaign\n  allowed: the summary.json of a campaign that is done", done.stderr)


if __name__ == "__main__":
    unittest.main()
