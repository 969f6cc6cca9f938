# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the claims of a sign, with what each test saw and what the claim asks, and of loads over the inputs."""
import math
import textwrap

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import LogLocator
from scipy import stats

import figures
import signs
from figures import BLUE, GREEN, GREY, RED

PAIRED = ("rises", "falls", "differs", "same", "ratio-within")
JITTER = 0.12


def name_of(claim):
    """The statistic over its divisors, without their sections, in short lines."""
    over = " × ".join(key.split(".")[-1] for key in claim.get("over", []))
    return textwrap.fill(claim["statistic"] + (f" / ({over})" if "×" in over else f" / {over}" if over else ""), 36)


def arms_of(axis, rows, claim):
    """Each point a line over the arms, as a ratio to its first arm; the mean of all with its 95 % interval."""
    arms = claim["arms"]
    lines = []
    for values in signs.by_point(rows, claim, mean=signs.geometric_mean).values():
        chosen = [values.get(arm) for arm in arms]
        if None not in chosen:
            lines.append(np.log(chosen) - math.log(chosen[0]))
    if not lines:
        return axis.text(0.5, 0.5, "no point has a number in every arm", ha="center", transform=axis.transAxes)
    x = np.arange(len(arms))
    for line in lines:
        axis.plot(x, np.exp(line), color=GREY, alpha=0.4, lw=0.8)
    if len(lines) >= signs.LEAST_POINTS:
        mean, half = zip(*(centre_and_half(column) for column in np.transpose(lines)))
        ends = np.exp(np.subtract(mean, half)), np.exp(np.add(mean, half))
        centre = np.exp(mean)
        axis.errorbar(x, centre, [centre - ends[0], ends[1] - centre], color=BLUE, marker="o", ms=4, lw=1.6, capsize=3)
    if claim["kind"] in ("same", "ratio-within"):
        low, high = ((1.0 / (1.0 + claim["margin"]), 1.0 + claim["margin"]) if claim["kind"] == "same"
                     else (claim["low"], claim["high"]))
        axis.fill_between([x[0], x[-1]], [1.0, low], [1.0, high], color=GREEN, alpha=0.15, lw=0, label="what the claim allows")
        axis.legend(fontsize=7)
    plain_logarithmic(axis)
    axis.set_xticks(x, arms)
    axis.set_xlim(-0.3, len(arms) - 0.7)
    axis.set_ylabel(f"{name_of(claim)},\nratio to {arms[0]}")


def plain_logarithmic(axis):
    """A logarithmic ordinate with plain numbers."""
    axis.set_yscale("log")
    axis.yaxis.set_major_locator(LogLocator(subs=(1.0, 1.5, 2.0, 3.0, 5.0, 7.0)))
    axis.yaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
    axis.yaxis.set_minor_locator(plt.NullLocator())


def centre_and_half(sample):
    mean, error, freedom = signs.student(sample)
    return mean, stats.t.ppf(0.975, freedom) * error


def limits_of(axis, rows, claim):
    """Each point a dot beside the limits; the mean of all with its 95 % interval."""
    kept = [math.exp(value) for value in signs.logarithms(rows, claim).values() if value is not None]
    if not kept:
        return axis.text(0.5, 0.5, "no point has a number", ha="center", transform=axis.transAxes)
    x = np.random.default_rng(1).uniform(-JITTER, JITTER, len(kept))
    axis.plot(x, kept, ".", color=GREY, alpha=0.6)
    if len(kept) >= signs.LEAST_POINTS:
        mean, half = centre_and_half(np.log(kept))
        centre, low, high = math.exp(mean), math.exp(mean - half), math.exp(mean + half)
        axis.errorbar([0.3], [centre], [[centre - low], [high - centre]], color=BLUE, marker="o", ms=4, capsize=3)
    if claim["kind"] == "within":
        axis.axhspan(claim["low"], claim["high"], color=GREEN, alpha=0.15, lw=0, label="what the claim allows")
    else:
        axis.axhline(claim["bound"], color=RED, ls="--", lw=1.0, label="the claim: above")
    axis.set_xlim(-0.5, 0.6)
    axis.set_xticks([0.0, 0.3], ["points", "mean"])
    axis.set_ylim(bottom=min(0.0, axis.get_ylim()[0]))
    axis.set_ylabel(name_of(claim))
    axis.legend(fontsize=7)


