#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills a run at random moments: its results are then the older ones or the new ones, whole, and the run goes on to
the files of the uninterrupted run, byte for byte, with nothing else left.

kill_and_resume.py BRASH CASE FOLDER [KILLS]

The kinds of moments take turns: while it runs, before the first checkpoint, while the results are written, and both
while it replaces an older run.
"""
import collections
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

# The first two say when, and the clock has a say in when a checkpoint is due; a build without the viewer has no report.
OTHERS = ["manifest.json", "report.html", "checkpoint.nc", "inputs", "run.lock"]
FILES = ["run.nc", "history.csv", "events.csv", "summary.json", "plan.svg"]
KINDS = ["running", "before the first checkpoint", "writing results", "replacing", "replacing, writing results"]


class Killed:
    """Runs of one case, each in a folder of its own."""

    def __init__(self, brash, case, folder):
        self.folder = folder
        self.command = [brash, "run", case, "--set", "time.duration=2", "--set", "output.statistics_from=0", "--set",
                        "failure.model=wedge", "--set", "output.checkpoint_interval=0.1"]
        self.moments = random.Random(1)
        self.older = self.whole("older", "--seed", "2")
        self.newer = self.whole("newer")
        self.measure()

    def whole(self, name, *options):
        subprocess.run([*self.command, *options, "-o", self.folder / name], check=True, stdout=subprocess.DEVNULL)
        return bytes_of(self.folder / name)

    def start(self, folder, *options):
        return subprocess.Popen([*self.command, *options, "-o", folder], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                text=True)

    def measure(self):
        """Wall times: of a run, until its first checkpoint, and of writing its results."""
        folder, begun = self.folder / "measured", time.monotonic()
        run = self.start(folder)
        wait_for((folder / "checkpoint.nc").exists, run)
        self.until_checkpoint = time.monotonic() - begun
        wait_for(lambda: writes_results(folder), run)
        writing = time.monotonic()
        run.communicate()
        self.wall, self.writing = time.monotonic() - begun, time.monotonic() - writing

    def kill(self, kind, folder):
        """Kills a run in `folder` at a moment of this kind; whether it was there to be killed."""
        replacing = kind.startswith("replacing")
        if replacing:
            shutil.copytree(self.folder / "older", folder)
        run = self.start(folder, *(["--replace"] if replacing else []))
        if kind.endswith("writing results"):
            wait_for(lambda: writes_results(folder), run)
            time.sleep(self.moments.uniform(0.0, self.writing))
        else:
            time.sleep(self.moments.uniform(0.0, self.until_checkpoint if "before" in kind else self.wall))
        run.kill()
        run.communicate()
        return run.returncode != 0

    def fault_after(self, kind, folder):
        """The fault after a kill, in the results that it left or when the run goes on; empty: none."""
        older = self.older if kind.startswith("replacing") else {}
        left = results_in(folder)
        if left not in (self.newer, older):
            return f"half of the results: {sorted(left)}"
        run = self.start(folder, "--resume")
        words = run.communicate()[1]
        if run.returncode == 2 and left:  # whole results, or the checkpoint of the older run
            run = self.start(folder, "--replace")
            words = run.communicate()[1]
        if run.returncode != 0:
            return f"does not go on: {words}"
        if different := [name for name in FILES if bytes_of(folder)[name] != self.newer[name]]:
            return f"different: {different}"
        more = sorted(p.name for p in folder.iterdir() if p.name not in [*FILES, *OTHERS])
        return f"left behind: {more}" if more else ""


def bytes_of(folder):
    return {name: (folder / name).read_bytes() for name in FILES}


def results_in(folder):
    """The results that a killed run has left, as the next command sees them: new ones that are whole come first."""
    part = folder / "results.part"
    new = part if (part / "manifest.json").exists() else folder
    found = {name: next((p.read_bytes() for p in (new / name, folder / name) if p.exists()), None) for name in FILES}
    return {name: data for name, data in found.items() if data is not None}


def writes_results(folder):
    part = folder / "results.part"
    return part.is_dir() and any(p.name != "run.begun" for p in part.iterdir())


def wait_for(found, run):
    while run.poll() is None:
        try:
            if found():
                return
        except FileNotFoundError:  # it went in between
            pass
        time.sleep(0.0005)


def main():
    brash, case, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    n_kills = int(sys.argv[4]) if len(sys.argv) > 4 else len(KINDS)
    shutil.rmtree(folder, ignore_errors=True)
    runs, counts, n_faults = Killed(brash, case, folder), collections.Counter(), 0
    for i in range(n_kills):
        kind, killed = KINDS[i % len(KINDS)], folder / f"killed-{i}"
        counts[kind, "killed" if runs.kill(kind, killed) else "was done before it could be killed"] += 1
        if fault := runs.fault_after(kind, killed):
            n_faults += 1
            print(f"kill {i}, {kind}: {fault}", flush=True)
        else:
            shutil.rmtree(killed)
    for (kind, end), n in sorted(counts.items()):
        print(f"{kind}: {n} {end}")
    print(f"{n_faults} of {n_kills} kills with a fault")
    return 1 if n_faults else 0


if __name__ == "__main__":
    sys.exit(main())
