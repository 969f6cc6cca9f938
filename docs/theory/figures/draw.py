#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the figures of the theory pages: draw.py [FOLDER], with the built module `brash` on PYTHONPATH.

The same sources and the same Matplotlib give the same bytes. trapezoid-fit.svg has a script of its own.
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import closed_forms
import contacts
import cracks
import cuts
import edge
import floes
import histories
import hull
import ice
import measured
import moving_edge
import plate
import step
import water

FIGURES = {"contacts": contacts.draw, "water": water.draw, "cuts": cuts.draw, "crack-patterns": cracks.draw,
           "histories": histories.draw, "plate": plate.draw, "closed-forms": closed_forms.draw,
           "edge": edge.draw, "moving-edge": moving_edge.draw, "solver": measured.solver,
           "crushed": measured.crushed, "step": step.draw, "hull": hull.draw, "floes": floes.draw, "ice": ice.draw}


def main():
    folder = pathlib.Path(sys.argv[1]) if sys.argv[1:] else pathlib.Path(__file__).parent
    # A fixed salt and no date: names of parts in the file do not vary.
    plt.rcParams.update({"svg.hashsalt": "brash", "font.size": 9, "axes.titlesize": 10, "legend.frameon": False,
                         "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False})
    for name, draw in FIGURES.items():
        figure = draw()
        figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
        plt.close(figure)


if __name__ == "__main__":
    main()
