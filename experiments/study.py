# SPDX-License-Identifier: GPL-3.0-or-later
"""Tools of the experiments that are campaigns: they run a plan, collect its numbers, record and check them.

An experiment is a folder with `plan.toml`, `recorded.csv` (one row a case), `closed_forms.csv` (one row a
setting) and `quick.csv` (the reference of the tests). They are of the preset `paper`; folders within have other SERIES.
"""
import argparse
import csv
import json
import math
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy import stats

ROOT = Path(__file__).resolve().parents[1]
LOWEST, HIGHEST, HIGH = 0.5, 20.0, 2.0  # Hz, band of the mean frequency; from where on frequencies count as high
SEGMENT = 2.0  # s, of the spectra
QUICK_SEEDS = 8  # recorded for the quick mode
# Series of recorded runs, and their folders within an experiment: the preset `paper` with runs of 20 s (plan_20s.toml), as
# the paper has them, and with equal travel (plan.toml); its second reading (docs/decisions/0039), which was the preset in
# version 0.3.0, with equal travel; the default with equal travel.
SERIES = {"paper-20s": "20s", "paper": ".", "second-reading": "second_reading", "brash": "brash"}


def program(text):
    """The path of a program that is named as in a shell."""
    return Path(shutil.which(text) or text).absolute()


def arguments(description, presets=False):
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brash", type=program, default=ROOT / "build" / "release" / "bin" / "brash")
    parser.add_argument("-o", "--output", type=Path, help="folder of the campaign [results/<experiment>]")
    parser.add_argument("--jobs", type=int, help="workers [one a core]")
    parser.add_argument("--quick", action="store_true", help="the plan's small variant, compared with quick.csv")
    parser.add_argument("--record", action="store_true", help="also rewrite the recorded numbers and pictures")
    if presets:
        parser.add_argument("--preset", choices=["paper", "brash"], default="paper", help="algorithm.preset [paper]")
        parser.set_defaults(plan="plan.toml")
        parser.add_argument("--replicates", type=int, help="of each setting [the plan's]")
    return parser


def series_of(options):
    """The name of the series that the command line asks for."""
    return options.preset + "-20s" * (options.plan == "plan_20s.toml")


def results_folder(options, name):
    """Where the campaign of an experiment with presets goes."""
    return options.output or Path("results") / f"{name}-{'quick' if options.quick else series_of(options)}"


def brash_module():
    """The Python module of the program: as installed, or of the release build."""
    try:
        import brash
    except ImportError:
        sys.path.insert(0, str(ROOT / "build" / "release" / "python"))
        import brash
    return brash


# Running and collecting.

def campaign(brash, plan, output, quick=False, jobs=None, overrides=(), replicates=None, may_fail=False):
    """Runs or resumes a campaign. With `may_fail`, it goes on without the cases that the program refuses."""
    command = [brash, "campaign", plan, "-o", output]
    command += ["--quick"] * quick + (["--jobs", str(jobs)] if jobs else [])
    command += ["--resume"] * output.exists() + (["--replicates", str(replicates)] if replicates else [])
    for override in overrides:
        command += ["--set", override]
    done = subprocess.run([str(word) for word in command], stdout=subprocess.DEVNULL)
    if not (may_fail and done.returncode == 1):  # 1: cases failed, and the others are done
        done.check_returncode()


def preset_campaign(options, plan, output):
    """`campaign` of a plan with the preset and the replicates of the command line."""
    campaign(options.brash, plan, output, jobs=options.jobs, replicates=options.replicates,
             overrides=[f"algorithm.preset={json.dumps(options.preset)}"])


def recorded(experiment, series="paper"):
    """The recorded rows of an experiment."""
    return ROOT / "experiments" / experiment / SERIES[series] / "recorded.csv"


def read_rows(path):
    """Rows of a CSV file, numbers as floats; cases that failed are left out."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text

    with open(path, newline="", encoding="utf-8") as file:
        rows = [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]
    return [row for row in rows if row.get("status", "done") == "done"]


def write_rows(path, rows):
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def spectrum(brash, history, start, segment=SEGMENT):
    """Frequency and density [N2/Hz] of the horizontal force by `brash stats`, and the other statistics."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "spectrum.csv"
        done = subprocess.run([str(brash), "stats", str(history), "--column", "Fx", "--from", str(start), "--segment",
                               str(segment), "--spectrum", str(file), "--json"], check=True, capture_output=True)
        rows = read_rows(file)
    return np.array([r["frequency"] for r in rows]), np.array([r["density"] for r in rows]), json.loads(done.stdout)


