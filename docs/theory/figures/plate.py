# SPDX-License-Identifier: GPL-3.0-or-later
"""notation.md: the trapezoid with its loads, and the answers of the failure model to its shape."""
import math

import brash
import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, SERIES, arrow, fill, panel


def trapezoid(axis):
    panel(axis, "the edge in plan: x into the ice")
    b, c, half = 1.0, 0.8, math.radians(35)
    wide = c / 2 + b * math.tan(half)
    fill(axis, [(-3, b), (-wide, b), (-c / 2, 0), (c / 2, 0), (wide, b), (3, b), (3, 3.1), (-3, 3.1)], ICE, "none")
    axis.plot([-3, -wide, -c / 2, c / 2, wide, 3], [b, b, 0, 0, b, b], color=EDGE, lw=1.8)
    angle = np.linspace(math.pi * 0.16, math.pi * 0.84, 60)
    axis.plot(2.2 * np.cos(angle), 2.2 * np.sin(angle), color=RED, ls="--")
    axis.plot([0, 0], [0, 2.2], color=RED, lw=0.8)
    axis.text(0.08, 1.6, r"$l_{break}$", color=RED)
    axis.text(0.2, 2.4, "circumferential crack", color=RED, ha="left")
    for y in (-0.28, 0, 0.28):
        arrow(axis, (y, -0.85), (y, -0.04), "black")
    axis.text(-0.5, -0.6, "$N$, and $P = \\mu_1 N$\nout of the plane", ha="right", va="center")
    arrow(axis, (0.45, -0.2), (1.2, -0.2), "black", "$f = \\mu_2 N$", (0.65, 0.0))
    axis.plot(0, 0, "o", color="black", ms=4)
    axis.text(-0.12, 0.12, "$B$", ha="right")
    axis.annotate("", (-2.2, 0), (-2.2, b), arrowprops={"arrowstyle": "<->", "color": GREY})
    axis.text(-2.3, b / 2, "$b$", color=GREY, ha="right", va="center")
    axis.annotate("", (-c / 2, -1.0), (c / 2, -1.0), arrowprops={"arrowstyle": "<->", "color": GREY})
    axis.text(0, -1.35, "$c$", color=GREY, ha="center")
    top = np.array([0.0, -c / 2 / math.tan(half)])
    axis.plot([-c / 2, 0, c / 2], [0, top[1], 0], color=GREY, lw=0.8, ls=":")
    span = np.linspace(math.pi / 2 - half, math.pi / 2 + half, 20)
    arc = top[:, None] + 1.25 * np.array([np.cos(span), np.sin(span)])
    axis.plot(*arc, color=GREY, lw=0.8)
    axis.text(0.3, 0.78, r"$\theta$", color=GREY, ha="center")
    axis.set_xlim(-3, 3)
    axis.set_ylim(-1.5, 3.1)


def answers(axes):
    b = np.linspace(0, 1, 60)
    model = brash.FailureModel("superposition")
    for c, colour in zip((0.1, 0.2, 0.4), SERIES):
        answer = model(b, c, math.radians(60), mu1=0.5, mu2=0.0, thickness_over_lc=0.1)
        axes[0].plot(b, answer.sigma_over_p, color=colour, label=f"$c/l_c$ = {c}")
        axes[1].plot(b, answer.lbreak_over_lc, color=colour)
    axes[0].set_title(r"largest stress $\sigma_{max}/p$", loc="left")
    axes[1].set_title(r"breaking length $l_{break}/l_c$", loc="left")
    axes[0].legend()
    for axis in axes:
        axis.set_xlabel("$b/l_c$")
        axis.set_ylim(bottom=0)


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), constrained_layout=True,
                                gridspec_kw={"width_ratios": (1.5, 1, 1)})
    trapezoid(axes[0])
    answers(axes[1:])
    return figure
