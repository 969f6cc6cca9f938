#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command `brash campaign` from outside, on this machine: campaign_command.py BRASH FOLDER"""
import csv
import fcntl
import hashlib
import json
import shutil
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from files import DATABASE_PLAN, PLAN, different

BRASH, FOLDER = sys.argv[1], Path(sys.argv[2]).resolve()


def campaign(*arguments, plan=PLAN):
    return subprocess.run([BRASH, "campaign", plan, *arguments], capture_output=True, text=True)


def quick(folder, *options):
    return campaign("-o", folder, "--quick", *options)


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(FOLDER, ignore_errors=True)
        FOLDER.mkdir(parents=True)
        cls.whole = FOLDER / "whole"
        done = quick(cls.whole, "--jobs", "1")
        assert done.returncode == 0, done.stderr

    def status(self, folder):
        return json.loads(quick(folder, "--status", "--json").stdout)

    def refuses(self, done, *parts):
        self.assertEqual(done.returncode, 2, done.stderr)
        for part in parts:
            self.assertIn(part, done.stderr)

    def test_several_workers_give_the_bytes_of_one(self):
        folder = FOLDER / "workers"
        self.assertEqual(quick(folder, "--jobs", "3").returncode, 0)
        self.assertEqual(different(self.whole, folder), [])

    def test_replicates_of_the_command_line_may_grow(self):
        folder = FOLDER / "replicates"
        done = quick(folder, "--replicates", "1")
        self.assertIn("4 of 4 cases done", done.stdout)
        self.assertRegex(done.stderr, r"[1-3] of 4 cases done, 0 failed, [1-3] missing, \d running")
        self.assertIn("8 of 8 cases done", quick(folder, "--replicates", "2", "--resume").stdout)
        self.assertEqual(quick(folder, "--resume").returncode, 0)
        self.assertEqual(different(self.whole, folder), [])

    def test_cases_beyond_the_replicates_are_left_out_of_the_tables_with_a_warning(self):
        folder = FOLDER / "fewer"
        self.assertEqual(quick(folder, "--replicates", "3").returncode, 0)
        fewer = quick(folder, "--replicates", "2", "--resume")
        self.assertEqual(fewer.returncode, 0)
        self.assertIn("8 of 8 cases done", fewer.stdout)
        self.assertIn("has 4 done cases that the plan does not have now", fewer.stderr)
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual([setting["n_done"] for setting in summary["settings"]], [2] * 4)
        self.assertNotIn("done cases", quick(folder, "--replicates", "3", "--resume").stderr)

    def test_what_cases_keep_stays_as_it_was_begun(self):
        plan, folder = FOLDER / "keeping.toml", FOLDER / "keeping"
        text = Path(PLAN).read_text(encoding="utf-8")
        plan.write_text(text, encoding="utf-8")
        self.assertEqual(campaign("-o", folder, "--replicates", "1", plan=plan).returncode, 0)
        for keep in ("summary", "run"):
            plan.write_text(text.replace('keep = "history"', f'keep = "{keep}"'), encoding="utf-8")
            self.refuses(campaign("-o", folder, "--replicates", "2", "--resume", plan=plan),
                         f'output.keep = "history", and the plan says "{keep}" now', "allowed:", "remedy:")
        plan.write_text(text, encoding="utf-8")
        self.assertEqual(campaign("-o", folder, "--replicates", "1", "--resume", plan=plan).returncode, 0)

    def test_cases_that_end_before_their_statistics_are_counted(self):
        # Without a time of their own they begin when the cone's axis passes the edge, 6.9 m away.
        plan = FOLDER / "early.toml"
        plan.write_text(Path(PLAN).read_text().replace("output = { statistics_from = 0.2 }", ""))
        done = campaign("-o", FOLDER / "early", "--quick", plan=plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout.count("3  of 3 cases without a mean: over before output.statistics_from"), 4)
        self.assertNotIn("horizontal.mean ", done.stdout)
        self.assertNotIn("without a mean", quick(FOLDER / "complete").stdout)

    def test_a_case_alone_gives_the_bytes_that_it_has_in_the_campaign(self):
        folder = FOLDER / "alone"
        subprocess.run([BRASH, "run", self.whole / "settings" / "plan_speed-1.4.toml", "--set", "random.replicate=2",
                        "-o", folder], check=True, capture_output=True)
        for name in ("summary.json", "history.csv"):
            self.assertEqual((folder / name).read_bytes(), (self.whole / "cases" / "speed-1.4-r0002" / name).read_bytes())

    def test_a_killed_campaign_is_counted_and_resumed_to_the_same_bytes(self):
        folder = FOLDER / "killed"
        process = subprocess.Popen([BRASH, "campaign", PLAN, "-o", folder, "--quick", "--jobs", "2"],
                                   stdout=subprocess.DEVNULL)
        while process.poll() is None and len(list((folder / "cases").glob("*[0-9]"))) < 4:
            time.sleep(0.005)
        process.kill()
        self.assertEqual(process.wait(), -signal.SIGKILL)
        status = self.status(folder)
        self.assertEqual(status["n_cases"], 12)
        self.assertEqual(status["n_done"] + status["n_missing"], 12)
        self.assertGreater(status["n_missing"], 0)
        self.assertFalse((folder / "campaign.csv").exists())
        # As a worker leaves them that is killed when its case has just got its name, and one that is killed at work, or while
        # inputs are copied.
        done = next((folder / "cases").glob("*[0-9]"))
        left = [done / "lock", folder / "cases" / (done.name + ".messages.1.part"), folder / "inputs" / "plan.toml.1.part"]
        for path in left:
            path.touch()
        self.assertEqual(quick(folder, "--resume").returncode, 0)
        self.assertEqual([path for path in left if path.exists()], [])
        self.assertEqual(different(self.whole, folder), [])

    def test_cases_that_are_not_as_they_were_made_are_named_and_run_again(self):
        folder = FOLDER / "unfit"
        shutil.copytree(self.whole, folder)
        cases = sorted(p for p in (folder / "cases").iterdir() if p.is_dir())
        one, two, untrue, cut, lost = cases[:5]
        one.rename(folder / "swapped")
        two.rename(one)
        (folder / "swapped").rename(two)
        summary = json.loads((untrue / "summary.json").read_text(encoding="utf-8"))
        summary["horizontal"]["mean"] = 9e9
        (untrue / "summary.json").write_text(json.dumps(summary), encoding="utf-8")
        history = (cut / "history.csv").read_text(encoding="utf-8")
        (cut / "history.csv").write_text(history[:len(history) // 2], encoding="utf-8")
        (lost / "history.csv").unlink()
        self.refuses(quick(folder, "--tables"), f"{one}: its manifest.json names another case", "allowed:", "`--resume`")
        done = quick(folder, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        for case, why in ((one, "names another case"), (two, "names another case"), (untrue, "summary.json has changed"),
                          (cut, "history.csv has changed"), (lost, "history.csv is missing")):
            self.assertRegex(done.stderr, f"warning: {case}: its .*{why}.*: the case is run again")
        self.assertEqual(done.stderr.count("is run again"), 5)
        self.assertEqual(different(self.whole, folder), [])
        self.assertNotIn("is run again", quick(folder, "--resume").stderr)

    def test_replicates_that_coincide_are_named_and_count_once(self):
        plan, folder = FOLDER / "alike.toml", FOLDER / "alike"
        case = Path(PLAN).resolve().parents[3] / "experiments/validation/cone.toml"
        plan.write_text(f'[campaign]\ncase = "{case}"\nreplicates = 3\n'
                        '[set]\nfailure.model = "wedge"\nfailure.wedges = [4, 4]\ntime.duration = 0.2\noutput.statistics_from = 0.1\n'
                        '[output]\nkeep = "history"\n', encoding="utf-8")
        done = campaign("-o", folder, plan=plan)  # it breaks no ice, and only breaks are drawn
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, "warning: same-as-a-replicate: .* 2 of 3 in .*ice.variation.thickness")
        setting, = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["settings"]
        self.assertEqual((setting["n_done"], setting["warnings"]["same-as-a-replicate"]), (3, 2))
        self.assertEqual(setting["statistics"]["horizontal.mean"]["n"], 1)
        self.assertIsNone(setting["statistics"]["horizontal.mean"]["mean_95"])
        table = list(csv.DictReader((folder / "campaign.csv").read_text(encoding="utf-8").splitlines()))
        self.assertEqual(["same-as-a-replicate" in row["warnings"] for row in table], [False, True, True])

    def test_an_interrupted_campaign_says_so_with_exit_code_3(self):
        folder = FOLDER / "interrupted"
        process = subprocess.Popen([BRASH, "campaign", PLAN, "-o", folder, "--quick", "--jobs", "2"],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not list((folder / "cases").glob("*[0-9]")):
            time.sleep(0.005)
        process.send_signal(signal.SIGINT)
        _, errors = process.communicate()
        self.assertEqual(process.returncode, 3)
        self.assertIn("`--resume` continues", errors)
        self.assertFalse((folder / "campaign.csv").exists())
        tables = quick(folder, "--tables")
        self.assertEqual(tables.returncode, 0, tables.stderr)
        with open(folder / "campaign.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual({row["case"] for row in rows}, {p.name for p in (folder / "cases").glob("*[0-9]")})
        self.assertEqual((summary["n_cases"], summary["n_done"]), (12, len(rows)))
        self.assertLess(len(rows), 12)
        self.assertEqual(summary["settings"][-1]["stopped_by"], "missing")
        self.assertEqual(quick(folder, "--resume").returncode, 0)
        self.assertEqual(different(self.whole, folder), [])

    def test_tables_of_nothing_are_refused_and_make_no_folder(self):
        self.refuses(quick(FOLDER / "nothing", "--tables"), "holds no case", "allowed:", "remedy:")
        self.assertFalse((FOLDER / "nothing").exists())

    def test_a_folder_that_another_process_works_in_is_refused(self):
        with open(self.whole / "campaign.lock", "w", encoding="utf-8") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            print("process 1 on another machine", file=lock, flush=True)
            self.refuses(quick(self.whole, "--resume"), "is in use by process", "remedy:")

    def test_a_folder_with_cases_needs_resume_and_the_same_settings(self):
        self.refuses(quick(self.whole), "holds the cases of a campaign already", "`--resume`")
        self.refuses(quick(self.whole, "--resume", "--set", "ice.thickness=0.4"), "settings/plan_speed-1.0.toml", "remedy:")
        self.assertEqual(quick(self.whole, "--resume").returncode, 0)

    def test_the_folder_of_a_run_is_refused(self):
        folder = FOLDER / "run"
        subprocess.run([BRASH, "run", self.whole / "settings" / "plan_speed-1.0.toml", "-o", folder], check=True,
                       capture_output=True)
        before = {p: p.read_bytes() for p in folder.iterdir() if p.is_file()}
        for options in ((), ("--resume",)):
            self.refuses(quick(folder, *options), "holds results that are not a campaign's", "allowed:", "remedy:")
            self.assertEqual({p: p.read_bytes() for p in folder.iterdir() if p.is_file()}, before)

    def test_a_run_is_kept_out_of_the_folder_of_a_campaign(self):
        before = {p: p.read_bytes() for p in self.whole.iterdir() if p.is_file()}
        self.refuses(subprocess.run([BRASH, "run", self.whole / "settings" / "plan_speed-1.0.toml", "-o", self.whole],
                                    capture_output=True, text=True), "holds a campaign", "allowed:", "remedy:")
        self.assertEqual({p: p.read_bytes() for p in self.whole.iterdir() if p.is_file()}, before)

    def test_a_run_replaces_no_files_but_those_of_runs(self):
        case = self.whole / "settings" / "plan_speed-1.0.toml"
        for name in ("history.csv", "manifest.json", "report.html"):
            with self.subTest(name):
                folder = FOLDER / f"holds-{name}"
                folder.mkdir()
                (folder / name).write_text("measured", encoding="utf-8")
                refused = subprocess.run([BRASH, "run", case, "-o", folder], capture_output=True, text=True)
                self.refuses(refused, str(folder / name), "allowed:", "remedy:")
                self.assertEqual((folder / name).read_text(encoding="utf-8"), "measured")
                (folder / name).unlink()
                (folder / "notes.txt").write_text("kept", encoding="utf-8")
                for option in ([], ["--replace"]):
                    subprocess.run([BRASH, "run", case, "-o", folder, *option], check=True, capture_output=True)
                self.assertEqual((folder / "notes.txt").read_text(encoding="utf-8"), "kept")

    def test_a_campaign_may_collect_no_columns(self):
        plan = FOLDER / "without_columns.toml"
        text = PLAN.read_text(encoding="utf-8").replace("[output]", "[output]\ncolumns = []")
        plan.write_text(text.replace("replicates = 3", "replicates = 1"), encoding="utf-8")
        folder = FOLDER / "without_columns"
        done = campaign("-o", folder, "--quick", plan=plan)
        self.assertEqual(done.returncode, 0, done.stderr)
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        self.assertEqual([setting["statistics"] for setting in summary["settings"]], [{}] * 4)

    def test_a_broken_plan_leaves_nothing_behind(self):
        plan = FOLDER / "broken.toml"
        plan.write_text("[campaign]\ncase = \"none.toml\"\n", encoding="utf-8")
        self.refuses(campaign("-o", FOLDER / "broken", plan=plan), "none.toml", "remedy:")
        self.assertFalse((FOLDER / "broken").exists())

    def test_a_case_that_fails_by_itself_is_recorded_and_the_others_are_done(self):
        model = FOLDER / "model.json"
        model.write_text("{}", encoding="utf-8")
        plan = FOLDER / "failing.toml"
        plan.write_text(PLAN.read_text(encoding="utf-8").replace(
            "[quick]", "[[grid]]\nlabels = [\"good\", \"bad\"]\nfailure.model = [\"wedge\", \"network\"]\n"
            "failure.file = [\"\", \"model.json\"]\n[quick]"), encoding="utf-8")
        folder = FOLDER / "failing"
        done = campaign("-o", folder, "--quick", "--set", "output.statistics_from=0.3", plan=plan)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("12 cases failed", done.stderr)
        record = json.loads((folder / "cases" / "speed-1.2_bad-r0001.failed").read_text(encoding="utf-8"))
        self.assertIn("inputs/model/model-", record["error"])
        with open(folder / "campaign.csv", newline="", encoding="utf-8") as file:
            rows = {row["case"]: row for row in csv.DictReader(file)}
        self.assertEqual(len(rows), 24)
        self.assertEqual((rows["speed-1.2_bad-r0001"]["status"], rows["speed-1.2_bad-r0001"]["horizontal.mean"]),
                         ("failed", ""))
        self.assertGreater(float(rows["speed-1.2_good-r0001"]["horizontal.mean"]), 0.0)
        self.assertEqual([p.name for p in (folder / "cases").glob("*.part")], [])

    def test_the_failure_database_of_several_processes_is_that_of_one(self):
        one, several = FOLDER / "one.nc", FOLDER / "several.nc"
        for output, jobs in ((one, "1"), (several, "2")):
            subprocess.run([BRASH, "failure", "database", DATABASE_PLAN, "-o", output, "--jobs", jobs], check=True,
                           capture_output=True)
        self.assertEqual(one.read_bytes(), several.read_bytes())
        self.assertFalse((FOLDER / "several.nc.chunks").exists())

    def test_the_tables_agree_with_each_other(self):
        import netCDF4
        import numpy as np
        from scipy import stats
        with open(self.whole / "campaign.csv", newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        summary = json.loads((self.whole / "summary.json").read_text(encoding="utf-8"))
        with netCDF4.Dataset(self.whole / "campaign.nc") as table:
            self.assertEqual(table["setting"].flag_meanings.split(), [s["setting"] for s in summary["settings"]])
            for name in ("horizontal.mean", "structure.speed", "replicate"):
                np.testing.assert_array_equal(table[name][:], [float(row[name]) for row in rows])
            self.assertEqual(table["structure.speed"].units, "m s-1")
            self.assertEqual(table["horizontal.mean"].units, "N")
        for setting in summary["settings"]:
            values = [float(row["horizontal.mean"]) for row in rows
                      if row["setting"] == setting["setting"] and "same-as-a-replicate" not in row["warnings"]]
            interval = stats.t.interval(0.95, len(values) - 1, np.mean(values), stats.sem(values))
            # Two ways to sum and to invert Student's distribution.
            np.testing.assert_allclose(setting["statistics"]["horizontal.mean"]["mean_95"], interval, rtol=1e-9)

    def test_the_printed_table_is_whole_and_says_how_to_halve_its_intervals(self):
        done = quick(FOLDER / "printed", "--jobs", "1")
        again = quick(FOLDER / "printed", "--resume")
        summary = json.loads((FOLDER / "printed" / "summary.json").read_text(encoding="utf-8"))
        # Student's interval is 2.484 standard deviations wide with three replicates, 1.242 with five.
        command = f"brash campaign {PLAN} -o {FOLDER / 'printed'} --quick --resume --replicates 5"
        self.assertIn(f"5 replicates instead of 3 about halve the intervals: `{command}`", done.stdout)
        # Each warning once, with the words of a case: those that came before the cases ran are not repeated.
        self.assertGreater(len(summary["warnings"]), 0)
        for warning, first in summary["warnings"].items():
            case = json.loads((FOLDER / "printed/cases" / first["case"] / "summary.json").read_text(encoding="utf-8"))
            self.assertIn({"id": warning, "text": first["text"]}, case["warnings"])
            self.assertEqual((done.stdout + done.stderr).count(f"warning: {warning}: "), 1 + (f"warning: {warning}: " in done.stderr))
            self.assertEqual(again.stdout.count(f", such as {first['case']}: {first['text']}\n"), 1)
        self.assertNotRegex(done.stdout, r"\b1 (cases|settings)")
        self.assertRegex(done.stdout, r"horizontal\.mean +-?[\d.]+ k?N +\[")
        single = quick(FOLDER / "single", "--replicates", "1")
        self.assertRegex(single.stdout, "one replicate has no interval: `brash campaign .* --resume --replicates 3`")

    def test_intervals_end_where_no_value_is_possible(self):
        plan, folder = FOLDER / "possible.toml", FOLDER / "possible"
        columns = ["n_breaks", "n_floes_born", "horizontal.standard_deviation", "horizontal.skewness",
                   "breaking_frequency", "ledger.closes", "horizontal.long_enough"]
        text = Path(PLAN).read_text(encoding="utf-8")
        plan.write_text(text.replace('keep = "history"', f"columns = {json.dumps(columns)}"), encoding="utf-8")
        self.assertEqual(campaign("-o", folder, "--quick", "--replicates", "2", plan=plan).returncode, 0)
        ends = set()
        for setting in json.loads((folder / "summary.json").read_text(encoding="utf-8"))["settings"]:
            for column in columns:
                statistic = setting["statistics"][column]
                if statistic["mean_95"] is None:
                    continue
                lower, upper = statistic["mean_95"]
                self.assertLessEqual(lower, statistic["mean"])
                self.assertGreaterEqual(upper, statistic["mean"])
                if column == "horizontal.skewness":
                    continue
                self.assertGreaterEqual(lower, 0.0)
                ends.add(lower)
                if column in ("ledger.closes", "horizontal.long_enough"):
                    self.assertLessEqual(upper, 1.0)
        self.assertIn(0.0, ends)  # two replicates have wide intervals, and some would reach below 0

    def test_the_crate_lists_the_results_with_their_hashes_and_keeps_the_licence_of_the_user(self):
        folder = FOLDER / "crate"
        self.assertEqual(quick(folder).returncode, 0)
        path = folder / "ro-crate-metadata.json"
        crate = json.loads(path.read_text(encoding="utf-8"))
        entities = {entity["@id"]: entity for entity in crate["@graph"]}
        root = entities["./"]
        self.assertEqual(entities[path.name]["about"], {"@id": "./"})
        self.assertEqual(entities["#brash"]["version"],
                         subprocess.run([BRASH, "--version"], capture_output=True, text=True).stdout.split()[0])
        names = [part["@id"] for part in root["hasPart"]]
        self.assertLessEqual({"campaign.csv", "campaign.nc", "summary.json", "manifest.json"}, set(names))
        self.assertEqual(sum(name.startswith("cases/") for name in names), 12)
        for name in names:
            data = (folder / name).read_bytes()
            self.assertEqual(entities[name]["sha256"], hashlib.sha256(data).hexdigest())
            self.assertEqual(entities[name]["contentSize"], str(len(data)))
        self.assertNotIn("license", root)
        root["license"] = {"@id": "https://creativecommons.org/licenses/by/4.0/"}
        path.write_text(json.dumps(crate), encoding="utf-8")
        self.assertEqual(quick(folder, "--resume").returncode, 0)
        again = {entity["@id"]: entity for entity in json.loads(path.read_text(encoding="utf-8"))["@graph"]}
        self.assertEqual(again["./"]["license"], root["license"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
