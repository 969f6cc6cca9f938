#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The default physics beside the program of commit 7bb887b4, the last before it was made faster: `./dev bench default`.

The older program is not built here. `default_bench.py PROGRAM` (`brash` built from 7bb887b4) writes its times to
default/before.json, each with the time of a loop that ran just before and just after it; without that file there are no ratios.
Runs break other amounts of ice, so the cost of a simulated second and of a solved sheet stand beside. The older program
refused every outline of the wall, so the wall has no ratio.
"""
import json
import pathlib
import sys
import tempfile
import time

from measure import BIN, ROOT, line, user_seconds

BEFORE = ROOT / "tests/benchmarks/default/before.json"
ICEBREAKER = "experiments/ships/icebreaker.toml"
RUNS = {  # name: file, settings, goal for the ratio
    "cone": ("experiments/validation/cone.toml", ["algorithm.preset=brash"], "<= 0.3"),
    "ship": (ICEBREAKER, ["time.duration=36"], "<= 0.25"),
    "wall": ("experiments/predictions/m5/wall.toml", ["time.duration=24"], ""),
    "field": ("tests/benchmarks/default/field.toml", [], "<= 0.7"),
}
WORDS = {"cone": "20 s of the validation case", "ship": "36 s of the icebreaker at 2 m/s", "wall": "24 s of a wall of 10 m",
         "field": "0.5 s of 10^4 floes awake"}


def loop_seconds():
    """CPU time of a loop that never changes: how fast the processor is just now [s]."""
    start = time.process_time()
    total = 0
    for i in range(20_000_000):
        total += i * i % 7
    return time.process_time() - start


def measured(program, name):
    """One run of `program` on one thread: its CPU time, that of the loop beside it, and what it did."""
    case, settings, _ = RUNS[name]
    overrides = [word for setting in (*settings, "output.frames_per_second=0") for word in ("--set", setting)]
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "run"
        loops = [loop_seconds()]
        seconds = user_seconds([program, "run", case, *overrides, "--threads", "1", "-o", out])
        loops.append(loop_seconds())
        summary = json.loads((out / "summary.json").read_text())
        stages = json.loads((out / "manifest.json").read_text())["volatile"]["stage_seconds"]
        rows = (out / "history.csv").read_text().splitlines()
    sheets = summary.get("sheets", {})
    return {"cpu_s": seconds, "loop_s": sum(loops) / len(loops), "breaks": summary["n_breaks"],
            "simulated_s": float(rows[-1].split(",")[0]), "stages": stages,
            "solved": sum(value for key, value in sheets.items() if key.startswith("solved_"))}


def default():
    """2. The default physics, one run of each kind on one thread: beside the program before, and by metre and sheet."""
    before = json.loads(BEFORE.read_text())["runs"] if BEFORE.exists() else {}
    lines = []
    for name, (_, _, goal) in RUNS.items():
        now = measured(BIN / "brash", name)
        if name in before:
            was = before[name]
            lines.append(line(f"{WORDS[name]}, default physics: CPU time / the same of 7bb887b4, each over a loop beside it",
                              [(now["cpu_s"] / now["loop_s"]) / (was["cpu_s"] / was["loop_s"])], goal))
        lines.append(line(f"{WORDS[name]}: CPU seconds of a simulated second", [now["cpu_s"] / now["simulated_s"]]))
        total = sum(now["stages"].values())
        lines += [line(f"{WORDS[name]}: share of the stage {stage}", [seconds / total])
                  for stage, seconds in now["stages"].items() if seconds > 0.01 * total]
        if now["solved"]:
            lines.append(line(f"{WORDS[name]}: milliseconds of the stage failure for a solved sheet",
                              [1e3 * now["stages"]["failure"] / now["solved"]]))
    return lines


if __name__ == "__main__":
    BEFORE.write_text(json.dumps({"program": "7bb887b4", "runs": {
        name: measured(sys.argv[1], name) for name, (_, _, goal) in RUNS.items() if goal}}, indent=1) + "\n")
