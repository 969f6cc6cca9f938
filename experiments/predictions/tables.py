# SPDX-License-Identifier: GPL-3.0-or-later
"""The short pages that predict.py prints: Markdown, forces in kN. The numbers behind them are details.py's."""
import json
import math
import subprocess
from collections import Counter

import numpy as np

import details
import inputs
import study
from case_numbers import growth_numbers, read_table
from inputs import BadInput
from signs import judged, tested
from verdicts import distribution, has_number, one_history, points_and_values, series, upper_bound

JUDGED = ["mean", "breaking_frequency"]  # of a series; the other statistics are printed beside them, without a verdict
OF_SHIPS = ("riska", "jeong", "lindqvist")
UNSETTLED = 0.2  # a load that changes by more between the halves of the window has not settled


def number(value, digits=3):
    return "-" if value is None or not math.isfinite(value) else f"{value:.{digits}g}" if abs(value) < 1000 else f"{value:.0f}"


def interval(ends, unit=1.0, digits=3):
    return f"{number(ends[0] / unit, digits)} to {number(ends[1] / unit, digits)}"


def read_numbers(path):
    """Rows as they were recorded."""
    return [{**row, "arm": row["arm"] or "", "point": int(row["point"]), "replicate": int(row["replicate"])}
            for row in read_table(path)]


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


def joined_rows(prediction, recorded, fresh):
    """Recorded rows and those of a campaign, which win, in the order of points, arms and replicates; each with all columns."""
    arms = list(prediction.arms)
    found = {(row["point"], arms.index(row["arm"]), row["replicate"]): row for row in (*recorded, *fresh)}
    names = list(dict.fromkeys(name for row in (*fresh, *recorded) for name in row))
    return [{name: as_recorded(name, found[key].get(name)) for name in names} for key in sorted(found)]


def as_recorded(name, value):
    """A value of a new row as it comes back from a file: all numbers but those of point and replicate are floats."""
    return float(value) if isinstance(value, int) and name not in ("point", "replicate") else value


# Measurements.

def measured_rows(prediction, options):
    """[{arm, statistic: value}] of the test: from its own file, a folder of histories, a table, or both joined."""
    table = [{**row, "arm": row.get("arm") or ""} for row in read_table(options.measured)] if options.measured else []
    if options.data:
        found = grown(prediction, options) if prediction.growth else histories(options)
        return joined(found, table, options.measured)
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


def history_files(options):
    if not options.data.is_dir():
        raise BadInput(f"--data {options.data}: is not a folder; name the folder of the unpacked data set")
    files = sorted(options.data.glob("*.csv"))
    if not files:
        raise BadInput(f"--data {options.data}: has no CSV file; convert the histories to CSV with a column of time [s]")
    return files


def grown(prediction, options):
    """Numbers of the one measured history over the ice that has come; its time 0, or --from, is the first contact."""
    files = history_files(options)
    if len(files) != 1:
        raise BadInput(f"--data {options.data}: has {len(files)} CSV files, and {prediction.path} predicts one test; leave one file in it")
    try:
        history = study.brash_module().read_history(str(files[0]), column=options.column or "")
    except ValueError as error:
        raise BadInput(f"{files[0]}: {error}") from error
    time, growth = np.asarray(history.times) - (options.start or 0.0), prediction.growth
    counted = time >= 0.0 if options.end is None else (time >= 0.0) & (time <= options.end - (options.start or 0.0))
    numbers = growth_numbers(time[counted], np.asarray(history.values)[counted], growth, growth["measured_speed"], growth["measured_width"])
    if not numbers:
        raise BadInput(f"{files[0]}: ends before the first window of {prediction.path}; give a longer history, or a smaller --from")
    return [{"arm": "", "file": files[0].name, **numbers}]


def histories(options):
    """Statistics of each measured history of a folder, by `brash stats`."""
    found = []
    for file in history_files(options):
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


def interval_lines(prediction, rows, statistics):
    """The interval of one run of each number that the criterion asks for; the other numbers are in the CSV file."""
    asked = [row for row in details.number_rows(prediction, rows) if row["number"] in statistics]
    if not asked:
        return []
    arms = any(row["arm"] for row in asked)
    lines = ["| arm " * arms + f"| number | median | {asked[0]['range']} |", "|---" * (3 + arms) + "|"]
    return lines + [f"| {row['arm']} " * arms + f"| {row['number']} [{row['unit']}] | {number(row['median'])} | "
                    f"{interval((row['low'], row['high']))} |" for row in asked] + [""]


