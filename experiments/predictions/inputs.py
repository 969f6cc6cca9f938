# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a prediction.toml and writes the campaign that it asks for."""
import json
import math
import os
import tomllib
from pathlib import Path

import study

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
GRAVITY = 9.80665  # m/s2, as brash::kGravity
TRAVEL_SPEEDS = ("structure.speed", "structure.motion.speed")
COLUMNS = [
    "horizontal.mean", "horizontal.standard_deviation", "horizontal.maximum", "horizontal.minimum", "horizontal.quantile_50",
    "horizontal.quantile_99", "vertical.mean", "mean_whole_history.horizontal", "mean_whole_history.vertical", "n_breaks",
    "breaking_frequency", "breaking_length_quantiles.05", "breaking_length_quantiles.50", "breaking_length_quantiles.95",
    "piece_area_quantiles.05", "piece_area_quantiles.50", "piece_area_quantiles.95",
]
KNOWN = {"title", "case", "presets", "ensemble", "travel", "set", "arm", "unknown", "criterion", "claim", "exponent", "quick",
         "measured", "growth"}
GROWTH = {"windows", "skip", "rate", "measured_width", "measured_speed"}
OF_UNKNOWN = {"key", "factor_of", "low", "high", "choices", "unit", "arms", "source", "why"}


class BadInput(Exception):
    """File, key, what is wrong and the remedy."""


def flat(table, prefix=""):
    """{section.key: value} of nested tables."""
    found = {}
    for name, value in table.items():
        found.update(flat(value, f"{prefix}{name}.") if isinstance(value, dict) else {prefix + name: value})
    return found


class Prediction:
    """A prediction.toml, checked."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.path = self.folder / "prediction.toml"
        if not self.path.is_file():
            raise BadInput(f"{self.path}: there is no such file; name a folder with a prediction.toml, such as m1 or m6/s1")
        try:
            self.table = tomllib.loads(self.path.read_text(encoding="utf-8"))
        except tomllib.TOMLDecodeError as error:
            raise BadInput(f"{self.path}: {error}; correct the line") from error
        self.name = self.folder.relative_to(HERE).as_posix() if self.folder.is_relative_to(HERE) else self.folder.name
        self.claims = self.table.get("claim", [])
        for key in ("title", "criterion"):
            if key not in self.table:
                self.refuse(key, "is missing", "add it; the other folders have examples")
        self.criterion = self.table["criterion"]
        self.arms = self.table.get("arm", {}) or {"": {}}
        self.unknowns = self.table.get("unknown", [])
        self.travel = self.table.get("travel", {})
        self.growth = self.table.get("growth")
        self.check()

    def refuse(self, key, what, remedy):
        raise BadInput(f"{self.path}: {key}: {what}; {remedy}")

    def check(self):
        for key in self.table.keys() - KNOWN:
            self.refuse(key, "is not a known key", f"take one of {', '.join(sorted(KNOWN))}")
        for i, unknown in enumerate(self.unknowns):
            key = f"unknown[{i}]"
            for name in unknown.keys() - OF_UNKNOWN:
                self.refuse(f"{key}.{name}", "is not a known key", f"take one of {', '.join(sorted(OF_UNKNOWN))}")
            if ("key" in unknown) == ("factor_of" in unknown):
                self.refuse(key, "needs a name", "write key = \"section.key\", or factor_of")
            if not unknown.get("source") or not unknown.get("why"):
                self.refuse(key, "a range without a source is a guess", "write source and why")
            if ("choices" in unknown) == ("low" in unknown):
                self.refuse(key, "needs a range", "write low and high, or choices")
            for name in ("low", "high"):
                if not isinstance(unknown.get(name, 0.0), (int, float)):
                    self.refuse(f"{key}.{name} = {unknown[name]!r}", "is not a number", "write the number, and its unit as `unit`")
            if "low" in unknown and not unknown["low"] < unknown.get("high", -math.inf):
                self.refuse(f"{key}.low = {unknown['low']}", "is not below high", "swap the two")
            for arm in set(unknown.get("arms", [])) - self.arms.keys():
                self.refuse(f"{key}.arms = {arm}", "is no arm of this prediction", f"take some of {', '.join(self.arms)}")
            if "factor_of" in unknown:
                self.check_factor(key, unknown)
        if self.growth is not None:
            for name in GROWTH - self.growth.keys():
                self.refuse(f"growth.{name}", "is missing", f"write {', '.join(sorted(GROWTH))}, as m5b does")
        if self.own_runs and not 1 <= self.ensemble["points"] <= self.ensemble["most_points"]:
            self.refuse("ensemble.points", "is above most_points", "lower it")

    def check_factor(self, key, unknown):
        """A factor needs the number that it multiplies, in the arms or for all of them."""
        for arm in unknown.get("arms", self.arms):
            if not isinstance({**flat(self.table.get("set", {})), **flat(self.arms.get(arm, {}))}.get(unknown["factor_of"]), (int, float)):
                self.refuse(f"{key}.factor_of = {unknown['factor_of']}", "has no number to multiply" + f" in arm {arm}" * bool(arm),
                            "write it in [set] or in each arm, in SI")

    @property
    def own_runs(self):
        """Whether the folder has runs; a sign may read those of other folders."""
        return "case" in self.table

    @property
    def ensemble(self):
        return self.table["ensemble"]

    @property
    def presets(self):
        return self.table.get("presets") or self.ensemble["presets"]

    def n_cases(self):
        """Cases of the least number of points."""
        return int(self.ensemble["points"]) * len(self.arms) * self.ensemble.get("replicates", 1)

    def names(self):
        """One name for each unknown."""
        return [unknown.get("key") or f"factor of {unknown['factor_of']}" for unknown in self.unknowns]


def setting_values(prediction, arm, point):
    """{key: value} of one setting, for the place `point` in the unit cube, shape=(n_unknowns,)."""
    values = flat(prediction.arms[arm])
    fixed = {**flat(prediction.table.get("set", {})), **values}
    ratios = []
    for unknown, place in zip(prediction.unknowns, point):
        if arm not in unknown.get("arms", [arm]):
            continue
        if "choices" in unknown:
            values[unknown["key"]] = unknown["choices"][int(place * len(unknown["choices"]))]
            continue
        value = unknown["low"] + place * (unknown["high"] - unknown["low"])
        if "factor_of" in unknown:
            values[unknown["factor_of"]] = rounded(value * fixed[unknown["factor_of"]])
        elif unknown["key"] == "length_over_thickness":
            ratios.append(value)
        else:
            values[unknown["key"]] = f"{value:.6g} {unknown['unit']}" if "unit" in unknown else rounded(value)
    case = case_values(prediction)
    for ratio in ratios:
        known = {**case, **fixed, **values}
        values["ice.youngs_modulus"] = rounded(modulus_of(ratio * known["ice.thickness"], known))
    if prediction.travel:
        speed = next(v[key] for v in (values, fixed, case) for key in TRAVEL_SPEEDS if key in v)
        values["output.statistics_from"] = rounded(prediction.travel["from"] / speed)
        values["time.duration"] = rounded(prediction.travel["end"] / speed)
    return values


def rounded(value):
    return float(f"{value:.6g}")


def case_values(prediction):
    path = prediction.folder / prediction.table["case"]
    return flat(tomllib.loads(path.read_text(encoding="utf-8")))


def modulus_of(length, values):
    """Young's modulus [Pa] of ice with the characteristic length l [m]: E = 12 (1 - nu^2) rho_w g l^4 / h^3."""
    nu, h = values.get("ice.poisson_ratio", 0.3), values["ice.thickness"]
    return 12.0 * (1.0 - nu**2) * values["water.density"] * GRAVITY * length**4 / h**3


