# SPDX-License-Identifier: GPL-3.0-or-later
"""contacts-and-bodies.md and fracture-of-floes.md: their measurements."""
import matplotlib.pyplot as plt
import numpy as np

from style import GREY, RED, SERIES
from tables import table


def solver():
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 3.0), constrained_layout=True)
    head, *rows = table("jam")
    for name, *cells, colour in zip(head[1:], *[row[1:] for row in rows], SERIES):
        points = [(float(row[0]), float(cell)) for row, cell in zip(rows, cells) if cell]
        axes[0].semilogx(*zip(*points), "o-", ms=4, color=colour, label=name)
    axes[0].set(xlabel="iterations", ylim=(40, 52))
    axes[0].set_title("mean resistance of a jam [kN]", loc="left")
    head, *rows = table("residual")
    sweeps, *columns = zip(*[[float(cell) for cell in row] for row in rows])
    for values, colour, style, name in zip(columns, (SERIES[0], SERIES[0], SERIES[1], SERIES[1]), ("o-", "o:", "o-", "o:"),
                                           head[1:]):
        axes[1].loglog(sweeps, values, style, ms=4, color=colour, label=name)
    axes[1].set_xlabel("sweeps")
    axes[1].set_title("residual of a row in a run [m/s]", loc="left")
    for axis in axes:
        axis.set_xticks(sweeps, [f"{n:g}" for n in sweeps])
        axis.minorticks_off()
        axis.legend()
    return figure


def crushed():
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 2.8), constrained_layout=True,
                                gridspec_kw={"width_ratios": (1, 1.2)})
    slender = np.linspace(0, 8, 50)
    axes[0].plot(slender, 0.5 * (1 + 0.3 * slender / 2), color=SERIES[0])
    axes[0].set(xlabel="length over width $L/W$", ylim=(0, 1.15))
    axes[0].set_title(r"largest possible stress over $\sigma_c$", loc="left")
    head, *rows = table("crushed")
    stress = {row[0].removeprefix("mean stress: "): row[2:] for row in rows if row[0].startswith("mean stress")}
    bars = [(f"validation, {name}", float(cells[1])) for name, cells in stress.items()]
    bars += [(f"{name}, largest", float(cell)) for name, cell in zip(head[4:], stress["largest"][2:])]
    for i, (_, value) in enumerate(reversed(bars)):
        axes[1].barh(i, value, color=SERIES[0], alpha=0.8, height=0.6)
    axes[1].set_yticks(range(len(bars)), [name for name, _ in reversed(bars)])
    axes[1].set_xlim(0, 1.08)
    axes[1].set_title(r"measured mean stress over $\sigma_c$ = 1 MPa", loc="left")
    axes[0].axhline(1, color=RED, ls="--", lw=1)
    axes[0].text(0.1, 1.03, "the floe is crushed", color=RED)
    axes[1].axvline(1, color=RED, ls="--", lw=1)
    axes[0].axhline(0.5, color=GREY, ls=":", lw=1)
    axes[0].text(7.9, 0.42, "without friction", color=GREY, ha="right")
    return figure
