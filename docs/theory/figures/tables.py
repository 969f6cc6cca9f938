# SPDX-License-Identifier: GPL-3.0-or-later
"""Measurements are drawn from the tables of their pages, so a figure and its table never differ."""
import csv
import pathlib
import re

THEORY = pathlib.Path(__file__).resolve().parents[1]


def table(page, head):
    """The rows below the line of `page` that begins with the cell `head`, without the rule; cells as text."""
    lines = (THEORY / page).read_text(encoding="utf-8").splitlines()
    [start] = [i for i, line in enumerate(lines) if line.startswith(f"| {head} |")]
    rows = []
    for line in [lines[start], *lines[start + 2:]]:
        if not line.startswith("|"):
            break
        rows.append([cell.strip() for cell in line.strip("|").split("|")])
    return rows


def numbers(text):
    """All numbers of a cell, such as a mean with its interval."""
    return [float(number) for number in re.findall(r"-?\d+(?:\.\d+)?(?:e-?\d+)?", text)]


def csv_table(name):
    """The head and the rows of tables/NAME.csv, without its comments; cells as text."""
    lines = (THEORY / f"tables/{name}.csv").read_text(encoding="utf-8").splitlines()
    return list(csv.reader(line for line in lines if not line.startswith("#")))
