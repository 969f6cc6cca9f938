# SPDX-License-Identifier: GPL-3.0-or-later
"""The tables that predict.py prints: Markdown, forces in kN."""
import json
import math
import subprocess
from collections import Counter

import numpy as np
from scipy import stats

import inputs
from case_numbers import read_table
from inputs import BadInput
from signs import judged, slopes, student, tested
from surrogate import Chaos, held_back_error, jackknife_indices, noise_share
from verdicts import points_and_values, prediction_interval, series, upper_bound, validation

# Printed of every study, whatever its verdict is about; unit of the table, and its divisor.
ALWAYS = {"mean": ("kN", 1e3), "deviation": ("kN", 1e3), "quantile_50": ("kN", 1e3), "quantile_99": ("kN", 1e3),
          "quantile_99_0.1s": ("kN", 1e3), "largest": ("kN", 1e3), "smallest": ("kN", 1e3), "mean_1s": ("kN", 1e3),
          "deviation_1s": ("kN", 1e3), "largest_1s": ("kN", 1e3), "smallest_1s": ("kN", 1e3), "crushing": ("kN", 1e3), "floes": ("kN", 1e3),
          "breaking_frequency": ("1/s", 1.0), "breaking_length": ("m", 1.0), "breaking_length_over_lc": ("-", 1.0),
          "piece_size_05": ("m", 1.0), "piece_size": ("m", 1.0), "piece_size_95": ("m", 1.0)}
REGRESSIONS = ["riska", "jeong", "lindqvist", "edwards", "croasdale", "ralston_tresca", "ralston_johansen"]
SHOWN_AS = {"edwards": "edwards (45 deg)"}  # a form that knows no slope says for which it was made
JUDGED = ["mean", "breaking_frequency"]  # of a series; the other statistics are printed beside them, without a verdict
PEAKS = ["largest", "quantile_99", "quantile_99_0.1s"]  # whose exponents stand beside the forms'
UNSETTLED = 0.2  # a load that changes by more between the halves of the window has not settled


def number(value, digits=3):
    return "-" if value is None or not math.isfinite(value) else f"{value:.{digits}g}" if abs(value) < 1000 else f"{value:.0f}"


def interval(ends, unit=1.0, digits=3):
    return f"{number(ends[0] / unit, digits)} to {number(ends[1] / unit, digits)}"


def read_numbers(path):
    """Rows as they were recorded."""
    return [{**row, "arm": row["arm"] or ""} for row in read_table(path)]


def complete(rows, prediction):
    """The rows of the points of which all arms have all replicates, in whole steps of the ensemble."""
    step = int(prediction.ensemble["points"])
    needed = {arm: prediction.ensemble.get("replicates", 1) for arm in prediction.arms}
    have = {}
    for row in rows:
        have.setdefault(row["point"], Counter())[row["arm"]] += 1
    whole = 0
    while have.get(whole + 1) == needed:
        whole += 1
    whole -= whole % step if whole >= step else 0
    return [row for row in rows if row["point"] <= whole]


# Measurements.

def measured_rows(prediction, options):
    """[{arm, statistic: value}] of the test: from its own file, a folder of histories, a table, or both joined."""
    table = [{**row, "arm": row.get("arm") or ""} for row in read_table(options.measured)] if options.measured else []
    if options.data:
        return joined(histories(options), table, options.measured)
    if options.measured:
        return table
    measured = prediction.table.get("measured", {})
    return [{"arm": "", key: value} for key, values in measured.items() for value in values]


def joined(found, table, path):
    """Numbers of histories with the columns that a table adds for the same files; its values win."""
    more = {row.get("file"): row for row in table}
    unknown = more.keys() - {row["file"] for row in found}
    if unknown:
        raise BadInput(f"{path}: file = {next(iter(unknown))}: is not in the folder of --data; name one of its files in each row")
    return [{**row, **{key: value for key, value in more.get(row["file"], {}).items() if value is not None}} for row in found]


