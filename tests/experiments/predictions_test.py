# SPDX-License-Identifier: GPL-3.0-or-later
"""The machinery of experiments/predictions against closed forms and made-up runs."""
import argparse
import math
import os
import pathlib
import re
import sys
import tempfile
import unittest
import unittest.mock

import numpy as np
from scipy import stats

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
PREDICTIONS = SOURCE / "experiments" / "predictions"
sys.path[:0] = [str(PREDICTIONS), str(PREDICTIONS.parent)]

import brash
import case_numbers
import details
import figures
import inputs
import pictures
import predict
import regressions
import signs
import tables
import verdicts


class Regressions(unittest.TestCase):
    def test_simple_forms(self):
        self.assertAlmostEqual(regressions.edwards(width=0, thickness=2, flexural_strength=1e5), 6.4e5)
        self.assertAlmostEqual(regressions.ship_breaking_length(10, 0), 3.2)


class Verdicts(unittest.TestCase):
    # experiments/sensitivity/README.md, (U2), (U3), (U4)

    def test_a_prediction_interval_holds_one_more_run_as_often_as_it_says(self):
        random = np.random.default_rng(7)
        inside = 0
        for _ in range(4000):
            *runs, one_more = np.exp(random.normal(2, 0.5, 9))
            low, high = verdicts.prediction_interval(runs, confidence=0.9)
            inside += low <= one_more <= high
        # The deviation of the count is 0.5 %.
        self.assertAlmostEqual(inside / 4000, 0.9, delta=0.02)

    def test_values_of_both_signs_have_a_linear_interval(self):
        low, high = verdicts.prediction_interval([-1.0, 0.0, 1.0])
        half = stats.t.ppf(0.975, 2) * math.sqrt(4 / 3)
        np.testing.assert_allclose([low, high], [-half, half])
        self.assertTrue(math.isnan(verdicts.prediction_interval([1.0])[0]))

    def test_validation_uncertainty_joins_its_parts(self):
        # S = 110 with deviation 6, D = 100: u = sqrt(5.5^2 + 6^2 + 8^2).
        found = verdicts.validation([104.0, 110.0, 116.0], 100.0, u_numerical=0.05, u_measured=0.08)
        self.assertAlmostEqual(found["u_val"], math.sqrt(5.5**2 + 36 + 64))
        self.assertAlmostEqual(found["error"], 10.0)
        self.assertFalse(found["told"])
        self.assertTrue(verdicts.validation([109.9, 110, 110.1], 100.0, 0.01, 0.01)["told"])

    def test_a_series_has_bias_and_coverage(self):
        found = verdicts.series([200.0, 200.0], [100.0, 400.0], [True, False])
        self.assertAlmostEqual(found["bias"], 0.0)
        self.assertAlmostEqual(found["rms"], math.log(2))
        self.assertEqual(found["covered"], 1)
        # Clopper and Pearson, 1 in 2: 1 - sqrt(0.975) and its mirror.
        np.testing.assert_allclose(found["coverage_95"], [1 - math.sqrt(0.975), math.sqrt(0.975)])

    def test_one_point_above_refutes_a_bound(self):
        criterion = {"statistic": "mean", "bound": 2.0}
        rows = [{"point": i, "mean": value} for i, value in enumerate([1.0, 1.5, 1.9])]
        self.assertEqual(verdicts.upper_bound(rows, criterion)["verdict"], "holds")
        found = verdicts.upper_bound(rows + [{"point": 3, "mean": 3.0}, {"point": 4, "mean": None}], criterion)
        self.assertEqual([found[name] for name in ("verdict", "above", "n_points", "largest_ratio")], ["refuted", 1, 4, 1.5])

    def test_a_bound_is_open_if_a_run_has_no_number_and_no_point_lies_above(self):
        criterion = {"statistic": "mean", "bound": 2.0}
        rows = [{"point": 1, "mean": 1.0}, {"point": 2, "mean": 1.5}, {"point": 2, "mean": None}]
        found = verdicts.upper_bound(rows, criterion)
        self.assertEqual((found["verdict"], found["without"], found["n_points"]), ("open", 1, 2))
        self.assertEqual(verdicts.upper_bound(rows + [{"point": 3, "mean": math.nan}], criterion)["without"], 2)


