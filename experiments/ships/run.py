#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The icebreaker over speed and thickness, the speed that a thrust gives her, and her speed over the size of floes.

run.py speeds [--replicates N]    speeds.toml: mean resistance beside Lindqvist, Riska, Jeong and the friction of open water
run.py attained                   attained.toml: the speed at which a constant thrust no longer accelerates her
run.py floe_sizes                 floe_sizes.toml: the speed that a constant thrust gives her, and the test of its head
run.py NAME --record              also writes NAME.csv, NAME_means.csv and NAME.png here
run.py NAME --from FOLDER         of a campaign that has run, or of the cases that it has finished so far

Options of all: --brash PROGRAM, -o FOLDER of the campaign [results/NAME], --jobs N.
"""
import json
import math
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path

import numpy as np
from scipy import stats

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study

SPEED, THICKNESS = "structure.speed", "ice.thickness"
VISCOSITY = 1.83e-6  # m2/s, sea water at 0 C (ITTC 7.5-02-01-03)
BOW_LENGTH = 34.6  # m, of the icebreaker's waterline for Riska's formula: icebreaker.toml


# Resistance over speed and thickness.

def open_water_friction(ship, speed, water_density):
    """Friction of the hull in open water [N]: the line of ITTC 1957 over Mumford's wetted surface, 1.7 L T + V / T."""
    length, draught = ship["length"], ship["draught"]
    volume = 0.6 * length * ship["breadth"] * draught  # a block coefficient of 0.6, assumed
    coefficient = 0.075 / (math.log10(speed * length / VISCOSITY) - 2.0) ** 2
    return 0.5 * water_density * speed**2 * coefficient * (1.7 * length * draught + volume / draught)


def formulas(brash, path):
    """Resistance of one setting by regressions and closed forms [N]."""
    case = tomllib.loads(path.read_text(encoding="utf-8"))
    done = subprocess.run([str(brash), "loads", str(path), "--json", f"--set=hull.bow_length={BOW_LENGTH}"], check=True,
                          capture_output=True)
    found = {load["formula"].lower(): load["horizontal"] for load in json.loads(done.stdout)["loads"]}
    return {**{name: found[name] for name in ("lindqvist", "riska", "jeong")},
            "open_water": open_water_friction(case["hull"], case["structure"]["speed"], case["water"]["density"])}


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


def exponents(rows, keys):
    """Powers of the mean resistance over inputs, by least squares in logarithms, and half their 95 % intervals."""
    terms = np.array([[1.0] + [math.log(row[key]) for key in keys] for row in rows])
    loads = np.log([row["horizontal.mean"] for row in rows])
    powers = np.linalg.lstsq(terms, loads, rcond=None)[0]
    free = len(rows) - terms.shape[1]
    variance = np.sum((loads - terms @ powers) ** 2) / free * np.linalg.inv(terms.T @ terms).diagonal()
    return list(zip(powers[1:], stats.t.ppf(0.975, free) * np.sqrt(variance[1:])))


def exponent_lines(rows, fewest=3, slowest=0.5):
    """Exponents of speed and thickness from `slowest` m/s on: over all settings, and each by itself where `fewest` runs are."""
    fast = [row for row in rows if row[SPEED] >= slowest]
    inputs, lines = (SPEED, THICKNESS), []
    if all(len({row[key] for row in fast}) > 1 for key in inputs) and len(fast) > 3:
        (speed, speed_half), (thickness, thickness_half) = exponents(fast, inputs)
        lines.append(f"Exponents over all settings: {speed:.2f} ± {speed_half:.2f} of the speed, {thickness:.2f} ± "
                     f"{thickness_half:.2f} of the thickness ({len(fast)} runs).")
    count = Counter((row[THICKNESS], row[SPEED]) for row in rows)
    many = [row for row in fast if count[row[THICKNESS], row[SPEED]] >= fewest]
    for key, other, unit in ((SPEED, THICKNESS, "m"), (THICKNESS, SPEED, "m/s")):
        for value in sorted({row[other] for row in many}):
            of = [row for row in many if row[other] == value]
            if len({row[key] for row in of}) > 1:
                [(slope, half)] = exponents(of, [key])
                lines.append(f"Exponent of the {key.split('.')[1]} at {value:g} {unit}: {slope:.2f} ± {half:.2f} ({len(of)} runs).")
    return lines


def speeds_means(rows):
    """A row a setting, and the exponents in words."""
    means = []
    for thickness, speed in sorted({(row[THICKNESS], row[SPEED]) for row in rows}):
        of = [row for row in rows if (row[THICKNESS], row[SPEED]) == (thickness, speed)]
        mean = {key: np.mean([row[key] for row in of]) for key in of[0] if isinstance(of[0][key], float)}
        bow = 100 * mean["mean_by_region.bow.total.Fx"] / mean["horizontal.mean"]
        crushing = 100 * mean["horizontal.mean_by_cause.crushing"] / mean["horizontal.mean"]
        means.append({"thickness_m": f"{thickness:g}", "speed_m_s": f"{speed:g}", "runs": str(len(of)),
                      **interval_cells("resistance_kN", [row["horizontal.mean"] for row in of], 1e3, 0),
                      "bow_percent": f"{bow:.0f}", "crushing_percent": f"{crushing:.0f}",
                      **{f"{name}_kN": f"{mean[name] / 1e3:.0f}" for name in ("lindqvist", "riska", "jeong")}})
    return means, exponent_lines(rows)