def rises_of(axis, rows, claim):
    """The rise of one statistic over the rise of the other; the claim is the half above the line."""
    one, other = signs.by_point(rows, claim), signs.by_point(rows, claim, claim["beside"])
    first, last = claim["arms"][0], claim["arms"][-1]
    ends = [(one[point], other[point]) for point in one]
    pairs = [(b[last] - b[first], a[last] - a[first]) for a, b in ends
             if None not in (a.get(first), a.get(last), b.get(first), b.get(last))]
    if not pairs:
        return axis.text(0.5, 0.5, "no point has a number in every arm", ha="center", transform=axis.transAxes)
    x, y = np.transpose(pairs) / 1e3
    axis.plot(x, y, ".", color=GREY)
    span = np.array([min(0.0, x.min()), max(x.max(), 0.0)])
    axis.plot(span, claim["times"] * span, "--", color=RED, lw=1.0, label=f"the claim: above {claim['times']:g} times")
    axis.set_xlabel(f"rise of {claim['beside']} [kN]")
    axis.set_ylabel(f"rise of {claim['statistic']} [kN]")
    axis.legend(fontsize=7)


def share_of(axis, outcome, claim):
    low, high = outcome.interval
    axis.errorbar([0.0], [outcome.effect], [[outcome.effect - low], [high - outcome.effect]], color=BLUE, marker="o", ms=4,
                  capsize=3)
    axis.axhline(claim["above"], color=RED, ls="--", lw=1.0, label="the claim: above")
    axis.set_xlim(-0.5, 0.5)
    axis.set_xticks([])
    axis.set_ylim(0.0, 1.0)
    axis.set_ylabel(f"share of the runs with\n{claim['statistic']}")
    axis.legend(fontsize=7)


def draw(prediction, outcomes, rows_of_claim, folder, name):
    """Writes `name`.png: a panel for each claim.

    outcomes: of the claims, in their order. rows_of_claim: the rows of numbers that a claim speaks of. Returns the panels.
    """
    figure, grid = plt.subplots(1, len(outcomes), figsize=(3.6 * len(outcomes), 3.3), squeeze=False, constrained_layout=True)
    for axis, outcome in zip(grid[0], outcomes):
        claim, rows = outcome.claim, rows_of_claim(outcome.claim)
        if claim["kind"] in PAIRED:
            arms_of(axis, rows, claim)
        elif claim["kind"] == "rises-beyond":
            rises_of(axis, rows, claim)
        elif claim["kind"] == "share":
            share_of(axis, outcome, claim)
        else:
            limits_of(axis, rows, claim)
        axis.set_title(f"{textwrap.fill(claim['text'], 40)}\np = {outcome.p:.2g}", fontsize=9)
    share_ordinates(grid[0])
    figure.suptitle(textwrap.fill(prediction.table["title"], 50 * len(outcomes)), fontsize=10)
    figures.save(figure, folder, name)
    return list(grid[0])


def share_ordinates(axes):
    """Panels that show the same quantity get the same limits."""
    for axis in axes:
        alike = [other for other in axes if other.get_ylabel() == axis.get_ylabel()]
        axis.set_ylim(min(a.get_ylim()[0] for a in alike), max(a.get_ylim()[1] for a in alike))


def exponents(prediction, rows, folder, name):
    """Writes `name`.png: the load over each input, on logarithmic axes, beside closed forms. Returns the panels."""
    inputs = prediction.table["exponent"]
    figure, grid = plt.subplots(1, len(inputs), figsize=(3.1 * len(inputs), 3.3), squeeze=False, constrained_layout=True)
    for axis, exponent in zip(grid[0], inputs):
        key, arms = exponent["of"], exponent["arms"]
        of_arm = [[row for row in rows if row["arm"] == arm] for arm in arms]
        x = [figures.shown(key, of[0][key]) for of in of_arm]
        points = [{row["point"]: row for row in of} for of in of_arm]
        for point in points[0]:
            axis.plot(x, [of[point]["mean"] / 1e3 for of in points], color=GREY, alpha=0.35, lw=0.8)
        lines = {"mean": ("mean of the program", BLUE, "-"), "quantile_99_0.1s": ("its 99 % quantile", BLUE, ":"),
                 **figures.CLOSED}
        for statistic, (label, colour, style) in lines.items():
            middle = [math.exp(np.mean([math.log(row[statistic]) for row in of])) / 1e3 for of in of_arm]
            axis.plot(x, middle, style, color=colour, marker="o", ms=3, lw=1.4, label=label)
        axis.set(xscale="log", yscale="log", xlabel=figures.LABELS[key])
        axis.set_xticks(x, [f"{value:.3g}" for value in x])
        axis.xaxis.set_minor_locator(plt.NullLocator())
        axis.yaxis.set_major_formatter(plt.FuncFormatter(lambda value, _: f"{value:g}"))
    for axis in grid[0]:
        axis.set_ylim(min(a.get_ylim()[0] for a in grid[0]), max(a.get_ylim()[1] for a in grid[0]))
    grid[0, 0].set_ylabel("horizontal load [kN]")
    grid[0, 0].legend(fontsize=6.5)
    figures.save(figure, folder, name)
    return list(grid[0])
