#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Predictions with their inputs first; README.md has the rules.

predict.py design FOLDER...        writes plan.toml from prediction.toml (--check: fails if it would differ)
predict.py run FOLDER              runs or resumes the campaign: results/predictions/FOLDER-PRESET; recorded rows are not run again
predict.py rows FOLDER             adds the finished cases to recorded-PRESET.csv, a row a case, also while the campaign runs
predict.py verdict FOLDER          the verdict; m6: the table of all signs (--record writes it or its claims beside the inputs)
predict.py indices FOLDER --of X   divides the variance of a number among the unknowns, with the surrogate's error
predict.py table [FOLDER...]       test, unknowns, interval, verdict and regressions of all (--record: table-PRESET.csv)
predict.py quick [FOLDER...]       one short run a folder, compared with quick.csv, as the tests do

FOLDER is m1, m6/s4, ... or a folder of your own with a prediction.toml.
"""
import argparse
import functools
import json
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent)]
import details
import inputs
import pictures
import study
import tables
from case_numbers import collect
from inputs import BadInput, Prediction

PRESET_OF = {"literal": "paper"}  # the program's; rows named "paper" are of the second reading (README.md)
ALL = ["m1", "m1b", "m2", "m3", "m3b", "m4", "m5", "m5b", "m7", *(f"m6/s{i}" for i in range(1, 11)), "table1", "exponents"]


def prediction_of(name):
    folder = HERE / name
    return Prediction(folder if folder.is_dir() else Path(name))


def output_of(options, prediction):
    return (options.output or Path("results") / "predictions") / f"{prediction.name.replace('/', '-')}-{options.preset}"


def design(options):
    """Writes the plans of the least numbers of points; the number of stale ones with --check."""
    stale = 0
    for name in options.folders or ALL:
        prediction = prediction_of(name)
        if not prediction.own_runs:
            continue
        path = prediction.folder / "plan.toml"
        points = inputs.points_of(prediction, prediction.ensemble["points"])
        text = inputs.plan_text(prediction, points, prediction.folder)
        if options.check and (not path.is_file() or path.read_text(encoding="utf-8") != text):
            print(f"{path}: is not what prediction.toml asks for; run predict.py design {name}", file=sys.stderr)
            stale += 1
        if not options.check:
            path.write_text(text, encoding="utf-8")
    return 1 if stale else 0


def plan_for(options, prediction, output):
    """The committed plan, or one of other points or of the settings without a row beside the results; None if all have rows."""
    least, most = prediction.ensemble["points"], prediction.ensemble["most_points"]
    n = options.points or least
    if not 1 <= n <= most or (n > least and n % least):
        raise BadInput(f"--points {n}: is not allowed here; take a multiple of {least} up to {most}, as {prediction.path} says, or "
                       "less for numbers without a verdict")
    there = recorded_elsewhere(options, prediction, output)
    if n == least and not there:
        return prediction.folder / "plan.toml"
    points = inputs.points_of(prediction, n)
    if there >= {inputs.label_of(arm, i) for i in range(n) for arm in prediction.arms}:
        return None
    path = output.parent / f"{output.name}.toml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(inputs.plan_text(prediction, points, path.parent, without=there), encoding="utf-8")
    return path


def recorded_elsewhere(options, prediction, output):
    """Settings whose rows this program has recorded, all replicates, and whose cases are not in the campaign's folder."""
    path = recorded_file(options, prediction)
    if not path.is_file():
        return set()
    replicates, n_done = prediction.ensemble.get("replicates", 1), {}
    program = program_now(options.brash)
    for row in tables.read_numbers(path):
        if row["status"] == "done" and row.get("program") == program:
            label = inputs.label_of(row["arm"], int(row["point"]) - 1)
            n_done[label] = n_done.get(label, 0) + 1
    return {label for label, n in n_done.items() if n >= replicates and not (output / "cases" / f"{label}-r0000").is_dir()}


def program_now(brash):
    """Name and version of a program, as a manifest has them."""
    said = subprocess.run([str(brash), "--version"], check=True, capture_output=True, text=True).stdout
    return f"brash {said.split()[0]}"


def recorded_file(options, prediction):
    return prediction.folder / f"recorded-{options.preset}.csv"


def check_runs(options, prediction):
    if not prediction.own_runs:
        raise BadInput(f"{prediction.path}: has no runs of its own; run the folders that its claims name in `from`")
    if options.preset not in prediction.presets:
        raise BadInput(f"--preset {options.preset}: is not in this prediction; take {' or '.join(prediction.presets)}")


