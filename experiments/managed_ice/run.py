#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A moored floater in managed ice: offset and line loads over the thickness of the ice and the size of its floes.

run.py [--brash PROGRAM] [-o FOLDER] [--jobs N] [--quick] [--record]

Runs plan.toml and prints a row for each setting. --record writes recorded.csv, a row a case, and managed_ice.png. --quick runs two
short settings: it compares their loads with quick.csv, and the energy of the lines by mooring.py with the program's.
"""
import json
import shutil
import sys
import tomllib
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import mooring
import study

EVERY = 10  # steps between two rows whose lines are solved
# mooring.py sums the energy of a line over 4000 pieces, which is off by 1e-7 of it.
ENERGY_SHARE = 1e-4
MOORING_LOADS = ["mean_offset", "largest_offset", "mean_tension", "largest_tension"]


def history_of(path):
    table = np.genfromtxt(path, delimiter=",", names=True)
    return {name: table[name] for name in table.dtype.names}


class Case:
    """A case of the campaign with its lines over time."""

    def __init__(self, output, row):
        folder = output / "cases" / row["case"]
        setting = output / "settings" / f"floater_{row['setting']}.toml"
        self.case = tomllib.loads(setting.read_text(encoding="utf-8"))
        self.history = history_of(folder / "history.csv")
        self.start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
        self.tensions, self.energy, self.offset = mooring.lines_over_time(self.history, self.case, EVERY)
        self.time = self.history["time"][::EVERY]

    def numbers(self):
        """Offsets [m] and the tension of the most loaded line [N], from the start of the statistics."""
        counts = self.time >= self.start
        away, hardest = self.away()[counts], self.tensions[counts].max(axis=1)
        return dict(zip(MOORING_LOADS, map(float, (away.mean(), away.max(), hardest.mean(), hardest.max()))))

    def away(self):
        """How far the ice has pushed the floater along its drift [m]; the ice drifts against x."""
        return -self.offset[:, 0]

    def energy_error(self):
        """The largest difference from body_mooring of the history, as a share of its range."""
        known = self.history["body_mooring"][::EVERY]
        change = self.energy - self.energy[0] + known[0]
        return np.abs(change - known).max() / np.ptp(known)


def collect(output):
    rows = study.read_rows(output / "campaign.csv")
    cases = [Case(output, row) for row in rows]
    for row, case in zip(rows, cases):
        row.update(case.numbers())
    return rows, cases


def print_rows(rows):
    print("setting                                 n  load, mean, largest [kN]   offset, mean, largest [m]   "
          "line, mean, largest [kN]")
    for setting in dict.fromkeys(row["setting"] for row in rows):
        chosen = [row for row in rows if row["setting"] == setting]

        def mean(key, scale=1.0):
            return np.mean([row[key] for row in chosen]) / scale

        print(f"{setting:38s}{len(chosen):3d} {mean('horizontal.mean', 1e3):11.0f} {mean('horizontal.maximum', 1e3):12.0f} "
              f"{mean('mean_offset'):17.2f} {mean('largest_offset'):8.2f} {mean('mean_tension', 1e3):17.0f} "
              f"{mean('largest_tension', 1e3):8.0f}")


def draw(rows, cases, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 1, figsize=(8, 5), sharex=True, constrained_layout=True)
    shown = {}
    for row, case in zip(rows, cases):
        shown.setdefault(row["setting"], (row, case))
    for row, case in shown.values():
        label = f"{row['ice.thickness']:g} m thick, floes of {row['field.size.median']:g} m"
        axes[0].plot(case.time, case.away(), lw=0.9, label=label)
        axes[1].plot(case.time, case.tensions.max(axis=1) / 1e3, lw=0.9, label=label)
    axes[0].set(ylabel="offset with the drift [m]")
    axes[1].set(ylabel="most loaded line [kN]", xlabel="time [s]")
    axes[0].legend(fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)


def quick(options, output):
    shutil.rmtree(output, ignore_errors=True)
    study.campaign(options.brash, HERE / "plan.toml", output, quick=True, jobs=options.jobs)
    rows, cases = collect(output)
    wrong = study.check_quick(rows, study.read_rows(HERE / "quick.csv"))
    for row, case in zip(rows, cases):
        if not case.energy_error() < ENERGY_SHARE:
            wrong.append(f"{row['case']}: the energy of the lines is off by {case.energy_error():.2g} of its range")
        if not row["largest_tension"] > row["mean_tension"] > 1e5:
            wrong.append(f"{row['case']}: no tension in the lines")
    print("\n".join(wrong) or f"{len(rows)} cases as recorded")
    return 1 if wrong else 0


def main():
    options = study.arguments(__doc__).parse_args()
    output = options.output or Path("results") / ("managed_ice-quick" if options.quick else "managed_ice")
    if options.quick and options.record:
        study.record_quick(options.brash, HERE, output)
        return 0
    if options.quick:
        return quick(options, output)
    study.campaign(options.brash, HERE / "plan.toml", output, jobs=options.jobs)
    rows, cases = collect(output)
    print_rows(rows)
    if options.record:
        study.write_rows(HERE / "recorded.csv", rows)
    draw(rows, cases, (HERE if options.record else output) / "managed_ice.png")
    return 0


if __name__ == "__main__":
    sys.exit(main())
