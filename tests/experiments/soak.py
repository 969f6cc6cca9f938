#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many seeds and long runs: none fails, every ledger closes, and memory grows with the floes present and the history
that is written at the end, with nothing else.

soak.py seeds BRASH CASE FOLDER [N [SECONDS]]    N [1000] seeds of the first SECONDS [3] of the case
soak.py long BRASH CASE FOLDER [N [SECONDS]]     N [20] seeds of SECONDS [200], in a sheet as long as the way
soak.py steps BRASH CASE FOLDER [N [SECONDS]]    N [200] generated cases of SECONDS [3] with large steps: no watchdog
                                                 ends a legal run, and no edge takes more work than
                                                 the structure does on it
soak.py cases BRASH CASE FOLDER [N [FIRST]]      N [10] cases drawn from the schema, from seed FIRST [1] on: they run to their
                                                 end with finite numbers, a closed ledger and a closed balance of energy, if
                                                 need be with the remedy that a watchdog's message names, and a run
                                                 that is interrupted, or resumed in its middle, leaves the same bytes
soak.py illegal BRASH CASE FOLDER [N [FIRST]]    N [100] drawn cases with one fault each: the message names file, key, value,
                                                 allowed values and remedy
"""
import collections
import json
import math
import os
import pty
import random
import re
import resource
import shutil
import signal
import statistics
import subprocess
import sys
import time
import tomllib
from pathlib import Path

from generated import Draw, illegal as spoilt_case, legal

# Of a run, but for those that say when it ran; a build without the viewer has no report.
SAME = ["run.nc", "history.csv", "events.csv", "summary.json"]
SHOWN = re.compile(rb"([\d.]+) of [\d.]+ s +\d+ % +(\d+) floes")
MEGABYTE = 1 << 20
BYTES_OF_FLOE = 32_000  # twice what one of rubble takes in the world (docs/performance.md, `./dev bench growth`)


def command(brash, case, folder, seed, seconds, *more):
    return [brash, "run", case, "-o", folder, "--seed", str(seed), "--set", f"time.duration={seconds}", "--set",
            "output.checkpoint_interval=0", *more]


def fault_of(folder, process_code, said):
    if process_code != 0:
        return f"exit status {process_code}: {said}"
    ledger = json.loads((folder / "summary.json").read_text())["ledger"]
    return "" if ledger["closes"] else f"the ledger does not close: {ledger}"


def resident(pid):
    """Memory that the process holds [MB]; 0 when it has gone."""
    try:
        pages = int(Path(f"/proc/{pid}/statm").read_text().split()[1])
    except (OSError, IndexError):
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / MEGABYTE


def seeds(brash, case, folder, n=1000, seconds=3):
    faults, peaks = [], []
    for seed in range(1, n + 1):
        shutil.rmtree(folder, ignore_errors=True)
        with subprocess.Popen(command(brash, case, folder, seed, seconds), stdout=subprocess.DEVNULL,
                              stderr=subprocess.PIPE, text=True) as process:
            said = process.stderr.read()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
        peaks.append(usage.ru_maxrss / 1024)
        if fault := fault_of(folder, process.returncode, said):
            faults.append(f"seed {seed}: {fault}")
            print(faults[-1], flush=True)
    print(f"{n} seeds of {seconds} s: {len(faults)} failed; memory at most {min(peaks):.0f} to {max(peaks):.0f} MB, "
          f"median {statistics.median(peaks):.0f}")
    return faults


def watched(brash, case, folder, seed, seconds):
    """One long run. Returns its fault and rows of simulated time [s], floes present and memory without history [MB]."""
    # Recorded frames are kept to the end of a run and would hide what the simulation itself holds.
    size = ["--set", f"field.length={seconds * 1.3 + 20:.0f}", "--set", "output.frames_per_second=0.01"]
    ours, its = pty.openpty()
    process = subprocess.Popen(command(brash, case, folder, seed, seconds, *size), stdout=subprocess.DEVNULL, stderr=its)
    os.close(its)
    rows, said = [], b""
    while True:
        try:
            block = os.read(ours, 4096)
        except OSError:  # the other end is closed
            break
        said = (said + block)[-4000:]
        if found := SHOWN.findall(block):
            rows.append((float(found[-1][0]), int(found[-1][1]), resident(process.pid)))
    os.close(ours)
    fault = fault_of(folder, process.wait(), said.decode(errors="replace"))
    history = 0.0 if fault else history_size(folder) / seconds
    return fault, [(time, floes, memory - history * time) for time, floes, memory in rows if memory > 0.0]


def history_size(folder):
    """Memory of the history, which a run keeps to its end [MB]."""
    with open(folder / "history.csv", encoding="utf-8") as file:
        n_columns = len(next(file).split(","))
        return 8 * n_columns * sum(1 for _ in file) / MEGABYTE


def growth(rows):
    """Floes that came, and memory that came with them [kB], in the first and in the second half of a run."""
    def mean_around(time):
        near = sorted(rows, key=lambda row: abs(row[0] - time))[:5]
        return [statistics.mean(row[i] for row in near) for i in (1, 2)]
    end = rows[-1][0]
    (f1, m1), (f2, m2), (f3, m3) = (mean_around(share * end) for share in (0.1, 0.5, 0.95))
    return (f2 - f1, 1024 * (m2 - m1)), (f3 - f2, 1024 * (m3 - m2))


def long(brash, case, folder, n=20, seconds=200):
    faults, halves = [], []
    for seed in range(1, n + 1):
        shutil.rmtree(folder, ignore_errors=True)
        fault, rows = watched(brash, case, folder, seed, seconds)
        halves.append(growth(rows))
        first, second = (memory / max(floes, 1) for floes, memory in halves[-1])
        print(f"seed {seed}, {seconds} s: {rows[-1][1]} floes, {rows[-1][2]:.0f} MB; "
              f"{first:.1f} then {second:.1f} kB for each new floe; {fault or 'no failure'}", flush=True)
        if fault:
            faults.append(f"seed {seed}: {fault}")
    # Over all runs, for a heap takes its blocks in steps that scatter one run's halves by more than half.
    first, second = (sum(half[i][1] for half in halves) / sum(half[i][0] for half in halves) for i in (0, 1))
    print(f"all runs: {first:.1f} kB for each new floe of the first half, {second:.1f} of the second; "
          f"at most {BYTES_OF_FLOE / 1024:.0f}")
    if max(first, second) > BYTES_OF_FLOE / 1024 or second > 1.25 * first:
        faults.append("memory grows beyond the floes present")
    return faults


def large_step(seed):
    """Settings of a case whose structure or floes go far in a step: thin ice, fast, or a long step."""
    draw = random.Random(seed)

    def between(least, most):  # evenly by the logarithm
        return round(least * (most / least) ** draw.random(), 4)
    width, angle = between(2.0, 12.0), draw.randint(25, 80)
    depth = round(min(0.4 * width * math.tan(math.radians(angle)), 4.0), 4)  # the cone keeps a keel and a top
    reach = 0.5 * width + depth / math.tan(math.radians(angle))
    return {"algorithm.preset": draw.choice(["paper", "paper", "paper", "brash"]),
              "ice.thickness": between(0.03, 0.6), "structure.speed": between(0.5, 4.0), "time.step": between(0.01, 0.05),
              "ice.friction_ice": draw.choice([0.05, 0.3, 0.6]), "ice.friction_structure": draw.choice([0.0, 0.027, 0.1]),
              "ice.flexural_strength": between(1e5, 1e6), "structure.angle": f"{angle} deg",
              "structure.breaking": draw.choice(["downward", "upward"]), "contact.iterations": draw.choice([10, 30, 100]),
              "structure.waterline_width": width, "structure.start_distance": round(reach + 0.1, 4),
              "structure.height_under_water": depth, "structure.height": 2 * depth, "field.length": 25,
              "field.width": 25, "field.initial_crack": draw.choice(["true", "false"]),
              "water.current": draw.choice(["[0, 0]", "[0, 0]", "[0.5, 0.3]"])}


def share_of_edge(folder):
    """Work that crushed the edge, as a share of the structure's work at the edge [-]."""
    losses = json.loads((folder / "summary.json").read_text())["energy"]["losses"]
    work = losses["edge"] + losses["bending"]
    return losses["edge"] / work if work else 0.0


