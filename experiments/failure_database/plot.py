#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plots what the models predict against what the plate solver computed.

usage: plot.py DATABASE.nc NETWORK.json SUPERPOSITION.json BRASH OUTPUT.png
The rows are those of the database; the network's test rows are not told apart here, its model card does that. The
superposition passes through all geometries of the database, so it is shown for a design that it has not seen when
DATABASE.nc is another one than it was made from.
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
    return np.stack([a.ravel() for a in inputs], 1), np.stack([a.ravel() for a in outputs], 1)


def predict(brash, model, inputs):
    text = "b_lc,c_lc,theta_deg,mu1,mu2,lc_over_h\n" + "".join(",".join(map(repr, map(float, row))) + "\n" for row in inputs)
    answer = subprocess.run([brash, "failure", "predict", "--model", model], input=text, text=True, check=True,
                            stdout=subprocess.PIPE).stdout
    return np.array([[float(r["sigma_over_p"]), float(r["lbreak_over_lc"])] for r in csv.DictReader(io.StringIO(answer))])


def main():
    database, network, superposition, brash, output = sys.argv[1:]
    inputs, computed = rows_of(database)
    figure, axes = plt.subplots(2, 2, figsize=(8.4, 7.6), constrained_layout=True)
    for column, (name, model) in enumerate((("network (Eq. 17)", network), ("superposition", superposition))):
        predicted = predict(brash, model, inputs)
        matters = computed[:, 0] >= 0.25
        error = np.abs(predicted / computed - 1.0)[matters, 0]
        length = np.abs(predicted - computed)[matters, 1]
        print(f"{name}: rows {matters.sum()}, sigma/p >= 0.25: stress error median {100 * np.median(error):.2f} %, "
              f"95 % {100 * np.quantile(error, 0.95):.2f} %; length error median {np.median(length):.4f}, "
              f"95 % {np.quantile(length, 0.95):.4f} l_c")
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
    figure.colorbar(shade, ax=axes, label=r"$b/l_c$", shrink=0.6)
    figure.savefig(output, dpi=90)


if __name__ == "__main__":
    main()
