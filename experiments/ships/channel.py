#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The channel that a structure leaves, and the pieces that it breaks: channel.py RUN... [--width W]

A row for each run, as CSV:
  width              of the channel over the structure's waterline [-]: median of the stations that its origin has passed
  depth, depth_95    of a cusp, l_break over l_c [-]: median and 95 %
  wide               width of a cusp over its depth [-]: of a segment of a parabola with the broken area, 3/2 A / depth^2
  area, area_95      of a piece over l_c^2 [-], as it was born from the sheet
"""
import argparse
import csv
import sys
import tomllib
from pathlib import Path

import netCDF4
import numpy as np

STEP = 0.25  # m between stations


def width_at(x, corners):
    """Width of the opening around the ship's track where the line at `x` crosses the sheet's outline [m], or nothing."""
    a, b = corners, np.roll(corners, -1, axis=0)
    crossed = (a[:, 0] <= x) != (b[:, 0] <= x)
    a, b = a[crossed], b[crossed]
    y = a[:, 1] + (x - a[:, 0]) / (b[:, 0] - a[:, 0]) * (b[:, 1] - a[:, 1])
    port, starboard = y[y > 0.0], y[y <= 0.0]
    return port.min() - starboard.max() if len(port) and len(starboard) else None


def characteristic_length(ice, water):
    """l_c of level ice [m], paper Eq. 18."""
    stiffness = ice["youngs_modulus"] * ice["thickness"] ** 3 / (12.0 * (1.0 - ice["poisson_ratio"] ** 2))
    return (stiffness / (water["density"] * 9.81)) ** 0.25


def row(folder, waterline):
    with netCDF4.Dataset(folder / "run.nc") as run:
        case = tomllib.loads(run.case)
        length = characteristic_length(case["ice"], case["water"])
        first = int(run["final_sheet_part_node_count"][0])
        sheet = np.column_stack([run["final_sheet_x"][:first], run["final_sheet_y"][:first]])
        edge = float(np.min(run["initial_sheet_x"][:]))
        reached = float(run["structure_x"][-1])
        born = np.asarray(run["floe_parent"][:]) < 0
        areas = np.asarray(run["floe_area"][:])[born] / length**2
    widths = [w for x in np.arange(edge + length, reached, STEP) if (w := width_at(x, sheet)) is not None]
    with open(folder / "events.csv", encoding="utf-8") as stream:
        breaks = [event for event in csv.DictReader(stream) if event["event"] == "break" and int(event["pressing_floe"]) < 0]
    depth = np.array([float(event["l_break"]) for event in breaks])
    broken = np.array([float(event["area_before"]) - float(event["area_after"]) for event in breaks])
    return {"run": folder.name, "h": case["ice"]["thickness"], "l_c": round(length, 3), "breaks": len(breaks),
            "width": round(float(np.median(widths)) / waterline, 3) if widths else "",
            "depth": round(float(np.median(depth)) / length, 3), "depth_95": round(float(np.quantile(depth, 0.95)) / length, 3),
            "wide": round(float(np.median(1.5 * broken / depth**2)), 2),
            "area": round(float(np.median(areas)), 3), "area_95": round(float(np.quantile(areas, 0.95)), 3)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("runs", nargs="+", type=Path)
    parser.add_argument("--width", type=float, default=20.0, help="of the structure's waterline [m]")
    options = parser.parse_args()
    rows = [row(folder, options.width) for folder in options.runs]
    table = csv.DictWriter(sys.stdout, rows[0])
    table.writeheader()
    table.writerows(rows)


if __name__ == "__main__":
    main()
