#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each trend of the paper's Sec. 3.2, tested at 5 % over the recorded replicates: run.py [--record|--check]

Reads the recorded numbers of the experiments beside this one, and runs only `brash trend`. It takes every series of
study.SERIES. README.md lists the claims and their verdicts. Holm's method adjusts the p-values of a series together.
"""
import argparse
import csv
import json
import math
import subprocess
import sys
from fnmatch import fnmatch
from pathlib import Path

import numpy as np
from scipy import stats

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study

ALPHA = 0.05
LITTLE = 0.25  # a load that changes by less than this over a whole range changes "little"
NEARLY = 0.10  # "nearly independent"
PAPER_RATIO = 0.491
ANGLE, SPEED, WIDTH, THICKNESS = "structure.angle", "structure.speed", "structure.waterline_width", "ice.thickness"
FORCE, VERTICAL = "horizontal.mean", "vertical.mean"
PARTS = {"crushing": ["crushing"], "floes": ["floe_normal", "floe_friction"]}  # of FORCE
LENGTH, AREA = "breaking_length_quantiles.50", "piece_area_quantiles.50"
FREQUENCY, CONTENT = "mean_frequency", "high_frequency_deviation"


class Runs:
    """Recorded numbers of one series."""

    def __init__(self, brash, series):
        self.brash, self.series = brash, series

    def path(self, experiment):
        return study.recorded(experiment, self.series)

    def rows(self, experiment):
        return study.read_rows(self.path(experiment))


def contrast(groups, weights):
    """Weighted sum of the means of independent samples: value, error, Welch's degrees of freedom."""
    parts = np.array([w * w * np.var(g, ddof=1) / len(g) for w, g in zip(weights, groups)])
    value = sum(w * np.mean(g) for w, g in zip(weights, groups))
    freedom = parts.sum() ** 2 / sum(p * p / (len(g) - 1) for p, g in zip(parts, groups))
    return value, math.sqrt(parts.sum()), freedom


def log_ratio(a, b):
    """ln(mean a / mean b): value, error, degrees of freedom."""
    value = math.log(np.mean(a) / np.mean(b))
    _, error, freedom = contrast([np.array(a) / np.mean(a), np.array(b) / np.mean(b)], [1.0, -1.0])
    return value, error, freedom


def interval(value, error, freedom, confidence=0.95):
    half = stats.t.ppf(0.5 + 0.5 * confidence, freedom) * error
    return value - half, value + half


class Claim:
    """A trend with its p-value, the meaning of its value if it is significant, and the change of each part of the mean load."""

    def __init__(self, experiment, text, p, effect, holds, parts=""):
        self.experiment, self.text, self.p, self.effect, self.holds, self.parts = experiment, text, p, effect, holds, parts

    def verdict(self, adjusted):
        return "undecided" if adjusted >= ALPHA else "confirmed" if self.holds else "refuted"


def change_text(a, b):
    """Last over first, as a change in per cent with its interval."""
    low, high = (math.expm1(x) * 100 for x in interval(*log_ratio(b, a)))
    return f"{(np.mean(b) / np.mean(a) - 1) * 100:+.0f} % ({low:+.0f} to {high:+.0f})"


def parts_text(rows, along):
    """Last less first in each part of the mean load [kN]."""
    def change(causes):
        values = [list(study.groups(rows, along, f"{FORCE}_by_cause.{cause}").values()) for cause in causes]
        return sum(np.mean(groups[-1]) - np.mean(groups[0]) for groups in values) / 1e3
    return ", ".join(f"{name} {change(causes):+.0f}" for name, causes in PARTS.items())


def monotone(runs, experiment, text, along, of, where="", rises=True):
    """Jonckheere and Terpstra's test by the program; refuted when the opposite is significant."""
    command = [str(runs.brash), "trend", str(runs.path(experiment)), "--along", along, "--of", of, "--json"]
    command += ["--where", where] * bool(where)
    trend = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["trends"][0]
    test = trend["jonckheere_terpstra"]
    rows = [row for row in runs.rows(experiment) if fnmatch(row["setting"], where or "*")]
    values = study.groups(rows, along, of)
    groups = list(values.values())
    parts = parts_text(rows, along) if of == FORCE else ""
    return Claim(experiment, text, test["p"], change_text(groups[0], groups[-1]), (test["z"] > 0) == rises, parts)


def flat(experiment, text, rows, along, margin):
    """Two one-sided tests that last over first is within the margin; refuted when it is outside of it."""
    groups = list(study.groups(rows, along, FORCE).values())
    value, error, freedom = log_ratio(groups[-1], groups[0])
    low, high = math.log1p(-margin), math.log1p(margin)
    inside = max(stats.t.sf((value - low) / error, freedom), stats.t.sf((high - value) / error, freedom))
    outside = min(1.0, 2 * min(stats.t.sf((low - value) / error, freedom), stats.t.sf((value - high) / error, freedom)))
    holds = inside <= outside
    return Claim(experiment, text, min(inside, outside), change_text(groups[0], groups[-1]), holds, parts_text(rows, along))