def unsettled_of(rows):
    """(runs whose load still changes from the first half of the window to the second, runs)."""
    moving = [row for row in rows if row.get("second_half_over_first") is not None]
    return sum(abs(row["second_half_over_first"] - 1.0) > UNSETTLED for row in moving), len(moving)


def unsettled_lines(rows):
    unsettled, n = unsettled_of(rows)
    return [f"In {unsettled} of {n} runs the load changes by more than {UNSETTLED:.0%} between the halves of the window.", ""] * int(unsettled > 0)


def test_line(found):
    """One test beside its prediction; an error of the model is told if it is larger than twice its uncertainty."""
    cells = [number(found["simulated"]), interval((found["low"], found["high"])),
             *(number(found[name]) for name in ("measured", "ratio", "error", "u_val")),
             interval((found["model_error_low"], found["model_error_high"])),
             "yes" if found["told"] else "no", "yes" if found["inside"] else "no"]
    return f"| {found['test']} | {' | '.join(cells)} |"


def series_lines(prediction, rows, measured, statistic, compared):
    """Comparison of one statistic with its measurements: one row a test if it is judged, and the series."""
    found = [row for row in compared if row["statistic"] == statistic]
    lines = [f"### {statistic}", ""]
    if not found:
        given = any(test.get(statistic) is not None for test in measured)
        missing = "Not measured." + " The criterion checks it, so this part of the verdict stays open." * (statistic in JUDGED)
        return [*lines, "No interval: fewer than two points have this number." if given else missing, ""]
    if statistic in JUDGED:
        lines += ["| test | predicted | interval | measured | ratio | error E | u_val | model error | error shown | inside |",
                  "|---|---|---|---|---|---|---|---|---|---|", *map(test_line, found), ""]
        farthest = max(found, key=lambda row: abs(math.log(row["ratio"])) if row["ratio"] > 0.0 else math.inf)
        lines += [f"Worst miss: {farthest['test']}, predicted {number(farthest['ratio'])} times the measured value.", ""] * (len(found) > 1)
    chosen_rows = [[row for row in rows if row["arm"] == test["arm"]] for test in found]
    ratios = [(row["simulated"], row["measured"]) for row in found]
    return lines + series_summary(prediction, statistic, ratios, [row["inside"] for row in found], chosen_rows)


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


def exponent_lines(prediction, rows, promised):
    """The exponent of the load along each input, and less each form's, with 95 % intervals over the points.

    promised: whether there are points enough for a verdict; without it nothing differs or not.
    """
    judged_one = prediction.criterion["statistic"]
    found = {(row["input"], row["less"]): row for row in details.exponent_rows(prediction, rows) if row["number"] == judged_one}
    forms = [form for form in details.REGRESSIONS if any(form == less for _, less in found)]
    compared = [row for (_, less), row in found.items() if less]
    lines = [f"| input | exponent of `{judged_one}` |" + "".join(f" less {form} |" for form in forms), "|---|---|" + "---|" * len(forms)]
    for wanted in prediction.table["exponent"]:
        cells = [exponent_cell(found.get((wanted.get("name", wanted["of"]), less)), promised and bool(less)) for less in ("", *forms)]
        lines.append(f"| `{wanted.get('name', wanted['of'])}` | {' | '.join(cells)} |")
    if not promised or not compared:
        return lines + [""]
    worst = max(compared, key=lambda row: abs(row["exponent"]))
    return [f"**{sum(map(differs, compared))} of {len(compared)} comparisons differ.** Worst miss: along `{worst['input']}` the program "
            f"less {worst['less']} is {signed(worst['exponent'])}.", "", *lines, "",
            "Bold: the 95 % interval leaves out 0. Each comparison is on its own: no correction was made for their number.", ""]


def differs(row):
    return abs(row["exponent"]) > row["half_width"]


def signed(value):
    return f"{value:.2f}".replace("-0.00", "0.00")