def steps(brash, case, folder, n=200, seconds=3):
    faults, shares = [], []
    for seed in range(1, n + 1):
        shutil.rmtree(folder, ignore_errors=True)
        settings = [word for key, value in large_step(seed).items() for word in ("--set", f"{key}={value}")]
        done = subprocess.run(command(brash, case, folder, seed, seconds, *settings), capture_output=True, text=True,
                              check=False)
        if fault := fault_of(folder, done.returncode, done.stderr.strip()):
            faults.append(f"case {seed}: {fault}\n    {' '.join(settings)}")
            print(faults[-1], flush=True)
            continue
        shares.append(share_of_edge(folder))
        if shares[-1] < -1e-9:  # rounding of a sum over the steps
            faults.append(f"case {seed}: loss_edge is {shares[-1]:.3g} of the work at the edge\n    {' '.join(settings)}")
            print(faults[-1], flush=True)
    print(f"{n} cases with large steps, {seconds} s: {len(faults)} failed; "
          f"least share of loss_edge {min(shares, default=0.0):.3g}")
    return faults


def not_finite(text):
    raise ValueError(f"{text} in summary.json")


def physics_fault(folder):
    """The fault in the numbers of a finished run, or ""."""
    with open(folder / "history.csv", encoding="utf-8") as file:
        names = next(file).split(",")
        for line in file:
            if not all(math.isfinite(float(cell)) for cell in line.split(",")):
                return f"history.csv is not finite: {dict(zip(names, line.split(',')))}"
    summary = json.loads((folder / "summary.json").read_text(), parse_constant=not_finite)
    if not summary["ledger"]["closes"]:
        return f"the ledger does not close: {summary['ledger']}"
    energy = summary["energy"]
    terms = [energy["kinetic_energy"], energy["potential_energy"], energy["removed_energy"], energy["energy_error"], *energy["losses"].values()]
    given = energy["work"] + energy["birth_energy"]
    # The remainder is one of the terms and is bounded by the watchdog in each step; the sum is then exact but for rounding.
    largest = max(map(abs, [*terms, energy["work"], energy["birth_energy"]]))
    return "" if abs(given - sum(terms)) <= 1e-9 * largest else f"the balance of energy does not close: {energy}"


