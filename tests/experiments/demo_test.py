# SPDX-License-Identifier: GPL-3.0-or-later
"""The case of `./dev demo`, and what its table says of the measured mean: demo_test.py BRASH FOLDER."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tomllib
import unittest

CASES = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/validation"
BRASH, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])


def keys(name):
    return tomllib.loads((CASES / name).read_text(encoding="utf-8"))


class Demo(unittest.TestCase):
    def test_the_case_is_the_validation_case_with_the_default_preset(self):
        demo, cone = keys("demo.toml"), keys("cone.toml")
        self.assertEqual(cone.pop("algorithm"), {"preset": "paper"})
        self.assertEqual(demo, cone)

    def table(self, *settings, preset="paper"):
        """The table of a short run, and its summary. The paper's algorithm is the faster one."""
        sets = [word for setting in (f"algorithm.preset='{preset}'", *settings) for word in ("--set", setting)]
        done = subprocess.run([BRASH, "run", CASES / "demo.toml", "-o", FOLDER, "--replace", *sets],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout, json.loads((FOLDER / "summary.json").read_text())

    def test_the_table_compares_the_mean_with_the_measured_one_and_says_how_long_it_is(self):
        table, summary = self.table("time.duration=2", "output.statistics_from=0.5")
        mean = summary["horizontal"]["mean"] / 1e3
        percent = 100.0 * (mean / 111.8 - 1.0)
        row = re.search(r"this run, mean over 1\.5 s +(\S+)  (\S+) % (above|below) the measured mean\n(.*)\n", table)
        self.assertIsNotNone(row, table)
        self.assertEqual(row[1], f"{mean:.1f}")
        self.assertEqual(row[2], f"{abs(percent):.1f}")
        self.assertEqual(row[3], "below" if percent < 0.0 else "above")
        self.assertIn("weak evidence", row[4])

    def test_each_mean_of_the_table_has_its_number_of_independent_samples_beside_it(self):
        table, summary = self.table("time.duration=1", "output.statistics_from=0.5")
        for load in ("horizontal", "vertical"):
            mean, samples = (summary[load][key] for key in ("mean", "effective_sample_size"))
            self.assertRegex(table, rf"  {load} +{mean / 1e3:.1f}  \[no interval\] +{samples:.1f} ")
        few = summary["horizontal"]["effective_sample_size"] < 10
        self.assertEqual("few-samples: the load has " in table, few)

    def test_a_run_without_statistics_is_compared_with_nothing(self):
        table, _ = self.table("time.duration=0.3", preset="brash")
        self.assertNotIn("measured mean", table)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
