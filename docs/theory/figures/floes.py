# SPDX-License-Identifier: GPL-3.0-or-later
"""fracture-of-floes.md: sections of a bent floe, and the wedge and the stress intensity that split a sheet."""
import csv
import pathlib
import re

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import LineCollection

from style import EDGE, GREY, ICE, RED, SERIES, STEEL, arrow, below, centroid, fill, panel

H, STRENGTH = 0.33, 539e3                      # the validation case's ice [m, Pa]
FLOE = np.array([(-0.9, -0.5), (0.1, -0.75), (1.0, -0.35), (1.05, 0.4), (0.2, 0.75), (-0.8, 0.5)])
FORCES = (((-0.75, 0.05), 22e3), ((0.85, 0.1), 22e3), ((0.1, -0.05), -44e3))  # places [m], upward forces [N]
ROOT = pathlib.Path(__file__).resolve().parents[3]
TABLE, SPLITTING = ROOT / "failure/criterion/src/splitting_table.hpp", ROOT / "experiments/splitting/edge_crack.csv"


def moments(ring):
    """Area, first and second moments of a convex ring, exact by the middles of the sides of a fan of triangles."""
    area, first, second = 0.0, np.zeros(2), np.zeros((2, 2))
    for b, c in zip(ring[1:], ring[2:]):
        a = ring[0]
        part = 0.5 * ((b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0])
        for middle in ((a + b) / 2, (b + c) / 2, (c + a) / 2):
            first = first + part / 3 * middle
            second = second + part / 3 * np.outer(middle, middle)
        area += part
    return area, first, second


def sections(floe):
    """Both ends and the tension [Pa] of every section, by (P1), (P2) and (P4) for vertical forces."""
    area, _, second = moments(floe)
    tilting = sum(np.array(place) * force for place, force in FORCES)
    slope = -np.linalg.solve(second + H**2 / 12 * area * np.eye(2), tilting)
    even = -sum(force for _, force in FORCES) / area
    for angle in np.pi * np.arange(12) / 12:
        normal = np.array([np.cos(angle), np.sin(angle)])
        low, high = (floe @ normal).min() + H, (floe @ normal).max() - H
        for offset in np.linspace(low, high, 17):
            a, first, moment_2 = moments(below(floe, -normal, -offset))
            lever = normal @ first - offset * a
            levers = moment_2 @ normal - offset * first
            moment = sum((normal @ place - offset) * force for place, force in FORCES if normal @ place > offset)
            moment += even * lever + slope @ levers + H**2 / 12 * normal @ slope * a
            ends = [p for p in below(floe, normal, offset) if abs(p @ normal - offset) < 1e-9]
            width = np.linalg.norm(ends[0] - ends[1])
            yield angle, np.array(ends), 6 * abs(moment) / (width * H**2)


def bent(figure, axis):
    panel(axis, "sections of one direction")
    floe = FLOE - centroid(FLOE)
    found = list(sections(floe))
    worst = max(found, key=lambda section: section[2])
    shown = [section for section in found if section[0] == worst[0]]
    fill(axis, floe, ICE)
    lines = LineCollection([ends for _, ends, _ in shown], array=np.array([tension for *_, tension in shown]) / STRENGTH,
                           cmap="viridis_r", linewidths=1.6)
    lines.set_clim(0, worst[2] / STRENGTH)
    axis.add_collection(lines)
    axis.plot(*worst[1].T, color=RED, lw=2.2)
    for place, force in FORCES:
        axis.plot(*place, "o", mfc="white" if force > 0 else "black", color="black", ms=8)
        if force > 0:
            axis.plot(*place, "o", color="black", ms=2.5)
    axis.text(0, -1.02, "dots: forces up; disc: force down", ha="center", va="top", color=GREY)
    axis.set_xlim(-1.15, 1.15)
    axis.set_ylim(-1.2, 0.85)
    figure.colorbar(lines, ax=axis, shrink=0.6, label=r"tension / $\sigma_f$")


