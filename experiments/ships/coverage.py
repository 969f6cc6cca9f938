#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ice on a hull over its travel: coverage.py NAME=RUN... [--picture FILE]

RUN has the results of a ship. A row for each run and each STEP of travel, as CSV:
  travel               since the bow met the ice, the middle of the window [m]
  bottom, sides, ...   share of the region that broken ice covers [-]: the mean of the window

To the standard error: how fast floes under the flat bottom go with the ship in the last 90 m, the median and 80 %.
"""
import argparse
import csv
import sys
import tomllib
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import netCDF4
import numpy as np

REGIONS = ("bottom", "sides", "shoulders", "bow")
STEP = 5.0  # m
LAST = 90.0  # m


def rows(name, folder):
    with netCDF4.Dataset(Path(folder, "run.nc")) as run:
        x, force = np.asarray(run["structure_x"][:]), np.asarray(run["Fx"][:])
        covered = {region: np.asarray(run[f"covered_{region}"][:]) for region in REGIONS}
    travel = x - x[np.flatnonzero(force)[0]]
    for first in np.arange(0.0, travel[-1] - STEP, STEP):
        inside = (travel >= first) & (travel < first + STEP)
        yield {"run": name, "travel": first + STEP / 2} | {region: round(float(share[inside].mean()), 4) for region, share in covered.items()}


def carpet(folder):
    """Speeds [m/s] of the floes whose middle stays less than 1.5 thicknesses below the keel, amidships, from frame to frame."""
    with netCDF4.Dataset(Path(folder, "run.nc")) as run:
        case, times, ship = tomllib.loads(run.case), run["frame_time"][:], run["frame_structure_x"][:]
        draught, across, along = case["hull"]["draught"], 0.45 * case["hull"]["breadth"], case["hull"]["midbody"] / 2
        ends = np.concatenate([[0], np.cumsum(run["frame_pose_count"][:])])
        speeds, before = [], {}
        for n in np.flatnonzero(ship > ship[-1] - LAST):
            frame = slice(ends[n], ends[n + 1])
            x, y, z = (np.asarray(run[f"pose_{axis}"][frame]) for axis in "xyz")
            below = (z < -draught) & (z > -draught - 1.5 * case["ice"]["thickness"]) & (abs(y) < across) & (abs(x - ship[n]) < along)
            now = dict(zip(np.asarray(run["pose_floe"][frame])[below], x[below]))
            speeds += [(now[floe] - before[floe]) / (times[n] - times[n - 1]) for floe in now.keys() & before.keys()]
            before = now
    return np.array(speeds)


def picture(found, file):
    names = list(dict.fromkeys(row["run"] for row in found))
    figure, axes = plt.subplots(1, len(names), figsize=(9, 3), sharey=True, squeeze=False, constrained_layout=True)
    for axis, name in zip(axes[0], names):
        own = [row for row in found if row["run"] == name]
        for region, style in zip(REGIONS, ("-", "--", "-.", ":")):
            axis.plot([row["travel"] for row in own], [100 * row[region] for row in own], style, label=region)
        axis.set(title=name, xlabel="travel in ice [m]", ylim=(0, None))
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("covered by broken ice [%]")
    axes[0][-1].legend(frameon=False)
    figure.savefig(file, metadata={"Date": None} if file.suffix == ".svg" else None)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", metavar="NAME=RUN")
    parser.add_argument("--picture", type=Path)
    options = parser.parse_args()
    for name, folder in (run.split("=", 1) for run in options.runs):
        low, median, high = np.quantile(carpet(folder), [0.1, 0.5, 0.9])
        print(f"{name}: floes under the bottom go with the ship at {median:.2f} m/s ({low:.2f} to {high:.2f})", file=sys.stderr)
    found = [row for run in options.runs for row in rows(*run.split("=", 1))]
    table = csv.DictWriter(sys.stdout, found[0])
    table.writeheader()
    table.writerows(found)
    if options.picture:
        picture(found, options.picture)


if __name__ == "__main__":
    main()
