# SPDX-License-Identifier: GPL-3.0-or-later
"""The figure of many threads: speed-up, where their time goes, and the schedule of one step."""
import statistics
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.patches import Patch

from measure import ROOT
from schedule import Costs, simulate

sys.path.insert(0, str(ROOT / "docs/theory/figures"))
from style import EDGE, GREEN, GREY, RED, SERIES, STEEL, WATER

THREADS = (1, 2, 4, 8, 16, 32)
# Functions that share out loops, in the words of the figure. All others are of single bodies.
STAGES = {"each_strip": ("sweeps of the solver", EDGE), "iterate": ("sweeps of the solver", EDGE),
          "find": ("search for contacts", GREEN), "report": ("loads of contacts", "#c77700"),
          "apply": ("water", "#7fb2d1"), "visit_neighbours": ("water", "#7fb2d1")}
OTHER = ("bodies, pairs, rows", STEEL)
SERIAL = ("between loops", RED)
PARTS = (("work", "chunks of loops", EDGE), ("serial", "between loops", RED), ("idle", "without work", "#e8a19c"),
         ("wait", "waiting for the last chunk", "#d9dde2"), ("start", "seeing a loop", "#c77700"),
         ("exchange", "taking chunks", SERIES[3]))


def speed_up(axis, packs, costs, dear):
    """Over threads: at the measured costs, down to words that are so many times as dear, and at no cost."""
    axis.plot(THREADS, THREADS, color=GREY, lw=0.8, ls=":", label="number of threads")
    for (size, steps), colour in zip(packs.items(), SERIES):
        def curve(of):
            return [statistics.median(s.seconds() / simulate(s, t, of).seconds for s in steps) for t in THREADS]
        measured = curve(costs)
        axis.plot(THREADS, measured, "o-", color=colour, ms=3, label=f"{size} floes")
        axis.fill_between(THREADS, measured, curve(costs.times(dear, Costs.WORDS)), color=colour, alpha=0.15, lw=0)
        axis.axhline(statistics.median(s.seconds() / s.critical_path() for s in steps), color=colour, lw=0.9, ls="--")
    axis.plot([], [], color=GREY, lw=0.9, ls="--", label="critical path")
    axis.set(xscale="log", yscale="log", ylim=(0.8, 150), xlabel="threads", ylabel="times as fast as on one thread")
    axis.set_xticks(THREADS, THREADS)
    axis.set_yticks((1, 2, 4, 8, 16), (1, 2, 4, 8, 16))
    axis.minorticks_off()
    axis.legend(loc="upper left", borderaxespad=0.0)


def time_goes(axis, step, size, costs):
    """Thread time of a step, relative to one thread."""
    places, names = range(len(THREADS)), [str(t) for t in THREADS]
    below = [0.0] * len(THREADS)
    runs = [simulate(step, t, costs) for t in THREADS]
    for attribute, name, colour in PARTS:
        shares = [100 * getattr(run, attribute) / (run.threads * run.seconds) for run in runs]
        axis.bar(places, shares, bottom=below, color=colour, label=name, width=0.8)
        below = [a + b for a, b in zip(below, shares)]
    axis.set_xticks(places, names)
    axis.set(xlabel="threads", ylabel="share of all threads' time [%]", ylim=(0, 100))
    axis.set_title(f"{size} floes", loc="left")


def gantt(axis, step, size, threads, costs, end):
    run = simulate(step, threads, costs)
    for worker in range(threads):
        bars = [(1e3 * begin, 1e3 * (until - begin), stage) for of, begin, until, stage in run.bars if of == worker]
        axis.broken_barh([bar[:2] for bar in bars], (worker - 0.45, 0.9), lw=0, rasterized=True,
                         facecolors=[(SERIAL if stage is None else STAGES.get(stage, OTHER))[1] for *_, stage in bars])
    axis.set(xlim=(0, 1e3 * end), ylim=(threads - 0.4, -0.6), ylabel="thread")
    axis.set_title(f"One step of {size} floes on {threads} threads: {1e3 * run.seconds:.1f} ms, {step.seconds() / run.seconds:.1f} "
                   "times as fast as on one", loc="left")
    axis.set_yticks(range(0, threads, threads // 4))


def save(path, packs, costs, dear):
    """Draws the packs, {floes: steps}."""
    # A fixed salt and no date: names of parts in the file do not vary.
    plt.rcParams.update({"svg.hashsalt": "brash", "font.size": 9, "axes.titlesize": 10, "legend.frameon": False,
                         "legend.fontsize": 8, "axes.spines.top": False, "axes.spines.right": False})
    figure = plt.figure(figsize=(9, 8.5), layout="constrained")
    axes = figure.subplot_mosaic("abc;ddd;eee", gridspec_kw={"height_ratios": (1.2, 0.8, 1.2)})
    speed_up(axes["a"], packs, costs, dear)
    sizes = list(packs)
    middle = {size: sorted(steps, key=lambda s: s.critical_path())[len(steps) // 2] for size, steps in packs.items()}
    time_goes(axes["b"], middle[sizes[0]], sizes[0], costs)
    time_goes(axes["c"], middle[sizes[-1]], sizes[-1], costs)
    step = middle[sizes[-1]]
    end = simulate(step, 8, costs).seconds
    for name, threads in (("d", 8), ("e", 16)):
        gantt(axes[name], step, sizes[-1], threads, costs, end)
    axes["e"].set_xlabel("milliseconds")
    axes["c"].legend(*axes["b"].get_legend_handles_labels(), loc="upper left", bbox_to_anchor=(1, 1))
    stages = dict([SERIAL, *STAGES.values(), OTHER])
    axes["d"].legend(handles=[Patch(color=colour, label=name) for name, colour in stages.items()], loc="upper left",
                     bbox_to_anchor=(1, 1))
    figure.savefig(path, metadata={"Date": None}, dpi=200)
    plt.close(figure)
