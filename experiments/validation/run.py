#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The validation case as an ensemble, beside the measurement, other models and closed forms (the paper's Fig. 7).

run.py                  plan.toml: 30 replicates; table and picture in results/validation
run.py --plan edge.toml -o results/edge        the preset brash, and the same with an edge at rest; 30 replicates each
run.py --plan laws.toml -o results/laws        each law of the ice on its own switch, 10 replicates; so water, pieces
run.py --plan steps.toml -o results/steps      four time steps, 30 replicates each
run.py --plan readings.toml -o results/readings  the paper read literally (decision 39), and with each row changed back
run.py --plan edge_steps.toml -o ...           three more with the preset brash and with an edge at rest
run.py --set hydrodynamics.form_drag=0 -o ...  the same with another input
run.py --record         also rewrites the recorded numbers here, and the picture of the plan's first setting
run.py --quick          one short replicate, compared with quick.csv
"""
import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study

# Mean horizontal force [kN]: the paper, Sec. 3.1.3.
REFERENCES = {"measured": 111.8, "cohesive elements": 110.0, "the paper's model": 112.93}
SMOOTHING = 0.1  # s
PICTURES = ["ensemble", "edge"]  # that are recorded
QUANTITIES = {
    "mean": "horizontal.mean", "  crushing at the edge": "horizontal.mean_by_cause.crushing",
    "  floes, normal": "horizontal.mean_by_cause.floe_normal",
    "  floes, friction": "horizontal.mean_by_cause.floe_friction", "vertical mean": "vertical.mean",
    "deviation": "horizontal.standard_deviation", "  above 2 Hz": "high_frequency_deviation",
    "99 %": "horizontal.quantile_99", "99 % of 0.1 s means": "smooth_quantile_99",
    "largest 0.1 s mean": "smooth_maximum", "mean, whole history": "mean_whole_history.horizontal"}
OTHERS = {"breaks a second [Hz]": "breaking_frequency", "mean frequency [Hz]": "mean_frequency"}


def smooth_peaks(history, start):
    """99 % quantile and maximum of the running mean over SMOOTHING."""
    rows = [row for row in study.read_rows(history) if row["time"] > start]
    n = max(1, round(SMOOTHING / (rows[1]["time"] - rows[0]["time"])))
    smooth = np.convolve([row["Fx"] for row in rows], np.ones(n) / n, mode="valid")
    return {"smooth_quantile_99": float(np.quantile(smooth, 0.99)), "smooth_maximum": float(smooth.max())}


def energies(summary):
    """Work of the structure [J], and where it went: the sheet's edge, contacts, friction, water."""
    energy = summary["energy"]
    losses = energy["losses"]
    of_contacts = [value for name, value in losses.items() if name.endswith("_contact")]
    of_friction = [losses[name] for name in ("structure_friction", "sheet_friction", "floe_friction")]
    return {"energy.work": energy["work"], "energy.losses.edge": losses["edge"], "energy.losses.contacts": sum(of_contacts),
            "energy.losses.friction": sum(of_friction), "energy.losses.water": losses["drag"] + losses["skin_friction"]}


def print_results(rows, closed):
    for setting in dict.fromkeys(row["setting"] for row in rows):
        chosen = [row for row in rows if row["setting"] == setting]
        print(f"{setting}: {len(chosen)} replicates; horizontal force [kN]\n{'':24s}    mean  95 % interval    deviation")
        for name, column in {**QUANTITIES, **OTHERS}.items():
            values = np.array([row[column] for row in chosen]) / (1e3 if name in QUANTITIES else 1.0)
            mean, half = study.mean_interval(values)
            print(f"  {name:22s}{mean:8.2f}  [{mean - half:.2f}, {mean + half:.2f}]{values.std(ddof=1):10.2f}")
    print("for comparison, means:", ", ".join(f"{name} {value}" for name, value in REFERENCES.items()))
    print("peaks:", ", ".join(f"{label} {closed[0][f'{name}.horizontal'] / 1e3:.0f}"
                              for name, (label, _, _) in figures.CLOSED.items()))


def spectra(brash, rows, output):
    """Mean density of the replicates with Student's interval at each frequency."""
    densities = []
    for row in rows:
        folder = output / "cases" / row["case"]
        start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
        frequency, density, _ = study.spectrum(brash, folder / "history.csv", start)
        densities.append(density)
    centre, half = zip(*(study.mean_interval(line) for line in np.array(densities).T))
    return frequency, np.array(centre), np.array(half)


