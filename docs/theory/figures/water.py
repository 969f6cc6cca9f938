# SPDX-License-Identifier: GPL-3.0-or-later
"""water.md: a tilted floe with its drag, the shade of a neighbour, a decay in large steps."""
import math

import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, SERIES, WATER, arrow, below, centroid, fill, panel


def floe(axis):
    panel(axis, "buoyancy and form drag on a floe that moves")
    tilt, velocity = math.radians(14), np.array([1.0, -0.25])
    turn = np.array([[math.cos(tilt), -math.sin(tilt)], [math.sin(tilt), math.cos(tilt)]])
    corners = np.array([(-1.5, -0.28), (1.5, -0.28), (1.5, 0.28), (-1.5, 0.28)]) @ turn.T + (0, -0.12)
    axis.fill([-2.6, 2.9, 2.9, -2.6], [0, 0, -1.35, -1.35], color=WATER, alpha=0.6, lw=0)
    fill(axis, corners, ICE)
    wet = below(corners, (0, 1), 0.0)
    fill(axis, wet, EDGE, "none", alpha=0.25)
    axis.plot([-2.6, 2.9], [0, 0], color=EDGE, lw=1)
    for point, name in ((centroid(corners), "$G$"), (centroid(wet), "$B$")):
        axis.plot(*point, "o", color="black", ms=4)
        axis.text(point[0] + 0.1, point[1] + 0.12, name)
    buoyancy = centroid(wet)
    arrow(axis, buoyancy, buoyancy + (0, 0.95), SERIES[2], r"$\rho_w g V$", (0.42, 0.0))
    # Drag on the elements that lead: along -u, in proportion to n . u.
    for a, b in zip(wet, np.roll(wet, -1, axis=0)):
        side = b - a
        normal = np.array([side[1], -side[0]]) / np.linalg.norm(side)
        leads = normal @ velocity
        if leads <= 1e-9 or abs(a[1]) + abs(b[1]) < 1e-9:
            continue
        for t in np.linspace(0.1, 0.9, max(2, round(4 * np.linalg.norm(side)))):
            at = a + t * side
            arrow(axis, at + 0.8 * leads * velocity, at, RED)
    arrow(axis, (-2.4, 0.55), np.array((-2.4, 0.55)) + 0.8 * velocity, "black", r"$\mathbf{u}$", (0.15, 0.05))
    axis.text(1.15, -1.2, r"red: $-(\mathbf{n}\cdot\mathbf{u})\,\mathbf{u}$ on leading faces", color=RED, ha="center")
    axis.set_xlim(-2.6, 2.9)
    axis.set_ylim(-1.35, 1.1)


def shade(axis):
    axis.set_title("shade of a neighbour (H8)", loc="left")
    gap = np.linspace(0, 2, 200)
    axis.plot(gap, np.clip(1.5 - gap, 0, 1), color=SERIES[0])
    axis.plot(1, 0.5, "o", color=SERIES[0], ms=4)
    axis.set(xlabel="distance of the neighbour / $g$", ylabel="shade $s$", ylim=(-0.03, 1.08))


def decay(axis):
    axis.set_title(r"decay $\dot v = -c|v|v$ in large steps (H9)", loc="left")
    time = np.linspace(0, 6, 200)
    axis.plot(time, 1 / (1 + time), color=GREY, lw=3, alpha=0.5, label="exact")
    for name, colour, step in (("velocity of the end of the step", SERIES[0], lambda v, dt: v / (1 + abs(v) * dt)),
                               ("velocity of its start", SERIES[1], lambda v, dt: v - abs(v) * v * dt)):
        dt, speed = 1.5, [1.0]
        for _ in range(4):
            speed.append(step(speed[-1], dt))
        axis.plot(dt * np.arange(5), speed, "o--", ms=4, lw=0.8, color=colour, label=name)
    axis.axhline(0, color=GREY, lw=0.6)
    axis.set(xlabel="$c\\,v_0\\,t$", ylabel="$v / v_0$")
    axis.legend()


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.0), constrained_layout=True,
                                gridspec_kw={"width_ratios": (1.7, 1, 1.1)})
    floe(axes[0])
    shade(axes[1])
    decay(axes[2])
    return figure
