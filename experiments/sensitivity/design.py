#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes plan.toml: Morris's trajectories through the open inputs. design.py [TRAJECTORIES]

Each trajectory starts at a random point of a grid of 4 levels and changes one input after the other, in random order,
by 2/3 of its range (M. D. Morris, Technometrics 33 (1991) 161). Many random sets of trajectories are drawn, and the set
with the largest spread is taken (F. Campolongo, J. Cariboni, A. Saltelli, Environ. Modell. Softw. 22 (2007) 1509).
"""
import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent

LEVELS = 4
TRIALS = 500
SEED = 20240611

# Range of each open input, with what it rests on. Four levels each, from least to largest.
INPUTS = {
    "ice.density": (880.0, 920.0),  # kg/m3, sea ice
    "water.density": (1000.0, 1030.0),  # kg/m3, fresh to sea water: a basin may hold either
    "ice.poisson_ratio": (0.25, 0.35),
    "ice.friction_structure": (0.02, 0.05),  # about the measured 0.027
    "ice.friction_ice": (0.1, 0.5),
    "ice.compressive_strength": (0.36e6, 3.67e6),  # Pa, the measured range of Sec. 3.1.2
    "ice.crushing_factor": (0.3, 0.7),
    "contact.restitution": (0.0, 0.3),
    "contact.area": ["projected", "projected", "surface", "surface"],
    "contact.margin": (0.001, 0.01),  # m
    "hydrodynamics.form_drag": (0.5, 1.2),
    "hydrodynamics.form_drag_along": ["velocity", "velocity", "normal", "normal"],
    "hydrodynamics.shading_gap": (0.25, 0.66),  # of the thickness: from next to nothing to all that can be seen
    "hydrodynamics.skin_friction": (0.002, 0.01),
    # The laws of the water, docs/decisions/0005: half the floe's mass in every direction, or a plate's potential flow.
    "hydrodynamics.added_mass_law": ["isotropic", "isotropic", "plate", "plate"],
    "hydrodynamics.ventilation": [False, False, True, True],
    "hydrodynamics.structure_flow": [False, False, True, True],
    "failure.wedges": [[3, 4], [3, 4], [4, 5], [4, 5]],  # of 3 to 5; where their number is fixed, replicates are equal
}

# The preset `brash` with the trapezoid in place of the true edge: a tenth of the time. The keys are those of the
# setting `trapezoid` of validation/laws.toml.
MODEL = """algorithm.preset = "brash"
failure.model = "superposition"
failure.edge = "static"
failure.joint_loads = false
failure.judged = "centre-line"
failure.pattern = "disc"
"""


def value(key, level):
    """The value of an input at a level in [0, 1]."""
    span = INPUTS[key]
    if isinstance(span, list):
        return span[round(level * (LEVELS - 1))]
    return float(f"{span[0] + level * (span[1] - span[0]):.6g}")


def trajectory(random):
    """shape=(n_inputs + 1, n_inputs), levels in [0, 1]."""
    n, step = len(INPUTS), LEVELS / (2.0 * (LEVELS - 1))
    start = random.integers(0, LEVELS // 2, n) / (LEVELS - 1)
    up = random.random(n) < 0.5
    point = np.where(up, start, start + step)
    points = [point.copy()]
    for i in random.permutation(n):
        point[i] += step if up[i] else -step
        points.append(point.copy())
    return np.array(points)


def design(n_trajectories):
    random = np.random.default_rng(SEED)

    def spread(trajectories):
        return sum(np.linalg.norm(a[:, None] - b[None], axis=2).sum() ** 2
                   for i, a in enumerate(trajectories) for b in trajectories[:i])

    return max(([trajectory(random) for _ in range(n_trajectories)] for _ in range(TRIALS)), key=spread)


def main():
    n_trajectories = int(sys.argv[1]) if len(sys.argv) > 1 else 5
    points = [point for path in design(n_trajectories) for point in path]
    labels = [f"t{i // (len(INPUTS) + 1) + 1}p{i % (len(INPUTS) + 1):02d}" for i in range(len(points))]
    lines = "\n".join(f"{key} = {json.dumps([value(key, point[i]) for point in points])}" for i, key in enumerate(INPUTS))
    (HERE / "plan.toml").write_text(f"""# SPDX-License-Identifier: GPL-3.0-or-later
# Written by design.py: {n_trajectories} trajectories through {len(INPUTS)} inputs. Change that, not this.

[campaign]
case = "../validation/cone.toml"
replicates = 2

[set]
output.statistics_from = 5.823627287853578   # s, 7 m at 1.202 m/s: the axis passes the ice edge
{MODEL}time.duration = 14.143                  # s, 17 m of travel
output.frames_per_second = 0
output.checkpoint_interval = 0

[[grid]]
labels = {json.dumps(labels)}
{lines}

[output]
keep = "summary"
columns = [
  "horizontal.mean", "horizontal.quantile_99", "horizontal.mean_by_cause.crushing",
  "horizontal.mean_by_cause.floe_normal", "vertical.mean", "mean_whole_history.horizontal",
  "mean_whole_history.vertical",
]

[quick]
replicates = 1
points = 2
set.time.duration = 3
set.output.statistics_from = 2.9999   # s: too short for statistics, as before the edge
""", encoding="utf-8")


if __name__ == "__main__":
    main()
