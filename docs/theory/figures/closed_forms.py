# SPDX-License-Identifier: GPL-3.0-or-later
"""standards.md: closed-form peaks of the validation case's cone against ice thickness and cone angle."""
import math
import pathlib

import brash
import matplotlib.pyplot as plt
import numpy as np

from style import SERIES

CASE = pathlib.Path(__file__).resolve().parents[3] / "experiments/validation/cone.toml"
METHODS = (("Croasdale, elastic beam", brash.croasdale_of), ("Ralston, Tresca", brash.ralston_of),
           ("Ralston, Johansen", lambda case: brash.ralston_of(case, "johansen")))


def curves(axis, key, values, shown, label):
    for (name, method), colour in zip(METHODS, SERIES):
        case, points = brash.Case.from_file(CASE), []
        for value in values:
            case[key] = float(value)
            try:
                points.append((shown(value), method(case).horizontal / 1e3))
            except brash.NotApplicable:  # a slope on which the ice locks, or that crushes first
                continue
        axis.plot(*zip(*points), color=colour, label=name)
    axis.set(xlabel=label, ylim=(0, None))


def draw():
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 3.2), constrained_layout=True)
    curves(axes[0], "ice.thickness", np.linspace(0.1, 1.0, 46), lambda h: h, "ice thickness [m]")
    curves(axes[1], "structure.angle", np.radians(np.linspace(45, 75, 61)), math.degrees, "cone angle [deg]")
    axes[0].set_title("horizontal peak [kN], 61.4 degrees", loc="left")
    axes[1].set_title("horizontal peak [kN], 0.33 m", loc="left")
    axes[0].legend()
    return figure
