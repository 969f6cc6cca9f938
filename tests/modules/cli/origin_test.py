# SPDX-License-Identifier: GPL-3.0-or-later
"""Every table names the preset and the program that made its numbers."""
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
CONE = SOURCE / "experiments/validation/cone.toml"
SHORT = ["--set", "time.duration=0.5", "--set", "structure.start_distance=7", "--set", "output.statistics_from=0"]
THIS = "brash " + re.search(r"[0-9.]+", subprocess.run([BRASH, "--version"], capture_output=True, text=True).stdout)[0]


class Origin(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.scratch.cleanup)
        cls.folder = pathlib.Path(cls.scratch.name)
        cls.shown = cls.brash("run", CONE, "-o", "own", *SHORT, "--set", "algorithm.preset=brash")
        cls.brash("run", CONE, "-o", "paper", *SHORT, "--set", "algorithm.preset=paper", "--set", "failure.pieces=break")
        # An earlier program made a third run.
        shutil.copytree(cls.folder / "own", cls.folder / "old")
        manifest = cls.folder / "old" / "manifest.json"
        manifest.write_text(manifest.read_text().replace(f'"version": "{THIS[6:]}"', '"version": "0.0.7"'))
        (cls.folder / "old" / "run.nc").unlink()

    @classmethod
    def brash(cls, *arguments):
        done = subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, cwd=cls.folder)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def json(self, *arguments):
        return json.loads(self.brash(*arguments, "--json"))

    def expect_in_netcdf(self, file, preset):
        try:
            import xarray
        except ImportError:
            return
        with xarray.open_dataset(file) as table:
            self.assertEqual(table["preset"].attrs["flag_meanings"], preset)
            programs = table["program"].attrs["flag_meanings"].split()
            made = [programs[i] for i in table["program"].values]
            self.assertEqual(made.count("brash_0.0.7"), 1)
            self.assertEqual(made.count(THIS.replace(" ", "_")), len(made) - 1)
            self.assertEqual(set(table.attrs["source"].split(", ")), {THIS, "brash 0.0.7"})

    def test_a_run_names_them_in_its_table_and_its_summary(self):
        self.assertIn(f"\npreset: brash; program: {THIS}\n", self.shown)
        summary = json.loads((self.folder / "paper" / "summary.json").read_text())
        self.assertEqual(summary["origin"], {"presets": ["paper (1 key changed)"], "programs": [THIS]})

    def test_a_run_tells_its_largest_load_from_that_of_its_statistics(self):
        text = self.brash("run", CONE, "-o", "late", *SHORT[:4], "--set", "output.statistics_from=0.45")
        with open(self.folder / "late" / "history.csv", newline="", encoding="utf-8") as file:
            rows = [(float(row["time"]), float(row["Fx"]), float(row["Fz"])) for row in csv.DictReader(file)]
        largest = [max(row[i] for row in rows) for i in (1, 2)]
        summary = json.loads((self.folder / "late" / "summary.json").read_text())
        self.assertEqual(summary["maximum_whole_history"], {"horizontal": largest[0], "vertical": largest[1]})
        self.assertLess(summary["horizontal"]["maximum"], largest[0])
        self.assertIn(f"largest {largest[0] / 1e3:.1f} horizontal, {largest[1] / 1e3:.1f} vertical\n", text)

    def test_check_and_loads_name_them_of_the_case(self):
        line = f"preset: paper (1 key changed); program: {THIS}\n"
        changed = ["--set", "algorithm.preset=paper", "--set", "failure.pieces=break"]
        self.assertIn(line, self.brash("check", CONE, *changed))
        self.assertIn(line, self.brash("loads", CONE, *changed))
        self.assertEqual(self.json("loads", CONE, *changed)["origin"]["presets"], ["paper (1 key changed)"])

    def test_a_key_that_repeats_its_preset_is_no_change(self):
        self.assertIn("preset: brash; ", self.brash("check", CONE, "--set", "algorithm.preset=brash", "--set",
                                                    "failure.pieces=break"))

    def test_stats_names_the_program_that_made_the_run(self):
        self.assertIn(f"  preset: brash; program: {THIS}\n", self.brash("stats", "own/run.nc", "--column", "Fx"))
        self.assertIn("  preset: brash; program: brash 0.0.7\n", self.brash("stats", "old/history.csv", "--column", "Fx"))
        found = self.json("stats", "old/history.csv", "--column", "Fx")
        self.assertEqual(found["origin"], {"presets": ["brash"], "programs": ["brash 0.0.7"]})

    def test_a_measurement_has_no_origin(self):
        shutil.copy(self.folder / "own" / "history.csv", self.folder / "measured.csv")
        self.assertNotIn("origin", self.json("stats", "measured.csv", "--column", "Fx"))
        self.assertNotIn("program: ", self.brash("stats", "measured.csv", "--column", "Fx"))

    def test_a_manifest_that_is_none_leaves_the_statistics(self):
        (self.folder / "odd").mkdir()
        shutil.copy(self.folder / "own" / "history.csv", self.folder / "odd")
        for text in ("{", "[]", '{"case": {"toml": "= ]"}, "program": {"version": "1"}}', '{"case": 3, "program": []}'):
            (self.folder / "odd" / "manifest.json").write_text(text)
            self.assertNotIn("origin", self.json("stats", "odd/history.csv", "--column", "Fx"))

    def test_text_of_a_manifest_steers_no_terminal(self):
        shutil.copytree(self.folder / "old", self.folder / "hostile")
        manifest = self.folder / "hostile" / "manifest.json"
        manifest.write_text(manifest.read_text().replace("0.0.7", "\\u001b[31m"))
        self.assertNotIn("\x1b", self.brash("stats", "hostile/history.csv", "--column", "Fx"))

    def test_compare_names_both_sides(self):
        text = self.brash("compare", "paper", "old", "-o", "both.svg")
        self.assertIn(f"run 1: preset: paper (1 key changed); program: {THIS}\n", text)
        self.assertIn("run 2: preset: brash; program: brash 0.0.7\n", text)

    def test_pieces_of_a_run_name_them(self):
        self.assertEqual(self.json("pieces", "own", "--born")["origin"], {"presets": ["brash"], "programs": [THIS]})
        self.assertIn(f"  preset: brash; program: {THIS}\n", self.brash("pieces", "own", "--born"))

    def test_campaigns_name_all_of_them(self):
        campaign = self.folder / "campaign"
        plan = self.folder / "plan.toml"
        plan.write_text((SOURCE / "tests/modules/campaign/plan.toml").read_text())
        run = ["campaign", plan, "-o", campaign, "--quick", "--replicates", "2"]
        text = self.brash(*run)
        [preset] = json.loads((campaign / "summary.json").read_text())["origin"]["presets"]
        self.assertRegex(preset, r"^brash \(\d keys changed\)$")  # its plan chooses another failure model
        self.assertIn(f"preset: {preset}; ", self.brash("check", campaign / "settings" / "plan_speed-1.4.toml"))
        self.assertIn(f"preset: {preset}; program: {THIS}\n", text)
        old = campaign / "cases" / "speed-1.4-r0000" / "manifest.json"
        old.write_text(old.read_text().replace(f'"version": "{THIS[6:]}"', '"version": "0.0.7"'))
        line = f"preset: {preset}; programs: "
        self.assertIn(line, self.brash(*run, "--tables"))
        self.assertEqual(set(json.loads((campaign / "summary.json").read_text())["origin"]["programs"]),
                         {THIS, "brash 0.0.7"})
        with open(campaign / "campaign.csv", newline="", encoding="utf-8") as file:
            made = {row["case"]: (row["preset"], row["program"]) for row in csv.DictReader(file)}
        self.assertEqual(made.pop("speed-1.4-r0000"), (preset, "brash 0.0.7"))
        self.assertEqual(set(made.values()), {(preset, THIS)})
        self.expect_in_netcdf(campaign / "campaign.nc", preset.replace(" ", "_"))
        self.assertIn(line, self.brash("trend", campaign, "--along", "structure.speed"))
        self.assertIn(line, self.brash("design", campaign, "--hours", "0.002"))
        one = self.json("trend", campaign, "--along", "structure.speed", "--where", "speed-1.[02468]*")
        self.assertIn("brash 0.0.7", one["origin"]["programs"])
        # Tables of earlier versions do not name them.
        table = campaign / "campaign.csv"
        rows = [line.rsplit(",", 2)[0] for line in table.read_text().splitlines()]
        table.write_text("\n".join(rows) + "\n")
        self.assertNotIn("origin", self.json("trend", campaign, "--along", "structure.speed"))


if __name__ == "__main__":
    unittest.main()
