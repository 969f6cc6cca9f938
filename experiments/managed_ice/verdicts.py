# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the runs meet criteria.toml."""
import numpy as np

import study

TRENDS = {"horizontal.mean": "load", "mean_offset": "offset"}


def trends(rows, level):
    """Jonckheere and Terpstra's tests, adjusted by Holm; a rising result has a positive statistic."""
    brash = study.brash_module()
    found = []
    for key, fixed in (("ice.thickness", {"field__size__median": 10.0}), ("field.size.median", {"ice__thickness": 1.0})):
        for column, name in TRENDS.items():
            groups = study.groups(rows, key, column, **fixed)
            found.append((f"mean {name} rises with {key}", brash.jonckheere_terpstra(list(groups.values()))))
    adjusted = brash.holm([test.p_value for _, test in found])
    return [{"criterion": text, "found": f"z = {test.statistic:.2f}, p = {p:.2g}", "met": bool(p < level and test.statistic > 0)}
            for (text, test), p in zip(found, adjusted)]


def precision(rows, limit):
    centre, half = study.mean_interval([row["horizontal.mean"] for row in rows])
    return {"criterion": f"the mean load of twenty fields is known to {limit:.0%}", "found": f"{half / centre:.1%}",
            "met": bool(half <= limit * centre)}


def balance(rows, limit):
    worst = max(abs(row["pull_over_load"] - 1.0) for row in rows)
    return {"criterion": f"the lines pull as the loads push, to {limit:.0%}", "found": f"{worst:.2%} at most",
            "met": bool(worst <= limit)}


def resonance(spectra, period, lines):
    frequency, density = spectra["offset"][:2]
    highest, nearest = int(np.argmax(density)), int(np.argmin(np.abs(frequency - 1.0 / period)))
    return {"criterion": "the highest line of the surge spectrum is at the natural period",
            "found": f"{frequency[highest]:.4f} Hz, natural {1.0 / period:.4f} Hz", "met": abs(highest - nearest) <= lines}


def oscillator(rows, limit):
    ratio = np.mean([row["oscillator_over_offset"] for row in rows])
    return {"criterion": f"a linear oscillator has the deviation of the offset to {limit:.0%}",
            "found": f"ratio {ratio:.3f}", "met": bool(abs(ratio - 1.0) <= limit)}


def judge(criteria, twenty, others, spectra, period):
    """Rows of verdicts.csv: criterion, what was found, and whether it is met."""
    rows = twenty + others
    return trends(rows, criteria["trends"]["level"]) + [
        precision(twenty, criteria["precision"]["half_width"]), balance(rows, criteria["balance"]["share"]),
        resonance(spectra, period, criteria["resonance"]["lines"]), oscillator(twenty, criteria["oscillator"]["share"])]


def show(judged):
    for row in judged:
        print(f"{'met    ' if row['met'] else 'not met'}  {row['criterion']}: {row['found']}")
