# SPDX-License-Identifier: GPL-3.0-or-later
"""Tension and energy of the lines of a moored structure over a run, from its motion: docs/theory/structures.md, (B11)."""
import numpy as np
from scipy import optimize


def upper_end(horizontal, vertical, length, weight, stiffness):
    """Place of the upper end of an elastic line from its anchor on the bed: span and height [m]."""
    total = np.hypot(horizontal, vertical)
    below = vertical - weight * length  # vertical pull at the anchor; none while a part lies on the bed
    if below >= 0.0:
        low = np.hypot(horizontal, below)
        span = horizontal / weight * (np.arcsinh(vertical / horizontal) - np.arcsinh(below / horizontal))
        height = (total - low) / weight + (vertical - 0.5 * weight * length) * length / stiffness
    else:
        hanging = vertical / weight
        span = length - hanging + horizontal / weight * np.arcsinh(vertical / horizontal)
        height = (total - horizontal) / weight + 0.5 * vertical * hanging / stiffness
    return np.array([span + horizontal * length / stiffness, height])


def pull(span, height, line, guess):
    """Horizontal and vertical pull [N] of a line whose upper end lies there."""
    length, weight, stiffness = line

    def miss(logarithms):
        return upper_end(*np.exp(logarithms), length, weight, stiffness) - (span, height)

    found = optimize.root(miss, np.log(guess), tol=1e-10)
    if not found.success:
        raise ValueError(f"no catenary for span {span} m and height {height} m: {found.message}")
    return np.exp(found.x)


def energy(horizontal, vertical, span, height, line):
    """H x + V z - U* [J]."""
    length, weight, stiffness = line
    s = (np.arange(4000) + 0.5) / 4000 * length
    tension = np.hypot(horizontal, np.maximum(0.0, vertical - weight * (length - s)))
    return horizontal * span + vertical * height - np.mean(tension + 0.5 * tension**2 / stiffness) * length


def rotation(roll, pitch, heading):
    """The heading is turned first, the roll last, each about the structure's own axes."""
    (cr, cp, ch), (sr, sp, sh) = np.cos([roll, pitch, heading]), np.sin([roll, pitch, heading])
    return (np.array([[ch, -sh, 0], [sh, ch, 0], [0, 0, 1]]) @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
            @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]]))


class Mooring:
    """The lines over time: tensions at the fairleads [N], shape=(n, n_lines), their energy [J] and their pull along x [N],
    shape=(n,), and the offset from the feet [m], shape=(n, 3)."""

    def __init__(self, places, turns, feet, lines):
        self.offset = places - feet
        self.tensions = np.empty((len(places), len(lines)))
        self.energy, self.pull = np.zeros(len(places)), np.zeros(len(places))
        for number, line in enumerate(lines):
            self._add(number, turns, line[:3], line[3:6], line[6:])

    def _add(self, number, turns, anchor, fairlead, properties):
        guess = np.array([5e5, 2e5])
        for i, (away, angles) in enumerate(zip(self.offset, turns)):
            x, y, z = away + rotation(*angles) @ fairlead - anchor
            span = np.hypot(x, y)
            guess = pull(span, z, properties, guess)
            self.tensions[i, number] = np.hypot(*guess)
            self.energy[i] += energy(*guess, span, z, properties)
            self.pull[i] -= guess[0] * x / span


def lines_of(case):
    return np.array(case["structure"]["motion"]["lines"], dtype=float)


def lines_over_time(history, case, every=1):
    """history: columns of history.csv by name; case: the resolved case; every: steps between two rows of the result."""
    structure = case["structure"]
    rows = slice(None, None, every)
    zero = np.zeros_like(history["time"])
    places = np.column_stack([history.get(name, zero)[rows] for name in ("structure_x", "structure_y", "structure_z")])
    turns = np.column_stack([history.get(f"structure_{name}", zero)[rows] for name in ("roll", "pitch", "heading")])
    feet = np.zeros_like(places)
    feet[:, 0] = structure["speed"] * history["time"][rows] - structure["start_distance"]
    return Mooring(places, turns, feet, lines_of(case))


def surge_stiffness(case, way=0.1):
    """Stiffness of the lines along x about the place without loads [N/m], from a way to either side."""
    places = np.array([[-way, 0.0, 0.0], [way, 0.0, 0.0]])
    held = Mooring(places, np.zeros_like(places), 0.0, lines_of(case))
    return (held.pull[0] - held.pull[1]) / (2.0 * way)
