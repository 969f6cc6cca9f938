#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the program beside its peers and limits: `./dev bench [LINE...]`, all lines without arguments.

Each line is a ratio of two times of one run, taken in turn, the median of at least five. Times are user CPU times of the
processes unless the line says otherwise, so that other work on the machine enters the ratio little. The results replace
the same lines of docs/performance.json. docs/performance.md shows ten of its rows; `performance.py --page` writes it alone.
"""
import datetime
import json
import operator
import os
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile
import time

from default_bench import default
from measure import BIN, REPETITIONS, ROOT, line, output_and_seconds, ratios, user_seconds
from peers import plate, rigid_bodies, rigid_body_peers, threads_beside_bullet
from schedule_bench import schedule

CASE = "experiments/validation/cone.toml"
UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}  # of Google Benchmark


def run_seconds(folder, *settings):
    """User CPU time of one run of the validation case with `settings` [s]."""
    overrides = [word for setting in settings for word in ("--set", setting)]
    return user_seconds([BIN / "brash", "run", CASE, *overrides, "-o", pathlib.Path(folder) / "run"])


def google_benchmark(name, pattern, field="cpu_time"):
    """Times of each benchmark whose name matches `pattern`: {name: [s, ...]}."""
    output = subprocess.run(
        [str(BIN / name), f"--benchmark_filter={pattern}", f"--benchmark_repetitions={REPETITIONS}",
         "--benchmark_min_time=0.1", "--benchmark_format=json"],
        cwd=ROOT, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    times = {}
    for row in json.loads(output)["benchmarks"]:
        if row.get("run_type") != "iteration":
            continue
        times.setdefault(row["name"], []).append(row[field] * UNITS[row["time_unit"]])
    return times


def coupled():
    """1. The coupled step against Bullet's own world over the same bodies."""
    output = subprocess.run([str(BIN / "bench_coupled"), "10", str(REPETITIONS)], cwd=ROOT, check=True,
                            stdout=subprocess.PIPE).stdout
    runs = json.loads(output)["runs"]
    return [line("coupled step / Bullet's world over the same floes, sheet, cone and iterations, first 10 s of the "
                 "validation case", [run["coupled_s"] / run["bullet_s"] for run in runs], "<= 0.85")]


def real_time():
    """2. Simulated seconds per second of one core."""
    with tempfile.TemporaryDirectory() as folder:
        samples = [10.0 / run_seconds(folder, "time.duration=10") for _ in range(REPETITIONS)]
    return [line("simulated seconds per CPU second, first 10 s of the validation case, results written", samples)]


def steps(floes, n_steps, *options):
    """Water and world of single steps of fields of floes, all active: rows of bench_growth."""
    output = subprocess.run([str(BIN / "bench_growth"), *options, str(n_steps), *map(str, floes)], cwd=ROOT, check=True,
                            stdout=subprocess.PIPE).stdout
    return json.loads(output)


def growth():
    """2. Water and world of one step against the number of floes."""
    sizes = (100, 300, 1000, 3000, 10000)
    # All sizes in each repetition, for the speed of a processor that others use too changes within seconds.
    runs = [[row for row in steps(sizes, 4) if row["layers"] == 3] for _ in range(REPETITIONS)]
    each = [[statistics.median(a + b for a, b in zip(row["water_s"], row["world_s"])) / row["floes"] for row in run]
            for run in runs]
    rubble = runs[0]
    lines = [line("CPU microseconds per floe and step, 100 floes of rubble", [1e6 * times[0] for times in each])]
    lines += [line(f"CPU time per floe and step, {n} floes / 100 floes ({row['contacts'] / row['floes']:.1f} bearing "
                   f"points per floe / {rubble[0]['contacts'] / rubble[0]['floes']:.1f})",
                   [times[i] / times[0] for times in each], "<= 1")
              for i, (n, row) in enumerate(zip(sizes, rubble)) if i > 0]
    peer = [[statistics.median(row["bullet_s"]) / row["floes"] for row in run] for run in runs]
    lines += [line(f"water and world / Bullet's own world over the same floes, {n} floes",
                   [own[i] / bullet[i] for own, bullet in zip(each, peer)], "< 1") for i, n in enumerate(sizes)]
    lines.append(line("CPU time per floe and step of Bullet's own world, 10000 floes / 100 floes",
                      [times[-1] / times[0] for times in peer]))
    largest = [run[-1] for run in runs]
    lines.append(line("CPU time of a step, 10^4 floes of rubble, all asleep / all awake",
                      [statistics.median(row["settled_s"]) / statistics.median(
                          a + b for a, b in zip(row["water_s"], row["world_s"])) for row in largest], "<= 0.01"))
    lines.append(line("kilobytes on the heap per floe, 10^4 floes", [1e-3 * rubble[-1]["bytes"] / rubble[-1]["floes"]]))
    return lines