def content_of(frequency, density):
    """Mean frequency of the spectrum in its band [Hz], and deviation from frequencies above HIGH [N]."""
    band = (frequency >= LOWEST) & (frequency <= HIGHEST)
    high = frequency >= HIGH
    return {"mean_frequency": float((frequency * density)[band].sum() / density[band].sum()),
            "high_frequency_deviation": math.sqrt(density[high].sum() * frequency[1])}


def program_of(folder):
    """Version and commit of the program that ran a case; {} without a manifest."""
    path = folder / "manifest.json"
    if not path.is_file():
        return {}
    program = json.loads(path.read_text(encoding="utf-8"))["program"]
    return {"program": f"{program['name']} {program['version']}", "commit": program["commit"]}


def collect(brash, output):
    """Rows of campaign.csv, with two numbers from the spectrum of each case's horizontal force."""
    rows = read_rows(output / "campaign.csv")
    for row in rows:
        folder = output / "cases" / row["case"]
        start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
        frequency, density, _ = spectrum(brash, folder / "history.csv", start)
        row.update(content_of(frequency, density))
    return rows


def closed_forms(brash, output, keys):
    """Closed-form peaks of every setting: one row a setting, horizontal and vertical in N."""
    rows = []
    for setting in json.loads((output / "summary.json").read_text(encoding="utf-8"))["settings"]:
        case = output / "settings" / f"{setting['case']}.toml"
        done = subprocess.run([str(brash), "loads", str(case), "--json"], check=True, capture_output=True)
        row = {"setting": setting["setting"], **{key: setting["values"][key] for key in keys}}
        for load in json.loads(done.stdout)["loads"]:
            for name, words in NAMES.items():
                if all(word in load["method"] + load["source"] for word in words):
                    row[f"{name}.horizontal"], row[f"{name}.vertical"] = load.get("horizontal"), load.get("vertical")
        rows.append(row)
    return rows


# What identifies a closed form in the answer of `brash loads`.
NAMES = {"croasdale": ("Croasdale",), "ralston_tresca": ("Ralston", "Tresca"),
         "ralston_johansen": ("Ralston", "Johansen")}


# Numbers.

def mean_interval(values, confidence=0.95):
    """Mean and half-width of Student's interval."""
    values = np.asarray(values, dtype=float)
    half = stats.t.ppf(0.5 + 0.5 * confidence, len(values) - 1) * values.std(ddof=1) / math.sqrt(len(values))
    return values.mean(), half


def groups(rows, key, column, **fixed):
    """{value of key: values of column}, in rising order, of the rows in which the other keys are as given."""
    result = {}
    for row in rows:
        if all(math.isclose(row[name.replace("__", ".")], value, rel_tol=1e-9) for name, value in fixed.items()):
            result.setdefault(row[key], []).append(row[column])
    return dict(sorted(result.items()))


def unit_of(column):
    """What a table or picture divides a column by: 1e3 for forces [kN], 1 for others."""
    return 1e3 if "horizontal" in column or "vertical" in column or "deviation" in column else 1.0


def print_table(rows, columns):
    """Mean and 95 % interval over the replicates of each setting, forces in kN."""
    settings = dict.fromkeys(row["setting"] for row in rows)
    print(f"{'setting':28s} n  " + "".join(f"{name:>34s}" for name in columns))
    for setting in settings:
        chosen = [row for row in rows if row["setting"] == setting]
        cells = []
        for column in columns:
            values = [row[column] / unit_of(column) for row in chosen if row[column] != ""]
            mean, half = mean_interval(values) if len(values) > 1 else (*values, math.nan, math.nan)[:2]
            cells.append(f"{mean:14.2f} [{mean - half:7.2f}, {mean + half:7.2f}]")
        print(f"{setting:28s}{len(chosen):3d} " + "".join(f"{cell:>34s}" for cell in cells))


# The quick mode: two settings, a few seconds.