def draw(rows, closed, spectrum, folder, stem):
    figure, axes = figures.plt.subplots(1, 4, figsize=(13, 3.6), constrained_layout=True)
    means = np.array([row["horizontal.mean"] for row in rows]) / 1e3
    centre, half = study.mean_interval(means)
    axes[0].plot(range(1, len(means) + 1), means, ".", color=figures.BLUE, label="replicates")
    axes[0].axhspan(centre - half, centre + half, color=figures.BLUE, alpha=0.2)
    axes[0].axhline(centre, color=figures.BLUE, lw=1, label=f"mean {centre:.1f} ± {half:.1f}")
    for (name, value), style in zip(REFERENCES.items(), ("-", "--", ":")):
        axes[0].axhline(value, color=figures.RED, ls=style, lw=1, label=f"{name}, {value:g}")
    axes[0].set(title="mean horizontal force [kN]", xlabel="replicate")
    axes[0].set_ylim(0, 1.05 * axes[0].get_ylim()[1])  # the highest points whole
    axes[0].legend(fontsize=7, loc="lower left")
    for i, name in enumerate(list(QUANTITIES)[:4]):
        mean, error = study.mean_interval(np.array([row[QUANTITIES[name]] for row in rows]) / 1e3)
        axes[1].bar(i, mean, yerr=error, color=figures.BLUE if i == 0 else figures.GREY, capsize=3)
    axes[1].set_xticks(range(4), ["total", "crushing", "floes,\nnormal", "floes,\nfriction"], fontsize=8)
    axes[1].set_title("mean by cause [kN]")
    names = ["99 %", "99 % of 0.1 s means", "largest 0.1 s mean"]
    for i, name in enumerate(names):
        mean, error = study.mean_interval(np.array([row[QUANTITIES[name]] for row in rows]) / 1e3)
        axes[2].bar(i, mean, yerr=error, color=figures.BLUE, capsize=3)
    for name, (label, colour, style) in figures.CLOSED.items():
        axes[2].axhline(closed[0][f"{name}.horizontal"] / 1e3, color=colour, ls=style, lw=1.2, label=label)
    axes[2].set_xticks(range(3), ["99 %", "99 % of\n0.1 s means", "largest\n0.1 s mean"], fontsize=8)
    axes[2].set_title("peaks [kN]")
    axes[2].legend(fontsize=7, loc="lower left", frameon=True, framealpha=0.9)
    frequency, density, error = spectrum
    axes[3].fill_between(frequency[1:], np.maximum(density - error, 1.0)[1:], (density + error)[1:], alpha=0.3,
                         color=figures.BLUE, lw=0)
    axes[3].loglog(frequency[1:], density[1:], color=figures.BLUE, lw=1)
    axes[3].set(title="spectrum [N²/Hz]", xlabel="frequency [Hz]")
    figures.save(figure, folder, stem)


def main():
    parser = study.arguments(__doc__)
    parser.add_argument("--plan", default="plan.toml")
    parser.add_argument("--set", action="append", default=[], dest="overrides")
    options = parser.parse_args()
    output = options.output or Path("results") / (HERE.name + ("-quick" if options.quick else "-ensemble"))
    if options.quick and options.record:
        study.record_quick(options.brash, HERE, output)
        return 0
    if options.quick:
        return study.quick(options, HERE, output)
    study.campaign(options.brash, HERE / options.plan, output, jobs=options.jobs, overrides=options.overrides)
    rows, closed = study.collect(options.brash, output), study.closed_forms(options.brash, output, [])
    for row in rows:
        folder = output / "cases" / row["case"]
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
        row.update({**smooth_peaks(folder / "history.csv", summary["statistics_from"]), **energies(summary)})
    print_results(rows, closed)
    target = HERE if options.record else output
    name = "ensemble" if options.plan == "plan.toml" else Path(options.plan).stem
    if options.record:
        study.write_rows(HERE / ("recorded.csv" if name == "ensemble" else f"{name}.csv"), rows)
    if options.record and name == "ensemble":
        study.write_rows(HERE / "closed_forms.csv", closed)
    if not options.record or name in PICTURES:
        first = [row for row in rows if row["setting"] == rows[0]["setting"]]
        draw(first, closed, spectra(options.brash, first, output), target, name)
    return 0


if __name__ == "__main__":
    sys.exit(main())
