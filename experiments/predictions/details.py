# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers behind a verdict, as rows of the CSV files beside it. README.md lists the files."""

import numpy as np
from scipy import stats

import inputs
from signs import slopes, student
from surrogate import Chaos, held_back_error, jackknife_indices, noise_share
from verdicts import linear_interval, points_and_values, prediction_interval, validation

# Recorded of every study, whatever its verdict is about; unit of the table, and its divisor.
ALWAYS = {"mean": ("kN", 1e3), "deviation": ("kN", 1e3), "quantile_50": ("kN", 1e3), "quantile_99": ("kN", 1e3),
          "quantile_99_0.1s": ("kN", 1e3), "largest": ("kN", 1e3), "smallest": ("kN", 1e3), "mean_1s": ("kN", 1e3),
          "deviation_1s": ("kN", 1e3), "largest_1s": ("kN", 1e3), "smallest_1s": ("kN", 1e3),
          "largest_0.1s": ("kN", 1e3), "largest_2s": ("kN", 1e3), "crushing": ("kN", 1e3), "floes": ("kN", 1e3),
          "breaking_frequency": ("1/s", 1.0), "breaking_length": ("m", 1.0), "breaking_length_over_lc": ("-", 1.0),
          "piece_size_05": ("m", 1.0), "piece_size": ("m", 1.0), "piece_size_95": ("m", 1.0)}
OF_HISTORIES = {"mean_frequency": ("Hz", 1.0), "mean": ("kN/m", 1e3), "deviation": ("kN/m", 1e3), "largest": ("kN/m", 1e3),
                "peaks_per_second": ("1/s", 1.0)}  # by how the name of a history's number begins; others have no unit
REGRESSIONS = ["riska", "jeong", "lindqvist", "edwards", "croasdale", "ralston_tresca", "ralston_johansen"]
SHOWN_AS = {"edwards": "edwards (45 deg)"}  # a form that knows no slope says for which it was made
PEAKS = ["largest", "quantile_99", "quantile_99_0.1s"]  # whose exponents stand beside the forms'
WITH_EXPONENTS = [*PEAKS, "crushing", "floes", "breaking_length", "breaking_frequency"]


def rounded(row):
    """The row with six digits a number."""
    return {key: f"{value:.6g}" if isinstance(value, float) else value for key, value in row.items()}


def recorded_numbers(prediction):
    """{number: (unit, divisor)} of the numbers of a prediction."""
    criterion, asked = prediction.criterion, {}
    if criterion["kind"] == "history":
        for name in (*criterion["statistics"], *criterion.get("also", [])):
            asked[name] = next((unit for start, unit in OF_HISTORIES.items() if name.startswith(start)), ("-", 1.0))
    return {**asked, **ALWAYS}


def number_rows(prediction, rows):
    """For each arm: median and interval of one run of each number; regressions and closed forms over the same points."""
    confidence = prediction.criterion.get("confidence", 0.95)
    found = []
    for arm in prediction.arms:
        chosen = [row for row in rows if row["arm"] == arm]
        for statistic, (unit, divisor) in recorded_numbers(prediction).items():
            values, n = points_and_values(chosen, statistic)
            if len(values):
                low, high = prediction_interval(values, n, confidence)
                found.append({"arm": arm, "number": statistic, "unit": unit, "median": np.median(values) / divisor,
                              "low": low / divisor, "high": high / divisor, "range": f"{confidence:.0%} interval of one run"})
        for form in REGRESSIONS:
            values, _ = points_and_values(chosen, form)
            if len(values):
                found.append({"arm": arm, "number": SHOWN_AS.get(form, form), "unit": "kN", "median": np.median(values) / 1e3,
                              "low": values.min() / 1e3, "high": values.max() / 1e3, "range": "least to largest"})
    return found


def load_rows(prediction, rows):
    """One row a test [SI], for whoever has the measured numbers: median and interval of one run of all that the criterion names."""
    criterion, found = prediction.criterion, []
    for arm in prediction.arms:
        chosen = [row for row in rows if row["arm"] == arm]
        test = {"arm": arm, "points": len({row["point"] for row in chosen})}
        for name in (*criterion["statistics"], *criterion.get("also", [])):
            values, n = points_and_values(chosen, name)
            if n >= 2:
                low, high = prediction_interval(values, n, criterion["confidence"])
                test.update({name: float(np.median(values)), f"{name}_low": low, f"{name}_high": high})
        found.append(test)
    return found


def series_rows(prediction, rows, measured):
    """Each measured number beside its prediction [SI], and whether the error is the model's and the interval holds the test."""
    criterion, found = prediction.criterion, []
    for statistic in criterion["statistics"]:
        for test in measured:
            values, n = points_and_values([row for row in rows if row["arm"] == test["arm"]], statistic)
            if test.get(statistic) is None or n < 2:
                continue
            low, high = prediction_interval(values, n, criterion["confidence"])
            compared = validation(values, test[statistic], criterion["u_numerical"], criterion["u_measured"])
            model_low, model_high = compared.pop("model_error")
            found.append({"arm": test["arm"], "test": test.get("file") or test["arm"] or "-", "statistic": statistic, "low": low,
                          "high": high, **compared, "model_error_low": model_low, "model_error_high": model_high,
                          "inside": low <= test[statistic] <= high})
    return found