QUICK_COLUMNS = ["mean_whole_history.horizontal", "mean_whole_history.vertical"]
# One case on another machine is another replicate (a last digit changes the order of breaks): so many deviations
# between replicates are allowed, and at least this share of the mean where replicates hardly differ yet.
QUICK_DEVIATIONS, QUICK_SHARE = 4.0, 0.02


def check_quick(rows, recorded):
    """Lines that name numbers outside four recorded deviations, and settings without any. Empty if there are none."""
    ran = {row["setting"] for row in rows}
    wrong = [f"{setting}: did not run" for setting in dict.fromkeys(r["setting"] for r in recorded) if setting not in ran]
    for row in rows:
        known = [r for r in recorded if r["setting"] == row["setting"]]
        if not known:
            wrong.append(f"{row['setting']}: nothing recorded")
        for r in known:
            if abs(row[r["column"]] - r["mean"]) > max(QUICK_DEVIATIONS * r["deviation"], QUICK_SHARE * abs(r["mean"])):
                wrong.append(f"{row['setting']}: {r['column']} is {row[r['column']]:.0f}, recorded {r['mean']:.0f} with "
                             f"a deviation between replicates of {r['deviation']:.0f}")
    return wrong


def record_quick(brash, folder, output):
    rows = []
    for seed in range(1, QUICK_SEEDS + 1):
        part = output / f"seed-{seed}"
        shutil.rmtree(part, ignore_errors=True)
        campaign(brash, folder / "plan.toml", part, quick=True, overrides=[f"random.seed={seed}"])
        rows += read_rows(part / "campaign.csv")
    recorded = []
    for setting in dict.fromkeys(row["setting"] for row in rows):
        for column in QUICK_COLUMNS:
            values = np.array([row[column] for row in rows if row["setting"] == setting])
            recorded.append({"setting": setting, "column": column, "mean": round(values.mean(), 1),
                             "deviation": round(values.std(ddof=1), 1)})
    write_rows(folder / "quick.csv", recorded)


def quick_campaign(options, folder, output):
    """Runs the small variant of the plan anew, whatever program ran it before. Its folder: `quick` within the user's."""
    for name, default in (("preset", "paper"), ("replicates", None), ("plan", "plan.toml"), ("overrides", [])):
        if getattr(options, name, default) != default:
            sys.exit(f"--quick: compares the small variant of plan.toml with its record; leave --{name.replace('overrides', 'set')} out")
    shutil.rmtree(output / "quick", ignore_errors=True)
    campaign(options.brash, folder / "plan.toml", output / "quick", quick=True, jobs=options.jobs)
    return output / "quick"


def quick(options, folder, output):
    """Runs the small variant of the plan; 0 when it is within the recorded deviations."""
    rows = read_rows(quick_campaign(options, folder, output) / "campaign.csv")
    wrong = check_quick(rows, read_rows(folder / "quick.csv"))
    print("\n".join(wrong) or f"{len(rows)} cases within {QUICK_DEVIATIONS:g} recorded deviations")
    return 1 if wrong else 0


def main(folder, keys, columns, draw, description):
    """Runs an experiment from its command line; `draw(rows, closed, output, folder, series)` makes its pictures in `folder`."""
    parser = arguments(description, presets=True)
    parser.add_argument("--20s", action="store_const", dest="plan", const="plan_20s.toml", help="runs of 20 s, not of equal travel")
    options = parser.parse_args()
    output = results_folder(options, folder.name)
    if options.quick and options.record:
        record_quick(options.brash, folder, output)
        return 0
    if options.quick:
        return quick(options, folder, output)
    preset_campaign(options, folder / options.plan, output)
    rows, closed = collect(options.brash, output), closed_forms(options.brash, output, keys)
    print_table(rows, columns)
    series = series_of(options)
    if options.record and series not in SERIES:
        sys.exit(f"--record: no series {series} is kept; found --preset {options.preset} --20s, allowed is one of the two")
    target = recorded(folder.name, series).parent if options.record else output
    if options.record:
        target.mkdir(exist_ok=True)
        write_rows(target / "recorded.csv", rows)
        write_rows(folder / "closed_forms.csv", closed)
    draw(rows, closed, output, target, series)
    print(f"pictures in {target}")
    return 0