def exponent_cell(row, marked):
    """Exponent with its 95 % interval; bold if it is marked and leaves out 0."""
    if row is None:
        return "-"
    mean, half = row["exponent"], row["half_width"]
    bold = "**" if marked and differs(row) else ""
    return f"{bold}{signed(mean)}{bold} ({signed(mean - half)} to {signed(mean + half)})"


def claim_lines(outcomes):
    lines = ["| claim | effect | 95 % interval | samples (left out) | p |", "|---|---|---|---|---|"]
    for o in outcomes:
        divisor, unit = (1e3, " kN") if o.claim["kind"] == "rises-beyond" else (1.0, "")
        samples = "runs" if o.claim["kind"] == "share" else "points"
        lines.append(f"| {o.claim['text']} | {number(o.effect / divisor, 4)}{unit} | {interval(o.interval, divisor, 4)}{unit} | "
                     f"{o.n} {samples} ({o.left_out}) | {o.p:.2g} |")
    return lines + [""]


def worst_miss(outcomes, word):
    """The claim that contradicts most, or that is farthest from being shown."""
    return min(outcomes, key=lambda o: o.opposite) if word == "contradicted" else max(outcomes, key=lambda o: o.p)


def effect_of(outcome):
    divisor, unit = (1e3, " kN") if outcome.claim["kind"] == "rises-beyond" else (1.0, "")
    return f"{number(outcome.effect / divisor, 4)}{unit} ({interval(outcome.interval, divisor, 4)}{unit})"


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
        lines += bound_lines(prediction, rows) + interval_lines(prediction, rows, [prediction.criterion["statistic"]])
    if kind == "exponents":
        lines += exponent_lines(prediction, rows, not fewer)
    if not fewer and kind == "claims":
        outcomes = outcomes_of(prediction, rows, rows_elsewhere)
        (word, p), = judged({prediction.name: outcomes}).values()
        lines += [f"**{word}**, p = {p:.2g}, alone." + f" Worst miss: {worst_miss(outcomes, word).claim['text']}." * (word != "shown"),
                  "", *claim_lines(outcomes)]
    if not fewer and kind == "series":
        lines += measured_lines(prediction, rows, measured) + regression_lines(prediction, rows)
        if "exponent" in prediction.table:
            lines += speed_lines(prediction, rows, measured)
    if not fewer and kind == "distribution":
        lines += distribution_lines(prediction, rows, measured)
    if not fewer and kind == "history":
        lines += history_lines(prediction, rows, measured)
    return "\n".join(lines + unsettled_lines(rows)).rstrip() + "\n"


def measured_lines(prediction, rows, measured):
    """A series beside its measurements; without them the intervals that will be compared."""
    statistics = prediction.criterion["statistics"]
    if not measured:
        return ["No measured values were given: the verdict is open.", "",
                *interval_lines(prediction, rows, [name for name in statistics if name in JUDGED])]
    compared = details.series_rows(prediction, rows, measured)
    return [line for name in statistics for line in series_lines(prediction, rows, measured, name, compared)]


def regression_lines(prediction, rows):
    """The program over each regression, without any measurement."""
    found = details.regression_rows(prediction, rows)
    said = ", ".join(f"{row['form']} {number(row['ratio'])} ({interval((row['low'], row['high']))})" for row in found)
    return [f"The program's mean over regressions (95 % over the points): {said}.", ""] if found else []


def speed_lines(prediction, rows, measured):
    """Exponents of the judged load over the inputs of a series, and whether the measured ones lie within those of one point."""
    lines = ["| input | exponent, less | of | 95 % |", "|---|---|---|---|"]
    for row in details.exponent_rows(prediction, rows):
        if row["number"] == prediction.criterion["statistic"]:
            mean, half = row["exponent"], row["half_width"]
            lines.append(f"| {row['input']} | {row['less'] or '-'} | {signed(mean)} | {signed(mean - half)} to {signed(mean + half)} |")
    for row in details.measured_exponents(prediction, rows, measured):
        lines += [""] * (lines[-1].startswith("|"))
        lines += [f"- Measured exponent, {row['input']}: {signed(row['measured'])}, within {signed(row['low'])} to {signed(row['high'])} "
                  f"of one point: **{'yes' if row['inside'] else 'no'}**."]
    return lines + [""]


def events_of(prediction, measured):
    """The judged number of each measured event [SI]."""
    statistic = prediction.criterion["statistic"]
    return [row[statistic] for row in measured if has_number(row, statistic)]


