#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Influence of the ice thickness (the paper's Figs. 18 and 19).

run.py                  the campaign, its table and pictures in results/thickness
run.py --record         also rewrites the recorded numbers and pictures here
run.py --quick          the short variant of the tests: two settings, compared with quick.csv
"""
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
import figures
import study

KEY = "ice.thickness"


def draw(rows, closed, output, folder):
    figures.mean_figure(rows, closed, KEY, folder, "means")
    figures.history_figure(rows, KEY, output, folder, "histories")


if __name__ == "__main__":
    sys.exit(study.main(HERE, [KEY], ["horizontal.mean", "vertical.mean", "mean_frequency"], draw, __doc__))