def steepens(experiment, text, groups, knee):
    """Is the slope beyond the knee above the one before it? Welch's t on the difference of slopes, two-sided."""
    x = list(groups)
    at = min(range(len(x)), key=lambda i: abs(x[i] - knee))
    after, before = x[-1] - x[at], x[at] - x[0]
    chosen = [groups[x[0]], groups[x[at]], groups[x[-1]]]
    value, error, freedom = contrast(chosen, [1 / before, -1 / before - 1 / after, 1 / after])
    low, high = (np.mean(chosen[1]) - np.mean(chosen[0])) / before, (np.mean(chosen[2]) - np.mean(chosen[1])) / after
    return Claim(experiment, text, 2 * stats.t.sf(abs(value / error), freedom),
                 f"slope after / before {high / low:.2f}", value > 0)


def stronger(experiment, text, strong, weak):
    """Is the relative rise of one row above the rise of another? Each is (first, last); two-sided."""
    a, b = log_ratio(strong[1], strong[0]), log_ratio(weak[1], weak[0])
    value, error = a[0] - b[0], math.hypot(a[1], b[1])
    freedom = error**4 / (a[1] ** 4 / a[2] + b[1] ** 4 / b[2])
    return Claim(experiment, text, 2 * stats.t.sf(abs(value / error), freedom),
                 f"rises by {math.exp(a[0]):.2f} against {math.exp(b[0]):.2f}", value > 0)


def of_angles(runs):
    rows = study.groups(runs.rows("cone_angle"), ANGLE, FORCE)
    return [
        monotone(runs, "cone_angle", "the mean rises with the cone angle", ANGLE, FORCE),
        steepens("cone_angle", "and faster at large angles", rows, math.radians(61.4)),
        monotone(runs, "cone_angle", "larger angles have a higher mean frequency", ANGLE, FREQUENCY),
        monotone(runs, "cone_angle", "larger angles have a larger deviation above 2 Hz", ANGLE, CONTENT),
    ]


def of_speeds(runs):
    return [
        monotone(runs, "velocity", "the mean rises with the speed", SPEED, FORCE),
        monotone(runs, "velocity", "higher speeds have a higher mean frequency", SPEED, FREQUENCY),
        monotone(runs, "velocity", "higher speeds have a larger deviation above 2 Hz", SPEED, CONTENT),
    ]


def of_angles_and_speeds(runs):
    grid = runs.rows("angle_velocity")

    def ends(rows, **fixed):
        groups = list(study.groups(rows, SPEED, FORCE, **fixed).values())
        return groups[0], groups[-1]

    at_50, at_70 = (ends(grid, structure__angle=math.radians(degrees)) for degrees in (50, 70))
    at_61 = ends(runs.rows("velocity"))
    shallow = [row for row in grid if math.isclose(row[ANGLE], math.radians(50))]
    slow = [row for row in grid if row[SPEED] == 0.5]
    return [
        flat("angle_velocity", f"at 50 deg the speed has little influence (< {LITTLE:.0%})", shallow, SPEED, LITTLE),
        monotone(runs, "angle_velocity", "at 70 deg the mean rises with the speed", SPEED, FORCE, "angle-70deg_*"),
        stronger("angle_velocity", "the speed acts more at 61.4 than at 50 deg", at_61, at_50),
        stronger("angle_velocity", "the speed acts more at 70 than at 50 deg", at_70, at_50),
        flat("angle_velocity", f"at 0.5 m/s the angle has little influence (< {LITTLE:.0%})", slow, ANGLE, LITTLE),
        monotone(runs, "angle_velocity", "at 2.0 m/s the mean rises with the angle", ANGLE, FORCE, "*_speed-2.0"),
    ]


def of_widths(runs):
    text = f"the horizontal mean is nearly independent of the width (< {NEARLY:.0%})"
    return [
        flat("waterline_width", text, runs.rows("waterline_width"), WIDTH, NEARLY),
        monotone(runs, "waterline_width", "the vertical mean rises with the width", WIDTH, VERTICAL),
    ]


def of_thicknesses(runs):
    rows = study.groups(runs.rows("thickness"), THICKNESS, FORCE)
    return [
        monotone(runs, "thickness", "the mean rises with the thickness", THICKNESS, FORCE),
        steepens("thickness", "and sharply at 0.5 m", rows, 0.4),
        monotone(runs, "thickness", "thicker ice has larger fluctuations", THICKNESS, "horizontal.standard_deviation"),
    ]


# The list of README.md.
CLAIMS = [of_angles, of_speeds, of_angles_and_speeds, of_widths, of_thicknesses]


def holm(p):
    """As brash::statistics::holm."""
    order = np.argsort(p, kind="stable")
    adjusted = np.empty(len(p))
    adjusted[order] = np.maximum.accumulate(np.minimum(1.0, np.asarray(p)[order] * np.arange(len(p), 0, -1)))
    return adjusted


