# SPDX-License-Identifier: GPL-3.0-or-later
"""Intervals over the unknowns, and verdicts of series and bounds. README.md has the formulas."""
import math

import numpy as np
from scipy import stats


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
    logs = bool(np.all(values > 0.0))
    y = np.log(values) if logs else values
    half = stats.t.ppf(0.5 + 0.5 * confidence, n - 1) * y.std(ddof=1) * math.sqrt(1.0 + 1.0 / n)
    ends = y.mean() - half, y.mean() + half
    return tuple(math.exp(end) for end in ends) if logs else ends


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


def share_interval(k, n, confidence=0.95):
    """Clopper and Pearson's interval of a share of k in n."""
    tail = 0.5 * (1.0 - confidence)
    low = 0.0 if k == 0 else stats.beta.ppf(tail, k, n - k + 1)
    high = 1.0 if k == n else stats.beta.ppf(1.0 - tail, k + 1, n - k)
    return float(low), float(high)


def series(simulated, measured, inside):
    """Bias, root mean square of ln S/D, and coverage of a series; bias with its 95 % interval (Student's)."""
    logs = np.log(np.asarray(simulated) / np.asarray(measured))
    n = len(logs)
    half = stats.t.ppf(0.975, n - 1) * logs.std(ddof=1) / math.sqrt(n) if n > 1 else math.nan
    covered = int(np.sum(inside))
    return {"n": n, "bias": float(logs.mean()), "bias_95": (logs.mean() - half, logs.mean() + half),
            "rms": float(math.sqrt(np.mean(logs**2))), "covered": covered, "coverage_95": share_interval(covered, n)}


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
