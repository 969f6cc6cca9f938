#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of one case by several programs, a row each as CSV: programs.py NAME=RUN...

  mean, deviation, quantile_99  of the horizontal load, in the window of the statistics [kN]
  breaks, under_floes           of the sheet: all, and those under a floe's load
  floes_broken                  floes that broke
  area_under_floes              share of the broken area under floes' loads [-]
  length                        median of the breaking lengths under the structure [m]
  stress_50, stress_95          largest stress at the break over the strength [-]
  load_50, load_95              P over sigma_f h^2 at the break, under the structure [-]
"""
import csv
import json
import sys
import tomllib
from pathlib import Path

import netCDF4
import numpy as np


def quantiles(values, digits):
    return [round(float(q), digits) for q in np.quantile(values, [0.5, 0.95])] if len(values) else ["", ""]


def row(name, folder):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    with open(folder / "events.csv", encoding="utf-8") as stream:
        events = [{key: float(value) for key, value in event.items() if value and key not in ("event", "cause")}
                  for event in csv.DictReader(stream) if event["event"] == "break"]
    with netCDF4.Dataset(folder / "run.nc") as run:
        case = tomllib.loads(run.case)
    under = [event["pressing_floe"] >= 0 for event in events]
    area = np.array([event["area_before"] - event["area_after"] for event in events])
    of_structure = [event for event, is_under in zip(events, under) if not is_under]
    stress = quantiles([event["sigma_max"] / event["flexural_strength"] for event in events], 3)
    load = quantiles([event["p"] / (event["flexural_strength"] * event["thickness"] ** 2) for event in of_structure], 3)
    load_of = summary["horizontal"]
    return {"program": name, "seed": case["random"]["seed"], "mean": round(load_of["mean"] / 1e3, 1),
            "deviation": round(load_of["standard_deviation"] / 1e3, 1), "quantile_99": round(load_of["quantile_99"] / 1e3, 1),
            "breaks": len(events), "under_floes": sum(under), "floes_broken": summary["n_floes_broken"],
            "area_under_floes": round(float(area[under].sum() / area.sum()), 3),
            "length": quantiles([event["l_break"] for event in of_structure], 3)[0],
            "stress_50": stress[0], "stress_95": stress[1], "load_50": load[0], "load_95": load[1]}


def main():
    rows = [row(name, Path(folder)) for name, folder in (run.split("=", 1) for run in sys.argv[1:])]
    table = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
    table.writeheader()
    table.writerows(rows)


if __name__ == "__main__":
    main()
