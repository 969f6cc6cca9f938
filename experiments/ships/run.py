#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The speed that a thrust gives the icebreaker, and her speed over the size of floes.

run.py attained                   attained.toml: the speed at which a constant thrust no longer accelerates her
run.py floe_sizes                 floe_sizes.toml: the speed that a constant thrust gives her, and the test of its head
run.py NAME --record              also writes NAME.csv, NAME_means.csv and NAME.png here
run.py NAME --from FOLDER         of a campaign that has run

Options of both: --brash PROGRAM, -o FOLDER of the campaign [results/NAME], --jobs N.
"""
import json
import sys
from pathlib import Path

import numpy as np
from scipy import stats

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study


def interval_cells(name, values, unit, digits):
    """Mean of a column [unit], and its 95 % interval if there are three values or more, as cells `name`, `low`, `high`."""
    values = [value / unit for value in values]
    mean, half = study.mean_interval(values) if len(values) > 2 else (np.mean(values), None)
    ends = {"low": mean - half, "high": mean + half} if half is not None else {"low": "", "high": ""}
    return {name: f"{mean:.{digits}f}", **{f"{name}_{end}": value if value == "" else f"{value:.{digits}f}" for end, value in ends.items()}}


def means_text(means):
    """Rows of means as aligned columns for the terminal."""
    columns = [[name, *(row[name] for row in means)] for name in means[0]]
    widths = [max(map(len, column)) for column in columns]
    return "\n".join("  ".join(cell.rjust(width) for cell, width in zip(cells, widths)) for cells in zip(*columns))


# The speed that a thrust gives her.

THRUST = 400e3  # N: free.toml
WAY = 46.0, 66.0  # m, where the mean speed and the acceleration are taken


def ride(folder):
    """Mean speed [m/s] and mean acceleration [m/s2] of a run while the ship goes over WAY."""
    with open(folder / "history.csv", encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        columns = [names.index(name) for name in ("time", "structure_x", "structure_vx")]
        time, place, speed = np.loadtxt(file, delimiter=",", usecols=columns).T
    there = (place - place[0] >= WAY[0]) & (place - place[0] <= WAY[1])
    return float(speed[there].mean()), float(np.polyfit(time[there], speed[there], 1)[0])


def steady_speed(speeds, accelerations):
    """Where a line through the accelerations is zero, and the speeds at which they may be zero, at 95 % (Fieller 1954)."""
    speeds, accelerations = np.asarray(speeds), np.asarray(accelerations)
    slope, offset = np.polyfit(speeds, accelerations, 1)
    spread = np.sum((speeds - speeds.mean()) ** 2)
    residual = np.sum((accelerations - slope * speeds - offset) ** 2) / (len(speeds) - 2)
    at = np.linspace(0.0, 2.0 * speeds.max(), 20001)
    error = np.sqrt(residual * (1 / len(speeds) + (at - speeds.mean()) ** 2 / spread))
    inside = at[np.abs(slope * at + offset) <= stats.t.ppf(0.975, len(speeds) - 2) * error]
    return -offset / slope, inside.min(), inside.max()


def attained_means(rows):
    """A row a speed at the start, and the steady speed in words."""
    means = []
    for start in sorted({row["setting"] for row in rows}):
        of = [row for row in rows if row["setting"] == start]
        means.append({"start_m_s": start.removeprefix("from-"), "runs": str(len(of)),
                      "mean_speed_m_s": f"{np.mean([row['mean_speed'] for row in of]):.2f}",
                      **interval_cells("acceleration_mm_s2", [row["acceleration"] for row in of], 1e-3, 0),
                      **interval_cells("load_kN", [row["horizontal.mean"] for row in of], 1e3, 0)})
    speed, lower, upper = steady_speed([row["mean_speed"] for row in rows], [row["acceleration"] for row in rows])
    return means, [f"Steady speed at a thrust of {THRUST / 1e3:.0f} kN: {speed:.2f} m/s ({lower:.2f} to {upper:.2f})."]


def attained_figure(rows, folder):
    figure, axis = figures.plt.subplots(figsize=(5.2, 3.6), constrained_layout=True)
    speeds = np.array([row["mean_speed"] for row in rows])
    accelerations = 1e3 * np.array([row["acceleration"] for row in rows])
    line = np.polyfit(speeds, accelerations, 1)
    x = np.linspace(speeds.min(), speeds.max(), 2)
    axis.axhline(0.0, color=figures.GREY, lw=0.8)
    axis.plot(x, np.polyval(line, x), color=figures.RED, lw=1.2, label="straight line")
    axis.plot(speeds, accelerations, "o", color=figures.BLUE, ms=5, label="runs")
    axis.set(xlabel="mean speed [m/s]", ylabel="mean acceleration [mm/s²]")
    axis.legend(fontsize=7)
    figures.save(figure, folder, "attained")


def attained(_options, output, rows):
    for row in rows:
        row["mean_speed"], row["acceleration"] = ride(output / "cases" / row["case"])
    return attained_means(rows), attained_figure


# The size of floes.

def mean_speed(folder):
    """Mean of the speed ahead over the statistics of a run [m/s]."""
    start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
    with open(folder / "history.csv", encoding="utf-8") as file:
        names = file.readline().strip().split(",")
        time, speed = np.loadtxt(file, delimiter=",", usecols=[names.index("time"), names.index("structure_vx")]).T
    return float(speed[time >= start].mean())


def sizes_of(rows):
    """{size: rows}, in rising order."""
    sizes = sorted({float(row["setting"].removesuffix("m")) for row in rows})
    return {size: [row for row in rows if row["setting"] == f"{size:g}m"] for size in sizes}


def floe_sizes_means(rows):
    """A row a size, and the test of the trend in words."""
    by_size, means = sizes_of(rows), []
    for size, of in by_size.items():
        means.append({"floes_m": f"{size:g}", "fields": str(len(of)),
                      **interval_cells("mean_speed_m_s", [row["mean_speed"] for row in of], 1.0, 2),
                      **interval_cells("load_kN", [row["horizontal.mean"] for row in of], 1e3, 0),
                      "breaks": f"{np.mean([row['n_breaks'] for row in of]):.1f}",
                      "floes_that_broke": f"{np.mean([row['n_floes_broken'] for row in of]):.1f}"})
    test = study.brash_module().jonckheere_terpstra([[row["mean_speed"] for row in of] for of in by_size.values()])
    falls = 0.5 * test.p_value if test.statistic < 0 else 1.0 - 0.5 * test.p_value
    return means, [f"Jonckheere and Terpstra, one-sided, that the speed falls with the size: z = {test.statistic:.2f}, p = {falls:.2g}."]


def floe_sizes_figure(rows, folder):
    figure, axis = figures.plt.subplots(figsize=(5.2, 3.6), constrained_layout=True)
    by_size = {size: [row["mean_speed"] for row in of] for size, of in sizes_of(rows).items()}
    figures.means(axis, by_size, "size", figures.BLUE, "mean, 95 % interval", unit=1.0)
    axis.set(xlabel="size of the floes [m]", ylabel="mean speed at a thrust of 1 MN [m/s]")
    axis.legend(fontsize=7)
    figures.save(figure, folder, "floe_sizes")


def floe_sizes(_options, output, rows):
    for row in rows:
        row["mean_speed"] = mean_speed(output / "cases" / row["case"])
    return floe_sizes_means(rows), floe_sizes_figure


STUDIES = {"attained": attained, "floe_sizes": floe_sizes}


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in STUDIES:
        sys.exit(__doc__ if "-h" in sys.argv or "--help" in sys.argv else f"run.py: name one of {', '.join(STUDIES)}")
    name = sys.argv.pop(1)
    parser = study.arguments(__doc__)
    parser.add_argument("--replicates", type=int, help="of each setting [the plan's]")
    parser.add_argument("--from", dest="done", type=Path, help="take a campaign as it is, and run nothing")
    options = parser.parse_args()
    output = options.done or options.output or Path("results") / name
    if not options.done:
        study.campaign(options.brash, HERE / f"{name}.toml", output, options.quick, options.jobs, (), options.replicates,
                       may_fail=name == "floe_sizes")  # not every field of large floes can be 70 % full
    rows = study.read_rows(output / "campaign.csv")
    (means, remarks), draw = STUDIES[name](options, output, rows)
    print("\n".join([means_text(means), *remarks]))
    folder = HERE if options.record else output
    if options.record:
        study.write_rows(HERE / f"{name}.csv", rows)
        study.write_rows(HERE / f"{name}_means.csv", means)
    draw(rows, folder)
    print(f"picture in {folder}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
