#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Python with ever more address space: each call gives its result or a MemoryError, and no signal ends the interpreter.

python_limits.py SOURCE [STEP]      with brash in the PYTHONPATH; STEP in MB [2]

Calls are made alone, in three threads, and in another process. A limit is raised until the call has succeeded thrice.
"""
import collections
import os
import subprocess
import sys

CALLS = {
    "reading a case": "brash.Case.from_file(source + '/experiments/fields/cone.toml')",
    "a polygon": "brash.Polygon([(0, 0), (1, 0), (0, 1)]).area",
    "a refusal": "assert refusal(lambda: brash.Polygon([(0, 0)]))",
    "a run": "case.run()",
    "steps": "brash.Simulation(case).step(50)",
    "a run with files": "case.run(tempfile.mkdtemp())",
    "a field": "brash.Case.from_file(source + '/experiments/fields/cone.toml', {'time.duration': 0.05, "
               "'output.statistics_from': 0}).run()",
}
CHILD = """
import multiprocessing, resource, sys, tempfile, threading
import numpy, brash
source, how, megabytes = sys.argv[1], sys.argv[2], int(sys.argv[3])
case = brash.Case.from_file(source + "/experiments/validation/cone.toml", {{"failure.model": "wedge", "time.duration": 1.5,
                                                                         "output.statistics_from": 0}})
ends = []

def refusal(call):
    try:
        call()
    except brash.InputError as error:
        return str(error)

def call():
    try:
        {call}
        ends.append("done")
    except MemoryError:
        ends.append("MemoryError")
    except Exception as error:  # a thread must not print
        ends.append("MemoryError" if "memory" in str(error) else repr(error))

def limit():
    now = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (now + (megabytes << 20),) * 2)

def in_another():
    limit()
    call()
    sys.exit({{"done": 0, "MemoryError": 10}}.get(ends[0], 11))

if how == "alone":
    limit()
    call()
elif how == "threads":
    limited = threading.Event()
    threads = [threading.Thread(target=lambda: (limited.wait(), call())) for _ in range(3)]
    for thread in threads:  # before the limit: a start without memory may hang (CPython issue 140746)
        thread.start()
    limit()
    limited.set()
    for thread in threads:
        thread.join()
else:
    other = multiprocessing.get_context("fork").Process(target=in_another)
    other.start()
    other.join()
    ends.append({{0: "done", 10: "MemoryError"}}.get(other.exitcode, f"exit code {{other.exitcode}}"))
print("|".join(sorted(set(ends))))
"""


def main():
    source, step = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2
    n_faults = 0
    for name, call in CALLS.items():
        for how in ("alone", "threads", "another process"):
            ends, n_done, megabytes = collections.Counter(), 0, 0
            while n_done < 3 and megabytes < 2000:
                done = subprocess.run([sys.executable, "-B", "-c", CHILD.format(call=call), source, how, str(megabytes)],
                                      capture_output=True, text=True, env={**os.environ, "MALLOC_ARENA_MAX": "1"})
                end = done.stdout.strip() if done.returncode == 0 else f"ended with {done.returncode}: {done.stderr[-300:]}"
                ends[end] += 1
                n_done += end == "done"
                megabytes += step
            bad = {end for end in ends if not set(end.split("|")) <= {"done", "MemoryError"}}
            n_faults += len(bad)
            print(f"{name}, {how}: {dict(ends)}, enough at {megabytes - step} MB", flush=True)
    print(f"{n_faults} kinds of end that are neither a result nor a MemoryError")
    return 1 if n_faults else 0


if __name__ == "__main__":
    sys.exit(main())
