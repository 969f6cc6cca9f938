#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots the predictions of the models against the solutions of the plate solver.

usage: plot.py DATABASE.nc NETWORK.json DEEP-NETWORK.json SUPERPOSITION.json BRASH OUTPUT.png
The picture has all rows of the database. The network's model card lists its test rows apart. The superposition passes
through all geometries of its own database. So give another DATABASE.nc to show it for a design that it has not seen. A
second picture, OUTPUT-range.png, shows the errors over the range.
"""
import csv
import io
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import netCDF4
import numpy as np


def rows_of(database):
    data = netCDF4.Dataset(database)
    solved = np.array(data["solved"]) == 1
    mu1 = np.array(data["mu1"])[solved]
    column = lambda name: np.repeat(np.array(data[name])[solved][:, None], mu1.shape[1], axis=1)
    inputs = [column("depth"), column("contact_length"), np.degrees(column("angle")), mu1,
              np.array(data["mu2"])[solved], 1.0 / column("thickness")]
    outputs = [np.array(data[name])[solved] for name in ("sigma_over_p", "lbreak_over_lc")]
    plateau = [np.array(data[name])[solved].ravel() for name in ("plateau_from", "plateau_to")]
    return np.stack([a.ravel() for a in inputs], 1), np.stack([a.ravel() for a in outputs], 1), plateau


def on_plateau(places, plateau):
    """Where the stress is at least 99 % of its peak."""
    return (places >= plateau[0]) & (places <= plateau[1])


def predict(brash, model, inputs):
    text = "b_lc,c_lc,theta_deg,mu1,mu2,lc_over_h\n" + "".join(",".join(map(repr, map(float, row))) + "\n" for row in inputs)
    answer = subprocess.run([brash, "failure", "predict", "--model", model], input=text, text=True, check=True,
                            stdout=subprocess.PIPE).stdout
    return np.array([[float(r["sigma_over_p"]), float(r["lbreak_over_lc"])] for r in csv.DictReader(io.StringIO(answer))])


def draw_range(errors, inputs, output):
    """Size of the stress error against each input, one row a model."""
    names = (r"$b/l_c$", r"$c/l_c$", r"$\theta$ [deg]", r"$\mu_1$", r"$h/l_c$")
    values = [inputs[:, 0], inputs[:, 1], inputs[:, 2], inputs[:, 3], 1.0 / inputs[:, 5]]
    figure, axes = plt.subplots(len(errors), len(names), figsize=(11, 6.6), sharey=True, constrained_layout=True)
    for row, (model, error) in zip(axes, errors.items()):
        for axis, name, value in zip(row, names, values):
            axis.scatter(value, 100 * np.maximum(error, 1e-5), s=2, linewidths=0, rasterized=True)
            axis.set(yscale="log", xlabel=name, xscale="log" if name in (names[1], names[3]) else "linear")
            axis.axhline(5, color="0.6", linewidth=0.8, linestyle=":")
        row[0].set_ylabel(f"{model}\nstress error [%]")
    figure.savefig(output, dpi=90)


def main():
    database, network, deep, superposition, brash, output = sys.argv[1:]
    inputs, computed, plateau = rows_of(database)
    errors = {}
    figure, axes = plt.subplots(2, 3, figsize=(11.6, 7.6), constrained_layout=True)
    for column, (name, model) in enumerate((("network (Eq. 17)", network), ("deep network", deep), ("superposition", superposition))):
        predicted = predict(brash, model, inputs)
        error = np.abs(predicted / computed - 1.0)[:, 0]
        length = np.abs(predicted - computed)[:, 1]
        for what, part in (("all rows", computed[:, 0] > 0), ("sigma/p >= 0.25", computed[:, 0] >= 0.25)):
            print(f"{name}, {what}: {part.sum()}; stress error " +
                  ", ".join(f"{100 * q:g} % {100 * np.quantile(error[part], q):.2f} %" for q in (0.5, 0.95, 0.99)) +
                  "; length error [l_c] " +
                  ", ".join(f"{100 * q:g} % {np.quantile(length[part], q):.4f}" for q in (0.5, 0.95, 0.99)) +
                  f"; on the plateau {100 * np.mean(on_plateau(predicted[:, 1], plateau)[part]):.1f} %")
        for row, (label, limits) in enumerate(((r"$\sigma/p$", (2e-3, 300)), (r"$l_{break}/l_c$", (0, 2.1)))):
            axis = axes[row][column]
            shade = axis.scatter(computed[:, row], predicted[:, row], s=4, c=inputs[:, 0], cmap="viridis", linewidths=0,
                                 rasterized=True)
            axis.plot(limits, limits, color="0.3", linewidth=0.8)
            axis.set(xlim=limits, ylim=limits, xlabel=f"{label} computed", ylabel=f"{label} predicted")
            axis.set_aspect("equal")
            if row == 0:
                axis.set(xscale="log", yscale="log", title=name)
                axis.axvline(0.25, color="0.6", linewidth=0.8, linestyle=":")
        errors[name] = error
    figure.colorbar(shade, ax=axes, label=r"$b/l_c$", shrink=0.6)
    figure.savefig(output, dpi=90)
    draw_range(errors, inputs, output.replace(".png", "-range.png"))


if __name__ == "__main__":
    main()
