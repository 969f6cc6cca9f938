# SPDX-License-Identifier: GPL-3.0-or-later
"""ice.md: thickness that varies with a rough edge, floes in their cells, and the caliper diameter of a floe."""
import pathlib

import brash
import matplotlib.pyplot as plt
import numpy as np

from style import EDGE, GREY, ICE, RED, SERIES, WATER, centroid, fill, panel

FIELD = pathlib.Path(__file__).resolve().parents[3] / "experiments/fields/cone.toml"
H, VARIATION, LENGTH = 0.33, 0.1, 4.0          # mean [m], coefficient of variation, correlation length [m]


def gaussian(x, y, length, seed):
    """(R1): 256 waves."""
    draw = np.random.default_rng(seed)
    waves, phases = draw.normal(scale=np.sqrt(2) / length, size=(256, 2)), draw.uniform(0, 2 * np.pi, 256)
    return np.sqrt(2 / 256) * sum(np.cos(k[0] * x + k[1] * y + phase) for k, phase in zip(waves, phases))


def thickness(figure, axis):
    panel(axis, "thickness [m] and a rough edge")
    x, y = np.meshgrid(np.linspace(-2.5, 24, 213), np.linspace(-12, 12, 193))
    deviation = np.sqrt(np.log1p(VARIATION**2))
    h = H * np.exp(deviation * gaussian(x, y, LENGTH, 2) - deviation**2 / 2)
    along = np.arange(-12, 12.01, 2.0 / 8)      # eight chords in a correlation length of 2 m
    edge = 0.6 * gaussian(0 * along, along, 2.0, 3)
    h[x < np.interp(y, along, edge)] = np.nan
    shown = axis.pcolormesh(x, y, h, cmap="Blues", shading="auto", rasterized=True)
    axis.plot(edge, along, color=EDGE, lw=1.2)
    axis.plot([18, 18 + LENGTH], [-11, -11], color="black", lw=2)
    axis.text(18 + LENGTH / 2, -10.3, r"$\ell$", ha="center", va="bottom")
    figure.colorbar(shown, ax=axis, shrink=0.75)


def floes(axis):
    """The program's floes. Each cell is its floe grown about the centroid, by (F5) read backwards."""
    panel(axis, "floes in their cells")
    case = brash.Case.from_file(FIELD, {"field.length": 60.0, "field.width": 60.0})
    share = case["field.concentration"]
    fill(axis, [(0, -30), (60, -30), (60, 30), (0, 30)], WATER, "none", alpha=0.6)
    for floe in brash.Simulation(case).frame().floes:
        ring = np.asarray(floe.rings[0])[:, :2]
        middle = centroid(ring)
        axis.fill(*(middle + (ring - middle) / np.sqrt(share)).T, facecolor="none", edgecolor=GREY, lw=0.6, ls=":")
        fill(axis, ring, ICE, lw=0.8)
        axis.plot(*middle, ".", color=RED, ms=2)
    axis.set_xlim(-0.5, 60.5)
    axis.set_ylim(-30.5, 30.5)


def caliper(axis):
    panel(axis, "caliper diameter of a floe (D1)")
    ring = np.array([(0.0, 0.0), (5.2, -1.2), (7.4, 1.4), (6.0, 4.6), (2.2, 5.4), (-0.8, 3.0)])
    middle = centroid(ring)
    fill(axis, ring, ICE)
    perimeter = np.linalg.norm(ring - np.roll(ring, -1, axis=0), axis=1).sum()
    angle = np.linspace(0, 2 * np.pi, 100)
    diameter = perimeter / np.pi
    axis.plot(*(middle[:, None] + diameter / 2 * np.array([np.cos(angle), np.sin(angle)])), color=RED, ls="--", lw=1)
    axis.text(*middle, f"$d$ = {diameter:.1f} m\n$\\sqrt{{A}}$ = {area(ring) ** 0.5:.1f} m", color=RED, ha="center",
              va="center")
    for turn, colour in ((0.35, SERIES[0]), (1.75, SERIES[1])):
        normal, tangent = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
        low, high = (ring @ normal).min(), (ring @ normal).max()
        place = middle @ tangent
        for offset in (low, high):
            ends = [offset * normal + (place + shift) * tangent for shift in (-4.6, 4.6)]
            axis.plot(*zip(*ends), color=colour, lw=0.8)
        shift = place - 4.3
        axis.annotate("", low * normal + shift * tangent, high * normal + shift * tangent,
                      arrowprops={"arrowstyle": "<->", "color": colour, "shrinkA": 0, "shrinkB": 0})
        axis.text(*((low + high) / 2 * normal + (shift - 0.7) * tangent), r"$w(\theta)$", color=colour, ha="center",
                  va="center")
    axis.autoscale_view()


def area(ring):
    x, y = ring.T
    return 0.5 * (x * np.roll(y, -1) - np.roll(x, -1) * y).sum()


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), constrained_layout=True, gridspec_kw={"width_ratios": (1.25, 1, 1)})
    thickness(figure, axes[0])
    floes(axes[1])
    caliper(axes[2])
    return figure
