# SPDX-License-Identifier: GPL-3.0-or-later
"""The default physics beside an older program: `./dev bench default`.

An old pass takes a quarter of an hour, so its times are kept in default_runs.json, beside those of a loop that does not
change. Each run is measured between two such loops, and their times stand for the speed of the machine.
"""
import json
import pathlib
import resource
import tempfile
from dataclasses import dataclass

from measure import BIN, ROOT, line, user_seconds

KEPT = ROOT / "tests/benchmarks/default_runs.json"


@dataclass
class Case:
    """A run, the part of the old time that is asked for, and the structure's speed [m/s]."""
    path: str
    seconds: float
    limit: float
    speed: float
    settings: tuple = ()


CASES = {
    "cone": Case("experiments/validation/demo.toml", 20, 0.3, 1.202),
    "icebreaker": Case("experiments/ships/icebreaker.toml", 36, 0.25, 2.0),
    "wall in thin ice": Case(
        "experiments/predictions/m5/wall.toml", 15, 0.25, 0.05,
        ("ice.youngs_modulus=107e6", "ice.flexural_strength=44e3", "ice.compressive_strength=46e3", "ice.friction_ice=0.15",
         "ice.friction_structure=0.1", "ice.density=926", "water.density=1010", "structure.height=1.2")),
    "10^4 floes awake": Case("experiments/fields/cone.toml", 0.5, 0.7, 1.202, ("field.length=790", "field.width=715")),
}


def loop_seconds():
    """User CPU time of a loop that never changes [s]."""
    before = resource.getrusage(resource.RUSAGE_SELF).ru_utime
    place, x = 0, 0.5
    cells = list(range(1 << 15))
    for i in range(4_000_000):
        x = 3.7 * x * (1.0 - x)
        place = (place * 1103515245 + i) & 32767
        cells[place] = (cells[place] + i) & 65535
    return resource.getrusage(resource.RUSAGE_SELF).ru_utime - before


def measured(case, program, folder):
    """User CPU time of a run over that of the loop, and what the run says of its sheets."""
    overrides = [word for setting in (f"time.duration={case.seconds}", *case.settings) for word in ("--set", setting)]
    before = loop_seconds()
    seconds = user_seconds([program, "run", case.path, *overrides, "--threads", "1", "-o", folder, "--replace"])
    loops = seconds / (0.5 * (before + loop_seconds()))
    stages = json.loads((folder / "manifest.json").read_text())["volatile"]["stage_seconds"]
    sheets = json.loads((folder / "summary.json").read_text()).get("sheets", {})
    return {"loops": loops, "failure": stages["failure"] / sum(stages.values()),
            "solves": sheets.get("solved_coarse", 0) + sheets.get("solved_cubic", 0)}


def default():
    """9. The preset `brash` beside program 7bb887b4, one thread."""
    kept, lines = json.loads(KEPT.read_text()), []
    with tempfile.TemporaryDirectory() as folder:
        for name, case in CASES.items():
            now, old = measured(case, BIN / "brash", pathlib.Path(folder) / "run"), kept["runs"][name]
            lines.append(line(f"{name}, {case.seconds:g} s: CPU time / that of {kept['program']}",
                              [now["loops"] / old["loops"]], f"<= {case.limit}"))
            seconds = now["loops"] * kept["loop_seconds"]
            lines.append(line(f"{name}: CPU seconds for a metre of way", [seconds / (case.speed * case.seconds)]))
            if now["solves"]:
                lines.append(line(f"{name}: milliseconds of failure model for a solved sheet",
                                  [1e3 * now["failure"] * seconds / now["solves"]]))
    return lines