def points_of(prediction, n):
    """The first n points of the folder's Sobol sequence, shape=(n, n_unknowns)."""
    return study.brash_module().sobol(n, len(prediction.unknowns), seed=prediction.ensemble["seed"])


def label_of(arm, i):
    return f"{arm}.s{i + 1:03d}" if arm else f"s{i + 1:03d}"


def parts_of(label):
    """Arm and number of the point, from 1, of a setting's name."""
    arm, _, point = label.rpartition("s")
    return arm.rstrip("."), int(point)


def written(key):
    """A key as a plan writes it: the section in quotes if it has a dot itself."""
    section, _, name = key.rpartition(".")
    return f'"{section}".{name}' if "." in section else key


def plan_text(prediction, points, folder, without=()):
    """The campaign of `points`, shape=(n, n_unknowns), as a plan that lies in `folder`: all arms of a point, then the next.

    without: names of settings that are left out, because their rows are there.
    """
    labels, columns = [], {}
    for i, point in enumerate(points):
        for arm in prediction.arms:
            if label_of(arm, i) in without:
                continue
            labels.append(label_of(arm, i))
            for key, value in setting_values(prediction, arm, point).items():
                columns.setdefault(key, []).append(value)
    uneven = [key for key, values in columns.items() if len(values) != len(labels)]
    if uneven:
        prediction.refuse("arm", f"not all arms have {', '.join(uneven)}", "give each arm the same keys")
    case = os.path.relpath(prediction.folder / prediction.table["case"], folder)
    fixed = {key: value for key, value in flat(prediction.table.get("set", {})).items() if key not in columns}
    quick = flat(prediction.table["quick"])
    return "\n".join([
        "# SPDX-License-Identifier: GPL-3.0-or-later",
        f"# Written by experiments/predictions/predict.py design {prediction.name}. Change prediction.toml, not this.", "",
        "[campaign]", f"case = {json.dumps(case)}", f"replicates = {prediction.ensemble.get('replicates', 1)}", "",
        "[set]", *(f"{written(key)} = {json.dumps(value)}" for key, value in fixed.items()), "",
        "[[grid]]", f"labels = {json.dumps(labels)}", *(f"{written(key)} = {json.dumps(v)}" for key, v in columns.items()), "",
        "[output]", f"keep = {json.dumps(prediction.ensemble.get('keep', 'history'))}",
        f"columns = {json.dumps(COLUMNS)}", "",
        "[quick]", "replicates = 1", "points = 1", *(f"set.{written(key)} = {json.dumps(value)}" for key, value in quick.items()), ""])
