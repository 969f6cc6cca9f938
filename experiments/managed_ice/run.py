#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A moored floater in managed ice: load, offset and line loads over the thickness of the ice and the size of its floes.

run.py [--brash PROGRAM] [-o FOLDER] [--jobs N] [--quick] [--record]

Runs twenty.toml and plan.toml, prints a row for each setting, and judges the criteria of criteria.toml. --record writes
recorded.csv, a row a case, spectra.csv, verdicts.csv and both pictures. --quick runs two short settings: it compares their loads
with quick.csv, and the energy of the lines by mooring.py with the program's.
"""
import json
import sys
import tomllib
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import mooring
import pictures
import study
import surge
import verdicts

EVERY = 25  # steps between two rows whose lines are solved
# mooring.py sums the energy of a line over 4000 pieces, which is off by 1e-7 of it.
ENERGY_SHARE = 1e-4
COLUMNS = ["time", "Fx", "structure_x", "structure_y", "structure_z", "structure_roll", "structure_pitch",
           "structure_heading", "structure_vx", "body_mooring"]


def history_of(path):
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")
    table = np.loadtxt(path, delimiter=",", skiprows=1, usecols=[names.index(name) for name in COLUMNS])
    return dict(zip(COLUMNS, table.T))


class Case:
    """A case of a campaign with its lines over time. Offsets and loads count along the drift, against x."""

    def __init__(self, output, row):
        folder = output / "cases" / row["case"]
        name = "floater" if row["setting"] == "base" else f"floater_{row['setting']}"
        self.path = output / "settings" / f"{name}.toml"
        self.case = tomllib.loads(self.path.read_text(encoding="utf-8"))
        self.history = history_of(folder / "history.csv")
        self.start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
        self.lines = mooring.lines_over_time(self.history, self.case, EVERY)
        self.step = self.case["time"]["step"]
        self.load = self.history["Fx"]  # against the structure's way, which is the drift's
        self.away = (self.case["structure"]["speed"] * self.history["time"] - self.case["structure"]["start_distance"]
                     - self.history["structure_x"])

    def counted(self):
        """Which rows of the history the statistics take."""
        return self.history["time"] >= self.start

    def drift_load(self):
        """The damping of the water that drifts past the floater at rest [N]."""
        return self.case["structure"]["motion"]["linear_damping"][0] * self.case["structure"]["speed"]

    def numbers(self, period):
        """What recorded.csv has beside the campaign's columns."""
        counts, rows = self.counted(), self.counted()[::EVERY]
        hardest = self.lines.tensions[rows].max(axis=1)
        load, pull = self.load[counts].mean() + self.drift_load(), self.lines.pull[rows].mean()
        way = self.by_oscillator(period)[counts]
        away = self.away[counts]
        return {"ice.thickness": self.case["ice"]["thickness"], "field.size.median": self.case["field"]["size"]["median"],
                "mean_offset": away.mean(), "offset_deviation": away.std(), "largest_offset": away.max(),
                "mean_tension": hardest.mean(), "largest_tension": hardest.max(), "pull_over_load": pull / load,
                "oscillator_over_offset": way.std() / away.std()}

    def by_oscillator(self, period):
        """The offset [m] of a linear oscillator under the recorded load."""
        damping = self.case["structure"]["motion"]["linear_damping"][0]
        return surge.oscillator(self.load + self.drift_load(), self.step, period, damping,
                                mooring.surge_stiffness(self.case))

    def energy_error(self):
        """The largest difference from body_mooring of the history, as a share of its range."""
        known = self.history["body_mooring"][::EVERY]
        change = self.lines.energy - self.lines.energy[0] + known[0]
        return np.abs(change - known).max() / np.ptp(known)


def collect(brash, output):
    """Rows and cases of a campaign, and the natural period of the surge [s]."""
    rows = study.read_rows(output / "campaign.csv")
    cases = [Case(output, row) for row in rows]
    period = surge.natural_period(brash, cases[0].path)
    for row, case in zip(rows, cases):
        row.update(case.numbers(period))
    return rows, cases, period


def print_rows(rows):
    print("thickness, size [m]   n  load, mean, largest [kN]   offset, mean, largest [m]   line, mean, largest [kN]")
    for setting in dict.fromkeys((row["ice.thickness"], row["field.size.median"]) for row in rows):
        chosen = [row for row in rows if (row["ice.thickness"], row["field.size.median"]) == setting]

        def mean(key, scale=1.0):
            centre, half = study.mean_interval([row[key] / scale for row in chosen])
            return f"{centre:.4g} ± {half:.2g}"

        print(f"{setting[0]:9g}, {setting[1]:4g} {len(chosen):7d}  {mean('horizontal.mean', 1e3):>14s},"
              f"{mean('horizontal.maximum', 1e3):>14s} {mean('mean_offset'):>15s},{mean('largest_offset'):>15s} "
              f"{mean('mean_tension', 1e3):>15s},{mean('largest_tension', 1e3):>15s}")


def spectra_of(cases, period, segment):
    """{quantity: frequency, density, lower and upper bound} of load, surge and the oscillator's surge."""
    module = study.brash_module()
    records = {"load": [case.load[case.counted()] for case in cases],
               "offset": [case.away[case.counted()] for case in cases],
               "oscillator": [case.by_oscillator(period)[case.counted()] for case in cases]}
    return {name: surge.pooled_spectrum(module, record, cases[0].step, segment) for name, record in records.items()}


def spectra_rows(spectra, highest=0.5):
    """Rows of spectra.csv, up to a frequency [Hz]."""
    rows = []
    for i, frequency in enumerate(spectra["load"][0]):
        if frequency <= highest:
            rows.append({"frequency": frequency} | {f"{name}{part}": values[k][i] for name, values in spectra.items()
                                                    for k, part in ((1, ""), (2, "_lower"), (3, "_upper"))})
    return rows


def quick(options, output):
    rows, cases, _ = collect(options.brash, study.quick_campaign(options, HERE, output))
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
    criteria = tomllib.loads((HERE / "criteria.toml").read_text(encoding="utf-8"))
    output.mkdir(parents=True, exist_ok=True)
    for plan in ("twenty", "plan"):
        study.campaign(options.brash, HERE / f"{plan}.toml", output / plan, jobs=options.jobs)
    rows, twenty, period = collect(options.brash, output / "twenty")
    others, _, _ = collect(options.brash, output / "plan")
    spectra = spectra_of(twenty, period, criteria["resonance"]["segment"])
    judged = verdicts.judge(criteria, rows, others, spectra, period)
    print_rows(rows + others)
    verdicts.show(judged)
    target = HERE if options.record else output
    named = [{"plan": name} | row for name, part in (("twenty", rows), ("plan", others)) for row in part]
    study.write_rows(target / "recorded.csv", named)
    study.write_rows(target / "spectra.csv", spectra_rows(spectra))
    study.write_rows(target / "verdicts.csv", judged)
    pictures.draw_means(rows + others, target)
    pictures.draw_spectra(twenty, spectra, period, target)
    return 0


if __name__ == "__main__":
    sys.exit(main())
