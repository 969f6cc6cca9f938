# SPDX-License-Identifier: GPL-3.0-or-later
"""Every row of the mistakes in docs/reference/warnings.md: its command answers with its remedy, one sentence."""
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
ROW = re.compile(r"^\| ([^|]+) \| `([^|`]+)` \| ([^|]+) \|$")


def rows():
    """Mistake, words of the command and remedy of each row."""
    page = (SOURCE / "docs/reference/warnings.md").read_text(encoding="utf-8")
    table = page.partition("## Mistakes of the first hour")[2]
    return [(match[1], shlex.split(match[2]), match[3]) for match in map(ROW.match, table.splitlines()) if match]


class Mistakes(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.succeeds("schema", "--template", stdout=(self.path / "mine.toml").open("w"))
        self.succeeds("run", "mine.toml", "--set", "time.duration=0.1")
        shutil.copy(SOURCE / "experiments/failure_database/cone_network.json", self.path)
        (self.path / "short.csv").write_text("time,Fx\n0,1\n0.01,2\n0.02,3\n")

    def call(self, *arguments, stdout=subprocess.PIPE):
        return subprocess.run([BRASH, *arguments], cwd=self.path, text=True, stdout=stdout, stderr=subprocess.PIPE)

    def succeeds(self, *arguments, **options):
        done = self.call(*arguments, **options)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_an_empty_name_is_not_taken_for_the_default(self):
        before = sorted(self.path.rglob("*"))
        for words in (("run", "mine.toml", "-o", ""), ("campaign", "plan.toml", "-o", ""),
                      ("check", "mine.toml", "--picture", ""), ("export", "gltf", "results/mine/run.nc", "-o", "")):
            done = self.call(*words)
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertIn("the name is empty", done.stderr)
            self.assertIn("remedy:", done.stderr)
        self.assertEqual(sorted(self.path.rglob("*")), before)

    def test_a_second_key_without_its_set_is_told_so(self):
        done = self.call("run", "mine.toml", "--set", "ice.thickness=1", "structure.speed=2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("structure.speed=2 is one argument too many", done.stderr)
        self.assertIn("write --set structure.speed=2", done.stderr)

    def test_a_campaign_tells_the_warnings_of_its_settings_before_it_runs(self):
        plan = self.path / "plan.toml"
        plan.write_text('[campaign]\ncase = "mine.toml"\n[set]\ntime.step = 0.1\n'
                        '[[grid]]\ntime.duration = [0.1, 0.2, 20]\n')
        warned = ("warning: no-statistics: 2 of 3 settings, such as duration-0.1: the run is over before its statistics "
                  "begin")
        status = self.call("campaign", "plan.toml", "-o", "c", "--status", "--json")
        self.assertEqual(status.returncode, 0, status.stderr)
        self.assertEqual(status.stderr.count("warning: no-statistics: "), 1)
        self.assertIn(warned, status.stderr)
        self.assertIn('"n_missing": 3', status.stdout)
        stopped = subprocess.run([BRASH, "campaign", "plan.toml", "-o", "mine.toml"], cwd=self.path, text=True,
                                 capture_output=True)
        self.assertIn(warned, stopped.stderr)
        self.assertNotEqual(stopped.returncode, 0)
        plan.write_text('[campaign]\ncase = "mine.toml"\n[set]\ntime.duration = 0.1\n')
        alone = self.call("campaign", "plan.toml", "-o", "c", "--status")
        self.assertIn("warning: no-statistics: the run is over", alone.stderr)

    def test_each_mistake_is_told_its_remedy(self):
        self.assertEqual(len(rows()), 9)
        for mistake, words, remedy in rows():
            with self.subTest(mistake):
                before = sorted(self.path.rglob("*"))
                done = self.call(*words)
                self.assertNotIn(". ", remedy)
                if done.returncode == 0:  # a result that cannot be used is told below it
                    self.assertIn(f": {remedy}\n", done.stdout.splitlines(keepends=True)[-1])
                else:
                    self.assertEqual(done.returncode, 2, done.stderr)
                    self.assertEqual(re.findall(r"^  remedy:  (.*)$", done.stderr, re.MULTILINE), [remedy])
                self.assertEqual(sorted(self.path.rglob("*")), before)


if __name__ == "__main__":
    unittest.main()