def many():
    """2. Water and world of one step with 10^3 to 10^5 floes in contact, the step that finds neighbours left out."""
    sizes, lines = (1000, 10000, 100000), []
    runs = [steps(sizes, 4, "--alone", "--awake", "--rubble") for _ in range(REPETITIONS)]
    each = [[statistics.median(a + b for a, b in zip(row["water_s"], row["world_s"])) / row["floes"] for row in run]
            for run in runs]
    lines.append(line("CPU microseconds per floe and step, 10^3 floes of rubble", [1e6 * times[0] for times in each]))
    for i, n in ((1, "10^4"), (2, "10^5")):
        points = [runs[0][k]["contacts"] / runs[0][k]["floes"] for k in (i, 0)]
        lines.append(line(f"CPU time per floe and step, {n} floes / 10^3 floes ({points[0]:.1f} bearing points per floe / "
                          f"{points[1]:.1f})", [times[i] / times[0] for times in each]))
    lines.append(line("kilobytes on the heap per floe, 10^5 floes", [1e-3 * runs[0][2]["bytes"] / runs[0][2]["floes"]]))
    return lines


def threads():
    """2. Two threads against one, wall time of water and world: it needs two idle cores."""
    limits = {300: ">= 1.5", 10000: ">= 1.8"}
    times = {(n, of): [] for n in limits for of in (1, 2)}
    for _ in range(REPETITIONS):
        for of in (1, 2):
            for row in steps(limits, 9, "--alone", f"--threads={of}"):
                if row["layers"] == 3:
                    times[min(limits, key=lambda n: abs(n - row["floes"])), of].append(statistics.median(row["wall_s"]))
    return [line(f"wall time of a step on one thread / on two, {n} floes of rubble", ratios(times[n, 1], times[n, 2]), limit)
            for n, limit in limits.items()]


def length():
    """3. The same run in a channel ten times as long: nothing may grow with the length of the edge."""
    times = {50: [], 500: []}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(REPETITIONS):
            for metres, samples in times.items():
                samples.append(run_seconds(folder, "time.duration=10", f"field.length={metres}"))
    return [line("CPU time of the first 10 s in 500 m of ice / in 50 m", ratios(times[500], times[50]), "<= 1")]


def moving(simulation):
    """How many floes the next step moves; it is taken."""
    def places():
        return {floe.id: [tuple(corner) for corner in floe.rings[0]] for floe in simulation.frame().floes}
    before = places()
    simulation.step()
    return sum(before.get(floe, place) != place for floe, place in places().items())


def channel():
    """3. A channel driven ten times as far, with floes at rest asleep."""
    sys.path.insert(0, str(ROOT / "build/release/python"))
    import brash  # what this line alone needs, built before
    ten_metres, looks, steps_between, whole, last, last_of_one = 10, 50, 49, [], [], []
    for seed in range(1, REPETITIONS + 1):
        simulation = brash.Simulation(brash.Case.from_file(
            ROOT / "tests/experiments/long.toml", {"random.seed": seed, "field.length": 120}))
        parts, of_one = [], []
        for _ in range(ten_metres):
            seconds = floes = 0
            for _ in range(looks):
                before = time.process_time()
                simulation.step(steps_between)
                seconds += time.process_time() - before
                floes += moving(simulation)
            parts.append(seconds)
            of_one.append(seconds / floes)
        # In the third 10 m the channel behind the structure has filled.
        whole.append(sum(parts) / (ten_metres * parts[2]))
        last.append(parts[-1] / parts[2])
        last_of_one.append(of_one[-1] / of_one[2])
    return [line("CPU time of 100 m of channel / of ten times its third 10 m, tests/experiments/long.toml", whole, "<= 1"),
            line("CPU time of its tenth 10 m / of its third", last, "<= 1"),
            line("the same for each moving floe; their number differs between stretches", last_of_one)]


def water():
    """4. The water of 10^4 floes against the world's step over them."""
    names = {1: "afloat", 3: "of rubble"}
    return [line(f"water / world step, 10^4 floes {names[row['layers']]}", ratios(row["water_s"], row["world_s"]),
                 "<= 0.1") for row in steps([10000], REPETITIONS)]


