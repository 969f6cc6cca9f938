#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills a run at random moments and resumes it: the finished files are those of the uninterrupted run, byte for byte, and
nothing else is left.

kill_and_resume.py BRASH CASE FOLDER [KILLS]
"""
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

# The first two say when, and the clock has a say in when a checkpoint is due; a build without the viewer has no report.
OTHERS = ["manifest.json", "report.html", "checkpoint.nc", "inputs"]
FILES = ["run.nc", "history.csv", "events.csv", "summary.json", "plan.svg"]


def main():
    brash, case, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    n_kills = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    shutil.rmtree(folder, ignore_errors=True)
    command = [brash, "run", case, "--set", "time.duration=4", "--set", "output.statistics_from=0", "--set",
               "output.checkpoint_interval=0.2", "-o"]

    start = time.monotonic()
    subprocess.run([*command, folder / "whole"], check=True, stdout=subprocess.DEVNULL)
    wall = time.monotonic() - start

    moments = random.Random(1)
    share = wall * 3 / max(n_kills, 3)  # so that all kills together take about as long as the run
    for _ in range(n_kills):
        run = subprocess.Popen([*command, folder / "killed", "--resume"], stdout=subprocess.DEVNULL)
        time.sleep(moments.uniform(0.1, 0.5) * share)
        run.kill()
        print("killed" if run.wait() != 0 else "was done before it could be killed")
    subprocess.run([*command, folder / "killed", "--resume"], check=True, stdout=subprocess.DEVNULL)

    different = [f for f in FILES if (folder / "whole" / f).read_bytes() != (folder / "killed" / f).read_bytes()]
    left = sorted(p.name for p in (folder / "killed").iterdir() if p.name not in [*FILES, *OTHERS])
    print("different:", different or "none", " left behind:", left or "none")
    return 1 if different or left else 0


if __name__ == "__main__":
    sys.exit(main())
