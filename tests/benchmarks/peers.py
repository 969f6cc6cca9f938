# SPDX-License-Identifier: GPL-3.0-or-later
"""Lines of the benchmarks beside peers: plates and packs of floes at equal accuracy, and threads over the same floes."""
import json
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

from measure import BIN, REPETITIONS, ROOT, line, output_and_seconds, ratios

# Plates beside FreeFem++: b, c, theta [degrees]; standard thickness and the cone's load ratios.
PLATES = ((0.5, 0.3, 60), (0, 0.5, 0), (0.1, 0.15, 120), (0.3, 0.05, 60), (0.3, 0.5, 120), (1, 0.3, 90))
PLATE_LOADS = {"h": 0.10087, "mu1": 0.511, "mu2": 0.027}
# Element size of FreeFem++'s P4 over the program's own, at which its error is that of the program; that of its reference.
FREEFEM_SCALE = 1.55
FREEFEM_FINE = 0.7


def plate_once(case, *fine):
    """The program's solution of a plate."""
    command = [BIN / "bench_plate", *case, *PLATE_LOADS.values(), *fine]
    return json.loads(output_and_seconds(command)[0])


def freefem_once(case, scale):
    """FreeFem++'s solution of a plate; `start` is the rest of its CPU time, of the system included as in its own clock."""
    values = {**dict(zip(("b", "c", "theta"), case)), **PLATE_LOADS, "scale": scale}
    command = ["FreeFem++-nw", "-nw", "-ne", ROOT / "tests/benchmarks/failure/freefem.edp",
               *(word for name, value in values.items() for word in (f"-{name}", value))]
    # Debian's package looks for its plugins elsewhere than it puts them.
    environment = {**os.environ, "FF_LOADPATH": "/usr/lib/freefem++", "OMP_NUM_THREADS": "1"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_stime
    output, seconds = output_and_seconds(command, env=environment)
    seconds += resource.getrusage(resource.RUSAGE_CHILDREN).ru_stime - before
    result = json.loads(next(row for row in output.splitlines() if row.startswith("{")))
    return {**result, "start": seconds - result["seconds"]}


def plate():
    """5. The plate solution beside FreeFem++ at equal accuracy."""
    if not shutil.which("FreeFem++-nw"):
        sys.exit("./dev bench plate needs the Debian packages freefem++ and libfreefem++")
    runs = [([plate_once(case) for case in PLATES], [freefem_once(case, FREEFEM_SCALE) for case in PLATES])
            for _ in range(REPETITIONS)]
    fine = [(plate_once(case, "fine")["sigma"], freefem_once(case, FREEFEM_FINE)["sigma"]) for case in PLATES]
    own, peer = ([sum(row["seconds"] for row in run[side]) for run in runs] for side in (0, 1))
    meshing = [sum(row["meshing"] for row in run[1]) for run in runs]
    lines = [line(f"{len(PLATES)} plates with mesh, three loads each, and stresses: program / FreeFem++", ratios(own, peer),
                  "< 1"),
             line("the same, FreeFem++ without its mesh", ratios(own, [a - b for a, b in zip(peer, meshing)]), "< 1"),
             line("CPU seconds of one plate, program", [time / len(PLATES) for time in own]),
             line("CPU seconds of one plate, FreeFem++", [time / len(PLATES) for time in peer]),
             line("CPU seconds that FreeFem++ takes besides to start", [row["start"] for run in runs for row in run[1]])]
    for side, name in enumerate(("program", "FreeFem++")):
        errors = [abs(row["sigma"] / statistics.mean(true) - 1) for row, true in zip(runs[0][side], fine, strict=True)]
        lines += [line(f"error of the largest stress, {name}: root mean square", [statistics.mean(e**2 for e in errors)**0.5]),
                  line(f"error of the largest stress, {name}: worst", [max(errors)])]
    lines.append(line("largest difference between the fine solutions of the two, from whose mean the errors are taken",
                      [max(abs(a / b - 1) for a, b in fine)]))
    return lines


# Engines of the pack and how they are called: program, pack, step [s], iterations of a step (and the crushing pressure);
# Yade: step [s], stiffness and damping as in yade.py. Each at the cheapest that was found to leave no floe PACK_PLACE from
# its place and the forces PACK_FORCE wrong. The small pack is one that Siconos and Yade are done with in seconds.
PACK_PLACE, PACK_FORCE = 0.005, 0.01
PACK = {"program": ("bench_rigid_bodies", "6x5x5", 0.006, 24),
        "program, ice that does not crush": ("bench_rigid_bodies", "6x5x5", 0.04, 20, "inf"),
        "ODE": ("bench_rigid_bodies_ode", "6x5x5", 0.0225, 20)}
SMALL = {"program": ("bench_rigid_bodies", "2x2x2", 0.015, 12),
         "ODE": ("bench_rigid_bodies_ode", "2x2x2", 0.0125, 20),
         "Siconos": ("bench_rigid_bodies_siconos", "2x2x2", 0.01, 100),
         "Yade": ("yade", "2x2x2", 0.004, 6.5e6, 0.8)}


def pack_once(program, size, step, setting, *more):
    """A pack of floes that comes to rest in one engine."""
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    if program != "yade":
        return json.loads(output_and_seconds([BIN / program, step, setting, size, *more], env=environment)[0])
    with tempfile.TemporaryDirectory() as folder:
        pack = pathlib.Path(folder) / "pack.json"
        pack.write_text(output_and_seconds([BIN / "bench_rigid_bodies", "pack", size])[0])
        environment |= {"PACK": str(pack), "DT": str(step), "STIFFNESS": str(setting), "DAMPING": str(more[0])}
        script = ROOT / "tests/benchmarks/rigid_body/yade.py"
        output = output_and_seconds(["yade", "-f0", "-n", "-x", script], env=environment)[0]
    return json.loads(next(row for row in output.splitlines() if row.startswith("{")))


def pack_runs(engines):
    """Runs of the pack in each engine that is installed, in turn; all must meet PACK_PLACE and PACK_FORCE."""
    there = {name: call for name, call in engines.items() if (BIN / call[0]).exists() or shutil.which(call[0])}
    for name in engines.keys() - there.keys():
        print(f"  {name} is not installed and left out", file=sys.stderr)
    runs = {name: [] for name in there}
    for _ in range(REPETITIONS):
        for name, call in there.items():
            runs[name].append(pack_once(*call))
    for name, rows in runs.items():
        if rows[0]["position"] > PACK_PLACE or max(rows[0]["bed"], rows[0]["wall"]) > PACK_FORCE:
            sys.exit(f"{name} misses {PACK_PLACE} m or {PACK_FORCE} of the force: {rows[0]}")
    return runs


def pack_ratios(runs):
    """The program's times over those of each peer."""
    times = {name: [row["seconds"] for row in rows] for name, rows in runs.items()}
    floes = runs["program"][0]["floes"]
    own = [name for name in runs if name.startswith("program")]
    return [line(f"{floes} floes, every engine within {1000 * PACK_PLACE:g} mm and {100 * PACK_FORCE:g} %: {name} / {peer}",
                 ratios(times[name], times[peer]), "< 1") for name in own for peer in runs if peer not in own]


def pack_figures(runs):
    """Times and errors of each engine."""
    lines = []
    for name, rows in runs.items():
        lines += [line(f"CPU seconds of a simulated second, {name}", [row["seconds"] for row in rows]),
                  line(f"largest distance of a floe from its place, {name} [mm]", [1000 * rows[0]["position"]]),
                  line(f"error of the force on bed or wall, {name} [%]", [100 * max(rows[0]["bed"], rows[0]["wall"])])]
    return lines


def rigid_bodies():
    """6. Rigid bodies beside ODE: a pack of floes that comes to rest, at equal accuracy of place and force."""
    runs = pack_runs(PACK)
    own_step = {"program at its own step": [pack_once("bench_rigid_bodies", "6x5x5", 0.01, 30)]}
    return pack_ratios(runs) + pack_figures({**runs, **own_step})


def rigid_body_peers():
    """6. Rigid bodies beside ODE, Siconos (without its checks of its own graph) and Yade: the same on a small pack."""
    runs = pack_runs(SMALL)
    return pack_ratios(runs) + pack_figures(runs)


# Bullet with threads, which Debian's packages are built without, and bench_threads with it.
THREADED = ROOT / "build/threads_beside_bullet"


def threads_runs(sizes):
    """Steps of packs of `sizes` floes in both worlds, in turn: {(world, threads, floes): [s, ...]}, rows of both worlds."""
    times, rows = {}, {"program": [], "Bullet": []}
    for _ in range(REPETITIONS):
        for world, folder in (("program", BIN), ("Bullet", THREADED / "bin")):
            output = subprocess.run([str(folder / "bench_threads"), world.lower(), "5", *map(str, sizes)], cwd=ROOT,
                                    check=True, stdout=subprocess.PIPE).stdout
            for n, row in zip(sizes, json.loads(output), strict=True):
                rows[world].append(row)
                for threads, key in ((1, "one_s"), (2, "two_s")):
                    times.setdefault((world, threads, n), []).append(statistics.median(row[key]))
    return times, rows


def threads_beside_bullet():
    """2. Two threads beside Bullet's own world for threads, wall time of water and world: it needs two idle cores."""
    subprocess.run([str(ROOT / "tests/benchmarks/simulation/threads_beside_bullet"), str(THREADED)], cwd=ROOT, check=True)
    sizes, words, lines = (300, 1000, 10000), {1: "one thread", 2: "two threads"}, []
    times, rows = threads_runs(sizes)
    for n in sizes:
        lines += [line(f"water and world / Bullet's world for threads, {n} floes of rubble, {words[of]} each",
                       ratios(times["program", of, n], times["Bullet", of, n]), "< 1") for of in words]
    for world in rows:
        lines += [line(f"wall time of a step on one thread / on two, {n} floes, {world}",
                       ratios(times[world, 1, n], times[world, 2, n])) for n in sizes]
        lines += [line(f"milliseconds of a step, {n} floes, {world} on {words[of]}", [1e3 * t for t in times[world, of, n]])
                  for n in sizes for of in words]
    return lines + [row for world, of_world in rows.items() for row in places(world, of_world)]


def places(world, rows):
    """How far a result depends on the threads: rows of bench_threads over all packs."""
    limit = ["<= 0"] if world == "program" else []
    lines = []
    for key, pair, of in (("", "on two threads than on one", "on one thread and on two"),
                          ("_again", "in a second run on two threads", "of two runs on two threads")):
        lines += [line(f"floes with another place or attitude {pair}, in the worst step, {world} [%]",
                       [100 * max(row[f"share_elsewhere{key}"] for row in rows)], *limit),
                  line(f"largest distance between the places of a floe {of}, {world} [mm]",
                       [1000 * max(row[f"distance{key}_m"] for row in rows)], *limit)]
    return lines