def distribution_lines(prediction, rows, measured):
    """Shares of runs below the criterion's levels, beside those of measured events."""
    criterion = prediction.criterion
    values, _ = points_and_values(rows, criterion["statistic"])
    found = distribution(values, events_of(prediction, measured), criterion["levels"], criterion["confidence"])
    lines = ["No measured events were given: the verdict is open.", ""]
    if found["verdict"] != "open":
        lines = [f"**{found['verdict']}**. Beyond all runs: {found['beyond']:.0%} of the events.", ""]
    lines += [f"| level [kN] | runs with `{criterion['statistic']}` below it | share (95 %) | events below it | p, Holm |",
              "|---|---|---|---|---|"]
    for row in found["rows"]:
        low, high = row["share_95"]
        event = f"{row['measured_below']} of {row['measured_n']} | {row['p_adjusted']:.2g}" if "p" in row else "- | -"
        lines.append(f"| {row['level'] / 1e3:g} | {row['below']} of {row['n']} | {row['share']:.0%} ({low:.0%} to {high:.0%}) | {event} |")
    return [*lines, "", *interval_lines(prediction, rows, [criterion["statistic"], *criterion.get("also", [])])]


def history_lines(prediction, rows, measured):
    """Numbers of one test's history, each with its interval."""
    found = one_history(rows, prediction.criterion, measured[0] if measured else {})
    units = details.recorded_numbers(prediction)
    lines = [f"**{found['verdict']}**." if measured else "No measured history was given: the verdict is open.", "",
             "| number | unit | judged | median | interval | measured | inside |", "|---|---|---|---|---|---|---|"]
    for row in found["rows"]:
        unit, divisor = units[row["number"]]
        value = "-" if row["measured"] is None else number(row["measured"] / divisor)
        inside = {None: "-", True: "yes", False: "no"}[row["inside"]]
        lines.append(f"| {row['number']} | {unit} | {'yes' if row['judged'] else '-'} | {number(row['median'] / divisor)} | "
                     f"{interval((row['low'], row['high']), divisor)} | {value} | {inside} |")
    return lines + [""]


def signs(predictions, rows_elsewhere, family, preset):
    """The table of all signs of one preset, and {sign: outcomes of its claims}. The pictures are predict.py's."""
    found, fewer = {}, {}
    for name, prediction in predictions.items():
        rows = rows_elsewhere(f"m6/{name}") if prediction.own_runs else []
        too_few = fewer_points(prediction, rows, rows_elsewhere)
        if not too_few:
            found[name] = outcomes_of(prediction, rows, rows_elsewhere)
        elif too_few != NOT_RUN:
            fewer[name] = too_few
    verdicts = judged(found, family) if found else {}
    lines = ["## Ten trends", "",
             "| trend | verdict | p, Holm | claim farthest from the statement | effect (95 %) | unsettled runs |",
             "|---|---|---|---|---|---|"]
    not_run = []
    for name, prediction in predictions.items():
        label = prediction.criterion.get("stands_for", name.upper())
        if name not in verdicts and name not in fewer:
            not_run.append(label)
            continue
        word, p = verdicts.get(name, (fewer.get(name), math.nan))
        cells = ["-", "-", "-", "-"]
        if name in found:
            worst, rows = worst_miss(found[name], word), rows_elsewhere(f"m6/{name}") if prediction.own_runs else []
            cells = [f"{p:.2g}" + (" of the opposite" if word == "contradicted" else ""), worst.claim["text"], effect_of(worst),
                     "{} of {}".format(*unsettled_of(rows)) if rows else "-"]
            label = f"[{label}]({name}/claims-{preset}.csv)"
        lines.append(f"| {label} | **{word}** | {' | '.join(cells)} |")
    if not_run:
        lines += ["", f"Not run: {', '.join(not_run)}."]
    return "\n".join(lines) + "\n", found


