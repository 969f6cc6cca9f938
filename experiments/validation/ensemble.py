#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Replicates of the validation case: ensemble.py [--seeds N] [--steps DT ...] [--set section.key=value ...] [-o FOLDER]

Prints, for each time step, the mean and the 95 % interval (Student's t over the seeds) of the horizontal and vertical
force from the moment the cone's axis passes the initial edge, its split by cause, and the 99 % quantile of the
horizontal force averaged over 0.1 s.
"""
import argparse
import csv
import json
import subprocess
from pathlib import Path

import numpy as np
from scipy import stats

HERE = Path(__file__).resolve().parent
BRASH = HERE.parents[1] / "build" / "release" / "bin" / "brash"
SMOOTHING = 0.1  # s


def simulate(folder, seed, step, overrides):
    command = [BRASH, "run", HERE / "cone.toml", "-o", folder, "--seed", str(seed), "--set", f"time.step={step}"]
    for override in overrides:
        command += ["--set", override]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        fx = np.array([[float(row["time"]), float(row["Fx"])] for row in csv.DictReader(file)])
    n = max(1, round(SMOOTHING / step))
    smooth = np.convolve(fx[fx[:, 0] > summary["statistics_from"], 1], np.ones(n) / n, mode="valid")
    return {
        "horizontal": summary["horizontal"]["mean"],
        "vertical": summary["vertical"]["mean"],
        "deviation": summary["horizontal"]["standard_deviation"],
        "crushing": summary["horizontal"]["mean_by_cause"]["crushing"],
        "contact": summary["horizontal"]["mean_by_cause"]["floe_normal"],
        "friction": summary["horizontal"]["mean_by_cause"]["floe_friction"],
        "q99 of 0.1 s": float(np.quantile(smooth, 0.99)),
        "whole history": summary["mean_whole_history"]["horizontal"],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seeds", type=int, default=8)
    parser.add_argument("--steps", type=float, nargs="+", default=[0.01])
    parser.add_argument("--set", action="append", default=[], dest="overrides")
    parser.add_argument("-o", "--output", type=Path, default=Path("results/validation-ensemble"))
    options = parser.parse_args()
    for step in options.steps:
        runs = [simulate(options.output / f"{step}-{seed}", seed, step, options.overrides)
                for seed in range(1, options.seeds + 1)]
        print(f"dt = {step} s, {options.seeds} seeds [kN]: mean, 95 % interval of the mean, deviation between seeds")
        for name in runs[0]:
            values = np.array([run[name] for run in runs]) / 1e3
            half = stats.t.ppf(0.975, len(values) - 1) * values.std(ddof=1) / np.sqrt(len(values))
            print(f"  {name:14s} {values.mean():7.1f}  [{values.mean() - half:.1f}, {values.mean() + half:.1f}]"
                  f"  {values.std(ddof=1):6.1f}", flush=True)


if __name__ == "__main__":
    main()