def geometry():
    """5. One crack event of the kernel beside its peers, CPU time of the thread."""
    times = google_benchmark("bench_geometry", "^(kernel_event/(100|1000|10000|100000)/32|(cgal|geos|clipper|boost)_event)/",
                             "real_time")
    rows = [(*name.split("/")[:2], samples) for name, samples in times.items()]
    kernel = {int(size): samples for name, size, samples in rows if name == "kernel_event"}
    lines = [line(f"crack event on an edge of {size} vertices, s", samples, "<= 80e-6") for size, samples in kernel.items()]
    lines.append(line("crack event, 10^2 to 10^5 vertices: slowest / fastest size",
                      [max(run) / min(run) for run in zip(*kernel.values())], "<= 1.3"))
    # On an edge of 10^2 vertices the peers have next to nothing to read: told without a limit.
    return lines + [line(f"crack event on an edge of {size} vertices: kernel / {name.split('_')[0]}",
                         ratios(kernel[int(size)], samples), *(["< 1"] if int(size) >= 1000 else []))
                    for name, size, samples in rows if name != "kernel_event"]


def failure():
    """5. The failure models beside the plate solution."""
    times = google_benchmark("bench_failure", "(assess/network|fem_row)")
    plate = next(samples for name, samples in times.items() if name.startswith("fem_row"))
    network = next(samples for name, samples in times.items() if name.startswith("assess"))
    return [line("one assessment: network / plate solve", ratios(network, plate), "< 1"),
            line("plate solve, CPU seconds", plate)]


def campaign():
    """7. Cost that a campaign adds to its runs."""
    settings = ("time.duration=1", "output.frames_per_second=0")
    with tempfile.TemporaryDirectory() as folder:
        plan = pathlib.Path(folder) / "plan.toml"
        plan.write_text(f'[campaign]\ncase = "{ROOT / CASE}"\nreplicates = {REPETITIONS}\n')
        overrides = [word for setting in settings for word in ("--set", setting)]
        together = [user_seconds([BIN / "brash", "campaign", plan, "--jobs", "1", *overrides, "-o",
                                  pathlib.Path(folder) / f"campaign{i}"]) for i in range(REPETITIONS)]
        apart = [sum(run_seconds(folder, *settings, f"random.replicate={k}") for k in range(REPETITIONS))
                 for _ in range(REPETITIONS)]
    return [line("CPU seconds a campaign adds to each of its cases", [(a - b) / REPETITIONS
                                                                  for a, b in zip(together, apart)], "< 0.1")]


def workers():
    """7. Two workers against one, wall time: it needs two idle cores."""
    settings = ("time.duration=8", "output.frames_per_second=0")
    times = {1: [], 2: []}
    with tempfile.TemporaryDirectory() as folder:
        plan = pathlib.Path(folder) / "plan.toml"
        plan.write_text(f'[campaign]\ncase = "{ROOT / CASE}"\nreplicates = 8\n')
        overrides = [word for setting in settings for word in ("--set", setting)]
        for i in range(REPETITIONS):
            for jobs, samples in times.items():
                start = time.monotonic()
                user_seconds([BIN / "brash", "campaign", plan, "--jobs", jobs, *overrides, "-o",
                              pathlib.Path(folder) / f"campaign{jobs}_{i}"])
                samples.append(time.monotonic() - start)
    return [line("efficiency of two workers, 8 runs of 8 s of the validation case (wall time)",
                 [0.5 * r for r in ratios(times[1], times[2])], ">= 0.95")]


def recording():
    """7. Recording, as a share of a run's wall time."""
    shares = []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(REPETITIONS):
            run_seconds(folder, "time.duration=20")
            seconds = json.loads((pathlib.Path(folder) / "run/manifest.json").read_text())["volatile"]["stage_seconds"]
            shares.append(seconds["recording"] / sum(seconds.values()))
    return [line("frames, checkpoints and results written, share of the wall time of 20 s of the validation case", shares,
                 "<= 0.02")]


def build():
    """8. One changed source file, rebuilt and linked without the compiler's cache."""
    lines = []
    for source in ("modules/rigid_body/src/world.cpp", "modules/simulation/src/simulation.cpp"):
        samples = []
        for _ in range(REPETITIONS):
            (ROOT / source).touch()
            samples.append(user_seconds(["cmake", "--build", "build/release", "--target", "brash", "--", "--quiet"],
                                        env={**os.environ, "CCACHE_DISABLE": "1"}))
        lines.append(line(f"CPU seconds to rebuild the program after a change in {source}", samples, "< 30"))
    return lines


