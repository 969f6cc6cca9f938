#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How the load on the strip's wall grows with the ice that has come: growth.py DIR [--picture FILE]

DIR has the results of depths.toml, or of one run. A row for each run and each window of ice that has come since the first contact [m]:
  load [N/m]  mean Fx over the width of the wall
  bed         share that the bed carries: the mean of bed_Fx over that of Fx + bed_Fx
  sail [m]    height over the water of the highest corner of a floe, the median of the window's frames
The first 0.1 m (2 s) are in no window: a whole edge meets a whole wall at once there, which exists in no tank.

With --test a row for each depth instead: growth of the load from the second to the last window in percent of the second, its
95 % interval over the seeds, and p of Student's paired test, two-sided, also adjusted for the depths by Holm's method.

The picture shows the last frame of each depth's first run from the side.
"""
import argparse
import csv
import math
import sys
import tomllib
from pathlib import Path

import netCDF4
import numpy as np

WINDOWS = [(0.1, 0.5), (0.5, 1.0), (1.0, 2.0), (2.0, 3.0)]  # m of ice


class Frames:
    """The floes of a run in each frame."""

    def __init__(self, run):
        self.run, self.times = run, np.asarray(run["frame_time"][:])
        self.nodes = np.concatenate([[0], np.cumsum(run["floe_outline_node_count"][:])])
        self.poses = np.concatenate([[0], np.cumsum(run["frame_pose_count"][:])])
        self.row = {int(name): i for i, name in enumerate(run["floe_id"][:])}

    def floes(self, frame):
        """Of each floe the corners of both faces: x and z, over the water [m]."""
        poses = slice(self.poses[frame], self.poses[frame + 1])
        for floe, x, z, w, i, j, k in zip(*(self.run[f"pose_{name}"][poses] for name in ("floe", "x", "z", "qw", "qx", "qy", "qz"))):
            n = self.row[int(floe)]
            u, v = (np.asarray(self.run[f"floe_outline_{name}"][self.nodes[n]:self.nodes[n + 1]]) for name in "xy")
            half = self.run["floe_thickness"][n] / 2
            along = (1 - 2 * (j * j + k * k)) * u + 2 * (i * j - w * k) * v
            up = 2 * (i * k - w * j) * u + 2 * (j * k + w * i) * v
            yield np.concatenate([np.stack([x + along + side * half * 2 * (i * k + w * j),
                                            z + up + side * half * (1 - 2 * (i * i + j * j))], axis=1) for side in (-1, 1)])

    def sail(self, frame):
        return max((floe[:, 1].max() for floe in self.floes(frame)), default=0.0)


def rows(folder):
    with netCDF4.Dataset(folder / "run.nc") as run:
        width = tomllib.loads(run.case)["structure"]["waterline_width"]
        force, time, x = (np.asarray(run[name][:]) for name in ("Fx", "time", "structure_x"))
        bed = np.asarray(run["bed_Fx"][:]) if "bed_Fx" in run.variables else np.zeros_like(force)
        come = x - x[np.flatnonzero(force)[0]]
        frames = Frames(run)
        shown = np.interp(frames.times, time, come)
        for first, last in WINDOWS:
            if come[-1] < last - 0.05:
                break
            inside = (come >= first) & (come < last)
            load, on_bed = force[inside].mean(), bed[inside].mean()
            sail = np.median([frames.sail(n) for n in np.flatnonzero((shown >= first) & (shown < last))])
            yield {"run": folder.name, "from": first, "to": last, "load": round(load / width, 1),
                   "bed": round(on_bed / (load + on_bed), 3), "sail": round(sail, 3)}


def growth(found):
    """A row for each depth, from the rows of all runs."""
    from scipy import stats

    tests = []
    for depth in dict.fromkeys(row["run"].rsplit("-r", 1)[0] for row in found):
        first, last = (np.array([row["load"] for row in found if row["run"].rsplit("-r", 1)[0] == depth and row["from"] == window[0]])
                       for window in (WINDOWS[1], WINDOWS[-1]))
        test = stats.ttest_rel(last, first)
        tests.append([depth, first.mean(), last.mean(), *(100 * v / first.mean() for v in (
            (last - first).mean(), *test.confidence_interval())), test.pvalue])
    p = np.array([test[-1] for test in tests])
    order = np.argsort(p)
    holm = np.minimum(np.maximum.accumulate(p[order] * np.arange(len(p), 0, -1)), 1.0)[np.argsort(order)]
    return [[depth, *(f"{v:.1f}" for v in numbers), f"{q:.3g}", f"{h:.3g}"] for (depth, *numbers, q), h in zip(tests, holm)]


def picture(folders, file):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from matplotlib.patches import Polygon
    from scipy.spatial import ConvexHull

    figure, panels = plt.subplots(len(folders), 1, figsize=(7, 1.6 * len(folders)), sharex=True, layout="constrained")
    for panel, folder in zip(panels, folders):
        with netCDF4.Dataset(folder / "run.nc") as run:
            case, frames = tomllib.loads(run.case), Frames(run)
            last = len(frames.times) - 1
            wall = float(run["frame_structure_x"][last]) + case["structure"]["length"] / 2  # at the waterline
            for floe in frames.floes(last):
                panel.add_patch(Polygon(floe[ConvexHull(floe).vertices] - [wall, 0], fc="0.85", ec="0.3", lw=0.5))
            edge = np.min(run["final_sheet_x"][:]) - wall
            depth, afloat = case["water"]["depth"], case["ice"]["density"] / case["water"]["density"]
            top = (1 - afloat) * case["ice"]["thickness"]
        panel.add_patch(Polygon([(edge, top), (4, top), (4, top - case["ice"]["thickness"]), (edge, top - case["ice"]["thickness"])],
                                fc="0.95", ec="0.3", lw=0.5))
        panel.axline((0, 0), slope=-math.tan(case["structure"]["angle"]), color="k", lw=1.5)
        panel.axhline(0, color="tab:blue", lw=0.5, zorder=0)
        if depth < 1:
            panel.axhspan(-depth - 0.1, -depth, color="0.6", zorder=0)
        panel.set(xlim=(-0.3, 2.7), ylim=(-0.72, 0.55), aspect="equal", ylabel="z [m]",
                  title="deep water" if depth >= 1 else f"{depth:g} m of water")
    panels[-1].set_xlabel("x from the wall [m]")
    figure.savefig(file, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", type=Path)
    parser.add_argument("--test", action="store_true")
    parser.add_argument("--picture", type=Path, metavar="FILE")
    options = parser.parse_args()
    folders = sorted(folder for folder in options.results.glob("cases/*") if (folder / "manifest.json").exists()) or [options.results]
    found = [row for folder in folders for row in rows(folder)]
    if options.test:
        table = csv.writer(sys.stdout, lineterminator="\n")
        table.writerow(["depth", "load_first", "load_last", "growth", "lower", "upper", "p", "p_holm"])
        table.writerows(growth(found))
    else:
        table = csv.DictWriter(sys.stdout, ["run", "from", "to", "load", "bed", "sail"], lineterminator="\n")
        table.writeheader()
        table.writerows(found)
    if options.picture:
        picture([folder for folder in folders if folder.name.endswith("-r0000")], options.picture)


if __name__ == "__main__":
    main()
