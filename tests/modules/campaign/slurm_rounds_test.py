# SPDX-License-Identifier: GPL-3.0-or-later
"""Rounds of a campaign under Slurm, with stand-ins for sbatch and squeue: progress, idleness, a killed collector."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

from files import PLAN

BRASH = os.environ["BRASH"]
#: Says a number, and runs the tasks of an array at once where RUNS is set. Collectors are left to the test.
SBATCH = """#!/usr/bin/python3
import os, pathlib, subprocess, sys
folder = pathlib.Path(os.environ["FAKE"])
number = len(list(folder.iterdir()))
(folder / str(number)).touch()
last = [int(word.rpartition("-")[2]) for word in sys.argv if word.startswith("--array=")]
words = sys.argv[[word.endswith("/exec.sh") for word in sys.argv].index(True) + 1:]
for task in range(last[0] + 1 if last and "RUNS" in os.environ else 0):
    subprocess.run(words, check=True, env={**os.environ, "SLURM_ARRAY_TASK_ID": str(task)})
print(100 + number)
"""


class Rounds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.out = self.path / "out"
        for name, text in (("sbatch", SBATCH), ("squeue", "#!/bin/sh\n")):
            command = self.path / "bin" / name
            command.parent.mkdir(exist_ok=True)
            command.write_text(text)
            command.chmod(0o755)
        (self.path / "submitted").mkdir()

    def campaign(self, plan, *options, **environment):
        environment = {**os.environ, "PATH": f"{self.path / 'bin'}:{os.environ['PATH']}",
                       "FAKE": str(self.path / "submitted"), **environment}
        return subprocess.run([BRASH, "campaign", plan, "-o", self.out, *options], capture_output=True, text=True,
                              env=environment)

    def as_collector(self, plan, *options, **environment):
        """The command of the newest collector, as its job runs it."""
        rounds = json.loads((self.out / "slurm/submitted.json").read_text())
        return self.campaign(plan, "--on", "slurm", "--resume", *options, SLURM_JOB_ID=rounds[-1]["collector"],
                             **environment)

    def test_a_stop_rule_may_take_as_many_rounds_as_it_needs(self):
        plan = self.path / "stopped.toml"
        grid = "[[grid]]\nstructure.speed = [1.0, 1.2, 1.4, 1.6]\n"
        # With seed 1 the first two replicates draw alike, and an interval of no width stops at once.
        plan.write_text(PLAN.read_text().replace("replicates = 50", "replicates = 2").replace(
            grid, "[stop]\nhalf_width = 1e-9\nmost_replicates = 8\n").replace(
            "[case]", "[case]\nrandom = { seed = 2 }").partition("[quick]")[0])
        done = self.campaign(plan, "--on", "slurm", RUNS="1")
        self.assertEqual(done.returncode, 0, done.stderr)
        for _ in range(6):
            done = self.as_collector(plan, RUNS="1")
            self.assertEqual(done.returncode, 0, done.stderr)
        done = self.as_collector(plan, RUNS="1")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("8 of 8 cases done", done.stdout)
        self.assertEqual(json.loads((self.out / "summary.json").read_text())["n_done"], 8)

    def test_a_collector_gives_up_after_three_rounds_without_a_case_that_was_done(self):
        self.assertEqual(self.campaign(PLAN, "--quick", "--on", "slurm").returncode, 0)
        for _ in range(2):
            self.assertEqual(self.as_collector(PLAN, "--quick").returncode, 0)
        done = self.as_collector(PLAN, "--quick")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("3 rounds under Slurm", done.stderr)

    def test_an_array_without_a_collector_is_cancelled(self):
        sbatch = self.path / "bin/sbatch"
        sbatch.write_text("#!/bin/sh\ncase \"$*\" in *--dependency*) echo no more jobs >&2; exit 1;; esac\necho 101\n")
        scancel = self.path / "bin/scancel"
        scancel.write_text(f"#!/bin/sh\necho $1 > {self.path / 'cancelled'}\n")
        scancel.chmod(0o755)
        done = self.campaign(PLAN, "--on", "slurm")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("the array 101 was cancelled", done.stderr)
        self.assertEqual((self.path / "cancelled").read_text(), "101\n")
        scancel.write_text("#!/bin/sh\nexit 1\n")
        self.assertIn("the array 101 is still in the queue: `scancel` it",
                      self.campaign(PLAN, "--on", "slurm", "--resume").stderr)

    def test_a_submission_answers_in_json_where_it_is_asked_to(self):
        done = self.campaign(PLAN, "--quick", "--on", "slurm", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout), {"n_cases": 12, "n_done": 0, "n_failed": 0, "n_missing": 12})
        self.assertIn("submitted", done.stderr)

    def test_options_of_slurm_are_refused_on_this_machine(self):
        for option in ("--wait", "--sbatch=--partition=short"):
            done = self.campaign(PLAN, "--quick", option)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            for part in (option.partition("=")[0], "has no effect with --on local", "allowed:", "remedy:"):
                self.assertIn(part, done.stderr)
            self.assertFalse(self.out.exists())

    def test_tables_of_fewer_cases_are_not_those_of_a_campaign_whose_collector_was_killed(self):
        first = self.campaign(PLAN, "--quick", "--replicates", "1")
        self.assertEqual(first.returncode, 0, first.stderr)
        grown = self.campaign(PLAN, "--quick", "--replicates", "2", "--resume", "--on", "slurm", "--wait", RUNS="1")
        self.assertEqual(grown.returncode, 3, grown.stdout)
        self.assertIn("`--resume` continues", grown.stderr)
        self.assertEqual(self.as_collector(PLAN, "--quick", "--replicates", "2").returncode, 0)
        self.assertEqual(json.loads((self.out / "summary.json").read_text())["n_done"], 8)


if __name__ == "__main__":
    unittest.main()