def cpu_seconds(pid):
    """Processor time that a child has taken [s]. On a busy machine it says what the clock on the wall cannot."""
    return time.clock_gettime((~pid << 3) | 2)


def ends_within(process, seconds):
    """Waits until the child ends, or has taken so much more processor time. @return whether it ended."""
    begun = cpu_seconds(process.pid)
    longest = time.monotonic() + 1800.0
    while process.poll() is None:
        if cpu_seconds(process.pid) - begun > seconds or time.monotonic() > longest:
            return False
        time.sleep(0.002)
    return True


HEARD_WITHIN = 5.0  # processor time from an interrupt to the end: one of the results' last second is writing them [s]


def interrupted(run, folder, at):
    """Interrupts a run once it has taken `at` seconds of processor time. @return its fault, or "": until it looks for
    interrupts the system ends it, and once it writes its results it is done with them."""
    process = subprocess.Popen([*run, folder], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    try:
        if not ends_within(process, at):
            process.send_signal(signal.SIGINT)
            if not ends_within(process, HEARD_WITHIN):
                return f"an interrupt after {at:.3g} s was not heard in {HEARD_WITHIN:g} s of processor time"
        if process.returncode in (0, 3, -signal.SIGINT):
            return ""
        return f"interrupted after {at:.3g} s: exit status {process.returncode}: {process.stderr.read().strip()}"
    finally:
        process.kill()
        process.communicate()


def engine_of(run):
    """The engine of the contacts of a run, also where its preset chose it."""
    manifest = json.loads((run / "manifest.json").read_text(encoding="utf-8"))
    return tomllib.loads(manifest["case"]["toml"])["contact"]["engine"]


def continuation_fault(run, folder, draw, seconds):
    """The fault of a run that is not made at once, or "". In one half of the cases an interrupt ends it, at a random moment
    of its `seconds` of processor time. The others begin from the state that the whole run kept in the middle, as after a
    kill."""
    whole, parted = folder / "whole", folder / "parted"
    if engine_of(whole) == "bullet":
        return ""  # a resumed run with Bullet has other bytes: docs/reference/case-file.md
    if draw.chance(0.5):
        if fault := interrupted(run, parted, draw.even(0.0, seconds)):
            return fault
    else:
        parted.mkdir()
        shutil.copy(whole / "checkpoint.nc", parted)
    if not (parted / "manifest.json").exists():
        done = subprocess.run([*run, parted, "--resume"], capture_output=True, text=True, check=False, timeout=3600)
        if done.returncode != 0:
            return f"--resume: exit status {done.returncode}: {done.stderr.strip()}"
    different = [name for name in SAME if (whole / name).read_bytes() != (parted / name).read_bytes()]
    return f"a resumed run has another {', '.join(different)}" if different else ""


REMEDY = re.compile(r"such as (--set time\.step=\S+) (--set contact\.iterations=\d+)")


def end_of_case(brash, folder, seed):
    """Draws a case and runs it. A watchdog may end a run of long steps or few sweeps: then the remedy that its message names is
    taken, up to three times. @return what became of it: "refused", "passed", "remedied" or "failed", and its fault, or ""."""
    run, seconds = [brash, "run", folder / "case.toml", "--threads", "1", "-o"], 0.0

    def attempt(_):
        nonlocal seconds
        shutil.rmtree(folder / "whole", ignore_errors=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        done = subprocess.run([*run, folder / "whole"], capture_output=True, text=True, check=False, timeout=3600)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return done

    file, _, done = legal(seed, folder, attempt)
    if file is None:
        is_whole = "  allowed: " in done.stderr and "  remedy:  " in done.stderr
        return "refused", "" if is_whole else f"refused without allowed values or remedy: {done.stderr}"
    end = "passed"
    for _ in range(3):
        if done.returncode != 1 or not (remedy := REMEDY.search(done.stderr)):
            break
        end = "remedied"
        run[3:] = ["--threads", "1", *" ".join(remedy.groups()).split(), "-o"]
        done = attempt(file)
    if done.returncode != 0:
        return "failed", f"exit status {done.returncode}: {done.stderr.strip()}"
    fault = physics_fault(folder / "whole") or continuation_fault(run, folder, Draw(f"end of {seed}"), seconds)
    return "failed" if fault else end, fault


def cases(brash, _, folder, n=10, first=1):
    faults, ends = [], collections.Counter()
    for seed in range(first, first + n):
        shutil.rmtree(folder, ignore_errors=True)
        end, fault = end_of_case(brash, folder, seed)
        ends[end] += 1
        if fault:
            shutil.copytree(folder, folder.with_name(f"{folder.name}_{seed}"), dirs_exist_ok=True)
            faults.append(f"case {seed}: {fault}")
            print(faults[-1], flush=True)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"{n} generated cases from {first} on: {', '.join(f'{count} {end}' for end, count in sorted(ends.items()))}; "
          f"{(used.ru_utime + used.ru_stime) / n:.2f} s of processor time each")
    if ends["refused"] > max(1, n // 10):
        faults.append(f"{ends['refused']} of {n} drawn cases were refused: expected at most a tenth")
    return faults


def check(brash, file):
    return subprocess.run([brash, "check", file], capture_output=True, text=True, check=False, timeout=600)


def illegal(brash, _, folder, n=100, first=1):
    faults, drawn = [], None
    for seed in range(first, first + n):
        shutil.rmtree(folder, ignore_errors=True)
        if drawn is None or seed % 10 == 0:
            file, found, _ = legal(seed, folder, lambda case: check(brash, case))
            drawn = found if file else drawn
        if drawn is None:
            continue
        file = drawn.write(folder)
        text, key, words = spoilt_case(seed, drawn)
        file.write_text(text, encoding="utf-8")
        done = check(brash, file)
        missing = [word for word in ["case.toml", key, "allowed: ", "remedy:  ", *words] if word not in done.stderr]
        if done.returncode != 2 or missing:
            faults.append(f"illegal {seed} of {key}: exit status {done.returncode}, without {missing}: {done.stderr.strip()}")
            print(faults[-1], flush=True)
    print(f"{n} illegal cases: {len(faults)} were not refused as they should be")
    return faults


def main():
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell has its background ignore interrupts, and runs inherit it
    what, brash, case, folder = sys.argv[1], Path(sys.argv[2]).resolve(), sys.argv[3], Path(sys.argv[4]).resolve()
    faults = {"seeds": seeds, "long": long, "steps": steps, "cases": cases, "illegal": illegal}[what](brash, case, folder, *map(int, sys.argv[5:7]))
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
