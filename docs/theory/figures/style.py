# SPDX-License-Identifier: GPL-3.0-or-later
"""Colours and small drawing helpers that the figures share."""
import numpy as np
from matplotlib.patches import Polygon

ICE, EDGE, STEEL, RED, GREEN, GREY, WATER = "#dcebf5", "#2b5c8a", "#9aa3ad", "#b3261e", "#2e7d32", "#6b7280", "#c9e0ee"
SERIES = ("#1f4e79", "#c77700", "#2e7d32", "#7b3294")


def panel(axis, title):
    """A drawing to scale without axes."""
    axis.set_aspect("equal")
    axis.axis("off")
    axis.set_title(title, loc="left")


def fill(axis, points, colour, edge=EDGE, **style):
    axis.add_patch(Polygon(np.asarray(points), closed=True, facecolor=colour, edgecolor=edge, **style))


def arrow(axis, start, end, colour, text="", offset=(0.0, 0.0)):
    axis.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.4, "shrinkA": 0, "shrinkB": 0})
    if text:
        axis.text(end[0] + offset[0], end[1] + offset[1], text, color=colour, ha="center", va="center")


def below(points, normal, distance):
    """The part of a convex polygon where x . normal <= distance."""
    points, normal = np.asarray(points, float), np.asarray(normal, float)
    result = []
    for a, b in zip(points, np.roll(points, -1, axis=0)):
        at_a, at_b = a @ normal - distance, b @ normal - distance
        if at_a <= 0:
            result.append(a)
        if at_a * at_b < 0:
            result.append(a + (b - a) * at_a / (at_a - at_b))
    return np.array(result)


def centroid(points):
    x, y = np.asarray(points).T
    cross = x * np.roll(y, -1) - np.roll(x, -1) * y
    return np.array([((x + np.roll(x, -1)) * cross).sum(), ((y + np.roll(y, -1)) * cross).sum()]) / (3 * cross.sum())