def histories(options):
    """Statistics of each measured history of a folder, by `brash stats`."""
    if not options.data.is_dir():
        raise BadInput(f"--data {options.data}: is no folder; name the folder of the unpacked data set")
    files = sorted(options.data.glob("*.csv"))
    if not files:
        raise BadInput(f"--data {options.data}: has no CSV file; convert the histories to CSV with a column of time [s]")
    found = []
    for file in files:
        command = [str(options.brash), "stats", str(file), "--json"]
        for name, value in (("--column", options.column), ("--from", options.start), ("--to", options.end)):
            command += [name, str(value)] if value is not None else []
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode:
            raise BadInput(f"{file}: brash stats refuses it: {done.stderr.strip()}")
        summary = json.loads(done.stdout)
        found.append({"arm": "", "file": file.name, "mean": summary["mean"], "deviation": summary["standard_deviation"],
                      "largest": summary["maximum"]})
    return found


# Verdicts.

def points_run(rows):
    return len({row["point"] for row in rows})


def heading(prediction, rows):
    n = points_run(rows)
    failed = [row for row in rows if row.get("status") == "failed"]
    lines = [f"## {prediction.table['title']}", "",
             f"Points of the unknowns: {n}. Runs: {len(rows)}. Unknowns: {len(prediction.unknowns)}.", ""]
    if failed:
        named = ", ".join(f"{row['arm'] or 'point'} {row['point']:g}" for row in failed)
        lines += [f"**{len(failed)} runs failed and have no numbers: {named}.** Series and claims leave them out, and a bound is open "
                  "in place of held.", ""]
    if rows and n < prediction.ensemble["points"]:
        lines += [f"**Fewer points than the {prediction.ensemble['points']} that were promised: no verdict.**", ""]
    return lines


def intervals(prediction, rows):
    """Prediction intervals of one run for each arm."""
    confidence = prediction.criterion.get("confidence", 0.95)
    lines = [f"| arm | number | unit | median | {confidence:.0%} interval of one run |", "|---|---|---|---|---|"]
    for arm in prediction.arms:
        chosen = [row for row in rows if row["arm"] == arm]
        for statistic, (unit, divisor) in ALWAYS.items():
            values, n = points_and_values(chosen, statistic)
            if len(values):
                ends = prediction_interval(values, n, confidence)
                lines.append(f"| {arm or '-'} | {statistic} | {unit} | {number(np.median(values) / divisor)} | "
                             f"{interval(ends, divisor)} |")
    moving = [row for row in rows if row.get("second_half_over_first") is not None]
    unsettled = sum(abs(row["second_half_over_first"] - 1.0) > UNSETTLED for row in moving)
    if unsettled:
        lines += ["", f"In {unsettled} of {len(moving)} runs the load still changes by more than {UNSETTLED:.0%} from the first "
                      "half of the window to the second."]
    return lines + [""]


def beside(prediction, rows):
    """Regressions and closed forms over the same points."""
    lines = []
    for arm in prediction.arms:
        chosen = [row for row in rows if row["arm"] == arm]
        for name in REGRESSIONS:
            values, _ = points_and_values(chosen, name)
            if len(values):
                lines.append(f"| {arm or '-'} | {SHOWN_AS.get(name, name)} | {number(np.median(values) / 1e3)} | "
                             f"{interval((values.min() / 1e3, values.max() / 1e3))} |")
    head = ["Beside it, over the same points:", "", "| arm | form | median [kN] | least to largest [kN] |", "|---|---|---|---|"]
    return head + lines + [""] if lines else []


def test_line(test, found, ends, inside):
    """One test beside its prediction; an error of the model is told if it is larger than twice its uncertainty."""
    cells = [number(found["simulated"]), interval(ends),
             *(number(found[name]) for name in ("measured", "ratio", "error", "u_val")), interval(found["model_error"]),
             "yes" if found["told"] else "no", "yes" if inside else "no"]
    return f"| {test.get('file') or test['arm'] or '-'} | {' | '.join(cells)} |"


def series_lines(prediction, rows, measured, statistic):
    """Comparison of one statistic with its measurements, one row a test, and the series."""
    criterion = prediction.criterion
    lines = [f"### {statistic}", "",
             "| test | predicted | interval | measured | ratio | error E | u_val | model error | error told | inside |",
             "|---|---|---|---|---|---|---|---|---|---|"]
    ratios, inside, chosen_rows = [], [], []
    for test in measured:
        chosen = [row for row in rows if row["arm"] == test["arm"]]
        values, n = points_and_values(chosen, statistic)
        if test.get(statistic) is None or n < 2:
            continue
        found = validation(values, test[statistic], criterion["u_numerical"], criterion["u_measured"])
        low, high = prediction_interval(values, n, criterion["confidence"])
        inside.append(low <= test[statistic] <= high)
        ratios.append((found["simulated"], test[statistic]))
        chosen_rows.append(chosen)
        lines.append(test_line(test, found, (low, high), inside[-1]))
    if not ratios:
        if not measured:
            return []
        given = any(test.get(statistic) is not None for test in measured)
        missing = "Not measured." + " The criterion judges it, so this part of the verdict stays open." * (statistic in JUDGED)
        return [*lines[:2], "No interval: fewer than two points have this number." if given else missing, ""]
    return lines + [""] + series_summary(prediction, statistic, ratios, inside, chosen_rows)