class Distributions(unittest.TestCase):
    LEVELS = [0.5, 1.0, 2.0, 3.0]

    def test_shares_below_levels_are_counted_and_open_without_events(self):
        found = verdicts.distribution([0.2, 0.7, 1.5, 4.0], [], self.LEVELS)
        self.assertEqual([row["below"] for row in found["rows"]], [1, 2, 3, 3])
        self.assertEqual(found["verdict"], "open")
        np.testing.assert_allclose(found["rows"][0]["share_95"], verdicts.share_interval(1, 4))

    def test_events_of_the_same_law_hold_and_those_of_another_refute(self):
        random = np.random.default_rng(13)
        runs = np.exp(random.normal(0, 0.8, 32))
        self.assertEqual(verdicts.distribution(runs, np.exp(random.normal(0, 0.8, 130)), self.LEVELS)["verdict"], "holds")
        found = verdicts.distribution(runs, 10.0 * np.exp(random.normal(0, 0.8, 130)), self.LEVELS)
        self.assertEqual(found["verdict"], "refuted")
        self.assertGreater(found["beyond"], 0.5)

    def test_equal_laws_are_rarely_refuted(self):
        random = np.random.default_rng(14)
        refuted = sum(verdicts.distribution(np.exp(random.normal(size=32)), np.exp(random.normal(size=130)), self.LEVELS)["verdict"]
                      == "refuted" for _ in range(400))
        self.assertLess(refuted / 400, 0.05 + 3 * 0.011)

    def test_a_page_has_the_shares_and_the_events(self):
        prediction = predict.prediction_of("m3b")
        rows = [{"arm": "", "point": i + 1, "replicate": 0, "largest_2s": 1e5 * (i + 1), "largest_0.1s": 2e5} for i in range(32)]
        text = tables.verdict(prediction, rows, [], None)
        self.assertIn("| 1000 | 9 of 32 | 28% (", text)
        self.assertIn("| largest_2s [kN] | 1650 |", text)
        text = tables.verdict(prediction, rows, [{"arm": "", "largest_2s": 1e7}] * 130, None)
        self.assertIn("**refuted**. Beyond all runs: 100% of the events.", text)
        self.assertIn("| 9 of 32 | 28% (14% to 47%) | 0 of 130 |", text)


class OneHistory(unittest.TestCase):
    CRITERION = {"statistics": ["mean", "growth"], "also": ["deviation"], "confidence": 0.95}

    def rows(self):
        random = np.random.default_rng(15)
        return [{"point": i, "mean": math.exp(0.1 * random.normal()), "growth": math.exp(0.1 * random.normal()),
                 "deviation": math.exp(0.1 * random.normal())} for i in range(16)]

    def test_judged_numbers_hold_together_and_one_outside_refutes(self):
        rows = self.rows()
        inside = verdicts.one_history(rows, self.CRITERION, {"mean": 1.0, "growth": 1.0, "deviation": 9.0})
        self.assertEqual(inside["verdict"], "holds")  # the deviation has no verdict
        self.assertEqual([row["inside"] for row in inside["rows"]], [True, True, False])
        self.assertEqual(verdicts.one_history(rows, self.CRITERION, {"mean": 2.0, "growth": 1.0})["verdict"], "refuted")
        self.assertEqual(verdicts.one_history(rows, self.CRITERION, {"mean": 1.0})["verdict"], "open")
        # Bonferroni: two judged numbers at 97.5 % each, the other at 95 %.
        for k, confidence in ((0, 0.975), (2, 0.95)):
            low, high = verdicts.prediction_interval([row[inside["rows"][k]["number"]] for row in rows], 16, confidence)
            self.assertAlmostEqual(inside["rows"][k]["low"], low)
            self.assertAlmostEqual(inside["rows"][k]["high"], high)

    def test_a_measured_history_gets_the_same_numbers_as_a_run(self):
        prediction = predict.prediction_of("m5b")
        time = np.arange(0, 70, 0.05)
        load = 1000.0 * (1.0 + 0.05 * time) + 300.0 * np.sin(2 * np.pi * 1.5 * time)
        with tempfile.TemporaryDirectory() as folder:
            np.savetxt(f"{folder}/case1.csv", np.c_[time + 5, load], delimiter=",", header="time,load", comments="")
            options = argparse.Namespace(measured=None, data=pathlib.Path(folder), column="load", start=5.0, end=None)
            found, = tables.measured_rows(prediction, options)
            pathlib.Path(folder, "other.csv").write_text("time,load\n0,1\n1,2\n", encoding="utf-8")
            with self.assertRaisesRegex(inputs.BadInput, "has 2 CSV files.*leave one file in it"):
                tables.measured_rows(prediction, options)
        expected = case_numbers.growth_numbers(time, load, prediction.growth, 0.05, 10)
        for name, value in expected.items():
            self.assertAlmostEqual(found[name], value, places=6, msg=name)


