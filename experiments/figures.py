# SPDX-License-Identifier: GPL-3.0-or-later
"""Axes and pictures that the experiments share; every picture is written as SVG and PNG."""
import math

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import study

plt.rcParams.update({"font.size": 9, "axes.grid": True, "grid.alpha": 0.3,
                     "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})
BLUE, RED, GREY, GREEN, ORANGE = "#1f4e79", "#b3261e", "#6b7280", "#2e7d32", "#c77700"
CLOSED = {"croasdale": ("Croasdale, ISO 19906", RED, "--"), "ralston_tresca": ("Ralston, Tresca", GREEN, "--"),
          "ralston_johansen": ("Ralston, Johansen", ORANGE, ":")}
LABELS = {"structure.angle": "cone angle [deg]", "structure.speed": "speed [m/s]",
          "structure.waterline_width": "waterline width [m]", "ice.thickness": "ice thickness [m]"}


def shown(key, value):
    """A value as the axis shows it."""
    return math.degrees(value) if key == "structure.angle" else value


def save(figure, folder, name):
    figure.savefig(folder / f"{name}.png", dpi=110)
    plt.close(figure)


def means(axis, values, key, colour, label, unit=1e3):
    """Replicates as dots, their mean with its 95 % interval, against the values of `key`."""
    x = [shown(key, value) for value in values]
    centre, half = zip(*(study.mean_interval(np.array(v) / unit) for v in values.values()))
    for at, sample in zip(x, values.values()):
        axis.plot([at] * len(sample), np.array(sample) / unit, ".", color=colour, alpha=0.5, ms=5, mew=0)
    axis.errorbar(x, centre, half, color=colour, marker="o", ms=4, lw=1.2, capsize=3, label=label)


def closed_lines(axis, closed, key, component):
    for name, (label, colour, style) in CLOSED.items():
        points = sorted((shown(key, row[key]), row[f"{name}.{component}"]) for row in closed
                        if isinstance(row.get(f"{name}.{component}"), float))
        if points:
            x, y = zip(*points)
            axis.plot(x, np.array(y) / 1e3, style, color=colour, lw=1.2, label=label)


def mean_figure(rows, closed, key, folder, name):
    """Means of both forces, peaks beside the closed forms, frequency content and ice broken, against one input."""
    figure, grid = plt.subplots(2, 3, figsize=(11, 6.4), constrained_layout=True)
    axes = grid.ravel()
    means(axes[0], study.groups(rows, key, "horizontal.mean"), key, BLUE, "total")
    for cause, colour in (("crushing", RED), ("floe_normal", GREEN), ("floe_friction", ORANGE)):
        column = f"horizontal.mean_by_cause.{cause}"
        if column in rows[0]:
            means(axes[0], study.groups(rows, key, column), key, colour, cause.replace("_", ", "))
    axes[0].set_title("mean horizontal force [kN]")
    means(axes[1], study.groups(rows, key, "vertical.mean"), key, BLUE, "mean")
    axes[1].set_title("mean vertical force [kN]")
    means(axes[2], study.groups(rows, key, "horizontal.quantile_99"), key, BLUE, "simulated, 99 %")
    closed_lines(axes[2], closed, key, "horizontal")
    axes[2].set_title("horizontal peaks [kN]")
    means(axes[3], study.groups(rows, key, "mean_frequency"), key, BLUE, "mean of the spectrum", unit=1.0)
    axes[3].set_title("mean frequency [Hz]")
    means(axes[4], study.groups(rows, key, "breaking_length_quantiles.50"), key, BLUE, "median", unit=1.0)
    axes[4].set_title("breaking length, median [m]")
    means(axes[5], study.groups(rows, key, "piece_area_quantiles.50"), key, BLUE, "median", unit=1.0)
    axes[5].set_title("area of a piece, median [m²]")
    for axis in axes:
        axis.set_xlabel(LABELS[key])
        axis.set_ylim(bottom=min(0.0, axis.get_ylim()[0]))
    for axis in (axes[0], axes[2]):
        axis.legend(fontsize=7)
    save(figure, folder, name)


def history_figure(rows, key, output, folder, name):
    """Horizontal force against time of the first replicate of each setting, one below the other."""
    chosen = sorted((row for row in rows if row["replicate"] == 0), key=lambda row: row[key])
    figure, axes = plt.subplots(len(chosen), 1, figsize=(9, 1.5 * len(chosen)), sharey=True, constrained_layout=True,
                                squeeze=False)
    for axis, row in zip(axes[:, 0], chosen):
        history = study.read_rows(output / "cases" / row["case"] / "history.csv")
        axis.plot([r["time"] for r in history], [r["Fx"] / 1e3 for r in history], color=BLUE, lw=0.6)
        axis.set_title(f"{LABELS[key].split(' [')[0]} {shown(key, row[key]):g} {LABELS[key].split('[')[1][:-1]}",
                       fontsize=9, loc="left")
        axis.set_ylabel("[kN]")
    axes[-1, 0].set_xlabel("time [s]")
    save(figure, folder, name)
