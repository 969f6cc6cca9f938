# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash compare` on folders: two runs, and the folder of a campaign."""
import json
import os
import pathlib
import random
import re
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


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

    def mean(self, *arguments):
        done = self.compare(*arguments, "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["run"]["mean"]

    def test_the_mean_of_a_run_is_that_of_its_summary(self):
        run = self.folder / "run"
        made = subprocess.run([BRASH, "run", str(SOURCE / "experiments/validation/cone.toml"), "--set", "failure.model=wedge",
                               "--set", "time.duration=2", "--set", "output.statistics_from=1", "-o", str(run)],
                              capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        of_summary = json.loads((run / "summary.json").read_text())["horizontal"]["mean"]
        for given in (run, run / "run.nc", run / "history.csv"):
            self.assertAlmostEqual(self.mean(given, run) / of_summary, 1.0, delta=1e-12)
        # The same start, whoever says it, and the whole history.
        self.assertAlmostEqual(self.mean(run, run, "--from", 1) / of_summary, 1.0, delta=1e-12)
        self.assertGreater(abs(self.mean(run / "run.nc", run, "--from", 0) / of_summary - 1.0), 1e-3)

    def test_the_inputs_that_differ_are_the_first_table_and_the_same_run_is_named(self):
        def run(name, *sets):
            made = subprocess.run([BRASH, "run", str(SOURCE / "experiments/validation/cone.toml"), "--set",
                                   "failure.model=wedge", "--set", "time.duration=2", "--set", "output.statistics_from=1",
                                   *sets, "-o", str(self.folder / name)], capture_output=True, text=True)
            self.assertEqual(made.returncode, 0, made.stderr)
            return self.folder / name

        one, again = run("one"), run("again")
        other = run("other", "--set", "ice.thickness=0.4", "--set", "random.seed=7")
        lines = self.compare(one, other).stdout.splitlines()
        self.assertEqual(lines[0].split(), ["inputs", "that", "differ", "run", "1", "run", "2"])
        self.assertEqual([line.split()[0] for line in lines[1:3]], ["ice.thickness", "random.seed"])
        self.assertEqual(lines[1].split()[-1], "0.4")
        self.assertEqual(lines[3], "")
        found = json.loads(self.compare(one, other, "--json").stdout)
        self.assertEqual([row["key"] for row in found["inputs_that_differ"]], ["ice.thickness", "random.seed"])
        self.assertNotIn("same_run", found)
        for same in (one, one / "history.csv", again):
            self.assertIn("both sides have the same run", self.compare(one, same).stdout.splitlines()[0])
        self.assertIn("both sides have the same run",
                      self.compare(self.run_of("measured", 20.0, 0.0), self.folder / "measured").stdout)

    def test_each_side_is_named_by_what_it_is(self):
        run = self.folder / "run"
        made = subprocess.run([BRASH, "run", str(SOURCE / "experiments/validation/cone.toml"), "--set", "failure.model=wedge",
                               "--set", "time.duration=2", "--set", "output.statistics_from=1", "-o", str(run)],
                              capture_output=True, text=True)
        self.assertEqual(made.returncode, 0, made.stderr)
        measured = self.run_of("measured", 20.0, 0.0) / "history.csv"
        for sides, names in (((run, run), ("run 1", "run 2")), ((run, measured), ("run", "measured")),
                             ((measured, run), ("measured", "run")), ((measured, measured), ("measured 1", "measured 2"))):
            said = self.compare(*sides, "--measured-column", "Fx").stdout
            unit = "loads [N]" if sides[0] == run else ""  # the file of the measurement names none
            self.assertIn(f"\n  {unit:<17} {names[0]:>12} {names[1]:>12}\n", "\n" + said)
            self.assertIn(f"\n{names[0]} over {names[1]}, 95 % interval", said)
            picture = (self.folder / "picture.svg").read_text(encoding="utf-8")
            for text in (f"{names[0]}: Fx", f"{names[1]}: Fx", f"{names[0]} / {names[1]}, 95 %"):
                self.assertIn(text, picture)

    def test_a_run_has_the_mean_of_itself(self):
        run = self.run_of("run", 40.0, 30.0)
        for measured in (run, run / "history.csv"):
            for given in (run, run / "history.csv"):
                done = self.compare(given, measured, "--column", "Fy", "--measured-column", "Fy", "--json")
                self.assertEqual(done.returncode, 0, done.stderr)
                found = json.loads(done.stdout)
                self.assertEqual((found["run"]["mean"], found["run"]["duration"]),
                                 (found["measured"]["mean"], found["measured"]["duration"]))
        whole = json.loads(self.compare(run, run / "history.csv", "--column", "Fy", "--measured-column", "Fy",
                                        "--measured-from", 0, "--json").stdout)
        self.assertLess(whole["measured"]["mean"], 0.8 * whole["run"]["mean"])

    def test_a_replicate_begins_after_the_time_of_its_summary(self):
        self.campaign({"thin": 20.0})
        for table in self.folder.glob("cases/*/history.csv"):
            table.write_text(re.sub(r"^5\.0,.*$", "5.0,1e9,1e9", table.read_text(), flags=re.MULTILINE))
        measured = self.run_of("measured", 20.0, 0.0)
        self.assertAlmostEqual(self.mean(self.folder, measured, "--column", "Fy"), 20.45, delta=0.1)  # of 20, 20.3, 20.6, 20.9

    def campaign(self, means, missing=(), late=()):
        """A campaign of two settings with four replicates each, whose loads have these means.

        Replicates that are `late` ended after the tables were written.
        """
        (self.folder / "cases").mkdir()
        for setting, mean in means.items():
            for replicate in set(range(4)) - set(missing):
                self.run_of(f"cases/{setting}-r{replicate:04d}", mean + 0.3 * replicate, 5.0)
        counted = sorted(set(range(4)) - set(missing) - set(late))
        settings = [{"setting": setting, "values": {"ice.thickness": i}, "n_done": len(counted), "n_failed": 0}
                    for i, setting in enumerate(means)]
        (self.folder / "summary.json").write_text(json.dumps({"settings": settings}))
        rows = [f"{setting}-r{replicate:04d},{setting},{replicate},done" for setting in means for replicate in counted]
        (self.folder / "campaign.csv").write_text("\n".join(["case,setting,replicate,status", *rows]) + "\n")

    def test_replicates_are_those_that_the_table_counts_as_done(self):
        self.campaign({"thin": 20.0, "thick": 40.0}, missing=[0])
        measured = self.run_of("measured", 20.2, 0.0)
        done = self.compare(self.folder, measured, "--where", "thin", "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        run = json.loads(done.stdout)["run"]
        self.assertEqual(run["histories"], 3)
        self.assertAlmostEqual(run["mean"], 20.6, delta=0.1)  # of 20.3, 20.6 and 20.9

    def test_a_replicate_that_ended_after_the_tables_does_not_enter(self):
        self.campaign({"thin": 20.0, "thick": 40.0}, late=[0])
        measured = self.run_of("measured", 20.2, 0.0)
        done = self.compare(self.folder, measured, "--where", "thin", "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        run = json.loads(done.stdout)["run"]
        self.assertEqual(run["histories"], 3)
        self.assertAlmostEqual(run["mean"], 20.6, delta=0.1)  # of 20.3, 20.6 and 20.9, without 20.0

    def test_two_settings_of_one_campaign_are_compared(self):
        self.campaign({"thin": 20.0, "thick": 40.0})
        done = self.compare(self.folder, self.folder, "--where", "thin", "--measured-where", "thick", "--column", "Fy", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertAlmostEqual(found["run"]["mean"], 20.45, delta=0.1)
        self.assertAlmostEqual(found["measured"]["mean"], 40.45, delta=0.1)

    def test_a_pattern_without_a_campaign_is_refused(self):
        runs = self.run_of("first", 40.0, 0.0), self.run_of("second", 20.0, 0.0)
        for option, side in (("--where", runs[0]), ("--measured-where", runs[1])):
            done = self.compare(*runs, option, "thin")
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{side}: is not a campaign of which {option} could choose a setting", done.stderr)
        self.campaign({"thin": 20.0, "thick": 40.0})
        done = self.compare(self.folder, runs[0], "--where", "thin", "--measured-where", "thin")
        self.assertIn("is not a campaign of which --measured-where could choose a setting", done.stderr)

    def test_a_picture_replaces_no_result_of_a_run(self):
        runs = self.run_of("first", 40.0, 0.0), self.run_of("second", 20.0, 0.0)
        picture = runs[0] / "case.svg"
        picture.write_text("<svg/>")
        (runs[0] / "manifest.json").write_text('{"outputs": [{"path": "case.svg"}]}')
        for command in (["compare", *runs], ["pieces", runs[0] / "run.nc"], ["design", self.folder]):
            done = subprocess.run([BRASH, *map(str, command), "-o", str(picture)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn("case.svg: would be written over a result that manifest.json beside it lists", done.stderr)
        self.assertEqual(picture.read_text(), "<svg/>")

    def test_a_time_step_is_for_files_without_times(self):
        run = self.run_of("first", 40.0, 0.0)
        (self.folder / "single.csv").write_text("Fy\n" + "".join(f"{40 + i % 7}\n" for i in range(1000)))
        done = self.compare(run, self.folder / "single.csv", run, "--column", "Fy", "--measured-dt", "0.1", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["measured"]["histories"], 2)
        done = self.compare(run, run / "history.csv", "--column", "Fy", "--measured-dt", "0.1")
        self.assertEqual(done.returncode, 2)
        self.assertIn("history.csv: has times in column 'time', and a time step is given", done.stderr)

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
        self.assertIn("is not a summary of a campaign\n  allowed: the summary.json of a campaign that is done", done.stderr)


if __name__ == "__main__":
    unittest.main()
