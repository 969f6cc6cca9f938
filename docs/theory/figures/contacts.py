# SPDX-License-Identifier: GPL-3.0-or-later
"""contacts-and-bodies.md: the contact as an overlap, the crushing bound in an impact, the friction disc."""
import math

import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, SERIES, STEEL, arrow, below, fill, panel

SLOPE, H, PUSH = math.radians(61.4), 0.33, 0.11          # the validation case's cone and ice [rad, m, m]


def overlap(axis):
    panel(axis, "overlap, seen from the side")
    normal = np.array([math.sin(SLOPE), -math.cos(SLOPE)])  # from the structure into the floe
    floe = [(0, 0), (0.75, 0), (0.75, H), (0, H)]
    face = np.array([PUSH, H]) @ normal
    structure = below([(-0.42, -0.12), (0.6, -0.12), (0.6, 0.5), (-0.42, 0.5)], normal, face)
    fill(axis, floe, ICE)
    fill(axis, structure, STEEL, "none", alpha=0.7)
    patch = below(floe, normal, face)
    fill(axis, patch, RED, RED, alpha=0.55)
    low, high = np.array([0.0, H - PUSH * math.tan(SLOPE)]), np.array([PUSH, H])
    axis.plot(*zip(low, high), color=RED, lw=3)
    middle = (low + high) / 2
    arrow(axis, middle, middle + 0.27 * normal, RED, "$n$", (0.03, -0.02))
    axis.annotate("", (0, H + 0.035), (PUSH, H + 0.035), arrowprops={"arrowstyle": "<->", "color": GREY})
    axis.text(PUSH / 2, H + 0.055, "$d$", ha="center", va="bottom", color=GREY)
    axis.text(0.55, 0.22, "floe", color=EDGE, ha="center")
    axis.text(-0.25, 0.33, "structure", ha="center")
    axis.text(0.17, -0.09, r"$S = w\,d/\cos a$", color=RED, ha="left")
    axis.set_xlim(-0.44, 0.78)
    axis.set_ylim(-0.14, 0.52)


def impact(n_steps, quarter=0.047, speed=1.0, stiffness=2 * H * 0.5e6):
    """Times and forces of a corner with S = 2 d h against a wall: each step bears the bound of its start.

    It ends with the step in which less than the bound stops the floe.
    """
    mass = stiffness * (2 * quarter / math.pi) ** 2
    dt, depth, force = quarter / n_steps, 0.0, []
    while mass * speed > dt * stiffness * depth:
        force.append(stiffness * depth)
        speed -= dt * force[-1] / mass
        depth += dt * speed
    return dt * np.arange(len(force)), np.array(force), mass, stiffness


def crushing(axis):
    axis.set_title("impact at the crushing bound", loc="left")
    _, _, mass, stiffness = impact(6)
    time = np.linspace(0, 0.047, 100)
    axis.plot(1e3 * time, math.sqrt(stiffness * mass) * np.sin(math.sqrt(stiffness / mass) * time) / 1e3, color=GREY,
              lw=3, alpha=0.5, label="spring $2 h \\sigma_c R$, exact")
    for n_steps, size, colour in ((6, 8, SERIES[1]), (12, 3.5, SERIES[0])):
        time, force, *_ = impact(n_steps)
        axis.plot(1e3 * time, force / 1e3, "o", ms=size, mfc="none" if n_steps == 6 else colour, color=colour,
                  label=f"{n_steps} steps in the quarter period")
    axis.set(xlabel="time [ms]", ylabel="force [kN]", ylim=(0, None))
    axis.legend(loc="lower right")


def friction(axis):
    panel(axis, "friction in one point")
    angle = np.linspace(0, 2 * np.pi, 100)
    axis.plot([-1, 1, 1, -1, -1], [-1, -1, 1, 1, -1], "--", color=GREY, lw=1)
    axis.fill(np.cos(angle), np.sin(angle), color=ICE)
    axis.plot(np.cos(angle), np.sin(angle), color=EDGE)
    start, slip = np.array([0.55, 0.2]), np.array([-0.75, -0.85])
    trial = start - slip
    found = trial / np.linalg.norm(trial)
    axis.plot(*start, "o", color="black", ms=4)
    axis.text(start[0] - 0.06, start[1], "$P_t$", ha="right", va="center")
    arrow(axis, start, trial, SERIES[1], "$P_t - s/g$", (0.08, 0.14))
    arrow(axis, trial, found, RED)
    axis.plot(*found, "o", color=RED, ms=5)
    axis.text(-0.05, -0.5, "$|P_t| \\leq \\mu P_n$", color=EDGE, ha="center")
    axis.text(0, -1.16, "dashed: Eq. 6, each direction by itself", color=GREY, ha="center", va="top")
    axis.set_xlim(-1.15, 1.75)
    axis.set_ylim(-1.4, 1.4)


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(10, 3.2), constrained_layout=True,
                                gridspec_kw={"width_ratios": (1.2, 1.2, 1)})
    overlap(axes[0])
    crushing(axes[1])
    friction(axes[2])
    return figure
