# SPDX-License-Identifier: GPL-3.0-or-later
"""geometry.md: cuts of the program, and how a crossing is rounded to the grid."""
import brash
import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, SERIES, fill, panel


def cracks(axis):
    panel(axis, "three cuts")
    sheet = brash.IceSheet([[0, -8], [9, -8], [9, 8], [0, 8]])
    before, after = sheet.exact_area, 0
    for i, (centre, radius, wedges) in enumerate((((0, 0), 3.5, 4), ((1.2, 3.1), 3.0, 3), ((1.5, -3.2), 2.8, 4))):
        cut = sheet.cut_circumferential(centre, radius=radius, wedges=wedges)
        after += cut.snap
        for piece in cut.pieces:
            after += piece.exact_area
            fill(axis, piece.outline, SERIES[i], "black", alpha=0.45, lw=0.8)
    for part in sheet.polygons():
        fill(axis, part.outline, ICE)
    assert before == sheet.exact_area + after
    axis.set_xlim(-0.5, 9.3)
    axis.set_ylim(-8.3, 8.3)


def rounding(axis):
    panel(axis, "a crossing becomes the grid point of its pixel")
    for line in range(9):
        axis.plot([line - 0.5] * 2, [-0.5, 5.5], color=GREY, lw=0.4, alpha=0.6)
    for line in range(7):
        axis.plot([-0.5, 7.5], [line - 0.5] * 2, color=GREY, lw=0.4, alpha=0.6)
    a, b, c, d = (np.array(p, float) for p in ((0, 1), (7, 4), (1, 5), (5, 0)))
    along, across = b - a, d - c
    t = np.cross(c - a, across) / np.cross(along, across)
    crossing = a + t * along
    node = np.round(crossing)
    axis.fill(*zip(*(node + corner for corner in ((-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)))), color=RED,
              alpha=0.18, lw=0)
    for ends in ((a, b), (c, d)):
        axis.plot(*zip(*ends), "--", color=GREY, lw=1)
        axis.plot(*zip(ends[0], node, ends[1]), color=EDGE, lw=1.6)
    axis.fill(*zip(a, node, b), color=SERIES[1], alpha=0.6, lw=0)
    axis.plot(*crossing, "x", color=GREY)
    axis.plot(*zip(a, b, c, d, node), "o", color=EDGE, ms=4)
    axis.text(6.9, 4.35, "edge of the sheet", color=EDGE, ha="right")
    axis.text(d[0] + 0.2, d[1] + 0.25, "cut", color=EDGE)
    axis.text(4.9, 1.9, "snap: area that the\nedge has moved over", color=SERIES[1], ha="left", va="top")
    axis.set_xlim(-0.6, 8.2)
    axis.set_ylim(-0.6, 5.6)


def draw():
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 4), constrained_layout=True, gridspec_kw={"width_ratios": (1, 1.7)})
    cracks(axes[0])
    rounding(axes[1])
    return figure