def series_summary(prediction, statistic, ratios, inside, chosen_rows):
    """Bias, root mean square and coverage; for what is judged also the criterion, and for the mean the regressions."""
    if any(simulated <= 0 or measured <= 0 for simulated, measured in ratios):
        return ["No logarithms: a value is not positive.", ""]
    found = series(*zip(*ratios), inside)
    low, high = found["coverage_95"]
    lines = [f"Bias (mean ln S/D): {found['bias']:+.3f} ({interval(found['bias_95'])}). Root mean square: {found['rms']:.3f}. "
             f"Inside: {found['covered']} of {found['n']} ({low:.0%} to {high:.0%}).", ""]
    if statistic not in JUDGED:
        return lines
    others = {}
    for name in prediction.criterion.get("regressions", []) if statistic == "mean" else []:
        means = [np.mean(points_and_values(rows, name)[0]) for rows in chosen_rows]
        if all(math.isfinite(value) and value > 0 for value in means):
            others[name] = series(means, [measured for _, measured in ratios], inside)
    lines += [f"- {name}: bias {other['bias']:+.3f}, root mean square {other['rms']:.3f}." for name, other in others.items()]
    return lines + [""] + statements(prediction, found, [other["rms"] for other in others.values()])


def statements(prediction, found, others):
    """The criterion of a series, one line each; `others`: root mean squares of the regressions."""
    least = prediction.criterion["least_inside"]
    lines = [f"- Inside their intervals: {found['covered']} of {found['n']}, {least} are needed: "
             f"**{'yes' if found['covered'] >= least else 'no'}**."]
    if found["n"] > 1 and prediction.criterion.get("regressions"):  # the only series whose criterion asks for the bias, m1's
        low, high = found["bias_95"]
        lines.append(f"- The interval of the bias holds 0: **{'yes' if low <= 0 <= high else 'no'}**.")
    if others:
        lines.append(f"- Root mean square below each regression: **{'yes' if found['rms'] < min(others) else 'no'}**.")
    return lines + [""]


def bound_lines(prediction, rows):
    criterion = prediction.criterion
    found = upper_bound(rows, criterion)
    low, high = found["share_95"]
    without = f" At {found['without']} points a run has no number." if found["without"] else ""
    return [f"**{found['verdict']}**: `{criterion['statistic']}` exceeds {number(criterion['bound'] / 1e3)} kN at {found['above']} of "
            f"{found['n_points']} points ({low:.0%} to {high:.0%}). Largest ratio to the bound: "
            f"{number(found['largest_ratio'])}.{without}", ""]


def exponents_of(rows, wanted, names):
    """{number: {point: exponent}} of the numbers that the rows have."""
    return {name: slopes(rows, {"statistic": name, "along": wanted["of"], "arms": wanted["arms"]})
            for name in names if any(row.get(name) is not None for row in rows)}


def differences(one, other):
    """One exponent less the other at each point that has both."""
    return [one[i] - other[i] for i in one if one[i] is not None and other.get(i) is not None]


def exponent_lines(prediction, rows, promised):
    """Exponents of the program's numbers and of closed forms, with 95 % intervals over the points, and their differences in pairs.

    promised: whether there are points enough for a verdict; without it nothing differs or not.
    """
    lines = ["| input | number | exponent | 95 % interval | program less form | 95 % interval | differs |", "|---|---|---|---|---|---|---|"]
    judged_one = prediction.criterion["statistic"]
    for wanted in prediction.table["exponent"]:
        found = exponents_of(rows, wanted, [judged_one, "quantile_99_0.1s", "crushing", "floes", "breaking_length",
                                            "breaking_frequency", *REGRESSIONS])
        for name, slope in found.items():
            cells = mean_cells([value for value in slope.values() if value is not None])
            other = mean_cells(differences(found[judged_one], slope)) if name in REGRESSIONS else ("-", "-", "-")
            other = other if promised else (*other[:2], "-")
            lines.append(f"| `{wanted['of']}` | {name} | {cells[0]} | {cells[1]} | {' | '.join(other)} |")
    note = "Each comparison stands by itself: no correction was made for their number."
    return lines + [""] + [note, ""] * promised + peak_lines(prediction, rows)


