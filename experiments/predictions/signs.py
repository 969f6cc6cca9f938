# SPDX-License-Identifier: GPL-3.0-or-later
"""Claims and their tests over the points of a prediction. README.md lists the kinds and the verdicts."""
import math

import numpy as np
from scipy import stats

ALPHA = 0.05
LEAST_POINTS = 3


class Outcome:
    """A tested claim: p of the claim, p of its opposite, the effect with its 95 % interval, and the points that took part."""

    def __init__(self, claim, p, opposite, effect, interval, n, left_out):
        self.claim, self.p, self.opposite = claim, p, opposite
        self.effect, self.interval, self.n, self.left_out = effect, interval, n, left_out


def value_of(row, claim, name=None):
    """The statistic of one run over the product of the numbers in `over`; None without a number."""
    value = row.get(name or claim["statistic"])
    for divisor in claim.get("over", []):
        if value is None or not row.get(divisor):
            return None
        value /= row[divisor]
    return value if value is not None and math.isfinite(value) else None


def geometric_mean(values):
    """exp of the mean logarithm; None where one has none."""
    return float(stats.gmean(values)) if min(values) > 0.0 else None


def by_point(rows, claim, name=None, mean=np.mean):
    """{point: {arm: mean over its replicates}} of the runs that the claim speaks of."""
    found = {}
    for row in rows:
        inside = all(low <= row[key] <= high for key, (low, high) in claim.get("where", {}).items())
        if inside and ("arms" not in claim or row["arm"] in claim["arms"]):
            found.setdefault(row["point"], {}).setdefault(row["arm"], []).append(value_of(row, claim, name))
    return {point: {arm: None if None in values else mean(values) for arm, values in arms.items()}
            for point, arms in found.items()}


def student(samples):
    """Mean, error and degrees of freedom of independent samples."""
    samples = np.asarray(samples, dtype=float)
    return samples.mean(), samples.std(ddof=1) / math.sqrt(len(samples)), len(samples) - 1


def one_sided(samples, limit, above):
    """p that the mean lies above (or below) the limit, by Student's t."""
    mean, error, freedom = student(samples)
    if error == 0.0:
        return 0.0 if (mean > limit) == above and mean != limit else 1.0
    t = (mean - limit) / error
    return float(stats.t.sf(t if above else -t, freedom))


def two_one_sided(samples, low, high):
    """TOST: p that the mean lies between the limits, and p of the opposite, that it lies outside, on either side."""
    inside = max(one_sided(samples, low, True), one_sided(samples, high, False))
    outside = min(1.0, 2.0 * min(one_sided(samples, low, False), one_sided(samples, high, True)))
    return inside, outside


def slopes(rows, claim):
    """Per point the slope of the logarithm along the arms, against the key `along`, or for two arms its difference."""
    arms = claim["arms"]
    at = {}
    if "along" in claim:
        for row in rows:
            at.setdefault(row["arm"], row[claim["along"]])
    places = np.array([at[arm] if at else i for i, arm in enumerate(arms)], dtype=float)
    if at and claim.get("scale", "logarithm") == "logarithm":
        places = np.log(places)
    if not at:
        places /= places[-1]  # the slope is then the change from the first arm to the last
    found = {}
    for point, values in by_point(rows, claim, mean=geometric_mean).items():
        chosen = [values.get(arm) for arm in arms]
        found[point] = None if None in chosen else float(np.polyfit(places, np.log(chosen), 1)[0])
    return found


def logarithms(rows, claim):
    """Per point the mean over its arms and replicates of the logarithm of the statistic."""
    return {point: None if None in arms.values() else float(np.mean(np.log(list(arms.values()))))
            for point, arms in by_point(rows, claim, mean=geometric_mean).items()}


def rises_beyond(rows, claim):
    """Per point the rise of the statistic from the first arm to the last, less `times` the rise of `beside`."""
    one, other = by_point(rows, claim), by_point(rows, claim, claim["beside"])
    first, last = claim["arms"][0], claim["arms"][-1]

    def rise(values):
        ends = values.get(first), values.get(last)
        return None if None in ends else ends[1] - ends[0]

    rises = {point: (rise(one[point]), rise(other[point])) for point in one}
    return {point: None if None in pair else pair[0] - claim["times"] * pair[1] for point, pair in rises.items()}


