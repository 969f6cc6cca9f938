#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of one input (Sec. 3.2 of the paper): a folder here with its plan, numbers and pictures.

one_input.py cone_angle          Figs. 10 and 11: the campaign, its table and pictures in results/cone_angle-paper
one_input.py velocity            Figs. 12 and 14
one_input.py waterline_width     Fig. 16
one_input.py thickness           Figs. 18 and 19
one_input.py NAME --20s          each run takes 20 s, as in the paper; without it, runs of a speed or width travel equally far
one_input.py NAME --preset brash --replicates 3    the same with the default, three replicates a setting
one_input.py NAME --record       also rewrites the recorded numbers and pictures of NAME
one_input.py NAME --quick        the short variant of the tests: two settings, compared with quick.csv
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import figures
import study

KEYS = {"cone_angle": "structure.angle", "velocity": "structure.speed",
        "waterline_width": "structure.waterline_width", "thickness": "ice.thickness"}


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in KEYS:
        sys.exit(__doc__ if "-h" in sys.argv or "--help" in sys.argv else f"one_input.py: name one of {', '.join(KEYS)}")
    name = sys.argv.pop(1)

    def draw(rows, closed, output, folder, _):
        figures.mean_figure(rows, closed, KEYS[name], folder, "means")
        figures.history_figure(rows, KEYS[name], output, folder, "histories")

    return study.main(HERE / name, [KEYS[name]], ["horizontal.mean", "vertical.mean", "mean_frequency", "breaking_length_quantiles.50"],
                      draw, __doc__)


if __name__ == "__main__":
    sys.exit(main())