def peak_lines(prediction, rows):
    """Exponents of the program's peaks, and less those of the closed forms, which are peaks too."""
    forms = [name for name in REGRESSIONS if any(row.get(name) is not None for row in rows)]
    lines = []
    for wanted in prediction.table["exponent"]:
        found = exponents_of(rows, wanted, [*PEAKS, *forms])
        for name in [peak for peak in PEAKS if peak in found]:
            samples = [list(found[name].values()), *(differences(found[name], found[form]) for form in forms)]
            lines.append(f"| `{wanted['of']}` | {name} | {' | '.join(mean_and_half(values) for values in samples)} |")
    head = ["Peaks beside the forms, which are peaks of one break; no part of the criterion. A quantile in time grows with the "
            "number of breaks too, and the largest force with the length of the record.", "",
            f"| input | number | exponent | {' | '.join(f'less {form}' for form in forms)} |",
            "|---|---|---|" + "---|" * len(forms)]
    return head + lines + [""] if lines and forms else []


def mean_and_half(samples):
    """Mean and half the width of its 95 % interval."""
    kept = [value for value in samples if value is not None]
    if len(kept) < 2:
        return "-"
    mean, error, freedom = student(kept)
    return f"{mean:+.2f} ± {stats.t.ppf(0.975, freedom) * error:.2f}"


def mean_cells(samples):
    """Mean, its 95 % interval, and whether it leaves out 0."""
    if len(samples) < 2:
        return "-", "-", "-"
    mean, error, freedom = student(samples)
    half = stats.t.ppf(0.975, freedom) * error
    shown = [f"{value:.2f}".replace("-0.00", "0.00") for value in (mean, mean - half, mean + half)]
    return shown[0], f"{shown[1]} to {shown[2]}", "yes" if abs(mean) > half else "no"


def claim_lines(outcomes):
    lines = ["| claim | effect | 95 % interval | samples (left out) | p |", "|---|---|---|---|---|"]
    for o in outcomes:
        divisor, unit = (1e3, " kN") if o.claim["kind"] == "rises-beyond" else (1.0, "")
        samples = "runs" if o.claim["kind"] == "share" else "points"
        lines.append(f"| {o.claim['text']} | {number(o.effect / divisor, 4)}{unit} | {interval(o.interval, divisor, 4)}{unit} | "
                     f"{o.n} {samples} ({o.left_out}) | {o.p:.2g} |")
    return lines + [""]


def outcomes_of(prediction, rows, rows_elsewhere):
    return [tested(rows_elsewhere(claim["from"]) if "from" in claim else rows, claim) for claim in prediction.claims]


NOT_RUN = "not run"


def fewer_points(prediction, rows, rows_elsewhere):
    """How many points are there of those that the folder, or the folders that its claims read, promise; "" if all are."""
    needed = [(prediction, rows)] if prediction.own_runs else [
        (inputs.Prediction(inputs.HERE / claim["from"]), rows_elsewhere(claim["from"])) for claim in prediction.claims]
    if not all(found for _, found in needed):
        return NOT_RUN
    few = [f"{points_run(found)} of {of.ensemble['points']} points" + ("" if of is prediction else f" of {of.name}")
           for of, found in needed if points_run(found) < of.ensemble["points"]]
    return ", ".join(few)


