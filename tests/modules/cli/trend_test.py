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
        # Both intervals together hold with 95 %: each has Student's t at 97.5 % of Welch's freedom.
        one = self.trend("--along", "structure.angle", "--where", "*_speed-2.0", "--json")
        alone = json.loads(one.stdout)["trends"][0]["last_less_first"]
        self.assertEqual(load["last_less_first"]["confidence"], 0.975)
        self.assertEqual(alone["confidence"], 0.95)
        self.assertEqual(load["last_less_first"]["difference"], alone["difference"])
        self.assertLess(load["last_less_first"]["interval_95"][0], alone["interval_95"][0])
        text = self.trend("--along", "structure.angle", "--where", "*_speed-2.0", "--of", "horizontal.mean", "--of",
                          "vertical.mean").stdout
        self.assertIn("] at 97.5 %", text)

    def name_the_axes(self):
        settings = [{"setting": "s", "values": {"structure.angle": a, "structure.speed": v}} for a, v in LOADS]
        (self.folder / "summary.json").write_text(json.dumps({"settings": settings}))

    def test_other_axes_of_the_grid_are_kept_apart(self):
        self.name_the_axes()
        (trend,) = json.loads(self.trend("--along", "structure.angle", "--json").stdout)["trends"]
        self.assertEqual([s["stratum"] for s in trend["strata"]], ["structure.speed = 0.5", "structure.speed = 2.0"])
        # Loads rise at one speed and fall at the other: pooled, the scores of both strata add.
        scores, variances = [], []
        for speed in (0.5, 2.0):
            groups = [LOADS[angle, speed] for angle in (50, 60, 70)]
            n = [len(group) for group in groups]
            pairs = itertools.combinations([(g, x) for g, group in enumerate(groups) for x in group], 2)
            scores.append(sum((y > x) - (y < x) for (i, x), (j, y) in pairs if i != j))
            total = sum(n)
            variances.append((total * (total - 1) * (2 * total + 5) - sum(k * (k - 1) * (2 * k + 5) for k in n)) / 18)
        self.assertAlmostEqual(trend["jonckheere_terpstra"]["z"], sum(scores) / sum(variances)**0.5, places=9)
        ends = [sum(LOADS[70, v]) / len(LOADS[70, v]) - sum(LOADS[50, v]) / len(LOADS[50, v]) for v in (0.5, 2.0)]
        self.assertAlmostEqual(trend["last_less_first"]["difference"], sum(ends) / 2, places=9)

    def test_a_table_keeps_the_axes_that_the_summary_beside_it_names(self):
        table = self.folder / "campaign.csv"
        alone = subprocess.run([BRASH, "trend", str(table), "--along", "structure.angle"], capture_output=True, text=True)
        self.assertEqual(alone.returncode, 2)
        self.assertIn("'angle-50deg_speed-0.5' and 'angle-50deg_speed-2.0' have one value of 'structure.angle'", alone.stderr)
        self.assertIn("  remedy:  name the folder of the campaign, or choose settings with --where", alone.stderr)
        self.name_the_axes()
        of_folder = self.trend("--along", "structure.angle", "--json").stdout
        for given, place in ((table, "/"), ("campaign.csv", self.folder)):
            of_table = subprocess.run([BRASH, "trend", str(given), "--along", "structure.angle", "--json"], cwd=place,
                                      capture_output=True, text=True)
            self.assertEqual(of_table.stdout, of_folder)

    def write_speeds(self, loads):
        """Cases of speeds and angles with these loads, and the summary that names the axes."""
        lines = [",".join(COLUMNS)]
        for (angle, speed), values in loads.items():
            name = f"angle-{angle}_speed-{speed}"
            lines += [f"{name}-r{i},{name},{i},done,{angle},{speed},{x},{x}" for i, x in enumerate(values)]
        (self.folder / "campaign.csv").write_text("\n".join(lines) + "\n")
        self.name_the_axes()

    def test_the_difference_of_the_ends_is_of_strata_that_have_both(self):
        # The load rises by 100 a step. All cases of angle 3 at speed 2 failed.
        loads = {(angle, speed): [100.0 * angle + 1000.0 * speed + e for e in (-1, 0, 1)]
                 for speed in (1, 2) for angle in (1, 2, 3) if (angle, speed) != (3, 2)}
        self.write_speeds(loads)
        (trend,) = json.loads(self.trend("--along", "structure.angle", "--json").stdout)["trends"]
        ends = trend["last_less_first"]
        self.assertAlmostEqual(ends["difference"], 200.0, places=9)
        # Student's t of 4 degrees of freedom, and the error of a difference of two means of three.
        self.assertAlmostEqual(ends["interval_95"][1] - 200.0, 2.776445 * (2 / 3)**0.5, places=5)
        self.assertEqual(ends["strata"], 1)
        self.assertEqual(len(trend["strata"]), 2)  # the test of the trend keeps both
        self.assertIn("], in the 1 of 2 strata with both ends\n", self.trend("--along", "structure.angle").stdout)

    def test_no_stratum_with_both_ends_has_no_difference(self):
        self.write_speeds({(1, 1): [1.0, 1.2], (2, 1): [1.1, 1.3], (2, 2): [5.0, 5.2], (3, 2): [5.1, 5.3]})
        (trend,) = json.loads(self.trend("--along", "structure.angle", "--json").stdout)["trends"]
        self.assertEqual(trend["last_less_first"],
                         {"difference": None, "interval_95": [None, None], "confidence": 0.95, "strata": 0})
        self.assertEqual(trend["trend"], "undecided")
        self.assertIn("last less first: no stratum has both ends", self.trend("--along", "structure.angle").stdout)

    def test_a_difference_of_the_ends_is_no_undecided_trend(self):
        lines = [",".join(COLUMNS)]
        for angle, values in ((50, (10.0, 10.1)), (60, (8.0, 8.1)), (70, (10.5, 10.6))):
            lines += [f"a{angle}-r{i},a{angle},{i},done,{angle},1,{x},{x}" for i, x in enumerate(values)]
        (self.folder / "campaign.csv").write_text("\n".join(lines) + "\n")
        found = json.loads(self.trend("--along", "structure.angle", "--json").stdout)["trends"][0]
        self.assertGreater(found["last_less_first"]["interval_95"][0], 0.0)
        self.assertEqual(found["trend"], "last above first")
        self.assertIn("the ends differ at 5 %", self.trend("--along", "structure.angle").stdout)

    def test_an_undecided_trend_says_how_large_a_change_could_hide(self):
        lines = [",".join(COLUMNS)]
        for angle, values in ((50, (10.0, 12.0)), (60, (11.0, 10.5))):
            lines += [f"a{angle}-r{i},a{angle},{i},done,{angle},1,{x},{x}" for i, x in enumerate(values)]
        (self.folder / "campaign.csv").write_text("\n".join(lines) + "\n")
        self.assertRegex(self.trend("--along", "structure.angle").stdout, r"a change of up to [\d.]+ could hide")

    def test_quoted_cells_of_a_campaign_may_hold_commas_quotes_and_line_ends(self):
        before = self.trend("--along", "structure.angle", "--where", "*_speed-2.0", "--json").stdout
        path = self.folder / "campaign.csv"
        head, *rows = path.read_text(encoding="utf-8").splitlines()
        text = '"a, ""b""\nc"'
        path.write_text("\r\n".join([f'"failure.file",{head}', *(f"{text},{row}" for row in rows)]) + "\r\n", encoding="utf-8",
                        newline="")
        self.assertEqual(self.trend("--along", "structure.angle", "--where", "*_speed-2.0", "--json").stdout, before)

    def test_what_cannot_be_tested_is_refused(self):
        self.assertIn("no column 'structure.width'\n  allowed: one of: case, setting",
                      self.trend("--along", "structure.width", code=2).stderr)
        self.name_the_axes()
        self.assertIn("allowed: 2 settings at least", self.trend("--along", "structure.angle", "--where", "angle-50deg_*",
                                                             code=2).stderr)


if __name__ == "__main__":
    unittest.main()