class Growth(unittest.TestCase):
    TABLE = {"windows": [[0, 0.5], [0.5, 1], [1, 3]], "skip": 2, "rate": 20}

    def numbers(self, end=62.0):
        time = np.arange(0, end, 0.001)
        return case_numbers.growth_numbers(time, 1000 * (1 + 0.05 * time) + 200 * np.sin(4 * np.pi * time), self.TABLE, 0.05, 10)

    def test_windows_of_ice_have_the_means_of_a_growing_load(self):
        found = self.numbers()
        # 100 N/m (1 + x / 1 m) over 0.1 to 0.5, 0.5 to 1, and 1 to 3 m: 2 s of 0.05 m/s stay out.
        for name, value in {"mean_0-0.5m": 130, "mean_0.5-1m": 175, "mean_1-3m": 300, "growth_1-3m": 300 / 130}.items():
            self.assertAlmostEqual(found[name] / value, 1.0, delta=1e-3, msg=name)

    def test_a_trend_hides_no_peak_and_no_line(self):
        found = self.numbers()
        self.assertAlmostEqual(found["peaks_per_second"], 2.0, delta=0.05)
        self.assertAlmostEqual(found["mean_frequency"], 2.0, delta=0.05)
        self.assertGreater(found["share_above_1Hz"], 0.95)

    def test_a_window_that_is_not_whole_has_no_number(self):
        self.assertNotIn("mean_1-3m", self.numbers(end=59.0))

    def test_a_slower_sensor_takes_means(self):
        time = np.arange(300) * 0.01
        np.testing.assert_allclose(case_numbers.at_rate(time - 1.0, time, 2.0), [1.245, 1.745, 2.245, 2.745])

    def test_time_is_counted_from_the_first_load(self):
        time, _ = case_numbers.since_contact({"time": np.array([1.0, 2.0, 3.0]), "Fx": np.array([0.0, 5.0, 1.0])})
        np.testing.assert_allclose(time, [-1.0, 0.0, 1.0])


class SomeArms(unittest.TestCase):
    def test_an_unknown_of_some_arms_leaves_the_others(self):
        prediction = predict.prediction_of("m7")
        thick, thin = (inputs.setting_values(prediction, arm, [1.0] * len(prediction.unknowns)) for arm in ("thick-192", "thin-377"))
        self.assertEqual(thick["ice.thickness"], 1.59)
        self.assertAlmostEqual(thin["ice.thickness"], 0.95 * 1.15, places=4)

    def test_faults_of_arms_and_factors_are_named(self):
        text = (PREDICTIONS / "m7" / "prediction.toml").read_text(encoding="utf-8")
        grown = (PREDICTIONS / "m5b" / "prediction.toml").read_text(encoding="utf-8")
        for whole, old, new, message in ((text, 'arms = ["thin-377", "thin-321"', 'arms = ["thin", "thin-321"', "arms = thin: is no arm"),
                                         (text, "ice.flexural_strength = 500.8e3", 'time.step = 0.01', "has no number to multiply"),
                                         (grown, "rate = 20 ", "rates = 20 ", "growth.rate: is missing")):
            with tempfile.TemporaryDirectory() as folder:
                pathlib.Path(folder, "prediction.toml").write_text(whole.replace(old, new, 1), encoding="utf-8")
                with self.assertRaisesRegex(inputs.BadInput, message):
                    inputs.Prediction(folder)


class Rows(unittest.TestCase):
    def test_a_plan_leaves_out_what_is_recorded(self):
        prediction = predict.prediction_of("m7")
        points = inputs.points_of(prediction, 8)
        whole, rest = (inputs.plan_text(prediction, points, prediction.folder, without=done) for done in ((), {"thick-192.s001"}))
        self.assertIn('labels = ["thick-192.s001", "thick-145.s001"', whole)
        self.assertIn('labels = ["thick-145.s001"', rest)

    def test_rows_join_and_the_campaign_wins(self):
        prediction = predict.prediction_of("m7")
        row = {"arm": "thick-145", "point": 1, "replicate": 0, "mean": 1.0}
        rows = tables.joined_rows(prediction, [row, {**row, "arm": "thin-377"}], [{**row, "mean": 2.0}, {**row, "arm": "thick-192", "new": 3}])
        self.assertEqual([(r["arm"], r["mean"], r["new"]) for r in rows], [("thick-192", 1.0, 3), ("thick-145", 2.0, None), ("thin-377", 1.0, None)])

    def test_the_hours_of_every_prediction_are_stated(self):
        rows = case_numbers.read_table(PREDICTIONS / "hours.csv")
        self.assertEqual([row["order"] for row in rows], list(range(1, len(rows) + 1)))
        cases = {row["folder"]: row["cases"] for row in rows}
        for name in predict.ALL:
            prediction = predict.prediction_of(name)
            if prediction.own_runs:
                self.assertEqual(cases[name], prediction.n_cases(), name)
        stated = float(re.search(r"Its (\d+) core hours", (PREDICTIONS / "README.md").read_text()).group(1))
        self.assertAlmostEqual(sum(row["core_hours"] for row in rows), stated, delta=0.5)

    def test_loads_have_a_row_a_test(self):
        prediction = predict.prediction_of("m1")
        rows = made_up(prediction, np.linspace(3e5, 9e5, 10))
        found = details.load_rows(prediction, rows)
        self.assertEqual([row["arm"] for row in found], list(prediction.arms))
        means = [row["mean"] for row in rows if row["arm"] == "r103"]
        self.assertAlmostEqual(found[0]["mean"], np.median(means))
        np.testing.assert_allclose([found[0]["mean_low"], found[0]["mean_high"]], verdicts.prediction_interval(means))
        self.assertNotIn("largest", found[0])

    def test_the_table_of_all_has_a_row_a_judged_number(self):
        prediction = predict.prediction_of("m1")
        rows = made_up(prediction, np.linspace(3e5, 9e5, 10))
        found = tables.overview(prediction, rows, [], None)
        self.assertEqual([row["arm"] for row in found], list(prediction.arms))
        self.assertEqual({row["verdict"] for row in found}, {"open"})
        self.assertAlmostEqual(found[0]["riska"], 600.0)
        self.assertEqual(tables.overview(prediction, [], [], None)[0]["verdict"], "not run")
        self.assertEqual(tables.markdown(found)[1].count("---"), len(found[0]))


