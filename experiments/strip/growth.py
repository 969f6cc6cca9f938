#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How the load on the strip's wall grows with the ice that has come: growth.py DIR, the results of depths.toml.

A row for each run and each window of ice that has come since the first contact [m], as CSV:
  load [N/m]  mean Fx over the width of the wall
  bed         share that the bed carries: the mean of bed_Fx over that of Fx + bed_Fx
  sail [m]    height over the water of the highest corner of a floe, the median of the window's frames
The first 0.1 m (2 s) are in no window: a whole edge meets a whole wall at once there, which exists in no tank.
"""
import csv
import sys
from pathlib import Path

import netCDF4
import numpy as np

WINDOWS = [(0.1, 0.5), (0.5, 1.0), (1.0, 2.0), (2.0, 3.0)]  # m of ice
WIDTH = 0.998  # m


def sails(run):
    """Times of the frames [s], and over the water the highest corner of a floe in each [m]."""
    nodes = np.concatenate([[0], np.cumsum(run["floe_outline_node_count"][:])])
    row = {int(name): i for i, name in enumerate(run["floe_id"][:])}
    poses = zip(*(run[f"pose_{name}"][:] for name in ("floe", "z", "qw", "qx", "qy", "qz")))
    highest = []
    for n in run["frame_pose_count"][:]:
        top = 0.0
        for floe, z, w, x, y, k in (next(poses) for _ in range(n)):
            i = row[int(floe)]
            outline = slice(nodes[i], nodes[i + 1])
            # Third row of the rotation, on the corners of the upper face and of the lower one.
            plane = 2 * (x * k - w * y) * run["floe_outline_x"][outline] + 2 * (y * k + w * x) * run["floe_outline_y"][outline]
            half = abs(1 - 2 * (x * x + y * y)) * run["floe_thickness"][i] / 2
            top = max(top, float(z + np.max(plane) + half))
        highest.append(top)
    return np.asarray(run["frame_time"][:]), np.array(highest)


def rows(folder):
    with netCDF4.Dataset(folder / "run.nc") as run:
        force, time = np.asarray(run["Fx"][:]), np.asarray(run["time"][:])
        bed = np.asarray(run["bed_Fx"][:]) if "bed_Fx" in run.variables else np.zeros_like(force)
        come = np.asarray(run["structure_x"][:])
        come = come - come[np.flatnonzero(force)[0]]
        frames, sail = sails(run)
    for first, last in WINDOWS:
        inside = (come >= first) & (come < last)
        shown = np.interp(frames, time, come)
        load, on_bed = force[inside].mean(), bed[inside].mean()
        yield {"run": folder.name, "from": first, "to": last, "load": round(load / WIDTH, 1),
               "bed": round(on_bed / (load + on_bed), 3), "sail": round(np.median(sail[(shown >= first) & (shown < last)]), 3)}


def main():
    table = csv.DictWriter(sys.stdout, ["run", "from", "to", "load", "bed", "sail"])
    table.writeheader()
    for folder in sorted(Path(sys.argv[1]).glob("cases/*")):
        if (folder / "manifest.json").exists():
            table.writerows(rows(folder))


if __name__ == "__main__":
    main()