def speeds_figure(rows, curves, folder):
    thicknesses = sorted({row[THICKNESS] for row in rows})
    figure, axes = figures.plt.subplots(1, len(thicknesses), figsize=(11, 3.8), constrained_layout=True, squeeze=False)
    styles = {"lindqvist": ("Lindqvist 1989", figures.RED, "--"), "riska": ("Riska 1997", figures.GREEN, "-."),
              "jeong": ("Jeong 2010", figures.ORANGE, ":"), "open_water": ("open water, friction", figures.GREY, "-")}
    for axis, thickness in zip(axes[0], thicknesses):
        of = [row for row in rows if row[THICKNESS] == thickness]
        for name, (label, colour, style) in styles.items():
            x, y = zip(*sorted((speed, values[name] / 1e3) for (h, speed), values in curves.items() if h == thickness))
            axis.plot(x, y, style, color=colour, lw=1.2, label=label)
        for row in of:
            axis.plot(row[SPEED], row["horizontal.mean"] / 1e3, ".", color=figures.BLUE, alpha=0.4, ms=6, mew=0)
        values = study.groups(of, SPEED, "horizontal.mean")
        centres = [study.mean_interval(v) if len(v) > 2 else (np.mean(v), 0.0) for v in values.values()]
        axis.errorbar(list(values), [c / 1e3 for c, _ in centres], [half / 1e3 for _, half in centres], color=figures.BLUE,
                      marker="o", ms=4, lw=1.2, capsize=3, label="brash, mean; dots: runs")
        axis.set(title=f"ice of {thickness:g} m", xlabel="speed [m/s]", ylim=(0, None))
    axes[0, 0].set_ylabel("resistance [kN]")
    axes[0, 0].legend(fontsize=7)
    figures.save(figure, folder, "speeds")


def speeds(options, output, rows):
    curves = {}
    for path in sorted((output / "settings").glob("icebreaker_*.toml")):
        case = tomllib.loads(path.read_text(encoding="utf-8"))
        curves[case["ice"]["thickness"], case["structure"]["speed"]] = formulas(options.brash, path)
    for row in rows:
        row.update(curves[row[THICKNESS], row[SPEED]])
    return speeds_means(rows), lambda rows, folder: speeds_figure(rows, curves, folder)


# The speed that a thrust gives her.

THRUST, DAMPING = 400e3, 2e4  # N, N s/m: free.toml
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


def towed_speed(rows, thickness=0.8):
    """Where the towed ship's mean resistance and the damping add up to the thrust [m/s], of rows of speeds.csv."""
    of = study.groups([row for row in rows if row[THICKNESS] == thickness], SPEED, "horizontal.mean")
    speeds = np.array(sorted(of))
    need = np.array([np.mean(of[speed]) for speed in speeds]) + DAMPING * speeds
    # The resistance falls from creeping speeds to its least; the steady speed lies above that.
    rising = int(np.argmin(need))
    return float(np.interp(THRUST, need[rising:], speeds[rising:]))


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
    return means, [f"Steady speed at a thrust of {THRUST / 1e3:.0f} kN: {speed:.2f} m/s ({lower:.2f} to {upper:.2f}). The towed ship "
                   f"needs that thrust at {towed_speed(study.read_rows(HERE / 'speeds.csv')):.2f} m/s."]


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


# Of a whole campaign, or of one that still runs.

def number_in(summary, column):
    """The number that a column of campaign.csv names; docs/reference/plan.md."""
    *path, last = column.split(".")
    for name in path:
        summary = summary.get(name, {})
    if isinstance(summary, list):
        return summary[[f"{100 * level:02.0f}" for level in (0.05, 0.25, 0.5, 0.75, 0.95)].index(last)]
    return summary.get(last, 0.0)  # a region that bore no load is not there


def finished_rows(output, name):
    """A row for each finished case, as campaign.csv has them."""
    plan = tomllib.loads((HERE / f"{name}.toml").read_text(encoding="utf-8"))
    base = Path(plan["campaign"]["case"]).stem
    rows = []
    for folder in sorted(folder for folder in (output / "cases").iterdir() if (folder / "summary.json").exists()):
        setting, _, replicate = folder.name.rpartition("-r")
        case = tomllib.loads((output / "settings" / f"{base}_{setting}.toml").read_text(encoding="utf-8"))
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        rows.append({"case": folder.name, "setting": setting, "replicate": float(replicate), "status": "done",
                     **study.program_of(folder), SPEED: case["structure"]["speed"], THICKNESS: case["ice"]["thickness"],
                     **{column: float(number_in(summary, column)) for column in plan["output"]["columns"]}})
    return rows


def rows_of(output, name):
    whole = output / "campaign.csv"
    return study.read_rows(whole) if whole.exists() else finished_rows(output, name)


STUDIES = {"speeds": speeds, "attained": attained, "floe_sizes": floe_sizes}


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
    rows = rows_of(output, name)
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