def ratio_row(runs):
    """Load of the 50 degree cone over the one of 70 degrees, and whether its interval holds the paper's ratio."""
    groups = list(study.groups(runs.rows("angle_velocity"), ANGLE, FORCE, structure__speed=2.0).values())
    value, error, freedom = log_ratio(groups[0], groups[-1])
    low, high = (math.exp(x) for x in interval(value, error, freedom))
    excluded = "excluded" if not low <= PAPER_RATIO <= high else "not excluded"
    return f"| {NAMES[runs.series]} | {math.exp(value):.3f} | {low:.3f} to {high:.3f} | {excluded} |"


# Of the series, in the page.
NAMES = {"paper-20s": "literal, 20 s", "paper": "literal, equal travel", "second-reading": "second reading", "brash": "`brash`"}

# What the exponents are of: experiment, input and its range in words.
EXPONENTS = [("velocity", SPEED, "speed, 0.5 to 2 m/s"), ("waterline_width", WIDTH, "width, 10.9 to 16.3 m"),
             ("thickness", THICKNESS, "thickness, 0.3 to 0.5 m"), ("cone_angle", ANGLE, "angle, 50 to 70 deg")]


def exponent(rows, along, of):
    """Slope of ln `of` against ln `along` over all rows, with the half-width of its 95 % interval."""
    x, y = (np.log([row[column] for row in rows]) for column in (along, of))
    line = stats.linregress(x, y)
    return line.slope, stats.t.ppf(0.975, len(rows) - 2) * line.stderr


def exponent_rows(run):
    """Exponents of the mean load, of the median breaking length and area of a piece, and of the closed forms' peaks."""
    for experiment, along, name in EXPONENTS:
        for of, column in (("mean load", FORCE), ("breaking length", LENGTH), ("piece area", AREA)):
            for runs in run:
                slope, half = exponent(runs.rows(experiment), along, column)
                yield {"input": name, "of": of, "from": runs.series, "exponent": f"{slope:.2f}", "half_width": f"{half:.2f}"}
        forms = study.read_rows(study.ROOT / "experiments" / experiment / "closed_forms.csv")
        for form, (label, _, _) in figures.CLOSED.items():
            yield {"input": name, "of": "peak", "from": label, "exponent": f"{exponent(forms, along, f'{form}.horizontal')[0]:.2f}",
                   "half_width": ""}


def claim_rows(listed):
    """Each claim of one series with its verdict, size and p, the p-values adjusted together."""
    adjusted = holm([claim.p for claim in listed])
    return [{"experiment": claim.experiment, "claim": claim.text, "verdict": claim.verdict(p), "last_against_first": claim.effect,
             "p": f"{p:.2g}", "parts": claim.parts} for claim, p in zip(listed, adjusted)]


def results(brash):
    """{file: rows} of the CSV files, and the page."""
    run = [Runs(brash, series) for series in study.SERIES if study.recorded("velocity", series).exists()]
    claims = [claim_rows([claim for of in CLAIMS for claim in of(runs)]) for runs in run]
    lines = ["| experiment | claim |" + "".join(f" {NAMES[runs.series]} |" for runs in run), "|---|---|" + "---|" * len(run)]
    for row in zip(*claims):
        verdicts = " | ".join(f"**{of['verdict']}**" for of in row)
        lines.append(f"| {row[0]['experiment']} | {row[0]['claim']} | {verdicts} |")
    lines += ["", "The load at 50 degrees over the load at 70 degrees, at 2.0 m/s:", "",
              f"| series | ratio | 95 % interval | the paper's {PAPER_RATIO} |", "|---|---|---|---|"]
    lines += [ratio_row(runs) for runs in run]
    tables = {"claims.csv": [{"series": runs.series, **row} for runs, rows in zip(run, claims) for row in rows],
              "exponents.csv": list(exponent_rows(run))}
    return tables, "\n".join(lines) + "\n"


def recorded(name):
    with open(HERE / name, encoding="utf-8") as file:
        return list(csv.DictReader(file))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brash", type=study.program, default=study.ROOT / "build" / "release" / "bin" / "brash")
    parser.add_argument("--record", action="store_true", help="also rewrite trends.md, claims.csv and exponents.csv")
    parser.add_argument("--check", action="store_true", help="fail when these are not what the recorded numbers say")
    options = parser.parse_args()
    tables, text = results(options.brash)
    print(text)
    if options.record:
        (HERE / "trends.md").write_text(text, encoding="utf-8")
        for name, rows in tables.items():
            study.write_rows(HERE / name, rows)
    if options.check:
        stale = [] if (HERE / "trends.md").read_text(encoding="utf-8") == text else ["trends.md"]
        stale += [name for name, rows in tables.items() if recorded(name) != rows]
        if stale:
            print(f"{', '.join(stale)}: not what the recorded numbers say; run experiments/trends/run.py --record")
            return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
