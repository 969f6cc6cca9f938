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

    def test_the_folder_of_a_campaign_is_named(self):
        (self.folder / "cases").mkdir()
        (self.folder / "summary.json").write_text("{}")
        done = self.compare(self.folder, self.run_of("measured", 1.0, 0.0))
        self.assertEqual(done.returncode, 2)
        self.assertIn("is the folder of a campaign", done.stderr)
        self.assertIn("give a folder in its cases/", done.stderr)


if __name__ == "__main__":
    unittest.main()