def two_arms(ratio, n=16, spread=0.05, seed=8):
    """Rows of two arms: thin and thick ice differ tenfold, the second arm by `ratio`."""
    random = np.random.default_rng(seed)
    rows = []
    for i in range(n):
        level = 10 ** random.random()
        other = level * ratio * math.exp(spread * random.normal())
        rows += [{"arm": "a", "point": i, "mean": level, "width": 10.0, "flag": 1.0},
                 {"arm": "b", "point": i, "mean": other, "width": 20.0, "flag": i % 2}]
    return rows


def outcome(rows, **claim):
    return signs.tested(rows, {"text": "", "statistic": "mean", "arms": ["a", "b"], **claim})


class Signs(unittest.TestCase):
    # experiments/sensitivity/README.md, (U5)

    def test_pairs_see_a_small_difference_under_a_large_spread_of_ice(self):
        rises = outcome(two_arms(1.1), kind="rises")
        self.assertLess(rises.p, 1e-4)
        self.assertAlmostEqual(rises.effect, 1.1, delta=0.05)
        self.assertTrue(rises.interval[0] < 1.1 < rises.interval[1])
        falls = outcome(two_arms(1.1), kind="falls")
        self.assertAlmostEqual(falls.p, rises.opposite)
        self.assertGreater(falls.p, 0.99)

    def test_an_exponent_along_a_key(self):
        found = outcome(two_arms(2.0**1.5, spread=0.01), kind="rises", along="width")
        self.assertAlmostEqual(found.effect, 1.5, delta=0.02)
        found = outcome(two_arms(math.exp(0.3), spread=0.0), kind="rises", along="width", scale="linear")
        self.assertAlmostEqual(found.effect, 0.03)

    def test_same_needs_evidence_and_not_its_absence(self):
        self.assertLess(outcome(two_arms(1.05), kind="same", margin=0.25).p, 0.001)
        few = outcome(two_arms(1.0, n=4, spread=0.5), kind="same", margin=0.25)
        self.assertTrue(few.p > 0.05 and few.opposite > 0.05)
        self.assertLess(outcome(two_arms(2.0), kind="same", margin=0.25).opposite, 0.001)

    def test_ratios_bounds_and_shares(self):
        self.assertLess(outcome(two_arms(0.4), kind="ratio-within", low=0.25, high=0.55).p, 0.001)
        self.assertLess(outcome(two_arms(0.9), kind="ratio-within", low=0.25, high=0.55).opposite, 0.001)
        rows = [{**row, "beside": row["mean"] / 3} for row in two_arms(1.0)]
        self.assertLess(outcome(rows, kind="exceeds", over=["beside"], bound=2.5).p, 1e-6)
        self.assertLess(outcome(rows, kind="within", over=["beside"], low=2, high=4).p, 1e-6)
        self.assertLess(outcome(rows, kind="within", over=["beside"], low=1, high=2).opposite, 1e-6)
        share = outcome(rows, kind="share", statistic="flag", above=0.5, arms=["a"])
        self.assertAlmostEqual(share.p, 0.5**16)

    def test_a_rise_beyond_another_rise(self):
        rows = [{**row, "part": 0.2 * row["mean"]} for row in two_arms(2.0)]
        self.assertLess(outcome(rows, kind="rises-beyond", beside="part", times=2.0).p, 0.001)
        self.assertLess(outcome(rows, kind="rises-beyond", beside="part", times=8.0).opposite, 0.001)

    def test_replicates_of_a_point_meet_in_the_mean_of_their_logarithms(self):
        rows = [{"arm": "a", "point": point, "replicate": i, "mean": mean * (1.0 + 1e-3 * point)}
                for point in range(1, 5) for i, mean in enumerate((1.0, 4.0))]
        found = outcome(rows, kind="within", low=1.9, high=2.1)
        self.assertAlmostEqual(found.effect, 2.0, delta=0.01)
        self.assertEqual(found.n, 4)

    def test_points_without_a_number_leave_and_are_counted(self):
        rows = two_arms(1.2)
        rows[1]["mean"] = None
        rows = rows[:-1]
        found = outcome(rows, kind="rises")
        self.assertEqual((found.n, found.left_out), (14, 2))
        self.assertEqual(outcome(rows[:4], kind="rises").p, 1.0)
        self.assertEqual(outcome(two_arms(1.2), kind="rises", where={"width": [15, 25]}).n, 0)

    def test_holm_is_the_programs_own(self):
        p = np.random.default_rng(9).random(10) ** 3
        np.testing.assert_allclose(signs.holm(p), brash.holm(p))

    def test_all_claims_must_hold_and_one_may_contradict(self):
        holds = outcome(two_arms(1.2), kind="rises")
        fails = outcome(two_arms(1.2), kind="falls")
        unsure = outcome(two_arms(1.0, n=4, spread=0.5), kind="same", margin=0.25)
        found = signs.judged({"s1": [holds], "s2": [holds, fails], "s3": [holds, unsure]}, family=10)
        self.assertEqual([found[name][0] for name in ("s1", "s2", "s3")], ["shown", "contradicted", "open"])
        self.assertAlmostEqual(found["s1"][1], 10 * holds.p)

    def test_true_null_signs_are_rarely_shown(self):
        # Ten signs without an effect: one or more is shown in at most 5 % of 400 families (deviation 1.1 %).
        wrong = 0
        for i in range(400):
            family = {str(j): [outcome(two_arms(1.0, n=8, seed=1000 * i + j), kind="rises")] for j in range(10)}
            wrong += any(verdict != "open" for verdict, _ in signs.judged(family).values())
        self.assertLess(wrong / 400, 0.05 + 0.05 + 3 * 0.015)  # shown and contradicted together


