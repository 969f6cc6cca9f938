#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of the speed at each cone angle (the paper's Fig. 15).

run.py                  the campaign, its table and pictures in results/angle_velocity-paper; --preset brash: the default
run.py --record         also rewrites the recorded numbers and pictures here
run.py --quick          the short variant of the tests: two angles at two speeds, compared with quick.csv

The row of 61.4 degrees is read from the recorded numbers of the experiment `velocity`.
"""
import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study

ANGLE, SPEED = "structure.angle", "structure.speed"
COLUMNS = {"horizontal.mean": "mean horizontal force [kN]", "vertical.mean": "mean vertical force [kN]",
           "mean_frequency": "mean frequency [Hz]", "breaking_length_quantiles.50": "breaking length, median [m]"}


def draw(rows, closed, output, folder, series):
    between = study.read_rows(study.recorded("velocity", series))
    rows = rows + [{**row, ANGLE: math.radians(61.4)} for row in between]
    figure, axes = figures.plt.subplots(1, len(COLUMNS), figsize=(14, 3.6), constrained_layout=True)
    shades = figures.plt.get_cmap("viridis")
    angles = sorted({row[ANGLE] for row in rows})
    for axis, (column, title) in zip(axes, COLUMNS.items()):
        for i, angle in enumerate(angles):
            figures.means(axis, study.groups(rows, SPEED, column, structure__angle=angle), SPEED,
                          shades(0.85 * i / (len(angles) - 1)), f"{math.degrees(angle):g} deg",
                          unit=study.unit_of(column))
        axis.set_title(title)
        axis.set_xlabel(figures.LABELS[SPEED])
        axis.set_ylim(bottom=min(0.0, axis.get_ylim()[0]))
    axes[0].legend(fontsize=8)
    figures.save(figure, folder, "means")


if __name__ == "__main__":
    sys.exit(study.main(HERE, [ANGLE, SPEED], list(COLUMNS), draw, __doc__))
