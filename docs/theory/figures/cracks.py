# SPDX-License-Identifier: GPL-3.0-or-later
"""Five breaks of two runs with the stress on the surface that fails. The data are the output of the program crack_study."""
import json
import pathlib

import matplotlib.pyplot as plt
import numpy as np

from style import GREEN, SERIES

DATA = pathlib.Path(__file__).with_name("crack-patterns.json")
CRACK = SERIES[0]
OUTSIDE_ICE = -1000


def stress_map(axis, data, window):
    """The stress over the strength, and white where it equals the strength."""
    per_cent = np.array(data["stress"], float).T
    stress = np.where(per_cent == OUTSIDE_ICE, np.nan, per_cent / 100)
    along = window["cell"] * np.arange(stress.shape[1]) - window["aside"]
    ahead = window["cell"] * np.arange(stress.shape[0]) + window["back"]
    half = window["cell"] / 2
    axis.contour(along, ahead, stress, levels=[1], colors="white", linewidths=0.8)
    return axis.imshow(stress, origin="lower", cmap="YlOrRd", vmin=0, vmax=2, interpolation="nearest",
                       extent=(along[0] - half, along[-1] + half, ahead[0] - half, ahead[-1] + half))


def one_break(axis, data, window):
    """The edge runs to the right, and the ice is above it."""
    image = stress_map(axis, data, window)
    if data["split"]:
        axis.plot((0, 0), (0, window["ahead"]), color="black", lw=0.8, ls=":", label="radial crack")
    axis.plot(*np.array(data["outline"]).T[::-1], color="black", lw=1.2, label="free edge")
    angle, radius = np.linspace(0, 2 * np.pi, 200), data["breaking_length"]
    axis.plot(radius * np.sin(angle), radius * np.cos(angle), color="black", lw=1.0, ls="--", label="disc")
    axis.plot(*np.array(data["crack"]).T[::-1], color=CRACK, lw=1.8, label="crack along the stress")
    axis.plot(0, radius, "o", color=CRACK, ms=4)
    for load in data["loads"]:
        axis.plot(*np.array(load["ends"]).T[::-1], color=GREEN, lw=4, solid_capstyle="butt", label="load")
    axis.set(aspect="equal", xlim=(-window["aside"], window["aside"]), ylim=(window["back"], window["ahead"]),
             title=f"{data['time']:.1f} s")
    return image


def draw():
    content = json.loads(DATA.read_text())
    figure, axes = plt.subplots(2, 3, figsize=(10, 4.8), sharex=True, sharey=True)
    figure.subplots_adjust(left=0.06, right=0.98, bottom=0.1, top=0.95, wspace=0.08, hspace=0.25)
    for axis, data in zip(axes.flat, content["breaks"]):
        image = one_break(axis, data, content["window"])
    for axis in (*axes[1, :2], axes[0, 2]):
        axis.set_xlabel("along the edge [m]")
        axis.tick_params(labelbottom=True)
    for axis in axes[:, 0]:
        axis.set_ylabel("into the ice [m]")
    key = axes[1, 2]
    key.axis("off")
    by_name = {text: line for axis in axes.flat for line, text in zip(*axis.get_legend_handles_labels())}
    key.legend(by_name.values(), by_name.keys(), loc="upper center", ncols=2, fontsize="small", handlelength=1.4)
    figure.colorbar(image, cax=key.inset_axes((0.1, 0.28, 0.8, 0.08)), orientation="horizontal", extend="both",
                    label="larger principal stress over the strength")
    return figure
