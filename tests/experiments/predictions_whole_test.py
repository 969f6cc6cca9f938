# SPDX-License-Identifier: GPL-3.0-or-later
"""The committed inputs of experiments/predictions, and a small prediction all the way to its verdict.

predictions_whole_test.py BRASH FOLDER
"""
import contextlib
import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
PREDICTIONS = SOURCE / "experiments" / "predictions"
sys.path[:0] = [str(PREDICTIONS), str(PREDICTIONS.parent)]
BRASH, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])

import inputs
import predict
import tables


class Inputs(unittest.TestCase):
    def test_the_plans_are_what_the_predictions_ask_for(self):
        self.assertEqual(predict.design(predict.arguments().parse_args(["design", "--check"])), 0)

    def test_more_points_continue_the_ensemble(self):
        prediction = predict.prediction_of("m3")
        few, many = (inputs.plan_text(prediction, inputs.points_of(prediction, n), PREDICTIONS / "m3") for n in (16, 32))
        line = next(line for line in few.splitlines() if line.startswith("ice.thickness"))
        self.assertIn(line[:-1], many)

    def test_every_plan_is_accepted_also_in_its_quick_variant(self):
        for name in predict.ALL:
            prediction = predict.prediction_of(name)
            if prediction.own_runs:
                for extra in ([], ["--quick"]):
                    command = [BRASH, "campaign", prediction.folder / "plan.toml", "-o", FOLDER / "none", "--status", *extra]
                    done = subprocess.run(command, capture_output=True, text=True)
                    self.assertEqual(done.returncode, 0, f"{name}: {done.stderr}")

    def test_the_verdicts_are_those_of_the_recorded_numbers(self):
        found = sorted(PREDICTIONS.glob("**/verdict-*.md"))
        self.assertGreater(len(found), 9)
        for path in found:
            name, preset = path.parent.relative_to(PREDICTIONS).as_posix(), path.stem.removeprefix("verdict-")
            arguments = ["-o", str(FOLDER / "none"), "verdict", name, "--preset", preset]
            with contextlib.redirect_stdout(io.StringIO()) as text:
                predict.verdict(predict.arguments().parse_args(arguments))
            self.assertEqual(text.getvalue(), path.read_text(encoding="utf-8") + "\n", path)

    def test_the_tables_beside_the_verdicts_are_those_of_the_recorded_numbers(self):
        n_tables = 0
        for path in sorted({*PREDICTIONS.glob("**/recorded-*.csv"), *PREDICTIONS.glob("**/claims-*.csv")}):
            prediction, preset = inputs.Prediction(path.parent), path.stem.split("-")[1]
            options = predict.arguments().parse_args(["-o", str(FOLDER / "none"), "verdict", prediction.name, "--preset", preset])
            rows_elsewhere = lambda other: predict.rows_of(options, predict.prediction_of(other))
            rows = rows_elsewhere(prediction.name) if prediction.own_runs else []
            measured = tables.measured_rows(prediction, options)
            for name, table in predict.numbers_of(prediction, rows, measured, rows_elsewhere).items():
                n_tables += 1
                with open(path.parent / f"{name}-{preset}.csv", encoding="utf-8") as file:
                    recorded = list(csv.DictReader(file))
                self.assertEqual(recorded, [{key: str(value) for key, value in row.items()} for row in table], path)
        self.assertGreater(n_tables, 40)

    def test_the_table_of_all_is_the_one_of_the_recorded_numbers(self):
        found = sorted(PREDICTIONS.glob("table-*.csv"))
        self.assertGreater(len(found), 1)
        for path in found:
            words = ["-o", str(FOLDER / "none"), "table", "--preset", path.stem.removeprefix("table-")]
            with contextlib.redirect_stdout(io.StringIO()) as text:
                predict.table(predict.arguments().parse_args(words))
            with open(path, encoding="utf-8") as file:
                self.assertEqual(text.getvalue(), "\n".join(tables.markdown(list(csv.DictReader(file)))) + "\n", path)

    def test_every_range_has_a_source_and_every_claim_a_known_kind(self):
        kinds = {"rises", "falls", "differs", "same", "within", "ratio-within", "exceeds", "rises-beyond", "share"}
        for name in predict.ALL:
            prediction = predict.prediction_of(name)
            self.assertTrue(prediction.criterion["text"], name)
            for claim in prediction.claims:
                self.assertIn(claim["kind"], kinds)
                of = predict.prediction_of(claim["from"]) if "from" in claim else prediction
                self.assertLessEqual(set(claim.get("arms", [])), set(of.arms))

    def test_faults_are_named_with_file_key_and_remedy(self):
        text = (PREDICTIONS / "m3" / "prediction.toml").read_text(encoding="utf-8")
        for old, new, message in ((text.split('source = "', 2)[1].split('"')[0], "", "source and why"),
                                  ("low = 0.9\nhigh = 1.1", "low = 1.9\nhigh = 1.1", "swap the two"),
                                  ("low = 0.9\nhigh = 1.1", "low = \"90 cm\"\nhigh = 1.1", "is not a number"),
                                  ("[criterion]", "[criterium]", "criterion: is missing"),
                                  ("[ensemble]", "[ensembel]", "is not a known key")):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "prediction.toml").write_text(text.replace(old, new, 1), encoding="utf-8")
                with self.assertRaisesRegex(inputs.BadInput, message):
                    inputs.Prediction(folder)
        with self.assertRaisesRegex(inputs.BadInput, "no such file"):
            inputs.Prediction("nowhere")