def verdict(prediction, rows, measured, rows_elsewhere):
    """The whole text of a folder."""
    if prediction.own_runs and not rows:
        others = sorted(path.stem.removeprefix("recorded-") for path in prediction.folder.glob("recorded-*.csv"))
        hint = "".join(f" Recorded with --preset {preset}." for preset in others)
        return f"## {prediction.table['title']}\n\nNot run yet with this preset. The inputs are committed.{hint}\n"
    lines = heading(prediction, rows) if prediction.own_runs else [f"## {prediction.table['title']}", ""]
    fewer = fewer_points(prediction, rows, rows_elsewhere)
    kind = prediction.criterion["kind"]
    if fewer and not prediction.own_runs:
        lines += [f"No verdict: {fewer}.", ""]
    if not fewer and kind == "upper-bound":
        lines += bound_lines(prediction, rows)
    if kind == "exponents":
        lines += exponent_lines(prediction, rows, not fewer)
    if not fewer and kind == "claims":
        outcomes = outcomes_of(prediction, rows, rows_elsewhere)
        (word, p), = judged({prediction.name: outcomes}).values()
        lines += [f"**{word}**, p = {p:.2g}, alone.", "", *claim_lines(outcomes)]
    if not fewer and kind == "series":
        for statistic in prediction.criterion["statistics"]:
            lines += series_lines(prediction, rows, measured, statistic)
        if not measured:
            lines += ["No measured values were given: the verdict is open.", ""]
    if rows:
        lines += intervals(prediction, rows) + beside(prediction, rows)
    return "\n".join(lines).rstrip() + "\n"


def signs(predictions, rows_elsewhere, family, preset):
    """The table of all signs of one preset, and {sign: outcomes of its claims}. The pictures are predict.py's."""
    found, fewer, lines = {}, {}, []
    for name, prediction in predictions.items():
        rows = rows_elsewhere(f"m6/{name}") if prediction.own_runs else []
        too_few = fewer_points(prediction, rows, rows_elsewhere)
        if not too_few:
            found[name] = outcomes_of(prediction, rows, rows_elsewhere)
        elif too_few != NOT_RUN:
            fewer[name] = too_few
    verdicts = judged(found, family) if found else {}
    table = ["| sign | statement | verdict | p, Holm | picture |", "|---|---|---|---|---|"]
    for name, prediction in predictions.items():
        word, p = verdicts.get(name, (fewer.get(name, "not run"), math.nan))
        label = prediction.criterion.get("stands_for", name.upper())
        picture = f"[claims]({name}/claims-{preset}.png)" if name in found else "-"
        p_cell = "-" if math.isnan(p) else f"{p:.2g}" + (" of the opposite" if word == "contradicted" else "")
        table.append(f"| {label} | {prediction.table['title']} | **{word}** | {p_cell} | {picture} |")
        if name in found:
            lines += [f"### {label}", "", *claim_lines(found[name])]
    return "\n".join(["## Ten signs", "", *table, "", *lines]).rstrip() + "\n", found


def indices(prediction, rows, statistic, degree):
    """First-order and total indices of each unknown, for each arm, with the surrogate's error."""
    lines = [f"## {prediction.table['title']}: variance of `{statistic}`", ""]
    names = prediction.names()
    for arm in prediction.arms:
        groups = {}
        for row in rows:
            if row["arm"] == arm and row.get(statistic) is not None:
                groups.setdefault(int(row["point"]), []).append(row[statistic])
        if len(groups) < 2 * len(names):
            lines += [f"{arm or 'All runs'}: {len(groups)} points are too few for {len(names)} unknowns; at least twice as many.", ""]
            continue
        numbers = sorted(groups)
        points = inputs.points_of(prediction, numbers[-1])[np.array(numbers) - 1]
        values = np.array([np.mean(groups[i]) for i in numbers])
        lines += arm_indices(arm, prediction, points, values, degree, noise_share([groups[i] for i in numbers]))
    return "\n".join(lines).rstrip() + "\n"


def arm_indices(arm, prediction, points, values, degree, noise):
    names, options = prediction.names(), {"degree": degree, "choices": [len(u.get("choices", [])) for u in prediction.unknowns]}
    chaos = Chaos(points, values, **options)
    first, total = chaos.indices()
    errors = jackknife_indices(points, values, **options)
    unseen = held_back_error(points, values, **options)
    lines = [f"### {arm or 'all runs'}", "",
             f"{len(values)} points, {len(chaos.terms)} terms. Error on samples held back: {unseen:.0%} of the variance. Between "
             f"replicates: {'not known' if math.isnan(noise) else f'{noise:.0%}'} of the variance of single runs.", ""]
    if unseen > 0.5:
        lines += ["**The surrogate misses more than half of the variance of unseen samples. The indices below are no result.**", ""]
    lines += ["| unknown | first order | total |", "|---|---|---|"]
    for j in np.argsort(-total, kind="stable"):
        lines.append(f"| `{names[j]}` | {first[j]:.2f} ± {2 * errors[0][j]:.2f} | {total[j]:.2f} ± {2 * errors[1][j]:.2f} |")
    return lines + [""]