class Numbers(unittest.TestCase):
    def test_block_means_leave_an_incomplete_block_out(self):
        np.testing.assert_allclose(case_numbers.block_means(np.arange(7.0), 0.5, 1.0), [0.5, 2.5, 4.5])

    def test_numbers_of_a_square_wave(self):
        time = np.arange(1, 2001) * 0.01
        force = np.where((time - 0.005) % 2 < 1, 3.0, 1.0)
        history = {"time": time, "Fx": force, "crushing_Fx": force / 2, "floe_normal_Fx": force / 4, "floe_friction_Fx": force / 4}
        found = case_numbers.history_numbers(history, 12.0, {"late": [8, 10]}, 0.5)
        for name, value in {"mean": 2, "largest": 3, "smallest": 1, "mean_1s": 2, "largest_1s": 3, "crushing": 1, "floes": 1,
                            "late": 2, "second_half_over_first": 1}.items():
            self.assertAlmostEqual(found[name], value, delta=0.05, msg=name)

    def test_the_length_of_an_elastic_plate(self):
        case = {"ice.thickness": 0.33, "ice.poisson_ratio": 0.3, "ice.youngs_modulus": 0.35e9, "water.density": 1025.0}
        cone = brash.Case.from_file(SOURCE / "experiments/validation/demo.toml")
        self.assertAlmostEqual(case_numbers.characteristic_length(case), brash.characteristic_length(cone), places=6)
        self.assertAlmostEqual(inputs.modulus_of(case_numbers.characteristic_length(case), case) / 0.35e9, 1.0)

    def test_modes_and_laws_of_sizes(self):
        random = np.random.default_rng(10)
        self.assertEqual(case_numbers.n_modes(random.normal(size=300)), 1)
        two = np.concatenate([random.normal(0, 1, 200), random.normal(6, 1, 200)])
        self.assertEqual(case_numbers.n_modes(two), 2)
        self.assertGreater(case_numbers.weibull_advantage(random.weibull(1.5, 500)), 0)
        self.assertLess(case_numbers.weibull_advantage(np.exp(random.normal(0, 0.5, 500))), 0)


def made_up(prediction, measured_mean, spread=0.1):
    """Rows of a prediction whose runs scatter about the measured mean of their arm."""
    random = np.random.default_rng(11)
    return [{"arm": arm, "point": i + 1, "replicate": 0, "second_half_over_first": 1.0, "riska": 2 * mean, "jeong": 3 * mean,
             "lindqvist": mean / 2, "mean": mean * math.exp(spread * random.normal()), "deviation": mean / 3}
            for i in range(8) for arm, mean in zip(prediction.arms, measured_mean)]