def sheets():
    """5. Sheets that a run solved, stage by stage."""
    runs = [json.loads(output_and_seconds([BIN / "bench_sheets", "tests/corpus/sheets/solved.txt", 5])[0])
            for _ in range(REPETITIONS)]
    return [line(f"milliseconds of a sheet on the {mesh} mesh: {stage}", [run[mesh][f"{stage}_ms"] for run in runs])
            for mesh in ("coarsest", "coarse", "fast") for stage in ("mesh", "membrane", "bending", "stress", "all")]


LINES = {function.__name__: function
         for function in (coupled, real_time, default, growth, many, threads, threads_beside_bullet, schedule, length, channel, water,
                          geometry, failure, plate, sheets, rigid_bodies, rigid_body_peers, campaign, workers, recording, build)}
TARGETS = {"coupled": ["bench_coupled"], "growth": ["bench_growth"], "many": ["bench_growth"], "threads": ["bench_growth"],
           "threads_beside_bullet": ["bench_threads"], "schedule": ["bench_schedule"], "channel": ["brash_python"], "water": ["bench_growth"],
           "geometry": ["bench_geometry"], "failure": ["bench_failure"], "plate": ["bench_plate"], "sheets": ["bench_sheets"],
           "rigid_bodies": ["bench_rigid_bodies"], "rigid_body_peers": ["bench_rigid_bodies"]}

# The rows of the page: line, how its figure begins in performance.json, and its words for a reader.
SHOWN = [
    ("default", "20 s of the validation case: CPU seconds", "seconds of a core for a second of the validation case, default physics"),
    ("default", "36 s of the icebreaker at 2 m/s: CPU seconds", "the same, the first 36 s of an icebreaker at 2 m/s"),
    ("real_time", "simulated seconds per CPU second", "simulated seconds in a second of one core, validation case"),
    ("coupled", "coupled step / Bullet's world", "a coupled step / a step of Bullet's own world with the same bodies"),
    ("growth", "water and world / Bullet's own world over the same floes, 10000", "water and bodies of a step / Bullet's own world, $10^4$ floes of rubble"),
    ("growth", "CPU time per floe and step, 10000", "a step for each floe of a pack of $10^4$ / of a pack of 100"),
    ("growth", "CPU time of a step, 10^4 floes of rubble, all asleep", "a step of $10^4$ floes asleep / awake"),
    ("threads", "wall time of a step on one thread / on two, 10000", "wall time on one thread / on two, $10^4$ floes"),
    ("length", "CPU time of the first 10 s in 500 m", "a run in 500 m of ice / in 50 m"),
    ("geometry", "crack event on an edge of 100000 vertices: kernel / boost",
     "a crack on an edge of $10^5$ vertices / the fastest peer, Boost.Geometry"),
    ("plate", "6 plates with mesh", "a plate solution / FreeFem++ at equal accuracy"),
    ("rigid_bodies", "174 floes, every engine within 5 mm and 1 %: program / ODE",
     "a pack of 174 floes that comes to rest / ODE at equal accuracy"),
]

INTRODUCTION = """# Performance

*How fast is the program, beside which programs, and what limits it?*

"A / B" is the time of A over the time of B, both from one run on one machine. Times are user CPU times, unless a row says
otherwise. A value is the median of at least 5 samples, with their range, or one run.
"""

NOTES = """![Speed-up over threads, where their time goes, and a step on 8 and on 16 threads](figures/schedule.svg)

*Speed-up of one step of rubble on many threads, by simulation (`./dev bench schedule`). The parts between loops limit a large pack,
and the few strips of the solver a small one. Dashes are the critical path. A shade reaches down to exchanges between cores that
cost 5 times as much.*

The simulation shares the measured chunks of each loop as `Workers` does. It leaves out shared caches, slower processors under
load and the system's scheduling.

## Limits of the comparisons

- **ODE** is slower than the program on this pack if ice does not crush. Siconos and Yade take a minute and more for each simulated
  second, so they were compared on 13 floes (`./dev bench rigid_body_peers`).
- **Bullet's threads** (`./dev bench threads_beside_bullet`) get the program's state before each step. Their result differs from run
  to run, and the program's has the same bits on any number of threads. They spin while they wait, so their times mean little on a
  machine that others use.

## Why a floe costs more in a large pack

Memory is the reason. A floe in a pack of $10^4$ takes only 1.10 times the instructions (Valgrind). But in each of 30 sweeps the
solver reads 64 bytes for each contact point, and 260 more for each point that presses. Beyond some hundred floes these bytes do not
fit a core's own cache. Bullet's own world grows more.

Huge pages take 0.93 to 0.97 of the time at $10^4$ floes (`GLIBC_TUNABLES=glibc.malloc.hugetlb=1`).

## What did not make the default faster

- `-O3`, or arithmetic without errno and traps: no gain.
- AVX2: 0.8 to 0.9 of a sheet's time, and other results on other processors.
- A coarser first mesh: 0.6 of a coarse sheet's time, but so few sheets are left that a run gains next to nothing.
- Floes that sleep (`time.settle_speed`): no floe of the cone gets slow enough in 20 s.
- Verdicts predicted by the edge's own motion: wrong by up to twelve times in its first tenth of a second.
"""


