#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A compliant tower in a host, the ice in a unit: the coupled run beside the program's own, and beside a stiff tower.

tower.py [-o FOLDER] [--seconds S] [--picture FILE.svg] [--brash PROGRAM]

The host integrates a mass on a spring and a dashpot. Each step it takes the ice load of the last step, moves the tower,
and tells the unit its place and mean velocity.
"""
import argparse
import csv
import json
import pathlib
import subprocess

import numpy as np
from scipy.linalg import expm

from fmu_host import Unit

CASE = pathlib.Path(__file__).resolve().parents[1] / "validation/second_reading.toml"
SPEED, START, STEP = 1.202, -7.0, 0.01  # of the case: [m/s], [m], [s]
MASS, STIFFNESS, DAMPING = 1e6, 8e6, 3e5  # of the tower: [kg], [N/m], [N s/m]
TOWER = {"structure.motion.mass": MASS, "structure.motion.stiffness": STIFFNESS, "structure.motion.damping": DAMPING}


def brash(options, *arguments, **sets):
    pairs = [f"{key.replace('__', '.')}={value}" for key, value in {"output__statistics_from": 0, **sets}.items()]
    subprocess.run([options.brash, *map(str, arguments), *[word for pair in pairs for word in ("--set", pair)]],
                   check=True, stdout=subprocess.DEVNULL)


class Oscillator:
    """Mass, spring and dashpot in plan under loads that are even in each step: exact."""

    def __init__(self, step):
        rates = np.array([[0.0, 1.0, 0.0], [-STIFFNESS / MASS, -DAMPING / MASS, 1.0 / MASS], [0.0, 0.0, 0.0]])
        self.over_a_step = expm(rates * step)
        self.state = np.zeros((2, 2))  # of x and y: stretch [m] and its rate [m/s]

    def advance(self, force):
        """@return the stretch at the end of the step, shape=(2,)."""
        with_force = np.hstack([self.state, np.reshape(force, (2, 1))])
        self.state = (with_force @ self.over_a_step.T)[:, :2]
        return self.state[:, 0]


def coupled(unit, seconds, step):
    """Time, place, velocity and load at the end of each step, shape=(n_steps, 6)."""
    ice = unit.instantiate()
    ice.enter_initialization()
    ice.exit_initialization()
    tower, stretch, force, rows = Oscillator(step), np.zeros(2), np.zeros(2), []
    for i in range(round(seconds / step)):
        time = i * step
        place = np.array([START + SPEED * time, 0.0]) + stretch
        after = tower.advance(force)
        velocity = np.array([SPEED, 0.0]) + (after - stretch) / step
        stretch = after
        ice.set(dict(zip(("structure_x", "structure_y", "structure_vx", "structure_vy"), (*place, *velocity))))
        ice.step(time, step)
        load = np.array(ice.get(["Fx", "Fy"]))
        force = -load  # loads have x as the ice drifts
        rows.append((time + step, *(place + step * velocity), *velocity, load[0]))
    ice.free()
    return np.array(rows)


def native(options, kind, **sets):
    """The same columns of a run of the program."""
    folder = options.folder / kind
    brash(options, "run", CASE, "-o", folder, "--replace", structure__motion__kind=kind,
          time__duration=options.seconds, **sets)
    with open(folder / "history.csv", encoding="utf-8") as file:
        table = list(csv.DictReader(file))
    names = ("time", "structure_x", "structure_y", "structure_vx", "structure_vy", "Fx")
    return np.array([[float(row[name]) for name in names] for row in table])


def reaction(loads, step=STEP):
    """Force of spring and dashpot on their foundation under ice loads that are given, shape=(n_steps,) [N]."""
    tower, found = Oscillator(step), np.empty(len(loads))
    for i, load in enumerate(loads):
        tower.advance(np.array([load, 0.0]))
        found[i] = STIFFNESS * tower.state[0, 0] + DAMPING * tower.state[0, 1]
    return found


def summary(force):
    return {"mean": force.mean(), "deviation": force.std(), "quantile_99": np.quantile(force, 0.99), "largest": force.max()}


def one_way_and_two_way(stiff, coupled, own, start):
    """Ice load and reaction from `start` [s] on: the load on a stiff tower prescribed to the tower, the run with the unit,
    and the program's own tower. The last two are samples of one process, so their difference is chance."""
    return {f"{kind}_{way}": summary(force[rows[:, 0] > start])
            for way, rows in (("one_way", stiff), ("two_way", coupled), ("own", own))
            for kind, force in (("ice_load", rows[:, 5]), ("reaction", reaction(rows[:, 5])))}


