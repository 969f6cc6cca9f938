#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ice load, offset and the hardest line of a moored floater over time, a curve for each setting: offset.py CAMPAIGN PICTURE

Prints for each setting the means and the largest values from the start of its statistics, and checks the energies of the body.
"""
import pathlib
import sys
import tomllib

import matplotlib.pyplot as plt
import pandas as pd

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "managed_ice"))
import mooring  # noqa: E402

EVERY = 20  # steps between two places of which the lines are solved


def main():
    campaign, picture = map(pathlib.Path, sys.argv[1:])
    figure, (loads, offsets, lines) = plt.subplots(3, 1, figsize=(8, 6), sharex=True, layout="constrained")
    for folder in sorted((campaign / "cases").iterdir()):
        setting = folder.name.rsplit("-r", 1)[0]
        with open(campaign / "settings" / f"kulluk_{setting}.toml", "rb") as file:
            case = tomllib.load(file)
        history = pd.read_csv(folder / "history.csv")
        held = mooring.lines_over_time({name: history[name].to_numpy() for name in history}, case, EVERY)
        time, back = history.time[::EVERY], -held.offset[:, 0]
        hardest, load = held.tensions.max(axis=1) / 1e6, history.Fx / 1e6
        loads.plot(history.time, load.rolling(100).mean(), label=setting.removeprefix("thickness-"))
        offsets.plot(time, back)
        lines.plot(time, hardest)

        start = case["output"]["statistics_from"]
        late, late_load = time > start, load[history.time > start]
        print(f"{setting}: load {late_load.mean():.2f} MN, at most {late_load.max():.2f}; offset {back[late].mean():.2f} m, "
              f"at most {back[late].max():.2f}; hardest line {hardest[late].mean():.2f} MN, at most {hardest[late].max():.2f}")
        # The energies of the body close, and the ice pushes it the way that the ice drifts.
        assert history.body_error.abs().max() < 0.01 * history.body_ice_work.abs().max()
        assert back[late].mean() > 0
    loads.set(ylabel="ice load [MN], 1 s means")
    loads.legend(title="thickness")
    offsets.set(ylabel="offset [m]")
    lines.set(ylabel="hardest line [MN]", xlabel="time [s]")
    figure.savefig(picture)


if __name__ == "__main__":
    main()
