# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements are drawn from the tables that the pages link, so a figure and its table never differ."""
import csv
import pathlib

THEORY = pathlib.Path(__file__).resolve().parents[1]


def table(name):
    """The head and the rows of tables/NAME.csv, without its comments; cells as text."""
    lines = (THEORY / f"tables/{name}.csv").read_text(encoding="utf-8").splitlines()
    return list(csv.reader(line for line in lines if not line.startswith("#")))