def share_interval(k, n, confidence=0.95):
    """Clopper and Pearson's interval of a share of k in n."""
    tail = 0.5 * (1.0 - confidence)
    low = 0.0 if k == 0 else stats.beta.ppf(tail, k, n - k + 1)
    high = 1.0 if k == n else stats.beta.ppf(1.0 - tail, k + 1, n - k)
    return float(low), float(high)


def share_outcome(rows, claim):
    """Exact binomial test over the runs."""
    flags = [row.get(claim["statistic"]) for row in rows if "arms" not in claim or row["arm"] in claim["arms"]]
    known = [flag for flag in flags if flag is not None]
    k, n = int(sum(known)), len(known)
    if n == 0:
        return Outcome(claim, 1.0, 1.0, math.nan, (math.nan, math.nan), 0, len(flags))
    return Outcome(claim, float(stats.binom.sf(k - 1, n, claim["above"])), float(stats.binom.cdf(k, n, claim["above"])),
                   k / n, share_interval(k, n), n, len(flags) - n)


def tested(rows, claim):
    """Tests one claim on the rows of numbers; each point is one independent sample."""
    kind = claim["kind"]
    if kind == "share":
        return share_outcome(rows, claim)
    logs = kind != "rises-beyond"
    if kind in ("rises", "falls", "differs", "same", "ratio-within"):
        samples = slopes(rows, claim)
    elif kind in ("exceeds", "within"):
        samples = logarithms(rows, claim)
    elif kind == "rises-beyond":
        samples = rises_beyond(rows, claim)
    else:
        raise ValueError(f"claim.kind = {kind}: is not known; take one of README.md's table")
    kept = [value for value in samples.values() if value is not None]
    if len(kept) < LEAST_POINTS:
        return Outcome(claim, 1.0, 1.0, math.nan, (math.nan, math.nan), len(kept), len(samples) - len(kept))
    p, opposite = p_values(kept, claim)
    mean, error, freedom = student(kept)
    half = stats.t.ppf(0.975, freedom) * error
    exponent = "along" in claim or not logs
    shown = (lambda x: x) if exponent else math.exp
    return Outcome(claim, p, opposite, shown(mean), (shown(mean - half), shown(mean + half)), len(kept),
                   len(samples) - len(kept))


def p_values(samples, claim):
    kind = claim["kind"]
    if kind in ("rises", "rises-beyond", "exceeds", "falls"):
        limit = math.log(claim["bound"]) if kind == "exceeds" else 0.0
        up = kind != "falls"
        return one_sided(samples, limit, up), one_sided(samples, limit, not up)
    if kind == "differs":
        return min(1.0, 2.0 * min(one_sided(samples, 0.0, True), one_sided(samples, 0.0, False))), 1.0
    if kind == "same":
        limit = math.log1p(claim["margin"])
        return two_one_sided(samples, -limit, limit)
    return two_one_sided(samples, math.log(claim["low"]), math.log(claim["high"]))


def holm(p):
    """As brash::statistics::holm."""
    order = np.argsort(p, kind="stable")
    adjusted = np.empty(len(p))
    adjusted[order] = np.maximum.accumulate(np.minimum(1.0, np.asarray(p)[order] * np.arange(len(p), 0, -1)))
    return adjusted


def judged(signs, family=None):
    """{sign: (verdict, adjusted p)} of {sign: outcomes of its claims}: all claims must hold, one may contradict.

    family: number of signs that Holm's method counts, those without runs included.
    """
    names = list(signs)
    missing = [1.0] * max(0, (family or len(names)) - len(names))
    claims = holm([max(o.p for o in signs[name]) for name in names] + missing)
    against = holm([min(1.0, len(signs[name]) * min(o.opposite for o in signs[name])) for name in names] + missing)
    found = {}
    for name, p, q in zip(names, claims, against):
        verdict = "shown" if p < ALPHA else "contradicted" if q < ALPHA else "open"
        found[name] = verdict, float(q if verdict == "contradicted" else p)
    return found
