#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The validation case with stock Bullet, beside the program's own contacts and solver and the paper's mean.

run.py                10 replicates with each engine at each time step; a table in kN
run.py --preset brash --replicates 2    the same with the default preset
run.py --table        the table again, from the recorded numbers
run.py --record       also rewrites recorded.csv here, or brash/recorded.csv
run.py --quick        four short cases, compared with quick.csv

Both engines draw the same random numbers in a replicate, so their difference is taken replicate by replicate.
"""
import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import study

PAPER = 112.93  # mean horizontal force of the paper's model [kN], Sec. 3.1.3
QUANTITIES = {
    "mean": "horizontal.mean", "  crushing at the edge": "horizontal.mean_by_cause.crushing",
    "  floes, normal": "horizontal.mean_by_cause.floe_normal",
    "  floes, friction": "horizontal.mean_by_cause.floe_friction", "vertical mean": "vertical.mean",
    "deviation": "horizontal.standard_deviation", "99 %": "horizontal.quantile_99"}


def interval(values):
    mean, half = study.mean_interval(values)
    return f"{mean:7.1f} ({mean - half:6.1f} to {mean + half:6.1f})"


def print_table(rows):
    """Both engines at each time step, and their difference over the replicates [kN]."""
    for step in sorted({row["time.step"] for row in rows}, reverse=True):
        brash, bullet = ({row["replicate"]: row for row in rows
                          if row["time.step"] == step and row["contact.engine"] == engine}
                         for engine in ("brash", "bullet"))
        both = sorted(brash.keys() & bullet.keys())
        print(f"dt = {step:g} s: {len(both)} replicates [kN]")
        print(f"  {'':22s}{'bullet':28s}{'brash':28s}bullet less brash")
        for name, column in QUANTITIES.items():
            own = [brash[r][column] / 1e3 for r in both]
            stock = [bullet[r][column] / 1e3 for r in both]
            cells = [interval(stock), interval(own), interval([b - a for a, b in zip(own, stock)])]
            print(f"  {name:22s}" + "".join(f"{cell:28s}" for cell in cells).rstrip())
    print(f"the paper's model: {PAPER}")


def main():
    parser = study.arguments(__doc__, presets=True)
    parser.add_argument("--table", action="store_true")
    options = parser.parse_args()
    target = study.recorded(HERE.name, options.preset)
    if options.table:
        print_table(study.read_rows(target))
        return 0
    output = study.results_folder(options, HERE.name)
    if options.quick and options.record:
        study.record_quick(options.brash, HERE, output)
        return 0
    if options.quick:
        return study.quick(options, HERE, output)
    study.preset_campaign(options, HERE / "plan.toml", output)
    rows = study.collect(options.brash, output)
    print_table(rows)
    if options.record:
        target.parent.mkdir(exist_ok=True)
        study.write_rows(target, rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
