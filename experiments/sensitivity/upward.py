#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The upward-breaking cone: its loads beside the closed forms, and the ice that rides on it beside Ralston's layer.

upward.py [--brash PROGRAM] [-o FOLDER] [--seeds N] [--set section.key=value]... [--record [NAME]]

Runs the validation case breaking upward with the seeds 1 to N. Prints one row a seed and the means; --record writes the
rows to NAME here [upward.csv]. All forces are means over the steady part [kN].
"""
import argparse
import csv
import json
import math
import subprocess
import tomllib
from pathlib import Path

import netCDF4
import numpy as np

HERE = Path(__file__).resolve().parent
CASE = HERE.parent / "validation" / "second_reading.toml"
GRAVITY = 9.80665
COLUMNS = ["seed", "horizontal", "crushing", "floes", "quantile_99", "maximum", "vertical", "ride_weight",
           "ride_load"]


def simulate(brash, folder, seed, settings):
    command = [brash, "run", CASE, "-o", folder, "--replace", "--seed", str(seed)]
    for setting in ["structure.breaking=upward", "output.frames_per_second=4", *settings]:
        command += ["--set", setting]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def ride(run, case, start):
    """Weight of the ice that rides on the front half of the cone [N], and the load that it makes on the slope [N].

    A floe rides if its centre is above half its thickness, within 1 m of the waterline. On a slope a under the azimuth t
    a weight W that slides up presses with W tan(a + atan mu) cos t on the cone.
    """
    slope = math.tan(case["structure"]["angle"] + math.atan(case["ice"]["friction_structure"]))
    radius = 0.5 * case["structure"]["waterline_width"] + 1.0
    weight_of = dict(zip(run["floe_id"][:], run["floe_area"][:] * run["floe_thickness"][:]
                         * case["ice"]["density"] * GRAVITY))
    first = np.concatenate([[0], np.cumsum(run["frame_pose_count"][:])])
    weights, loads = [], []
    for frame, time in enumerate(run["frame_time"][:]):
        if time < start:
            continue
        poses = slice(first[frame], first[frame + 1])
        x, y, z = (run[f"pose_{name}"][poses] for name in "xyz")
        x = x - run["frame_structure_x"][frame]
        weight = np.array([weight_of[floe] for floe in run["pose_floe"][poses]])
        distance = np.hypot(x, y)
        rides = (z > 0.5 * case["ice"]["thickness"]) & (distance < radius) & (x > 0.0)
        weights.append(weight[rides].sum())
        loads.append(slope * (weight * x / distance)[rides].sum())
    return np.mean(weights), np.mean(loads)


def row_of(folder, seed):
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    case = tomllib.loads(manifest["case"]["toml"])
    horizontal, causes = summary["horizontal"], summary["horizontal"]["mean_by_cause"]
    with netCDF4.Dataset(folder / "run.nc") as run:
        weight, load = ride(run, case, summary["statistics_from"])
    values = [horizontal["mean"], causes["crushing"], causes["floe_normal"] + causes["floe_friction"],
              horizontal["quantile_99"], horizontal["maximum"], summary["vertical"]["mean"], weight, load]
    return [seed] + [round(value / 1e3, 1) for value in values]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--brash", default="brash")
    parser.add_argument("-o", "--output", type=Path, default=Path("results/upward"))
    parser.add_argument("--seeds", type=int, default=20)
    parser.add_argument("--set", action="append", default=[], metavar="section.key=value")
    parser.add_argument("--record", nargs="?", const="upward.csv", metavar="NAME")
    options = parser.parse_args()
    rows = []
    print(*COLUMNS)
    for seed in range(1, options.seeds + 1):
        folder = options.output / f"{seed:02}"
        simulate(options.brash, folder, seed, options.set)
        rows.append(row_of(folder, seed))
        print(*rows[-1], flush=True)
    print("mean", *np.mean(np.array(rows)[:, 1:], axis=0).round(1))
    if options.record:
        with open(HERE / options.record, "w", newline="", encoding="utf-8") as file:
            csv.writer(file, lineterminator="\n").writerows([COLUMNS, *rows])
    subprocess.run([options.brash, "loads", CASE, "--set", "structure.breaking=upward"], check=True)


if __name__ == "__main__":
    main()
