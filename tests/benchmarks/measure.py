# SPDX-License-Identifier: GPL-3.0-or-later
"""What every line of the benchmarks needs: times of commands, and rows of the table."""
import pathlib
import resource
import statistics
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
BIN = ROOT / "build/release/bin"
REPETITIONS = 5


def output_and_seconds(command, **options):
    """What a command writes, and the user CPU time of it and all it starts [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    output = subprocess.run([str(part) for part in command], cwd=ROOT, check=True, stdout=subprocess.PIPE,
                            stderr=subprocess.DEVNULL, text=True, **options).stdout
    return output, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before


def user_seconds(command, **options):
    """User CPU time of a command and all it starts [s]."""
    return output_and_seconds(command, **options)[1]


def line(what, samples, limit="", **more):
    """One row of the table: the median of `samples` and their range."""
    return {"what": what, "median": statistics.median(samples), "lowest": min(samples), "highest": max(samples),
            "n": len(samples), "limit": limit, **more}


def ratios(above, below):
    """Ratio of the times of each pair."""
    return [a / b for a, b in zip(above, below, strict=True)]