def verdict_word(prediction, rows, measured, rows_elsewhere):
    """The verdict in few words."""
    criterion = prediction.criterion
    fewer = fewer_points(prediction, rows, rows_elsewhere)
    if fewer:
        return fewer
    if criterion["kind"] == "upper-bound":
        return upper_bound(rows, criterion)["verdict"]
    if criterion["kind"] == "claims":
        return judged({prediction.name: outcomes_of(prediction, rows, rows_elsewhere)})[prediction.name][0] + ", alone"
    if criterion["kind"] == "distribution":
        values, _ = points_and_values(rows, criterion["statistic"])
        return distribution(values, events_of(prediction, measured), criterion["levels"], criterion["confidence"])["verdict"]
    if criterion["kind"] == "history":
        return one_history(rows, criterion, measured[0] if measured else {})["verdict"]
    if criterion["kind"] == "exponents":
        compared = [row for row in details.exponent_rows(prediction, rows) if row["less"] and row["number"] == criterion["statistic"]]
        return f"{sum(map(differs, compared))} of {len(compared)} comparisons differ"
    if not measured:
        return "open"
    asked = [row for row in details.series_rows(prediction, rows, measured) if row["statistic"] in JUDGED]
    return f"{sum(row['inside'] for row in asked)} of {len(asked)} inside"


def judged_numbers(prediction):
    """Names of the numbers that a criterion judges."""
    criterion = prediction.criterion
    if criterion["kind"] == "claims":
        return list(dict.fromkeys(claim["statistic"] for claim in prediction.claims))
    if criterion["kind"] == "series":
        return [name for name in criterion["statistics"] if name in JUDGED]
    return criterion["statistics"] if criterion["kind"] == "history" else [criterion["statistic"]]


def overview(prediction, rows, measured, rows_elsewhere):
    """One row for each arm and judged number of a prediction; regressions and closed forms in kN, medians over the points."""
    same = {"folder": prediction.name, "test": prediction.table["title"], "points": points_run(rows), "unknowns": len(prediction.unknowns),
            "verdict": verdict_word(prediction, rows, measured, rows_elsewhere),
            "program": "; ".join(sorted({row["program"] for row in rows if row.get("program")}))}
    blank = {"arm": "", "number": "", "unit": "", "median": None, "low": None, "high": None}
    found = details.number_rows(prediction, rows) if rows else []
    forms = {}
    for row in found:
        if row["range"] == "least to largest":
            forms.setdefault(row["arm"], {})[row["number"].split(" ")[0]] = row["median"]
    for arm, values in forms.items():  # the slope of a stem is no slope of a structure
        forms[arm] = {form: value for form, value in values.items() if "lindqvist" not in values or form in OF_SHIPS}
    asked = [{name: row[name] for name in blank} for row in found if row["number"] in judged_numbers(prediction)]
    return [{**same, **row, **{form: forms.get(row["arm"], {}).get(form) for form in details.REGRESSIONS}} for row in asked or [blank]]


def markdown(rows):
    """A table of rows of one kind."""
    lines = [f"| {' | '.join(rows[0])} |", "|---" * len(rows[0]) + "|"] if rows else []
    return lines + [f"| {' | '.join('-' if cell in (None, '') else str(cell) for cell in row.values())} |" for row in rows]


def indices(prediction, found, too_few, statistic):
    """First-order and total indices of each unknown, for each arm, with the surrogate's error."""
    lines = [f"## {prediction.table['title']}: variance of `{statistic}`", ""]
    for arm in prediction.arms:
        if arm in too_few:
            n = len(prediction.names())
            lines += [f"{arm or 'All runs'}: {too_few[arm]} points are too few for {n} unknowns; at least twice as many.", ""]
        else:
            lines += arm_indices(arm, [row for row in found if row["arm"] == arm])
    return "\n".join(lines).rstrip() + "\n"


def arm_indices(arm, rows):
    unseen, noise = rows[0]["held_back"], rows[0]["noise"]
    lines = [f"### {arm or 'all runs'}", "",
             f"{rows[0]['points']} points, {rows[0]['terms']} terms. Error on samples held back: {unseen:.0%} of the variance. Between "
             f"replicates: {'not known' if math.isnan(noise) else f'{noise:.0%}'} of the variance of single runs.", ""]
    if unseen > 0.5:
        lines += ["**The surrogate misses more than half of the variance of unseen samples. The indices below are no result.**", ""]
    lines += ["| unknown | first order | total |", "|---|---|---|"]
    return lines + [f"| `{row['unknown']}` | {row['first']:.2f} ± {row['first_error']:.2f} | "
                    f"{row['total']:.2f} ± {row['total_error']:.2f} |" for row in rows] + [""]
