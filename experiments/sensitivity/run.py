#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Sensitivity of the loads: Morris's screening of the open inputs, with the noise of the replicates kept apart.

run.py                  the campaign of plan.toml (written by design.py), table and picture in results/sensitivity
run.py --record         also rewrites recorded.csv, effects.csv and the picture here
run.py --quick          the short variant of the tests: two short cases, compared with quick.csv

An effect is the change of a load over the whole range of an input. The table has three numbers for each input: the
mean of its effects with the 95 % interval of the noise, the mean of their magnitudes (the ranking), and their deviation
beyond the noise. Interactions and curvature make that deviation.
"""
import math
import sys
from pathlib import Path

import numpy as np
from scipy import stats

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import design
import figures
import study

LOADS = {"horizontal.mean": "mean horizontal", "vertical.mean": "mean vertical",
         "horizontal.quantile_99": "99 % horizontal"}

NUMBERS = ["mean_effect", "half_width_95", "mean_magnitude", "noise_limit", "deviation_beyond_noise"]


def level(key, written):
    """Where a value of the table stands in the range of its input, 0 to 1; choices are evenly apart."""
    span = design.INPUTS[key]
    if isinstance(span, list):
        known = list(dict.fromkeys(" ".join(map(str, item)) if isinstance(item, list) else item for item in span))
        return known.index(written) / (len(known) - 1)
    return (written - span[0]) / (span[1] - span[0])


def effects(rows, column):
    """{input: its effects over the whole range} and {input: deviation of one effect that noise alone makes}."""
    points = {}
    for row in rows:
        points.setdefault(row["setting"], []).append(row)
    noise = math.sqrt(np.mean([np.var([r[column] for r in point], ddof=1) for point in points.values()]))
    replicates = np.mean([len(point) for point in points.values()])
    found, errors = {key: [] for key in design.INPUTS}, {}
    names = list(points)
    for first, second in zip(names, names[1:]):
        if first.split("p")[0] != second.split("p")[0]:
            continue  # the next trajectory
        a, b = points[first][0], points[second][0]
        changed = [key for key in design.INPUTS if a[key] != b[key]]
        assert len(changed) == 1, (first, second, changed)
        step = level(changed[0], b[changed[0]]) - level(changed[0], a[changed[0]])
        change = np.mean([r[column] for r in points[second]]) - np.mean([r[column] for r in points[first]])
        found[changed[0]].append(change / step)
        errors[changed[0]] = noise * math.sqrt(2.0 / replicates) / abs(step)
    return found, errors


def ranking(rows):
    table = []
    for column in LOADS:
        found, errors = effects(rows, column)
        for key, values in found.items():
            values, noise = np.array(values), errors[key]
            n = len(values)
            # Of n magnitudes of noise alone, the mean is below this in 95 of 100 cases.
            limit = noise * (math.sqrt(2 / math.pi) + stats.norm.ppf(0.95) * math.sqrt((1 - 2 / math.pi) / n))
            beyond = max(0.0, values.var(ddof=1) - noise**2) if n > 1 else math.nan
            table.append({"load": column, "input": key, "effects": n, "mean_effect": values.mean(),
                          "half_width_95": stats.norm.ppf(0.975) * noise / math.sqrt(n),
                          "mean_magnitude": np.abs(values).mean(), "noise_limit": limit,
                          "deviation_beyond_noise": math.sqrt(beyond)})
    return sorted(table, key=lambda row: (list(LOADS).index(row["load"]), -row["mean_magnitude"]))


def draw(table, folder):
    figure, axes = figures.plt.subplots(1, len(LOADS), figsize=(14, 5), constrained_layout=True)
    for axis, (column, title) in zip(axes, LOADS.items()):
        chosen = [row for row in table if row["load"] == column][::-1]
        names = [row["input"].replace(".", ", ").replace("_", " ") for row in chosen]
        axis.barh(names, [row["mean_magnitude"] / 1e3 for row in chosen], color=figures.GREY, label="mean magnitude")
        axis.errorbar([row["mean_effect"] / 1e3 for row in chosen], names,
                      xerr=[row["half_width_95"] / 1e3 for row in chosen], fmt="o", ms=3, color=figures.BLUE, capsize=2,
                      label="mean effect, 95 %")
        axis.plot([row["noise_limit"] / 1e3 for row in chosen], names, "|", color=figures.RED, ms=9,
                  label="noise alone, 95 %")
        axis.set_title(f"{title} force [kN]")
        axis.tick_params(axis="y", labelsize=8)
    axes[0].legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.05), ncol=3)
    figures.save(figure, folder, "effects")


def main():
    options = study.arguments(__doc__).parse_args()
    output = options.output or Path("results") / (HERE.name + ("-quick" if options.quick else ""))
    if options.quick and options.record:
        study.record_quick(options.brash, HERE, output)
        return 0
    if options.quick:
        return study.quick(options, HERE, output)
    study.campaign(options.brash, HERE / "plan.toml", output, jobs=options.jobs)
    rows = study.read_rows(output / "campaign.csv")
    table = ranking(rows)
    print("over the whole range of each input [kN]: mean effect, 95 %, mean magnitude (noise alone), beyond noise")
    for row in table:
        effect, half, magnitude, limit, beyond = (row[name] / 1e3 for name in NUMBERS)
        print(f"  {row['load']:24s}{row['input']:32s}{effect:8.1f} ±{half:5.1f}{magnitude:8.1f} ({limit:.1f}){beyond:8.1f}")
    target = HERE if options.record else output
    if options.record:
        study.write_rows(HERE / "recorded.csv", rows)
        study.write_rows(HERE / "effects.csv", table)
    draw(table, target)
    return 0


if __name__ == "__main__":
    sys.exit(main())
