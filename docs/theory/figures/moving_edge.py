# SPDX-License-Identifier: GPL-3.0-or-later
"""fracture-of-the-edge.md: breaking load and breaking length against the speed."""
import math
import pathlib

import brash
import matplotlib.pyplot as plt
import numpy as np

from style import GREY, RED, SERIES

CASE = pathlib.Path(__file__).resolve().parents[3] / "experiments/validation/cone.toml"
EDGES = (("straight, $c$ = 0.3 $l_c$", {"b_lc": 0.0, "c_lc": 0.3, "theta": 0.0}),
         ("straight, $c$ = 1 $l_c$", {"b_lc": 0.0, "c_lc": 1.0, "theta": 0.0}),
         ("protrusion, $c$ = 0.3 $l_c$", {"b_lc": 0.4, "c_lc": 0.3, "theta": math.radians(60)}),
         ("protrusion, $c$ = 1 $l_c$", {"b_lc": 0.4, "c_lc": 1.0, "theta": math.radians(60)}),
         ("bay, $c$ = 0.3 $l_c$", {"b_lc": -0.4, "c_lc": 0.3, "theta": math.radians(60)}))


def draw():
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.4), constrained_layout=True)
    case = brash.Case.from_file(CASE, {"failure.length_density": "water"})  # as in `brash`, which moves the edge
    l_c = brash.characteristic_length(case)
    speed = np.geomspace(0.02, 5.0, 61)
    of_model, of_plate = brash.MovingEdge(case), brash.MovingEdge(case, "fem")
    for (name, edge), colour in zip(EDGES, (*SERIES, GREY)):
        model = of_plate if edge["b_lc"] < 0 else of_model
        moving, rest = model(speed=speed, **edge), model(speed=0.0, **edge)
        axes[0].semilogx(speed, moving.load / rest.load, color=colour, label=name)
        axes[1].semilogx(speed, moving.deflection / rest.deflection, color=colour)
        axes[2].semilogx(speed, moving.breaking_length / l_c, color=colour)
        axes[2].axhline(float(rest.breaking_length) / l_c, color=colour, ls=":", lw=1)
    axes[2].semilogx(speed, 0.32 * (1 - 0.144 * speed), color=RED, ls="--", label="0.32 (1 - 0.144 V)")
    axes[0].axhline(1, color=GREY, ls=":", lw=1)
    axes[0].set_title("breaking load over the static load", loc="left")
    axes[1].set_title("deflection at break over the static one", loc="left")
    axes[2].set_title("breaking length over $l_c$", loc="left")
    for axis in axes:
        axis.set_xlabel("speed $V$ [m/s]")
        axis.set_ylim(bottom=0)
    axes[0].legend()
    axes[2].legend()
    return figure