def picture(file, own, coupled, stiff):
    """Loads, and how far the tower bends, over time."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    # The same curves are the same bytes.
    plt.rcParams.update({"font.size": 9, "svg.hashsalt": "tower", "axes.spines.top": False, "axes.spines.right": False})
    drawing, (loads, bends) = plt.subplots(2, 1, figsize=(7, 4.6), sharex=True, constrained_layout=True)
    for rows, label, style in ((stiff, "stiff tower", {"color": "#b0b7c3", "lw": 0.8}),
                               (own, "tower of the program", {"color": "#1f4e79", "lw": 1.2}),
                               (coupled, "tower of the host, ice in a unit", {"color": "#c77700", "lw": 1.2, "ls": "--"})):
        loads.plot(rows[:, 0], rows[:, 5] / 1e3, label=label, **style)
        bends.plot(rows[:, 0], -1e3 * (rows[:, 1] - START - SPEED * rows[:, 0]), **style)
    loads.set_ylabel("ice load [kN]")
    loads.legend(frameon=False, fontsize=8, ncols=3, loc="lower left", bbox_to_anchor=(0, 1))
    bends.set_ylabel("bend [mm]")
    bends.set_xlabel("time [s]")
    drawing.savefig(file, metadata={"Date": None, "Creator": None})
    plt.close(drawing)


def figures(options):
    file = options.folder / "cone.fmu"
    brash(options, "export", "fmu", CASE, "-o", file, structure__motion__kind="driven")
    unit = Unit(file, options.folder / "cone")
    own = native(options, "compliant", **{key.replace(".", "__"): value for key, value in TOWER.items()})
    stiff = native(options, "towed")
    fine, coarse = coupled(unit, options.seconds, STEP), coupled(unit, options.seconds, 5 * STEP)
    if options.picture:
        picture(options.picture, own, fine, stiff)
    apart = np.abs(fine - own)
    touch = int(np.argmax(own[:, 5] != 0.0))  # the first step with a load
    foot = START + SPEED * own[:, 0]
    return {"seconds": options.seconds,
            "first_difference_of_place": apart[:touch + 2, 1].max(),
            "largest_difference_of_place": apart[:, 1].max(), "largest_difference_of_load": apart[:, 5].max(),
            "largest_stretch": np.abs(own[:, 1] - foot).max(), "largest_load": own[:, 5].max(),
            "largest_difference_of_place_at_five_times_the_step": np.abs(coarse[:, 1] - own[4::5, 1]).max(),
            "from_first_touch": one_way_and_two_way(stiff, fine, own, own[touch, 0]),
            "mean_load": {"own": own[:, 5].mean(), "coupled": fine[:, 5].mean(),
                          "coupled_at_five_times_the_step": coarse[:, 5].mean(), "stiff": stiff[:, 5].mean()}}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-o", dest="folder", type=pathlib.Path, default=pathlib.Path("results/coupling"))
    parser.add_argument("--seconds", type=float, default=8.0)
    parser.add_argument("--picture", type=pathlib.Path, help="loads and bends over time (SVG or PNG)")
    parser.add_argument("--brash", default="brash")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    found = figures(options)
    (options.folder / "coupling.json").write_text(json.dumps(found, indent=1) + "\n", encoding="utf-8")
    print(json.dumps(found, indent=1))


if __name__ == "__main__":
    main()