def run(options):
    prediction = prediction_of(options.folder)
    check_runs(options, prediction)
    output = output_of(options, prediction)
    plan = plan_for(options, prediction, output)
    if plan is None:
        print(f"All rows of {prediction.name} are in {recorded_file(options, prediction)}.")
        return 0
    command = [options.brash, "campaign", plan, "-o", output]
    command += ["--set", f"algorithm.preset={json.dumps(PRESET_OF.get(options.preset, options.preset))}"]
    command += ["--tables"] if options.tables else ["--resume"] * output.exists()
    command += ["--jobs", options.jobs] * bool(options.jobs) + ["--on", "slurm"] * (options.on == "slurm")
    command += [f"--sbatch={text}" for text in options.sbatch]
    return subprocess.run([str(word) for word in command]).returncode


def add_rows(options):
    """Records the finished cases. A row stands for its case in other checkouts too."""
    prediction = prediction_of(options.folder)
    check_runs(options, prediction)
    output = output_of(options, prediction)
    plan = plan_for(options, prediction, output)
    if plan and output.is_dir():
        command = [options.brash, "campaign", plan, "-o", output, "--tables"]
        subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)
    options.record = True
    rows = all_rows(options, prediction)
    print(f"{len(rows)} of {prediction.n_cases()} rows are in {recorded_file(options, prediction)}.")
    return 0


def all_rows(options, prediction):
    """Numbers of the runs in the campaign's folder, and of the recorded rows that it does not have. Empty if there are none."""
    output, recorded = output_of(options, prediction), recorded_file(options, prediction)
    kept = tables.read_numbers(recorded) if recorded.is_file() else []
    if not (output / "campaign.csv").is_file():
        return kept
    fresh = collect(options.brash, prediction, output)
    programs = {row.get("program") for row in fresh} - {None}
    others = sorted({str(row.get("program")) for row in kept if row.get("program") not in programs})
    if others and options.record and not options.replace:
        raise BadInput(f"{recorded}: has rows of {', '.join(others)}, and the runs are of {', '.join(sorted(programs))}; take --replace to "
                       "replace the file, after moving it if its rows shall stay")
    rows = tables.joined_rows(prediction, [row for row in kept if row.get("program") in programs], fresh)
    if options.record:
        study.write_rows(recorded, rows)
    return rows


def rows_of(options, prediction):
    """The rows of the points that are complete."""
    return tables.complete(all_rows(options, prediction), prediction)


def verdict(options):
    """Prints a verdict. --record writes the page, of claims only their numbers: the page of the signs is m6's."""
    rows_elsewhere = functools.cache(lambda other: rows_of(options, prediction_of(other)))
    if options.folder.rstrip("/") in ("m6", str(HERE / "m6")):
        folder, text = HERE / "m6", verdict_of_signs(options, rows_elsewhere)
    else:
        prediction = prediction_of(options.folder)
        rows = rows_of(options, prediction) if prediction.own_runs else []
        measured = tables.measured_rows(prediction, options)
        folder, text = prediction.folder, tables.verdict(prediction, rows, measured, rows_elsewhere)
        if options.record:
            record_numbers(prediction, rows, measured, rows_elsewhere, options.preset)
        if prediction.criterion["kind"] == "claims":
            folder = None
    if options.record and folder:
        (folder / f"verdict-{options.preset}.md").write_text(text, encoding="utf-8")
    print(text)
    return 0


def verdict_of_signs(options, rows_elsewhere):
    """The table of all signs; --record draws the claims of each."""
    predictions = {name: prediction_of(f"m6/{name}") for name in (f"s{i}" for i in range(1, 11))}
    text, found = tables.signs({name: p for name, p in predictions.items() if options.preset in p.presets},
                               rows_elsewhere, len(predictions), options.preset)
    for name, outcomes in found.items() if options.record else ():
        pictures.draw(predictions[name], outcomes, lambda claim: rows_elsewhere(claim.get("from", f"m6/{name}")),
                      HERE / "m6" / name, f"claims-{options.preset}")
    return text


def numbers_of(prediction, rows, measured, rows_elsewhere):
    """{name: rows} of the CSV files beside a verdict."""
    found = {"numbers": details.number_rows(prediction, rows) if rows else []}
    if prediction.criterion["kind"] == "claims" and not tables.fewer_points(prediction, rows, rows_elsewhere):
        found["claims"] = list(map(details.claim_row, tables.outcomes_of(prediction, rows, rows_elsewhere)))
    if prediction.criterion["kind"] == "series" and measured and rows:
        found["series"] = details.series_rows(prediction, rows, measured)
    if prediction.criterion["kind"] in ("series", "history") and "measured" not in prediction.table and rows:
        found["loads"] = details.load_rows(prediction, rows)
    if "exponent" in prediction.table and rows:
        found["exponents"] = details.exponent_rows(prediction, rows)
    return {name: list(map(details.rounded, table)) for name, table in found.items() if table}


