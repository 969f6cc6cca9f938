# SPDX-License-Identifier: GPL-3.0-or-later
"""structures.md: a ship from its particulars, its regions, and the slope of its panels."""
import math
import pathlib

import brash
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import PolyCollection

from style import EDGE, GREY, ICE, RED, SERIES, WATER, fill, panel

CASE = pathlib.Path(__file__).resolve().parents[3] / "experiments/ships/icebreaker.toml"
N = 200                                        # chords of each curve of the waterline


def half_waterline(hull):
    """The port side of (K4) at rest, stem to stern [m, m], with the lengths of bow and run [m]."""
    half = hull["breadth"] / 2
    bow = 2 * half / math.tan(hull["waterline_angle"])  # the default: a parabola, p = 2
    run = hull["length"] - bow - hull["midbody"]
    t = np.linspace(0, 1, N)
    fore, aft = hull["length"] / 2 - bow, -hull["length"] / 2 + run
    x = np.concatenate([hull["length"] / 2 - bow * t, np.linspace(fore, aft, N), (-hull["length"] / 2 + run * t)[::-1]])
    y = half * np.concatenate([1 - (1 - t) ** 2, np.ones(N), (t * (2 - t))[::-1]])
    return x, y, bow, run


def regions(x, y, hull):
    """Where the regions of (K7) end along the port side: abaft the bow, the shoulders and the sides [m]."""
    fore, aft = x[y >= 0.999 * hull["breadth"] / 2][[0, -1]]
    angle = np.degrees(np.abs(np.arctan2(np.diff(y), np.diff(x))))
    steep = np.minimum(angle, 180 - angle) >= 10
    bow = x[:-1][steep & (x[:-1] > fore)].min()
    return bow, fore - 0.04 * hull["length"], aft


def span(axis, a, b, height, text):
    axis.annotate("", (a, height), (b, height), arrowprops={"arrowstyle": "<->", "color": GREY, "shrinkA": 0, "shrinkB": 0})
    axis.text((a + b) / 2, height - 1.0, text, color=GREY, ha="center", va="top")


def plan(axis, hull):
    panel(axis, "waterline and regions")
    x, y, bow, run = half_waterline(hull)
    fill(axis, np.column_stack([np.concatenate([x, x[::-1]]), np.concatenate([y, -y[::-1]])]), ICE, "none")
    ends = (math.inf, *regions(x, y, hull), -math.inf)
    for name, first, last, colour in zip(("bow", "shoulder", "side", "stern"), ends, ends[1:], (RED, *SERIES[1:3], GREY)):
        part = (x <= first) & (x >= last)
        for side in (1, -1):
            axis.plot(x[part], side * y[part], color=colour, lw=3, solid_capstyle="butt")
        axis.text(x[part].mean(), np.interp(x[part].mean(), x[::-1], y[::-1]) + 2, name, color=colour, ha="center", va="bottom")
    tip = hull["length"] / 2
    axis.plot([tip, tip - 10], [0, 0], color="black", lw=0.8)
    axis.plot([tip, tip - 10], [0, 10 * math.tan(hull["waterline_angle"])], color="black", lw=0.8, ls="--")
    axis.text(tip - 9.2, 1.9, r"$\alpha$", va="center")
    height = -hull["breadth"] / 2 - 2.5
    span(axis, tip - bow, tip, height, "$L_b$")
    span(axis, -tip + run, tip - bow, height, "$L_m$")
    span(axis, -tip, -tip + run, height, "$L_r$")
    axis.set_xlim(-50, 56)
    axis.set_ylim(-18, 15)


def profile(axis, hull):
    panel(axis, "from the side")
    half, draught, top = hull["length"] / 2, hull["draught"], hull["depth"] - hull["draught"]
    fill(axis, [(-52, 0), (57, 0), (57, -11), (-52, -11)], WATER, "none", alpha=0.6)
    stem, stern = (lambda z: half + z / math.tan(hull["stem_angle"])), (lambda z: -half - z / math.tan(hull["stern_angle"]))
    fill(axis, [(stern(-draught), -draught), (stem(-draught), -draught), (stem(top), top), (stern(top), top)], "#d5dade")
    axis.plot([-52, 57], [0, 0], color=EDGE, lw=0.8)
    axis.plot([half, half - 13], [0, 0], color="black", lw=0.8)
    axis.text(half - 11.5, -1.9, r"$\phi$", ha="center", va="center")
    axis.text(-half + 5, -1.9, r"$\phi_s$", ha="center", va="center")
    axis.annotate("", (0, 0), (0, -draught), arrowprops={"arrowstyle": "<->", "color": GREY, "shrinkA": 0, "shrinkB": 0})
    axis.text(1.2, -draught / 2, "$T$", color=GREY, va="center")
    axis.set_xlim(-52, 57)
    axis.set_ylim(-11, 6)


def panels(figure, axis, case):
    """The faces that look to a viewer below the bow; the hull is convex, so none hides another."""
    panel(axis, r"panels from below the bow: slope $\psi$ [deg]")
    points, faces = case.mesh()
    corners = points[faces]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    view = np.array([0.42, -0.72, -0.55])
    view /= np.linalg.norm(view)
    right = np.cross([0, 0, 1], view)
    right /= np.linalg.norm(right)
    up = np.cross(view, right)
    seen = normal @ view > 0
    slope = np.degrees(np.arccos(np.abs(normal[:, 2])))
    shown = PolyCollection(np.stack([corners[seen] @ right, corners[seen] @ up], axis=-1), array=slope[seen],
                           cmap="viridis", edgecolors="face", linewidths=0.4)
    shown.set_clim(0, 90)
    axis.add_collection(shown)
    x, y, *_ = half_waterline(case.to_dict()["hull"])
    line = np.column_stack([x, -y, np.zeros_like(x)])
    axis.plot(line @ right, line @ up, color="white", lw=1.2)
    axis.autoscale_view()
    figure.colorbar(shown, ax=axis, orientation="horizontal", shrink=0.7, ticks=(0, 20, 40, 60, 80))


def draw():
    case = brash.Case.from_file(CASE)
    hull = case.to_dict()["hull"]
    figure = plt.figure(figsize=(11, 3.9))
    plan(figure.add_axes((0.01, 0.36, 0.52, 0.56)), hull)
    profile(figure.add_axes((0.01, 0.01, 0.52, 0.29)), hull)
    panels(figure, figure.add_axes((0.55, 0.06, 0.44, 0.86)), case)
    return figure
