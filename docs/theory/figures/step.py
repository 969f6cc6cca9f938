# SPDX-License-Identifier: GPL-3.0-or-later
"""simulation.md: the stages of one step, with the sections and equations of the paper."""
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.patches import FancyBboxPatch

from style import EDGE, GREY, ICE, RED, SERIES, STEEL, WATER, arrow, fill

BLOCKS = (
    ("The structure moves through the ice", (
        ("structure moves", "Sec. 3.1.1"), ("contacts with the edge", "Sec. 2.2.2"), ("crushing", "Eq. 15"),
        ("wedges of the edge", "Figs. 2 to 4"), ("failures", "Eqs. 17 to 19"), ("cracks, new floes", "Sec. 2.2.2"))),
    ("The bodies move", (
        ("water on the floes", "Eqs. 13, 14"), ("bounded contacts", "Eqs. 1 to 6, 16"),
        ("velocities and poses", "Eqs. 7 to 10"))),
    ("The accounts are closed", (
        ("loads on the structure", "Sec. 2.1.3"), ("watchdog", "energy, area"), ("sleep and wake", ""),
        ("crushed floes leave", "Sec. 2.2.1"), ("bent floes break", ""))))
WIDTH, ROW, GAP, TOP = 3.1, 0.42, 0.75, 1.62   # of a column and a row, between columns, of the first row


def breaking(axis, left):
    """In plan: the structure, its chord on the edge, and the crack ahead."""
    middle = np.array([left + 1.35, 2.6])
    angle = np.linspace(-np.pi / 2, np.pi / 2, 40)
    fill(axis, [(left + 1.3, 1.95), (left + WIDTH, 1.95), (left + WIDTH, 3.25), (left + 1.3, 3.25)], ICE, "none")
    axis.plot([left + 1.3] * 2, [1.95, 3.25], color=EDGE, lw=1.2)
    axis.plot(*(middle[:, None] + 0.55 * np.array([np.cos(angle), np.sin(angle)])), color=RED, ls="--")
    for turn in (-0.55, 0.0, 0.55):
        ahead = np.array([np.cos(turn), np.sin(turn)])
        axis.plot(*zip(middle + 0.1 * ahead, middle + 0.55 * ahead), color=RED, lw=0.9)
    around = np.linspace(0, 2 * np.pi, 60)
    fill(axis, np.array([left + 0.92, 2.6]) + 0.48 * np.column_stack([np.cos(around), np.sin(around)]), STEEL, "none")
    arrow(axis, (left + 0.05, 2.6), (left + 0.42, 2.6), "black")


def moving(axis, left):
    """From the side: a floe under the load of a neighbour, weight and buoyancy."""
    fill(axis, [(left, 1.95), (left + WIDTH, 1.95), (left + WIDTH, 2.75), (left, 2.75)], WATER, "none", alpha=0.6)
    floe = np.array([(0.55, 2.45), (1.75, 2.72), (1.7, 2.94), (0.5, 2.67)]) + (left, 0)
    fill(axis, floe, ICE)
    fill(axis, np.array([(1.72, 2.55), (2.8, 2.55), (2.8, 2.8), (1.72, 2.8)]) + (left, 0), ICE)
    arrow(axis, (left + 2.2, 2.92), (left + 1.76, 2.84), RED, "$P$", (0.52, 0.14))
    arrow(axis, (left + 1.1, 2.1), (left + 1.1, 2.5), SERIES[2], r"$\rho_w g V$", (0.42, -0.22))
    arrow(axis, (left + 0.1, 2.3), (left + 0.5, 2.45), SERIES[0], "drag", (-0.1, -0.32))


def counted(axis, left):
    """A history of the load."""
    time = np.linspace(0, 1, 200)
    load = 2.0 + 1.0 * np.mod(5.3 * time, 1) * (0.6 + 0.4 * np.sin(9 * time + 1) ** 2)
    axis.plot(left + 0.2 + (WIDTH - 0.4) * time, load, color=SERIES[0], lw=1)
    axis.plot([left + 0.2, left + 0.2, left + WIDTH - 0.2], [3.2, 1.95, 1.95], color=GREY, lw=0.8)
    axis.text(left + 0.3, 3.2, "$F_x$", color=SERIES[0], va="center")
    axis.text(left + WIDTH - 0.15, 1.95, "$t$", color=GREY, va="center")


def column(axis, left, title, stages):
    axis.text(left, 3.5, title, weight="bold", va="center", fontsize=10)
    for i, (name, source) in enumerate(stages):
        low = TOP - (i + 1) * ROW
        axis.add_patch(FancyBboxPatch((left, low + 0.05), WIDTH, ROW - 0.1, boxstyle="round,pad=0,rounding_size=0.08",
                                      facecolor=ICE if i % 2 else "#eef4f9", edgecolor=EDGE, lw=0.8))
        axis.text(left + 0.1, low + ROW / 2, name, va="center")
        axis.text(left + WIDTH - 0.1, low + ROW / 2, source, va="center", ha="right", color=GREY)
    return TOP - len(stages) * ROW


def draw():
    figure, axis = plt.subplots(figsize=(11, 4.4), constrained_layout=True)
    axis.set_aspect("equal")
    axis.axis("off")
    lefts = [i * (WIDTH + GAP) for i in range(3)]
    for left, sketch, (title, stages) in zip(lefts, (breaking, moving, counted), BLOCKS):
        sketch(axis, left)
        bottom = column(axis, left, title, stages)
        if left < lefts[-1]:
            arrow(axis, (left + WIDTH + 0.12, TOP - 0.8), (left + WIDTH + GAP - 0.12, TOP - 0.8), "black")
    floor, far = TOP - 6 * ROW, -0.85
    axis.plot([lefts[2] + WIDTH / 2] * 2 + [far] * 2, [bottom - 0.05] + [floor - 0.35] * 2 + [3.5], color="black", lw=1.4)
    arrow(axis, (far, 3.5), (-0.1, 3.5), "black")
    axis.text(lefts[1] + WIDTH / 2, floor - 0.27, r"next step: $t + \Delta t$; the load moves a structure that is free to move",
              ha="center", va="bottom")
    # The move is cut into parts where the ice fails, or where an input leaves the model's range.
    side = -0.22
    axis.plot([-0.02, side, side], [floor + 0.2, floor + 0.2, TOP - 0.2], color=RED, lw=1.2)
    arrow(axis, (side, TOP - 0.2), (-0.02, TOP - 0.2), RED)
    axis.text(side - 0.08, (floor + TOP) / 2, "in parts, if the ice fails within the step", color=RED, rotation=90,
              ha="right", va="center", fontsize=8)
    axis.set_xlim(-0.9, lefts[2] + WIDTH + 0.05)
    axis.set_ylim(floor - 0.45, 3.7)
    return figure
