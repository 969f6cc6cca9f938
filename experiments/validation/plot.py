#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resistance against time (the paper's Fig. 7) of a run: plot.py RUN_FOLDER [PICTURE]."""
import csv
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

CAUSES = {"crushing": "crushing at the edge", "floe_normal": "floes, normal", "floe_friction": "floes, friction"}
MEASURED_MEAN = 111.8  # kN, paper, Sec. 3.1.3


def main(folder, picture):
    with open(folder / "history.csv", newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    column = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    time = column["time"]
    start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
    mean = column["Fx"][time > start].mean() / 1e3

    figure, (top, bottom) = plt.subplots(2, 1, sharex=True, figsize=(9, 5.5), constrained_layout=True)
    top.plot(time, column["Fx"] / 1e3, lw=0.7, color="#1f4e79", label="simulated")
    top.hlines(mean, start, time[-1], color="#1f4e79", ls="--", lw=1.4, label=f"its mean from {start:.2f} s on, {mean:.1f} kN")
    top.axhline(MEASURED_MEAN, color="#b3261e", lw=1, label=f"measured mean, {MEASURED_MEAN} kN")
    top.set_ylabel("horizontal force [kN]")
    top.legend(loc="upper left", fontsize=8, ncols=3)
    window = 1.0  # s, running mean
    n = max(1, round(window / (time[1] - time[0])))
    for cause, label in CAUSES.items():
        smooth = np.convolve(column[f"{cause}_Fx"], np.ones(n) / n, mode="same")
        bottom.plot(time, smooth / 1e3, lw=1, label=label)
    bottom.set_ylabel("by cause, 1 s mean [kN]")
    bottom.set_xlabel("time [s]")
    bottom.legend(loc="upper left", fontsize=8, ncols=3)
    for axes in (top, bottom):
        axes.set_ylim(top=1.15 * axes.get_ylim()[1])  # room for the legends
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    run_folder = Path(sys.argv[1])
    main(run_folder, Path(sys.argv[2]) if len(sys.argv) > 2 else run_folder / "resistance.png")
