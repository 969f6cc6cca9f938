# SPDX-License-Identifier: GPL-3.0-or-later
"""`./dev bench schedule`: a step of rubble on more threads than the machine has, from the times of its chunks on one."""
import json
import statistics
import subprocess

import schedule_figure
from measure import BIN, REPETITIONS, ROOT, line
from schedule import Costs, simulate, step_of

SIZES = (300, 1000, 10000)
N_STEPS, N_PACKS = 5, 7
DEAR = 5  # times the measured costs of threads


def program(n_steps, n_packs, *sizes):
    """Output of bench_schedule."""
    command = [str(BIN / "bench_schedule"), *map(str, (n_steps, n_packs, *sizes))]
    return json.loads(subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)


def lines_of_costs(rows):
    """What threads cost, one sample for each row."""
    costs = [Costs.measured(row) for row in rows]
    told = {"a look at the clock, which is taken off each chunk": [row["clock_s"] for row in rows],
            "exchange of a word that the core has": [c.near for c in costs],
            "exchange of a word that another core has": [c.far for c in costs],
            "from the call of a loop to the caller's first chunk": [row["caller_s"] for row in rows],
            "the same to the other thread's first chunk, if awake": [row["other_s"] for row in rows],
            "the same to the other thread's first chunk, if asleep": [row["roused_s"] for row in rows],
            "from the other thread's last chunk to the end of its loop": [row["end_s"] for row in rows],
            "until a thread without work sleeps": [c.awake for c in costs],
            "of the caller to wake one more thread": [c.rouse_more for c in costs]}
    return [line(f"microseconds: {what}", [1e6 * sample for sample in samples]) for what, samples in told.items()]


def lines_of_pack(floes, steps, whole, costs):
    """Speed-up and counts, one sample for each step; `whole` are the times of the steps that were not recorded [s]."""
    def over_steps(what, of_step):
        return line(f"{what}, {floes} floes", [of_step(step) for step in steps])

    def speed_up(threads, name, of):
        return over_steps(f"speed-up on {threads} threads{name}", lambda s: s.seconds() / simulate(s, threads, of).seconds)

    lines = [over_steps("milliseconds of a step on one thread, sum of its parts", lambda s: 1e3 * s.seconds()),
             line(f"the same / processor time of a step without a record, {floes} floes",
                  [step.seconds() / seconds for step, seconds in zip(steps, whole)]),
             over_steps("time between loops [%]", lambda s: 100 * sum(s.serial) / s.seconds()),
             over_steps("step / its critical path", lambda s: s.seconds() / s.critical_path()),
             *(speed_up(threads, "", costs) for threads in (2, 4, 8, 16, 32))]
    for threads in (8, 16):
        lines += [speed_up(threads, f", words {DEAR} times as dear", costs.times(DEAR, Costs.WORDS)),
                  speed_up(threads, f", waking {DEAR} times as dear", costs.times(DEAR, Costs.WAKING))]
    runs = {threads: [simulate(step, threads, costs) for step in steps] for threads in (8, 16)}
    counts = {"loops, at the end of which threads wait": [run.shared_loops for run in runs[8]],
              "chunks taken, two exchanges each": [run.exchanges for run in runs[8]],
              **{f"of them from the share of another of {n} threads": [run.foreign for run in runs[n]] for n in runs},
              **{f"times that one of {n} threads found no chunk": [run.without_chunk for run in runs[n]] for n in runs}}
    lines += [line(f"{what}, {floes} floes", samples) for what, samples in counts.items()]
    return lines


def schedule():
    """2. Many threads by simulation of the schedule, water and world of one step of rubble."""
    output = program(N_STEPS, N_PACKS, *SIZES)
    rows = [output["costs"], *(program(1, 1)["costs"] for _ in range(REPETITIONS - 1))]
    costs = Costs(**{name: statistics.median(getattr(Costs.measured(row), name) for row in rows) for name in Costs.names()})
    clock = statistics.median(row["clock_s"] for row in rows)
    packs = {size: [step_of(row, clock) for row in pack["steps"]] for size, pack in zip(SIZES, output["packs"])}
    schedule_figure.save(ROOT / "docs/figures/schedule.svg", packs, costs, DEAR)
    lines = lines_of_costs(rows)
    for (size, steps), pack in zip(packs.items(), output["packs"]):
        lines += lines_of_pack(size, steps, [row["whole_s"] for row in pack["steps"]], costs)
    return lines