def record_numbers(prediction, rows, measured, rows_elsewhere, preset):
    for name, table in numbers_of(prediction, rows, measured, rows_elsewhere).items():
        study.write_rows(prediction.folder / f"{name}-{preset}.csv", table)
    if prediction.criterion["kind"] == "exponents" and rows:
        pictures.exponents(prediction, rows, prediction.folder, f"exponents-{preset}")


def table(options):
    """One row a judged number: the test, its unknowns, the interval, the verdict and the regressions."""
    rows_elsewhere = functools.cache(lambda other: rows_of(options, prediction_of(other)))
    found = []
    for name in options.folders or ALL:
        prediction = prediction_of(name)
        if options.preset in prediction.presets:
            rows = rows_elsewhere(name) if prediction.own_runs else []
            found += tables.overview(prediction, rows, tables.measured_rows(prediction, options), rows_elsewhere)
    found = list(map(details.rounded, found))
    if options.record:
        study.write_rows(HERE / f"table-{options.preset}.csv", found)
    print("\n".join(tables.markdown(found)))
    return 0


def indices(options):
    prediction = prediction_of(options.folder)
    found, too_few = details.index_rows(prediction, rows_of(options, prediction), options.of, options.degree)
    if options.record and found:
        study.write_rows(prediction.folder / f"indices-{options.preset}-{options.of}.csv", list(map(details.rounded, found)))
    text = tables.indices(prediction, found, too_few, options.of)
    print(text)
    return 0


def quick(options):
    """One short run a folder; the number of folders that are wrong."""
    wrong = []
    for name in options.folders or [name for name in ALL if (HERE / name / "quick.csv").is_file() or options.record]:
        prediction = prediction_of(name)
        if not prediction.own_runs:
            continue
        output = (options.output or Path("results") / "predictions") / f"{prediction.name.replace('/', '-')}-quick"
        if options.record:
            study.record_quick(options.brash, prediction.folder, output)
        else:
            options.jobs = 1
            wrong += [name] * study.quick(options, prediction.folder, output)
    return len(wrong)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brash", type=study.program, default=inputs.ROOT / "build" / "release" / "bin" / "brash")
    parser.add_argument("-o", "--output", type=Path, help="folder of the campaigns [results/predictions]")
    commands = parser.add_subparsers(required=True)

    def command(name, action, many=False):
        added = commands.add_parser(name)
        added.set_defaults(action=action)
        added.add_argument("folders" if many else "folder", nargs="*" if many else None)
        if not many or name == "table":
            added.add_argument("--preset", choices=["brash", "paper", "literal"], default="brash")
        return added

    def recording(added, help):
        added.add_argument("--record", action="store_true", help=help)
        added.add_argument("--replace", action="store_true", help="replace recorded rows of another program")

    command("design", design, many=True).add_argument("--check", action="store_true")
    runs = command("run", run)
    runs.add_argument("--points", type=int, help="points of the unknowns: a multiple of ensemble.points; fewer than that give no verdict")
    runs.add_argument("--tables", action="store_true", help="run nothing: the tables of the finished ones, for a verdict so far")
    runs.add_argument("--jobs", type=int)
    runs.add_argument("--on", choices=["local", "slurm"], default="local")
    runs.add_argument("--sbatch", action="append", default=[])
    verdicts = command("verdict", verdict)
    recording(verdicts, "write rows, numbers and verdict beside the inputs")
    verdicts.add_argument("--measured", type=Path, help="CSV: a column `arm`, or `file` beside --data, and one column a measured "
                          "statistic [SI]")
    verdicts.add_argument("--data", type=Path, help="folder of measured histories (CSV), one test a file; of [growth], the one test")
    verdicts.add_argument("--column", help="of the load in these files")
    verdicts.add_argument("--from", dest="start", type=float, help="time from which they count [s]")
    verdicts.add_argument("--to", dest="end", type=float, help="time at which they end [s]")
    divided = command("indices", indices)
    divided.add_argument("--of", default="mean", help="a number of the runs, such as mean or piece_size")
    divided.add_argument("--degree", type=int, default=3)
    recording(divided, "write the indices beside the inputs")
    added = command("rows", add_rows)
    added.add_argument("--replace", action="store_true", help="replace recorded rows of another program")
    added.add_argument("--points", type=int, help="as of run")
    overview = command("table", table, many=True)
    recording(overview, "write table-PRESET.csv")
    overview.set_defaults(measured=None, data=None)
    command("quick", quick, many=True).add_argument("--record", action="store_true")
    return parser


def main():
    options = arguments().parse_args()
    try:
        return options.action(options)
    except BadInput as error:
        print(f"predict.py: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
