#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Kills a campaign at random moments until it is done: the files are those of the campaign that nobody killed.

campaign_killed.py BRASH FOLDER KILLS [--quick]
"""
import random
import shutil
import subprocess
import sys
import time
from pathlib import Path

from files import PLAN, different


def main():
    brash, folder, n_kills = sys.argv[1], Path(sys.argv[2]).resolve(), int(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    command = [brash, "campaign", PLAN, *sys.argv[4:], "--jobs", "2", "-o"]
    start = time.monotonic()
    subprocess.run([*command, folder / "whole"], check=True, stdout=subprocess.DEVNULL)
    # So that all kills together take about as long as the campaign.
    interval = (time.monotonic() - start) / n_kills
    moments = random.Random(1)
    killed = 0
    for _ in range(n_kills):
        campaign = subprocess.Popen([*command, folder / "killed", "--resume"], stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL)
        time.sleep(moments.uniform(0.1, 1.9) * interval)
        campaign.kill()
        killed += campaign.wait() < 0
    subprocess.run([*command, folder / "killed", "--resume"], check=True, stdout=subprocess.DEVNULL)
    faults = different(folder / "whole", folder / "killed")
    print(f"killed {killed} times; different: {faults or 'none'}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
