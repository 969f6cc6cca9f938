# SPDX-License-Identifier: GPL-3.0-or-later
"""The numbers of each run of a prediction's campaign: forces in N over the window of travel, lengths in m; program and commit."""
import csv
import json
import math
import subprocess
import tomllib

import numpy as np
from scipy.signal import welch

import study
from inputs import GRAVITY, TRAVEL_SPEEDS, flat, parts_of
from regressions import edwards

CAUSES = {"crushing": ["crushing_Fx"], "floes": ["floe_normal_Fx", "floe_friction_Fx"]}
LARGEST_MEANS = {"largest_0.1s": 0.1, "largest_2s": 2.0}  # s; each is the largest mean over so long
SEGMENT, LOWEST, HIGH = 8.0, 0.2, 1.0  # s of a spectrum's segments; Hz from which it counts, and from which it counts as high


def read_table(path):
    """Rows of a CSV file: numbers as floats, empty cells as None."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text or None

    with open(path, newline="", encoding="utf-8") as file:
        return [{key: value(text) for key, text in row.items()} for row in csv.DictReader(file)]


def read_history(path):
    """{column: values} of a history.csv, the columns that the numbers need."""
    with open(path, encoding="utf-8") as file:
        names = file.readline().strip().split(",")
    wanted = [name for name in ["time", "Fx", *CAUSES["crushing"], *CAUSES["floes"], "structure_vx"] if name in names]
    values = np.loadtxt(path, delimiter=",", skiprows=1, usecols=[names.index(name) for name in wanted], ndmin=2)
    return dict(zip(wanted, values.T))


def block_means(samples, dt, seconds):
    """Means of successive blocks; an incomplete last one is left out."""
    block = max(1, round(seconds / dt))
    n = len(samples) // block
    return samples[: n * block].reshape(n, block).mean(axis=1)


def force_numbers(force, dt):
    """Numbers of the horizontal force, raw and as 1 s means."""
    found = {}
    for suffix, values in (("", force), ("_1s", block_means(force, dt, 1.0))):
        if len(values) < 2:
            continue
        found.update({f"mean{suffix}": values.mean(), f"deviation{suffix}": values.std(ddof=1),
                      f"largest{suffix}": values.max(), f"smallest{suffix}": values.min()})
    short = block_means(force, dt, 0.1)
    for name, seconds in LARGEST_MEANS.items():
        means = block_means(force, dt, seconds)
        found[name] = means.max() if len(means) else math.nan
    found.update({"quantile_50": np.quantile(force, 0.5), "quantile_99": np.quantile(force, 0.99),
                  "quantile_99_0.1s": np.quantile(short, 0.99), "variation": found["deviation"] / found["mean"]})
    half = len(force) // 2
    found["second_half_over_first"] = force[half:].mean() / force[:half].mean()
    return found


def at_rate(time, force, rate):
    """Means of a history over successive 1 / rate [s] from time 0 on, as a slower sensor gives it; nan where it has no sample."""
    counted = time >= 0.0
    # A sample at the end of a step belongs to that step, also if its time is a rounding error early.
    place = np.floor(time[counted] * rate + 1e-9).astype(int)
    n = np.bincount(place)
    with np.errstate(invalid="ignore"):
        return np.bincount(place, force[counted]) / n


def n_peaks(force):
    """Peaks about the straight line through a window: each begins half a deviation above the line, and ends below it."""
    place = np.arange(len(force))
    residual = force - np.polyval(np.polyfit(place, force, 1), place)
    high = 0.5 * residual.std(ddof=1)
    n, inside = 0, False
    for value in residual:
        n += not inside and value > high
        inside = value > high or (inside and value >= 0.0)
    return n


def spectrum_numbers(force, rate):
    """Mean frequency [Hz] of the spectrum from LOWEST on (Welch's method), and the share of its variance from HIGH on."""
    frequency, density = welch(force, fs=rate, nperseg=min(len(force), round(SEGMENT * rate)))
    band = frequency >= LOWEST
    whole = density[band].sum()
    return {"mean_frequency": float((frequency * density)[band].sum() / whole),
            "share_above_1Hz": float(density[frequency >= HIGH].sum() / whole)}


def growth_numbers(time, force, growth, speed, width):
    """Numbers of a load over the ice that has come since the first contact, at time 0; per metre of `width`.

    growth: the table of prediction.toml; force in N, time in s, speed in m/s. Numbers whose window is not whole are left out.
    """
    load = at_rate(time, force, growth["rate"]) / width
    begin = np.arange(len(load)) / growth["rate"]
    come = begin * speed
    counted = (begin >= growth["skip"]) & np.isfinite(load)
    found, first, peaks = {}, None, 0
    for low, high in growth["windows"]:
        if len(load) / growth["rate"] * speed < high * (1.0 - 1e-6):
            continue
        window, name = load[counted & (come >= low - 1e-9) & (come < high - 1e-9)], f"{low:g}-{high:g}m"
        found.update({f"mean_{name}": window.mean(), f"deviation_{name}": window.std(ddof=1),
                      f"largest_1s_{name}": block_means(window, 1.0 / growth["rate"], 1.0).max()})
        if first is None:
            first = window.mean()
        else:
            found[f"growth_{name}"] = window.mean() / first
        whole = load[counted & (come < high - 1e-9)]
        peaks += n_peaks(window)
        found.update({"peaks_per_second": peaks * growth["rate"] / len(whole), **spectrum_numbers(whole, growth["rate"])})
    return found


def since_contact(history):
    """Times since the first load of a run, and the loads."""
    loaded = np.flatnonzero(history["Fx"])
    first = history["time"][loaded[0]] if len(loaded) else math.inf
    return history["time"] - first, history["Fx"]


def history_numbers(history, start, travel, speed):
    """Numbers of one load history from `start` [s] on; `travel` may name windows of way [m], passed at `speed` [m/s]."""
    time, force = history["time"], history["Fx"]
    dt = time[1] - time[0]
    counted = time > start - 0.5 * dt
    found = force_numbers(force[counted], dt)
    for cause, columns in CAUSES.items():
        found[cause] = float(sum(history[name][counted].mean() for name in columns))
    if "structure_vx" in history:
        found["speed"] = history["structure_vx"][counted].mean()
    for name, window in travel.items():
        if isinstance(window, list):
            inside = (time * speed > window[0]) & (time * speed <= window[1])
            found[name] = force[inside].mean() if inside.any() else math.nan
    return found


def speed_of(case):
    """Speed of a structure that is towed, or of the feet of its springs [m/s]."""
    return next((case[key] for key in TRAVEL_SPEEDS if key in case), math.nan)


def characteristic_length(case):
    """l_c [m] of the ice of a resolved case, {key: value}."""
    h, nu = case["ice.thickness"], case["ice.poisson_ratio"]
    stiffness = case["ice.youngs_modulus"] * h**3 / (12.0 * (1.0 - nu**2))
    return (stiffness / (case["water.density"] * GRAVITY)) ** 0.25


def length_numbers(row, case):
    """Breaking lengths and piece sizes of one row of campaign.csv, {column: value or None}."""
    l_c = characteristic_length(case)
    found = {"l_c": l_c, "buckling_unit": case["water.density"] * GRAVITY * l_c**2}
    for name, level in (("breaking_length_05", "05"), ("breaking_length", "50"), ("breaking_length_95", "95")):
        found[name] = row.get(f"breaking_length_quantiles.{level}")
    for name, level in (("piece_size_05", "05"), ("piece_size", "50"), ("piece_size_95", "95")):
        area = row.get(f"piece_area_quantiles.{level}")
        found[name] = None if area is None else math.sqrt(area)
    length = found["breaking_length"]
    found["breaking_length_over_lc"] = None if length is None else length / l_c
    found["breaking_frequency"], found["n_breaks"] = row.get("breaking_frequency"), row.get("n_breaks")
    return found


def n_modes(logarithms, n=512):
    """Modes of a Gaussian kernel estimate with Silverman's bandwidth, 0.9 min(s, IQR / 1.34) n^(-1/5)."""
    x = np.asarray(logarithms)
    quartiles = np.quantile(x, [0.25, 0.75])
    width = 0.9 * min(x.std(ddof=1), (quartiles[1] - quartiles[0]) / 1.34) * len(x) ** -0.2
    grid = np.linspace(x.min() - 3 * width, x.max() + 3 * width, n)
    density = np.exp(-0.5 * ((grid[:, None] - x) / width) ** 2).sum(axis=1)
    return int(np.sum((density[1:-1] > density[:-2]) & (density[1:-1] >= density[2:])))


def weibull_advantage(sizes):
    """Log-likelihood of the best Weibull law less the one of the best log-normal law."""
    from scipy import stats
    weibull = stats.weibull_min.fit(sizes, floc=0)
    log_normal = stats.lognorm.fit(sizes, floc=0)
    return float(stats.weibull_min.logpdf(sizes, *weibull).sum() - stats.lognorm.logpdf(sizes, *log_normal).sum())


def shape_numbers(folder):
    """Whether the sizes of a run's floes have one mode, and a Weibull law rather than a log-normal one; 1 or 0."""
    floes = study.brash_module().read_results(str(folder / "run.nc")).floes
    sizes = np.sqrt([floe.area for floe in floes])
    if len(sizes) < 10:
        return {}
    return {"n_pieces": len(sizes), "one_mode": float(n_modes(np.log(sizes)) == 1),
            "weibull_over_log_normal": float(weibull_advantage(sizes) > 0.0)}


def closed_forms(brash, case_file, case):
    """Closed forms and regressions of one setting [N]; those that do not apply are left out."""
    done = subprocess.run([str(brash), "loads", str(case_file), "--json"], check=True, capture_output=True)
    found = {}
    for load in json.loads(done.stdout)["loads"]:
        formula = load["formula"]
        if "not_applicable" in load:
            continue
        if formula in ("Croasdale", "Lindqvist", "Riska", "Jeong"):
            found[formula.lower()] = load["horizontal"]
        elif formula == "Ralston":
            found["ralston_tresca" if "Tresca" in load["method"] else "ralston_johansen"] = load["horizontal"]
    if (case["structure.kind"], case.get("structure.breaking")) == ("cone", "upward"):
        found["edwards"] = edwards(width=case["structure.waterline_width"], thickness=case["ice.thickness"],
                                   flexural_strength=case["ice.flexural_strength"], water_density=case["water.density"])
    return found


def collect(brash, prediction, output):
    """One row a run of the campaign in `output`: arm, point, replicate, the values of the setting, and its numbers.

    A run that failed has no numbers of its own, only its inputs and closed forms.
    """
    settings = {s["setting"]: s["case"] for s in
                json.loads((output / "summary.json").read_text(encoding="utf-8"))["settings"]}
    known, rows = {}, []
    for row in read_table(output / "campaign.csv"):
        if row["setting"] not in known:
            file = output / "settings" / f"{settings[row['setting']]}.toml"
            case = flat(tomllib.loads(file.read_text(encoding="utf-8")))
            known[row["setting"]] = case, closed_forms(brash, file, case)
        case, forms = known[row["setting"]]
        arm, point = parts_of(row["setting"])
        inputs = {key: value for key, value in case.items() if key in row or key.startswith(("ice.", "water.density"))}
        folder = output / "cases" / row["case"]
        named = {"arm": arm, "point": point, "replicate": int(row["replicate"]), "status": row["status"], **study.program_of(folder),
                 **inputs, **forms}
        if row["status"] != "done":
            rows.append(named)
            continue
        start = json.loads((folder / "summary.json").read_text(encoding="utf-8"))["statistics_from"]
        history = read_history(folder / "history.csv")
        found = history_numbers(history, start, prediction.travel, speed_of(case))
        if prediction.growth:
            found.update(growth_numbers(*since_contact(history), prediction.growth, speed_of(case), case["structure.waterline_width"]))
        found.update(length_numbers(row, case))
        if prediction.ensemble.get("keep") == "run":
            found.update(shape_numbers(folder))
        rows.append({**named, **found})
    names = list(dict.fromkeys(name for row in rows for name in row))
    return [{name: row.get(name) for name in names} for row in rows]
