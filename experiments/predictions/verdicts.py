# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals over the unknowns, and verdicts of series and bounds. README.md has the formulas."""
import math

import numpy as np
from scipy import stats

from signs import ALPHA, holm, share_interval


def has_number(row, statistic):
    return row.get(statistic) is not None and math.isfinite(row[statistic])


def points_and_values(rows, statistic):
    """Values of the runs that have the statistic, and the number of points among them."""
    kept = [row for row in rows if has_number(row, statistic)]
    return np.array([row[statistic] for row in kept], dtype=float), len({row["point"] for row in kept})


def prediction_interval(values, n_points=None, confidence=0.95):
    """Student's interval of one more run: in logarithms if all values are positive. nan below two points.

    n_points: independent places of the unknowns among the values, if runs repeat at a place.
    """
    values = np.asarray(values, dtype=float)
    n = n_points or len(values)
    if n < 2:
        return math.nan, math.nan
    if np.all(values > 0.0):
        return tuple(math.exp(end) for end in linear_interval(np.log(values), confidence, n))
    return linear_interval(values, confidence, n)


def linear_interval(values, confidence=0.95, n_points=None):
    """The same without logarithms."""
    values = np.asarray(values, dtype=float)
    n = n_points or len(values)
    half = stats.t.ppf(0.5 + 0.5 * confidence, n - 1) * values.std(ddof=1) * math.sqrt(1.0 + 1.0 / n)
    return float(values.mean() - half), float(values.mean() + half)


def validation(values, measured, u_numerical, u_measured):
    """ASME V&V 20-2009: comparison error, validation uncertainty, and the interval of the model's error, in the values' unit.

    u_numerical: standard uncertainty over the simulation. u_measured: over the measurement.
    """
    simulated = float(np.mean(values))
    error = simulated - measured
    u_input = float(np.std(values, ddof=1))
    u_val = math.sqrt((u_numerical * simulated) ** 2 + u_input**2 + (u_measured * measured) ** 2)
    return {"simulated": simulated, "measured": measured, "ratio": simulated / measured, "error": error, "u_input": u_input,
            "u_val": u_val, "model_error": (error - 2.0 * u_val, error + 2.0 * u_val), "told": abs(error) > 2.0 * u_val}


def series(simulated, measured, inside):
    """Bias, root mean square of ln S/D, and coverage of a series; bias with its 95 % interval (Student's)."""
    logs = np.log(np.asarray(simulated) / np.asarray(measured))
    n = len(logs)
    half = stats.t.ppf(0.975, n - 1) * logs.std(ddof=1) / math.sqrt(n) if n > 1 else math.nan
    covered = int(np.sum(inside))
    return {"n": n, "bias": float(logs.mean()), "bias_95": (logs.mean() - half, logs.mean() + half),
            "rms": float(math.sqrt(np.mean(logs**2))), "covered": covered, "coverage_95": share_interval(covered, n)}


def distribution(values, measured, levels, confidence=0.95):
    """Shares of runs below each level, beside those of measured events (may be empty), with Fisher's p adjusted by Holm's method.

    Verdict: refuted if one share differs at 5 %, else holds; open without events. `beyond`: share of the events outside all runs.
    """
    values, measured = np.asarray(values, dtype=float), np.asarray(measured, dtype=float)
    rows = []
    for level in levels:
        below, n = int(np.sum(values < level)), len(values)
        row = {"level": level, "below": below, "n": n, "share": below / n, "share_95": share_interval(below, n, confidence)}
        if len(measured):
            row["measured_below"], row["measured_n"] = int(np.sum(measured < level)), len(measured)
            table = [[below, n - below], [row["measured_below"], len(measured) - row["measured_below"]]]
            row["p"] = float(stats.fisher_exact(table)[1])
        rows.append(row)
    if not len(measured):
        return {"verdict": "open", "rows": rows, "beyond": math.nan}
    for row, p in zip(rows, holm([row["p"] for row in rows])):
        row["p_adjusted"] = float(p)
    outside = (measured < values.min()) | (measured > values.max())
    return {"verdict": "refuted" if min(row["p_adjusted"] for row in rows) < ALPHA else "holds", "rows": rows,
            "beyond": float(np.mean(outside))}


def one_history(rows, criterion, measured):
    """Numbers of one test: the judged ones hold together with the criterion's confidence (Bonferroni), the others alone.

    measured: {number: value}, maybe empty. Verdict: refuted if a judged number lies outside, else open if one is missing, else holds.
    """
    judged, each = criterion["statistics"], 1.0 - (1.0 - criterion["confidence"]) / len(criterion["statistics"])
    found = []
    for name in [*judged, *criterion.get("also", [])]:
        values, n = points_and_values(rows, name)
        if n < 2:
            continue
        low, high = prediction_interval(values, n, each if name in judged else criterion["confidence"])
        value = measured.get(name)
        found.append({"number": name, "judged": name in judged, "median": float(np.median(values)), "low": low, "high": high,
                      "measured": value, "inside": None if value is None else bool(low <= value <= high)})
    inside = {row["number"]: row["inside"] for row in found if row["judged"]}
    known = [inside.get(name) for name in judged]
    return {"verdict": "refuted" if False in known else "open" if None in known else "holds", "rows": found}


def upper_bound(rows, criterion):
    """Verdict of an upper bound over all runs: points above it, and the largest ratio.

    A run without a number might lie above, so the bound does not hold then: it is refuted by another point, or open.
    """
    statistic, bound = criterion["statistic"], criterion["bound"]
    values, n_points = points_and_values(rows, statistic)
    without = len({row["point"] for row in rows if not has_number(row, statistic)})
    if len(values) == 0:
        return {"verdict": "open", "n_points": 0, "without": without, "above": 0, "share_95": (0.0, 1.0), "largest_ratio": math.nan}
    above = {row["point"] for row in rows if has_number(row, statistic) and row[statistic] > bound}
    return {"verdict": "refuted" if above else "open" if without else "holds", "n_points": n_points, "without": without,
            "above": len(above), "share_95": share_interval(len(above), n_points), "largest_ratio": float(values.max() / bound)}