TINY = """
title = "a tiny pair"
case = "cone.toml"
[ensemble]
points = 4
most_points = 8
seed = 1
presets = ["paper"]
keep = "run"
[travel]
from = 1.2
end = 2.4
[set]
output.frames_per_second = 0
output.checkpoint_interval = 0
[arm.slow]
structure.speed = 0.8
[arm.fast]
structure.speed = 1.6
[[unknown]]
key = "ice.friction_structure"
low = 0.02
high = 0.05
source = "a test"
why = "a test"
[[unknown]]
factor_of = "structure.speed"
low = 0.9
high = 1.1
source = "a test"
why = "a test"
[criterion]
kind = "claims"
text = "a test"
[[claim]]
text = "the load rises"
kind = "rises"
statistic = "mean"
arms = ["slow", "fast"]
[quick]
time.duration = 1
"""


class Measured(unittest.TestCase):
    def test_histories_of_a_folder_are_read_within_the_given_times(self):
        with tempfile.TemporaryDirectory() as folder:
            time = np.arange(0, 30, 0.01)
            for k in (1, 2):
                noise = np.random.default_rng(k).normal(size=len(time))
                load = np.where(time < 10, 9e9, k * (1000 + 10 * np.sin(40 * time) + noise))
                np.savetxt(f"{folder}/test{k}.csv", np.c_[time, load], delimiter=",", header="time,load", comments="")
            words = ["--brash", BRASH, "verdict", "m5", "--data", folder, "--column", "load", "--from", "12", "--to", "28"]
            found = tables.measured_rows(predict.prediction_of("m5"), predict.arguments().parse_args(words))
            self.assertEqual([row["file"] for row in found], ["test1.csv", "test2.csv"])
            self.assertAlmostEqual(found[1]["mean"], 2000, delta=1)
            options = predict.arguments().parse_args(words[:-4] + ["--column", "nothing"])
            with self.assertRaisesRegex(inputs.BadInput, "brash stats refuses it"):
                tables.measured_rows(predict.prediction_of("m5"), options)
        with self.assertRaisesRegex(inputs.BadInput, "is not a folder"):
            options = predict.arguments().parse_args(["verdict", "m5", "--data", "nowhere"])
            tables.measured_rows(predict.prediction_of("m5"), options)