LIMITS = {"<": operator.lt, "<=": operator.le, ">=": operator.ge}


def met(row):
    """Whether the median keeps its limit, in words; empty without one."""
    if not row["limit"]:
        return ""
    sign, number = row["limit"].split()
    return "yes" if LIMITS[sign](row["median"], float(number)) else "**no**"


def excess(row):
    """By which factor the median misses its limit."""
    sign, number = row["limit"].split()
    ratio = row["median"] / float(number)
    return ratio if sign.startswith("<") else 1 / ratio


def number_and_range(row):
    spread = f" ({row['lowest']:.3g} to {row['highest']:.3g})" if row["n"] > 1 else ""
    return f"{row['median']:.3g}{spread}"


def shown(results):
    """The rows of the page's table, as far as their lines are measured."""
    for name, beginning, words in SHOWN:
        if name in results:
            [row] = [row for row in results[name]["lines"] if row["what"].startswith(beginning)]
            yield f"| {words} | {number_and_range(row)} | {row['limit']} | {met(row)} | `{name}` |"


def page(results):
    """The page of the documents."""
    verdicts = [(row, met(row)) for entry in results.values() for row in entry["lines"] if row["limit"]]
    missed = [row for row, answer in verdicts if answer != "yes"]
    beside = [row for row in missed if not any(row["what"].startswith(beginning) for _, beginning, _ in SHOWN)]
    worst = [f" The worst of {len(beside)} misses that only the file has: {row['what']}, {number_and_range(row)}, limit {row['limit']}."
             for row in sorted(beside, key=excess)[-1:]]
    dates = sorted(entry["date"] for entry in results.values())
    machines = sorted({entry["machine"] for entry in results.values()})
    return "\n".join([
        INTRODUCTION, "| figure | median | limit | met | line |", "|---|---|---|---|---|", *shown(results), "",
        f"Measured from {dates[0]} to {dates[-1]} on {' and '.join(machines)}. `./dev bench LINE` measures a line again, and `./dev bench`",
        "all. `docs/performance.json` has every row with its load and its range.", "",
        f"{len(verdicts) - len(missed)} of {len(verdicts)} limits are met.{''.join(worst)}", "", NOTES])


def processor():
    for row in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if row.startswith("model name"):
            return row.split(":")[1].strip()
    return platform.machine()


def main():
    path = ROOT / "docs/performance.json"
    if sys.argv[1:] == ["--page"]:
        (ROOT / "docs/performance.md").write_text(page(json.loads(path.read_text())))
        return
    unknown = [name for name in sys.argv[1:] if name not in LINES]
    if unknown:
        sys.exit(f"no line {', '.join(unknown)}; there are: {', '.join(LINES)}")
    wanted = [name for name in LINES if name in (sys.argv[1:] or LINES)]
    targets = sorted({target for name in wanted for target in TARGETS.get(name, [])})
    if targets:
        subprocess.run(["cmake", "--build", "build/release", "--target", *targets, "--", "--quiet"], cwd=ROOT, check=True)
    for name in wanted:
        print(f"{name}: {LINES[name].__doc__}", file=sys.stderr)
        lines = LINES[name]()
        results = json.loads(path.read_text()) if path.exists() else {}
        results[name] = {"date": datetime.date.today().isoformat(), "machine": f"{os.cpu_count()} cores, {processor()}",
                         "load": os.getloadavg()[0], "command": f"./dev bench {name}", "lines": lines}
        for row in lines:
            print(f"  {row['what']}: {row['median']:.3g} ({row['limit'] or 'no limit'})", file=sys.stderr)
        results = {known: results[known] for known in LINES if known in results}
        path.write_text(json.dumps(results, indent=1) + "\n")
        (ROOT / "docs/performance.md").write_text(page(results))


if __name__ == "__main__":
    main()