class Texts(unittest.TestCase):
    MEASURED = np.linspace(3e5, 9e5, 10)

    def text_of(self, factor):
        prediction = predict.prediction_of("m1")
        measured = [{"arm": arm, "mean": factor * mean} for arm, mean in zip(prediction.arms, self.MEASURED)]
        return tables.verdict(prediction, made_up(prediction, self.MEASURED), measured, None)

    def test_a_series_that_is_right_says_so_and_one_that_is_not_too(self):
        text = self.text_of(1.0)
        for line in ("Inside their intervals: 10 of 10, 8 are needed: **yes**", "holds 0: **yes**",
                     "below each regression: **yes**", "- riska: bias +0.693"):
            self.assertIn(line, text)
        text = self.text_of(2.0)
        for line in ("Inside their intervals: 0 of 10, 8 are needed: **no**", "holds 0: **no**", "below each regression: **no**"):
            self.assertIn(line, text)

    def test_a_series_says_whether_a_test_tells_an_error_of_the_model(self):
        for factor, told in ((1.0, "no"), (4.0, "yes")):
            lines = [line for line in self.text_of(factor).splitlines() if line.startswith("| r") and line.count("|") == 11]
            self.assertEqual([line.split(" | ")[-2] for line in lines], [told] * 10)

    def test_a_series_prints_the_ratio_to_each_regression(self):
        self.assertRegex(self.text_of(1.0), r"over regressions \(95 % over the points\): riska 0\.5\d* \(.*jeong 0\.3\d* \(.*lindqvist 2 \(1\.9")

    def test_a_series_has_the_exponents_of_its_arms_and_of_the_tests(self):
        prediction = predict.prediction_of("m7")
        speeds = [inputs.flat(keys)["structure.speed"] for keys in prediction.arms.values()]
        loads = [1e6 * v**0.4 for v in speeds]
        rows = [{**row, "structure.speed": inputs.flat(prediction.arms[row["arm"]])["structure.speed"]}
                for row in made_up(prediction, loads, spread=0.02)]
        tests = [{"arm": arm, "mean": load} for arm, load in zip(prediction.arms, loads)]
        text = tables.verdict(prediction, rows, tests, None)
        self.assertRegex(text, r"\| speed, thick sheet \| - \| 0\.[34]\d \|")
        self.assertRegex(text, r"- Measured exponent, speed, thin sheet: 0\.40, within .* of one point: \*\*yes\*\*\.")

    def test_a_series_names_its_worst_miss(self):
        prediction = predict.prediction_of("m1")
        arms = list(prediction.arms)
        measured = [{"arm": arm, "mean": mean * (3 if arm == arms[4] else 1)} for arm, mean in zip(arms, self.MEASURED)]
        self.assertIn(f"Worst miss: {arms[4]}, predicted 0.3", tables.verdict(prediction, made_up(prediction, self.MEASURED), measured, None))

    def test_the_worst_claim_is_the_one_that_contradicts_or_else_the_least_sure(self):
        claims = [outcome(two_arms(1.2), kind="rises"), outcome(two_arms(1.2), kind="falls"),
                  outcome(two_arms(1.0, n=4, spread=0.5), kind="same", margin=0.25)]
        self.assertIs(tables.worst_miss(claims, "contradicted"), claims[1])
        self.assertIs(tables.worst_miss(claims[::2], "open"), claims[2])

    def test_a_series_judges_the_frequency_and_names_what_was_not_measured(self):
        prediction = predict.prediction_of("m5")
        rows = [{**row, "breaking_frequency": row["mean"] / 1e3} for row in made_up(prediction, [5e3])]
        measured = [{"arm": "", "mean": 5e3, "breaking_frequency": 50.0}] * 7
        text = tables.verdict(prediction, rows, measured, None)
        self.assertIn("Inside their intervals: 7 of 7, 6 are needed: **yes**", text.split("### breaking_frequency")[0])
        self.assertIn("Inside their intervals: 0 of 7, 6 are needed: **no**", text.split("### breaking_frequency")[1])
        self.assertIn("### largest\n\nNot measured", text)
        # Its criterion does not ask for the bias.
        self.assertNotIn("The interval of the bias", text)

    def test_a_frequency_that_was_counted_joins_the_histories(self):
        prediction = predict.prediction_of("m5")
        rows = [{**row, "breaking_frequency": row["mean"] / 1e3} for row in made_up(prediction, [5e3])]
        histories = [{"arm": "", "file": f"{i}.csv", "mean": 5e3} for i in range(7)]
        with tempfile.TemporaryDirectory() as folder, unittest.mock.patch.object(tables, "histories", lambda _: histories):
            table = pathlib.Path(folder) / "counted.csv"
            options = argparse.Namespace(measured=None, data=folder)
            text = tables.verdict(prediction, rows, tables.measured_rows(prediction, options), None)
            self.assertIn("### breaking_frequency\n\nNot measured. The criterion checks it", text)
            options.measured = table
            table.write_text("file,breaking_frequency\n" + "".join(f"{i}.csv,5.0\n" for i in range(7)), encoding="utf-8")
            text = tables.verdict(prediction, rows, tables.measured_rows(prediction, options), None)
            self.assertIn("7 of 7, 6 are needed: **yes**", text.split("### breaking_frequency")[1])
            self.assertIn("7 of 7, 6 are needed: **yes**", text.split("### breaking_frequency")[0])
            table.write_text("file,breaking_frequency\n8.csv,5.0\n", encoding="utf-8")
            with self.assertRaisesRegex(inputs.BadInput, "file = 8.csv: is not in the folder of --data"):
                tables.measured_rows(prediction, options)

    def test_fewer_points_than_promised_give_no_verdict(self):
        prediction = predict.prediction_of("m3")
        rows = [{"arm": "", "point": i, "quantile_99_0.1s": 1e6, "mean": 3e5} for i in range(5)]
        self.assertIn("no verdict", tables.verdict(prediction, rows, [], None))
        whole = [{**rows[0], "point": i} for i in range(16)]
        broken = tables.verdict(prediction, whole + [{"arm": "", "point": 16, "status": "failed"}], [], None)
        self.assertIn("1 runs failed and have no numbers: point 16.", broken)
        self.assertRegex(broken, r"\*\*open\*\*: .* at 0 of 16 points .* At 1 points a run has no number\.")
        self.assertIn("**holds**", tables.verdict(prediction, whole, [], None))
        self.assertIn("| quantile_99_0.1s [kN] | 1000 |", tables.verdict(prediction, whole, [], None))
        self.assertIn("Largest ratio to the bound: 0.5", tables.verdict(prediction, whole, [], None))

    def test_the_table_of_signs_counts_ten_whatever_was_run(self):
        predictions = {name: predict.prediction_of(f"m6/{name}") for name in ("s2", "s9")}
        rows = [{**row, "arm": {"a": "light", "b": "heavy"}[row["arm"]]} for row in two_arms(0.8)]
        text, found = tables.signs(predictions, lambda name: rows if name == "m6/s2" else [], 10, "paper")
        self.assertRegex(text, r"\| \[S2\]\(s2/claims-paper.csv\) \| \*\*shown\*\* \|.*\| 0 of 0 \|")
        self.assertIn("\nNot run: S9, nearest sign only.\n", text)
        self.assertEqual(list(found), ["s2"])
        text, found = tables.signs(predictions, lambda name: [row for row in rows if row["point"] < 4], 10, "paper")
        self.assertRegex(text, r"\| S2 \| \*\*4 of 16 points\*\*( \| -){4} \|")
        self.assertEqual(list(found), [])

    def test_a_sign_that_reads_other_folders_needs_their_points(self):
        prediction = predict.prediction_of("m6/s10")
        few = lambda _: [{"arm": "", "point": i, "breaking_length_over_lc": 1.0} for i in range(4)]
        text = tables.verdict(prediction, [], [], few)
        self.assertIn("No verdict: 4 of 16 points of m6/s5, 4 of ", text)
        self.assertNotIn("**", text)
        text, found = tables.signs({"s10": prediction}, few, 10, "paper")
        self.assertRegex(text, r"\| S10 \| \*\*4 of 16 points of m6/s5, .*\*\*( \| -){4} \|")
        self.assertEqual(found, {})
        self.assertIn("No verdict: not run.", tables.verdict(prediction, [], [], lambda _: []))

    def test_fewer_points_than_promised_may_be_run(self):
        prediction = predict.prediction_of("m6/s2")
        with tempfile.TemporaryDirectory() as folder:
            output = pathlib.Path(folder) / "s2"
            for points in (4, 32):
                path = predict.plan_for(argparse.Namespace(points=points, preset="brash"), prediction, output)
                self.assertEqual(path.read_text(encoding="utf-8").count('"light.s'), points)
            for points in (-1, 24, 80):
                with self.assertRaisesRegex(inputs.BadInput, f"--points {points}: is not allowed here"):
                    predict.plan_for(argparse.Namespace(points=points, preset="brash"), prediction, output)

    def test_a_picture_has_what_each_kind_of_claim_saw(self):
        prediction = predict.prediction_of("m6/s7")
        rows = [{**row, "structure.speed": {"a": 1.0, "b": 2.0}[row["arm"]], "crushing": 0.1 * row["mean"], "one_mode": True}
                for row in two_arms(0.8)]
        arms = {"statistic": "mean", "arms": ["a", "b"]}
        kinds = [{"kind": "rises", **arms}, {"kind": "falls", "along": "structure.speed", **arms},
                 {"kind": "same", "margin": 0.25, **arms}, {"kind": "ratio-within", "low": 0.5, "high": 0.9, **arms},
                 {"kind": "exceeds", "statistic": "mean", "bound": 1.0},
                 {"kind": "within", "statistic": "mean", "low": 0.5, "high": 1e9},
                 {"kind": "rises-beyond", "beside": "crushing", "times": 2.0, **arms},
                 {"kind": "share", "statistic": "one_mode", "above": 0.5}]
        outcomes = [signs.tested(rows, {"text": claim["kind"], **claim}) for claim in kinds]
        with tempfile.TemporaryDirectory() as folder:
            axes = pictures.draw(prediction, outcomes, lambda claim: rows, pathlib.Path(folder), "claims")
            self.assertTrue((pathlib.Path(folder) / "claims.png").is_file())
        self.assertEqual([axis.get_title().split("\n")[0] for axis in axes], [claim["kind"] for claim in kinds])
        points = len({row["point"] for row in rows})
        for axis in axes[:4]:  # a line a point over the arms, and the mean
            self.assertGreaterEqual(len([line for line in axis.lines if len(line.get_xdata()) == 2]), points + 1)
        self.assertEqual(len(axes[4].lines[0].get_xdata()), points)
        self.assertEqual(len(axes[6].lines[0].get_xdata()), points)
        # The mean of the pairs falls to 0.8.
        mean = axes[0].containers[0].lines[0].get_ydata()
        self.assertAlmostEqual(mean[1] / mean[0], outcomes[0].effect, places=10)

    def test_exponents_are_compared_in_pairs(self):
        prediction = predict.prediction_of("exponents")
        random = np.random.default_rng(12)
        rows = []
        for i in range(16):
            level = 10 ** random.random()
            for arm, keys in prediction.arms.items():
                width = keys["structure"]["waterline_width"]
                row = {"arm": arm, "point": i + 1, "replicate": 0, "second_half_over_first": 1.0, **inputs.flat(keys),
                       "structure.angle": math.radians(float(keys["structure"]["angle"].split()[0]))}
                load = level * width**1.5 * math.exp(0.02 * random.normal())
                rows.append({**row, "mean": load, "quantile_99_0.1s": 2.0 * load, "largest": level * width,
                             **{form: level * width**0.5 for form in figures.CLOSED}})
        text = tables.verdict(prediction, rows, [], None)
        self.assertRegex(text, r"\*\*\d+ of 12 comparisons differ\.\*\* Worst miss: along `structure\.waterline_width`")
        self.assertRegex(text, r"\| `structure\.waterline_width` \| 1\.\d\d \(.*\) \| \*\*\d\.\d\d\*\* \(")
        self.assertIn("no correction was made", text)
        few = tables.verdict(prediction, [row for row in rows if row["point"] < 4], [], None)
        self.assertIn("| `structure.waterline_width` | 1.", few)
        self.assertNotIn("differ.", few)
        self.assertNotIn("no correction was made", few)
        found = {(row["input"], row["number"], row["less"]): row for row in details.exponent_rows(prediction, rows)}
        self.assertAlmostEqual(found["structure.waterline_width", "croasdale", ""]["exponent"], 0.5)
        less = found["structure.waterline_width", "mean", "croasdale"]
        self.assertAlmostEqual(less["exponent"], 1.0, delta=0.05)
        self.assertTrue(tables.differs(less))
        self.assertFalse(tables.differs(found["ice.thickness", "mean", "croasdale"]))
        self.assertAlmostEqual(found["structure.waterline_width", "largest", ""]["exponent"], 1.0)
        self.assertAlmostEqual(found["structure.waterline_width", "largest", "croasdale"]["exponent"], 0.5)
        with tempfile.TemporaryDirectory() as folder:
            width = pictures.exponents(prediction, rows, pathlib.Path(folder), "exponents")[0]
            self.assertTrue((pathlib.Path(folder) / "exponents.png").is_file())
        mean, croasdale = (next(line for line in width.lines if line.get_label() == label).get_ydata()
                           for label in ("mean of the program", figures.CLOSED["croasdale"][0]))
        self.assertAlmostEqual(math.log(mean[2] / mean[0]) / math.log(22 / 8), 1.5, delta=0.05)
        self.assertAlmostEqual(math.log(croasdale[2] / croasdale[0]) / math.log(22 / 8), 0.5, places=10)

    def test_a_run_that_failed_leaves_its_point_in_place(self):
        prediction = predict.prediction_of("m6/s2")
        rows = [{"arm": arm, "point": i, "mean": None if (arm, i) == ("light", 3) else 1.0}
                for i in range(1, 18) for arm in prediction.arms]
        self.assertEqual({row["point"] for row in tables.complete(rows, prediction)}, set(range(1, 17)))
        self.assertEqual({row["point"] for row in tables.complete(rows[:10], prediction)}, set(range(1, 6)))

    def test_a_point_that_lacks_a_replicate_is_not_complete(self):
        prediction = predict.prediction_of("table1")
        rows = [{"arm": "", "point": i, "replicate": k} for i in range(1, 65) for k in range(2)]
        self.assertEqual(tables.complete(rows, prediction), rows)
        self.assertEqual({row["point"] for row in tables.complete(rows[:9], prediction)}, set(range(1, 5)))


if __name__ == "__main__":
    unittest.main()
