#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Loads of 1, 10, 50 and 100 years of a campaign, and how they move: levels.py CAMPAIGN [--record]

The levels of `brash design` for the table of hours, for twice its hours, without the state that decides most, and with
either half of the replicates. --record writes recorded.csv and levels.png beside this script.
"""
import argparse
import csv
import json
import pathlib
import subprocess
import tempfile

import matplotlib.pyplot as plt

HERE = pathlib.Path(__file__).resolve().parent
YEARS = [1, 10, 50, 100]


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def write_rows(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def design(campaign, states, folder):
    table = folder / "states.csv"
    write_rows(table, states)
    done = subprocess.run(["brash", "design", campaign, "--scatter", table, "--years", ",".join(map(str, YEARS)), "--json"],
                          check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


def half_of(campaign, parity, folder):
    """The campaign with the even replicates alone (parity 0), or the odd ones (1), in its table."""
    folder.mkdir()
    for entry in campaign.resolve().iterdir():
        if entry.name != "campaign.csv":
            (folder / entry.name).symlink_to(entry)
    rows = [row for row in rows_of(campaign / "campaign.csv") if int(row["replicate"]) % 2 == parity]
    write_rows(folder / "campaign.csv", rows)
    return folder


def without(states, setting):
    """The table without the state of a setting, whose values name it."""
    return [row for row in states if any(float(row[key]) != value for key, value in setting["values"].items())]


def variants(campaign):
    """(name, design) of each variant."""
    states = rows_of(HERE / "states.csv")
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        whole = design(campaign, states, folder)
        yield "as it is", whole
        yield "twice the hours", design(campaign, [{**row, "hours": 2 * float(row["hours"])} for row in states], folder)
        shares = whole["annual"][YEARS.index(50)]["shares"]
        most = max(shares, key=shares.get)
        [setting] = [s for s in whole["settings"] if s["setting"] == most]
        yield f"without {most}", design(campaign, without(states, setting), folder)
        for parity, name in enumerate(["even replicates", "odd replicates"]):
            yield name, design(half_of(campaign, parity, folder / name), states, folder)


def upper(level):
    """The upper end of an interval; JSON has none where there is none."""
    return float("inf") if level["level_95"][1] is None else level["level_95"][1]


def draw(found, picture):
    crushing = found[0][1]["full_crushing"]["horizontal"] / 1e6
    top = 1.3 * crushing
    figure, axis = plt.subplots(figsize=(7, 4), layout="constrained")
    for i, (name, of) in enumerate(found):
        levels = of["annual"]
        years = [level["years"] * 1.06 ** (i - 2) for level in levels]
        value = [level["level"] / 1e6 for level in levels]
        ends = [[v - level["level_95"][0] / 1e6 for v, level in zip(value, levels)],
                [max(min(upper(level) / 1e6, 2 * top) - v, 0) for v, level in zip(value, levels)]]
        axis.errorbar(years, value, ends, fmt="o", capsize=3, label=name)
    axis.axhline(crushing, color="#c00", linewidth=1, label="the ice over the full width crushes")
    axis.set(xscale="log", xlabel="return period [years]", ylabel="load, 95 % interval [MN]",
             ylim=(0, min(axis.get_ylim()[1], top)), xticks=YEARS, xticklabels=YEARS)
    axis.legend(loc="upper center", bbox_to_anchor=(0.5, -0.15), ncols=3, fontsize="small")
    figure.savefig(picture, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("campaign", type=pathlib.Path)
    parser.add_argument("--record", action="store_true", help="write recorded.csv and levels.png here")
    options = parser.parse_args()
    found = list(variants(options.campaign))
    rows = [{"variant": name, "years": f"{level['years']:g}", "level": f"{level['level']:.0f}", "lower": f"{level['level_95'][0]:.0f}",
             "upper": f"{upper(level):.0f}", "histories": f"{level['records']:.3g}", "peaks": of["tail"]["peaks"],
             "shape": f"{of['tail']['shape']:.3f}", "above_crushing": level["above_crushing"]}
            for name, of in found for level in of["annual"]]
    for row in rows:
        print("  ".join(str(value) for value in row.values()))
    if options.record:
        write_rows(HERE / "recorded.csv", rows)
        draw(found, HERE / "levels.png")


if __name__ == "__main__":
    main()
