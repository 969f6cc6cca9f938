# SPDX-License-Identifier: GPL-3.0-or-later
"""simulation.md: the leading and trailing outlines of a cone, from the side and in plan."""
import math

import brash
import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, STEEL, WATER, fill, panel

RADIUS, SLOPE, H, FREEBOARD = 6.8, math.radians(61.4), 0.33, 0.040  # the validation case [m, rad]
TOP, BOTTOM = (RADIUS + z / math.tan(SLOPE) for z in (FREEBOARD, FREEBOARD - H))


def side(axis):
    panel(axis, "from the side: a cone that breaks downward")
    x = [RADIUS - 1.0, RADIUS + 0.55]
    axis.fill([x[0], x[1], x[1], x[0]], [0, 0, -0.62, -0.62], color=WATER, alpha=0.6, lw=0)
    ice = RADIUS - 0.06
    fill(axis, [(ice, FREEBOARD - H), (x[1], FREEBOARD - H), (x[1], FREEBOARD), (ice, FREEBOARD)], ICE)
    low, high = -0.62, 0.3
    face = [(RADIUS + z / math.tan(SLOPE), z) for z in (low, high)]
    fill(axis, [(x[0], low), *face, (x[0], high)], STEEL, "none", alpha=0.7)
    z = FREEBOARD - (TOP - ice) * math.tan(SLOPE)
    fill(axis, [(ice, z), (TOP, FREEBOARD), (ice, FREEBOARD)], RED, "none", alpha=0.5)
    axis.plot([ice, TOP], [z, FREEBOARD], color=RED, lw=2.5)
    for radius, name, colour, at in ((TOP, "leading", RED, FREEBOARD), (BOTTOM, "trailing", "black", FREEBOARD - H)):
        axis.plot([radius] * 2, [at, 0.42], ":", color=colour, lw=1)
        axis.text(radius + (0.02 if name == "leading" else -0.02), 0.42, name, color=colour, va="bottom",
                  ha="left" if name == "leading" else "right")
    axis.text(RADIUS + 0.38, FREEBOARD - H / 2, "ice", color=EDGE, ha="center", va="center")
    axis.text(RADIUS - 0.7, -0.2, "structure", ha="center")
    axis.set_xlim(*x)
    axis.set_ylim(-0.62, 0.55)


def plan(axis):
    panel(axis, "in plan")
    edge = RADIUS - 0.45                                     # the edge, so that a cap of the trailing disc lies in ice
    angle = np.linspace(0, 2 * np.pi, 256, endpoint=False)
    disc = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    sheet = brash.IceSheet([[edge, -4], [RADIUS + 1.5, -4], [RADIUS + 1.5, 4], [edge, 4]])
    crushed = sheet.cut(BOTTOM * disc)
    for part in sheet.polygons():
        fill(axis, part.outline, ICE)
    for piece in crushed.pieces:
        fill(axis, piece.outline, "white", "black", hatch="xxx", lw=0.8)
    for contact in sheet.contacts(TOP * disc):
        fill(axis, contact.overlap.outline, RED, RED, alpha=0.7)
    for radius, style in ((TOP, {"color": RED}), (BOTTOM, {"color": "black"})):
        axis.plot(*(radius * disc).T, ":", lw=1, **style)
    axis.text(RADIUS + 1.4, 2.7, "intact", color=EDGE, ha="right")
    axis.text(RADIUS + 0.2, 0, "contact", color=RED, ha="left", va="center")
    axis.text(edge - 0.1, 0, "crushed", ha="right", va="center")
    axis.set_xlim(edge - 1.3, RADIUS + 1.5)
    axis.set_ylim(-3.2, 3.2)


def draw():
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 3.6), constrained_layout=True, gridspec_kw={"width_ratios": (1.6, 1)})
    side(axes[0])
    plan(axes[1])
    return figure
