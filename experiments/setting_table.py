#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The settings of a campaign beside each other, as a Markdown table with 95 % intervals over the replicates.

setting_table.py validation/laws.csv             recorded rows, or the campaign.csv of a results folder
setting_table.py laws.csv water.csv              of several files; settings of the same name go together
setting_table.py FILE... --column NAME[/UNIT]    other columns; UNIT divides the numbers: horizontal.maximum/1e6

An interval is Student's. The difference is the first column's, less that of the first setting. Its interval is
Welch's: settings have seeds of their own, so their replicates are independent.
"""
import argparse
import math
import sys
from pathlib import Path

import numpy as np
from scipy import stats

sys.path.insert(0, str(Path(__file__).resolve().parent))
import study

COLUMNS = ["horizontal.mean/1e3", "horizontal.mean_by_cause.crushing/1e3", "horizontal.quantile_99/1e3",
           "breaking_frequency", "breaking_length_quantiles.50", "piece_area_quantiles.50"]


def welch(first, second, confidence=0.95):
    """Difference of the means, first less second, and half its interval."""
    variances = [np.var(values, ddof=1) / len(values) for values in (first, second)]
    error = math.sqrt(sum(variances))
    freedom = sum(variances) ** 2 / sum(v**2 / (len(values) - 1) for v, values in zip(variances, (first, second)))
    return np.mean(first) - np.mean(second), stats.t.ppf(0.5 + 0.5 * confidence, freedom) * error


def cell(mean, half):
    """Both to the digits that the interval leaves."""
    digits = max(0, 1 - math.floor(math.log10(half))) if half > 0.0 and math.isfinite(half) else 2
    return f"{mean:.{digits}f} ± {half:.{digits}f}" if math.isfinite(half) else f"{mean:.{digits}f}"


def values_of(rows, setting, column):
    name, _, unit = column.partition("/")
    found = [row[name] for row in rows if row["setting"] == setting and row[name] != ""]
    return np.array(found, dtype=float) / float(unit or 1.0)


def table(rows, columns):
    settings = list(dict.fromkeys(row["setting"] for row in rows))
    base = values_of(rows, settings[0], columns[0])
    lines = ["| setting | n | " + " | ".join([columns[0], f"less {settings[0]}", *columns[1:]]) + " |",
             "|---" * (len(columns) + 3) + "|"]
    for setting in settings:
        found = [values_of(rows, setting, column) for column in columns]
        cells = [cell(*study.mean_interval(values)) if len(values) > 1 else cell(*values, math.nan) if len(values) else "-"
                 for values in found]
        difference = "" if setting == settings[0] or min(len(base), len(found[0])) < 2 else cell(*welch(found[0], base))
        lines.append("| " + " | ".join([setting, str(len(found[0])), cells[0], difference, *cells[1:]]) + " |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("--column", action="append", dest="columns")
    options = parser.parse_args()
    rows = [row for file in options.files for row in study.read_rows(file)]
    known = [name for name in rows[0] if all(name in row for row in rows)]
    for column in options.columns or []:
        if column.partition("/")[0] not in known:
            parser.error(f"--column {column}: is not a column of the files; they have {', '.join(known)}")
    print(table(rows, options.columns or [column for column in COLUMNS if column.partition("/")[0] in known]))


if __name__ == "__main__":
    main()