def claim_row(outcome):
    """A tested claim [SI]; `of`: of what the samples are."""
    low, high = outcome.interval
    return {"claim": outcome.claim["text"], "kind": outcome.claim["kind"], "effect": float(outcome.effect), "low": float(low),
            "high": float(high), "samples": outcome.n, "of": "runs" if outcome.claim["kind"] == "share" else "points",
            "left_out": outcome.left_out, "p": float(outcome.p), "p_opposite": float(outcome.opposite)}


def exponents_of(rows, wanted, names):
    """{number: {point: exponent}} of the numbers that the rows have."""
    return {name: slopes(rows, {"statistic": name, "along": wanted["of"], "arms": wanted["arms"]})
            for name in names if any(row.get(name) is not None for row in rows)}


def differences(one, other):
    """One exponent less the other at each point that has both."""
    return [one[i] - other[i] for i in one if one[i] is not None and other.get(i) is not None]


def without_noise(value):
    """A number of order one, or 0 where it is the rounding of one."""
    return 0.0 if abs(value) < 1e-12 else float(value)


def exponent_rows(prediction, rows):
    """Exponents with half the width of their 95 % intervals: of each number, and of the load and its peaks less each form's."""
    judged_one, found = prediction.criterion["statistic"], []

    def add(wanted, number, form, samples):
        kept = [value for value in samples if value is not None]
        if len(kept) >= 2:
            mean, error, freedom = student(kept)
            found.append({"input": wanted.get("name", wanted["of"]), "number": number, "less": form, "exponent": without_noise(mean),
                          "half_width": without_noise(stats.t.ppf(0.975, freedom) * error)})

    for wanted in prediction.table["exponent"]:
        exponents = exponents_of(rows, wanted, [judged_one, *WITH_EXPONENTS, *REGRESSIONS])
        for name, slope in exponents.items():
            add(wanted, name, "", slope.values())
        for name in (judged_one, *PEAKS):
            for form in REGRESSIONS:
                if name in exponents and form in exponents:
                    add(wanted, name, form, differences(exponents[name], exponents[form]))
    return found


def measured_exponents(prediction, rows, measured):
    """The exponent of each measured series beside the interval of one point's exponent."""
    judged_one, found = prediction.criterion["statistic"], []
    of_test = {test["arm"]: test.get(judged_one) for test in measured}
    for wanted in prediction.table["exponent"]:
        name, arms = wanted.get("name", wanted["of"]), wanted["arms"]
        values = [value for value in exponents_of(rows, wanted, [judged_one])[judged_one].values() if value is not None]
        loads = [of_test.get(arm) for arm in arms]
        if len(values) < 2 or None in loads or min(loads) <= 0.0:
            continue
        places = np.log([inputs.flat(prediction.arms[arm])[wanted["of"]] for arm in arms])
        low, high = linear_interval(values, prediction.criterion["confidence"])
        measured_one = float(np.polyfit(places, np.log(loads), 1)[0])
        found.append({"input": name, "low": low, "high": high, "measured": measured_one, "inside": low <= measured_one <= high})
    return found


def regression_rows(prediction, rows):
    """The mean load over each regression, geometric mean over the arms of a point, with its 95 % interval over the points."""
    found = []
    for form in prediction.criterion.get("regressions", []):
        at = {}
        for row in rows:
            if row.get("mean") and row.get(form) and row["mean"] > 0.0:
                at.setdefault(row["point"], []).append(np.log(row["mean"] / row[form]))
        if len(at) >= 2:
            mean, error, freedom = student([np.mean(values) for values in at.values()])
            half = stats.t.ppf(0.975, freedom) * error
            found.append({"form": form, "ratio": np.exp(mean), "low": np.exp(mean - half), "high": np.exp(mean + half)})
    return found


def index_rows(prediction, rows, statistic, degree):
    """First-order and total indices of each unknown, for each arm, with the surrogate's error; {arm: too few points}."""
    names, found, too_few = prediction.names(), [], {}
    for arm in prediction.arms:
        groups = {}
        for row in rows:
            if row["arm"] == arm and row.get(statistic) is not None:
                groups.setdefault(int(row["point"]), []).append(row[statistic])
        if len(groups) < 2 * len(names):
            too_few[arm] = len(groups)
            continue
        numbers = sorted(groups)
        points = inputs.points_of(prediction, numbers[-1])[np.array(numbers) - 1]
        values = np.array([np.mean(groups[i]) for i in numbers])
        found += arm_indices(arm, prediction, points, values, degree, noise_share([groups[i] for i in numbers]))
    return found, too_few


def arm_indices(arm, prediction, points, values, degree, noise):
    names, options = prediction.names(), {"degree": degree, "choices": [len(u.get("choices", [])) for u in prediction.unknowns]}
    chaos = Chaos(points, values, **options)
    first, total = chaos.indices()
    errors = jackknife_indices(points, values, **options)
    of_surrogate = {"points": len(values), "terms": len(chaos.terms), "held_back": float(held_back_error(points, values, **options)),
                    "noise": float(noise)}
    return [{"arm": arm, "unknown": names[j], "first": float(first[j]), "first_error": float(2 * errors[0][j]),
             "total": float(total[j]), "total_error": float(2 * errors[1][j]), **of_surrogate}
            for j in np.argsort(-total, kind="stable")]
