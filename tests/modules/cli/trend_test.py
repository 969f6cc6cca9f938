# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash trend`: the exact p-value, Holm's adjustment, the choice of settings, refusals."""
import itertools
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

BRASH = os.environ["BRASH"]
COLUMNS = ["case", "setting", "replicate", "status", "structure.angle", "structure.speed", "horizontal.mean",
           "vertical.mean"]
LOADS = {(50, 0.5): [10.0, 11.0, 12.5], (60, 0.5): [12.0, 13.0, 12.2], (70, 0.5): [14.0, 14.5],
         (50, 2.0): [30.0, 31.0], (60, 2.0): [20.0, 21.0], (70, 2.0): [10.0, 10.5]}


def exact_p(groups):
    """Two-sided p of Jonckheere and Terpstra over all ways to deal the values to the groups."""
    label = [g for g, group in enumerate(groups) for _ in group]

    def score(values):
        return sum((y > x) - (y < x) for (i, x), (j, y) in itertools.combinations(zip(label, values), 2) if i != j)

    observed = abs(score([x for group in groups for x in group]))
    scores = [abs(score(order)) for order in itertools.permutations(x for group in groups for x in group)]
    return sum(s >= observed for s in scores) / len(scores)


class Trend(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        lines = [",".join(COLUMNS)]
        for (angle, speed), values in LOADS.items():
            name = f"angle-{angle}deg_speed-{speed}"
            lines += [f"{name}-r{i:04d},{name},{i},done,{angle},{speed},{x},{i + 1.5}" for i, x in enumerate(values)]
            lines.append(f"{name}-r0009,{name},9,failed,{angle},{speed},,")
        (self.folder / "campaign.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")

    def trend(self, *arguments, code=0):
        done = subprocess.run([BRASH, "trend", str(self.folder), *arguments], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def test_the_p_value_is_exact_and_failed_cases_are_left_out(self):
        done = self.trend("--along", "structure.angle", "--where", "*_speed-0.5", "--json")
        trend = json.loads(done.stdout)["trends"][0]
        groups = [LOADS[angle, 0.5] for angle in (50, 60, 70)]
        self.assertEqual([s["n"] for s in trend["settings"]], [3, 3, 2])
        self.assertAlmostEqual(trend["jonckheere_terpstra"]["p"], exact_p(groups), places=12)
        self.assertEqual(trend["trend"], "rises")

    def test_several_columns_are_adjusted_together(self):
        done = self.trend("--along", "structure.angle", "--where", "*_speed-2.0", "--of", "horizontal.mean", "--of",
                          "vertical.mean", "--json")
        load, other = json.loads(done.stdout)["trends"]
        self.assertAlmostEqual(load["p_adjusted"], 2 * load["jonckheere_terpstra"]["p"], places=12)
        self.assertEqual(load["trend"], "falls")
        self.assertEqual(other["trend"], "undecided")
        self.assertLess(load["last_less_first"]["interval_95"][1], 0)

    def test_what_cannot_be_tested_is_refused(self):
        self.assertIn("no column 'structure.width'\n  allowed: one of: case, setting",
                      self.trend("--along", "structure.width", code=2).stderr)
        self.assertIn("allowed: 2 settings at least", self.trend("--along", "structure.angle", "--where", "angle-50deg_*",
                                                             code=2).stderr)


if __name__ == "__main__":
    unittest.main()