def wedge(axis):
    panel(axis, "a structure splits a sheet")
    fill(axis, [(0, -1), (2, -1), (2, 1), (0, 1)], ICE)
    fill(axis, [(-0.45, -0.28), (-0.1, -0.28), (0.12, 0), (-0.1, 0.28), (-0.45, 0.28)], STEEL, "none")
    axis.plot([0.12, 0.9], [0, 0], color=RED, lw=2)
    axis.plot([0.9, 2], [0, 0], color=RED, lw=1, ls=":")
    arrow(axis, (0.02, 0.2), (0.02, 0.62), RED, "$P$", (0.14, 0.0))
    arrow(axis, (0.02, -0.2), (0.02, -0.62), RED, "$P$", (0.14, 0.0))
    arrow(axis, (-1.0, 0), (-0.5, 0), "black", "$N$", (-0.28, 0.15))
    axis.annotate("", (0, 0.12), (0.9, 0.12), arrowprops={"arrowstyle": "<->", "color": GREY, "shrinkA": 0, "shrinkB": 0})
    axis.text(0.5, 0.17, r"$a = \alpha W$", color=GREY, ha="center", va="bottom")
    axis.annotate("", (0, 1.12), (2, 1.12), arrowprops={"arrowstyle": "<->", "color": GREY, "shrinkA": 0, "shrinkB": 0})
    axis.text(1, 1.17, "$W$", color=GREY, ha="center", va="bottom")
    axis.annotate("", (2.12, -1), (2.12, 1), arrowprops={"arrowstyle": "<->", "color": GREY, "shrinkA": 0, "shrinkB": 0})
    axis.text(2.18, 0, "$B$", color=GREY, va="center")
    for side in (1, -1):
        for x in (1.2, 1.7):
            arrow(axis, (x, side * 0.75), (x - 0.3, side * 0.75), SERIES[0])
    axis.text(1.3, -0.55, "inertia", color=SERIES[0], ha="center", va="center")
    axis.set_xlim(-1.1, 2.4)
    axis.set_ylim(-1.1, 1.4)


def of_table(name):
    """The numbers of one array of the program's table, flat."""
    numbers = re.search(name + r"\{(.*?)\};", TABLE.read_text(encoding="utf-8"), re.DOTALL)[1]
    return np.array([float(number) for number in re.findall(r"\d+\.?\d*", numbers)])


def intensity(axis):
    """(G7) with the program's table for a square, and FreeFem++ with its finest mesh."""
    with SPLITTING.open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["breadth"] == "1" and row["mesh"] == "2"]
    elements = {load: np.array([(float(row["crack"]), float(row["k_j"])) for row in rows if row["load"] == load])
                for load in ("opening", "push")}
    crack, square = of_table("kCrackLengths"), list(of_table("kBreadths")).index(1)
    opening, closing = (of_table(name).reshape(-1, crack.size)[square] for name in ("kOpening", "kClosing"))
    for push, colour in zip((0, 1, 2), SERIES):
        k = (opening - push * closing) / (np.sqrt(crack) * (1 - crack) ** 1.5)
        axis.plot(crack, k, color=colour, label=f"$N$ = {push} $P$" if push else "$N$ = 0")
        axis.plot(elements["opening"][:, 0], elements["opening"][:, 1] + push * elements["push"][:, 1], "o", ms=4,
                  color=colour)
        axis.plot(crack[k.argmin()], k.min(), "o", ms=9, mfc="none", color=RED)
    axis.set_title(r"$K_I h \sqrt{W} / P$ of a square sheet", loc="left")
    axis.set(xlabel=r"crack $\alpha = a / W$", xlim=(0, 0.7), ylim=(0, 16))
    axis.legend(loc="upper left", bbox_to_anchor=(0.12, 1.0))


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.2), constrained_layout=True, gridspec_kw={"width_ratios": (1.3, 1.2, 1)})
    bent(figure, axes[0])
    wedge(axes[1])
    intensity(axes[2])
    return figure