class WholeWay(unittest.TestCase):
    def test_a_small_prediction_runs_resumes_grows_and_is_judged(self):
        shutil.rmtree(FOLDER, ignore_errors=True)
        case = FOLDER / "tiny"
        case.mkdir(parents=True)
        shutil.copy(SOURCE / "experiments/validation/cone.toml", case / "cone.toml")
        (case / "prediction.toml").write_text(TINY, encoding="utf-8")
        prediction = predict.prediction_of(case)
        (case / "plan.toml").write_text(inputs.plan_text(prediction, inputs.points_of(prediction, 4), case), encoding="utf-8")

        def call(*words):
            said = io.StringIO()
            options = predict.arguments().parse_args(["--brash", BRASH, "-o", str(FOLDER), *words])
            with contextlib.redirect_stdout(said):
                self.assertEqual(options.action(options), 0)
            return said.getvalue()

        self.assertIn("Not run yet with this preset. The inputs are committed.\n", call("verdict", str(case), "--preset", "paper"))
        call("run", str(case), "--preset", "paper", "--jobs", "1")
        text = call("verdict", str(case), "--preset", "paper", "--record")
        self.assertIn("Points of the unknowns: 4. Runs: 8.", text)
        self.assertRegex(text, r"\*\*(shown|open|contradicted)\*\*")
        self.assertFalse((case / "verdict-paper.md").exists())
        self.assertIn("\nthe load rises,rises,", (case / "claims-paper.csv").read_text(encoding="utf-8"))
        self.assertIn("\nfast,mean,kN,", (case / "numbers-paper.csv").read_text(encoding="utf-8"))
        rows = tables.read_numbers(case / "recorded-paper.csv")
        self.assertTrue(all(row.get("n_pieces") is None or row["one_mode"] in (0.0, 1.0) for row in rows))
        self.assertAlmostEqual(rows[0]["output.statistics_from"] * rows[0]["structure.speed"], 1.2, delta=1e-4)
        # Recorded rows stand for their cases in another checkout, and one that is missing runs there.
        elsewhere = FOLDER / "elsewhere"
        said = call("-o", str(elsewhere), "run", str(case), "--preset", "paper", "--jobs", "1")
        self.assertIn(f"All rows of tiny are in {case / 'recorded-paper.csv'}.", said)
        self.assertFalse(elsewhere.exists())
        lines = (case / "recorded-paper.csv").read_text(encoding="utf-8").splitlines(keepends=True)
        (case / "recorded-paper.csv").write_text("".join(lines[:-1]), encoding="utf-8")
        call("-o", str(elsewhere), "run", str(case), "--preset", "paper", "--jobs", "1")
        self.assertEqual([path.name for path in (elsewhere / "tiny-paper" / "cases").iterdir()], ["fast.s004-r0000"])
        self.assertIn("8 of 8 rows are in ", call("-o", str(elsewhere), "rows", str(case), "--preset", "paper"))
        self.assertEqual((case / "recorded-paper.csv").read_text(encoding="utf-8"), "".join(lines))
        # Rows of another program are neither mixed in nor replaced in silence.
        self.assertRegex(rows[0]["program"], r"brash \d+\.\d+\.\d+")
        old = "".join(lines).replace(rows[0]["program"], "brash 0.0.1")
        (case / "recorded-paper.csv").write_text(old, encoding="utf-8")
        with self.assertRaisesRegex(inputs.BadInput, "has rows of brash 0.0.1, and the runs are of brash .*--replace"):
            call("rows", str(case), "--preset", "paper")
        self.assertEqual((case / "recorded-paper.csv").read_text(encoding="utf-8"), old)
        call("rows", str(case), "--preset", "paper", "--replace")
        self.assertEqual((case / "recorded-paper.csv").read_text(encoding="utf-8"), "".join(lines))
        # More points keep the runs that are there.
        first = (FOLDER / "tiny-paper" / "cases" / "slow.s001-r0000" / "history.csv").stat().st_mtime_ns
        call("run", str(case), "--preset", "paper", "--jobs", "1", "--points", "8")
        self.assertIn("Runs: 16.", call("verdict", str(case), "--preset", "paper"))
        self.assertEqual((FOLDER / "tiny-paper" / "cases" / "slow.s001-r0000" / "history.csv").stat().st_mtime_ns, first)
        self.assertIn("Error on samples held back", call("indices", str(case), "--preset", "paper", "--degree", "1"))
        # A run that failed leaves its point out of the test, and is named.
        table = FOLDER / "tiny-paper" / "campaign.csv"
        table.write_text(table.read_text(encoding="utf-8").replace("fast.s008,0,done", "fast.s008,0,failed"), encoding="utf-8")
        text = call("verdict", str(case), "--preset", "paper")
        self.assertIn("1 runs failed and have no numbers: fast 8.", text)
        self.assertIn("| 7 points (1) |", text)
        with self.assertRaisesRegex(inputs.BadInput, "multiple of 4 up to 8"):
            call("run", str(case), "--preset", "paper", "--points", "6")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
