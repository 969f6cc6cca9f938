#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A campaign under Slurm gives the bytes that it gives on this machine alone.

campaign_under_slurm.py BRASH FOLDER [--faults]

Without --faults, the quick variant of plan.toml. With it, all 200 cases, while a task, a node's daemon with all that it
runs, and the controller are killed; the campaign still ends with every case done, once. Exit code 77 (skipped) where the
daemons of Slurm cannot start.
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import cluster

HERE = Path(__file__).resolve().parent
PLAN = HERE / "plan.toml"
SKIPPED = 77
#: What may differ: times and hosts, locks, and what concerns Slurm.
VOLATILE = {"manifest.json", "campaign.lock"}


def files_of(folder):
    """The bytes of every file of a campaign that must not depend on where it ran."""
    files = (p for p in folder.rglob("*") if p.is_file() and p.name not in VOLATILE and folder / "slurm" not in p.parents)
    return {str(p.relative_to(folder)): p.read_bytes() for p in files}


def commands_with(word):
    """Numbers of the running processes one of whose arguments contains `word`."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                arguments = (entry / "cmdline").read_bytes().decode(errors="replace").split("\0")
            except OSError:
                continue
            if any(word in argument for argument in arguments):
                found.append(int(entry.name))
    return found


def parent_of(process):
    try:
        return int(Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])
    except OSError:
        return None


def is_below(process, ancestor):
    while process not in (None, 0, 1):
        if process == ancestor:
            return True
        process = parent_of(process)
    return False


class Campaign:
    """The campaign of PLAN in one folder."""

    def __init__(self, brash, folder, quick):
        self.command = [brash, "campaign", PLAN, "-o", folder] + (["--quick"] if quick else [])
        self.folder = folder

    def run(self, *options, env=None):
        subprocess.run([*self.command, *options], check=True, stdout=subprocess.DEVNULL, env=env)

    def status(self):
        out = subprocess.run([*self.command, "--status", "--json"], check=True, capture_output=True, text=True).stdout
        return json.loads(out)

    def wait_for(self, n_done, seconds=600):
        end = time.monotonic() + seconds
        while (status := self.status())["n_done"] < n_done:
            if time.monotonic() > end:
                raise RuntimeError(f"no {n_done} cases in {seconds} s: {status}")
            time.sleep(0.2)


def kill_a_task(campaign):
    """Kills a process that runs a chunk, and so its task."""
    tasks = commands_with(str(campaign.folder / "slurm" / "round-"))
    if not tasks:
        raise RuntimeError("no task is running")
    os.kill(tasks[-1], signal.SIGKILL)
    print(f"killed a task (process {tasks[-1]})", flush=True)


def kill_a_node(folder, campaign):
    """Kills a node's daemon and everything that runs on the node; starts it again after the controller gave it up."""
    daemon = cluster.process_of(folder, "right")
    steps = [p for p in commands_with("slurmstepd") if process_runs_on(p, "right")]
    children = [p for p in commands_with(str(campaign.folder)) if any(is_below(p, step) for step in steps)]
    for process in [daemon, *steps, *children]:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass
    print(f"killed the daemon of a node, {len(steps)} steps and {len(children)} processes on it", flush=True)


def process_runs_on(process, node):
    try:
        variables = Path(f"/proc/{process}/environ").read_bytes().split(b"\0")
    except OSError:
        return False
    return b"SLURMD_NODENAME=" + node.encode() in variables or f"/spool-{node}/".encode() in Path(
        f"/proc/{process}/cmdline").read_bytes()


def kill_the_controller(folder):
    os.kill(cluster.process_of(folder, "slurmctld"), signal.SIGKILL)
    print("killed the controller", flush=True)


def with_faults(campaign, folder, env):
    """Runs the campaign under Slurm while its parts are killed."""
    waiting = subprocess.Popen([*campaign.command, "--on", "slurm", "--jobs", "20", "--wait"], env=env,
                               stdout=subprocess.DEVNULL)
    campaign.wait_for(20)
    kill_a_task(campaign)
    campaign.wait_for(50)
    kill_a_node(folder, campaign)
    campaign.wait_for(80)
    kill_the_controller(folder)
    time.sleep(3)
    cluster.start(folder, "slurmctld")
    campaign.wait_for(100)
    cluster.start(folder, "right")
    return waiting.wait()


def main():
    brash, folder, faults = sys.argv[1], Path(sys.argv[2]).resolve(), "--faults" in sys.argv[3:]
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    slurm = folder / "slurm"
    try:
        cluster.up(slurm)
    except (OSError, RuntimeError, subprocess.CalledProcessError) as error:
        print(f"skipped: the daemons of Slurm cannot start here: {error}")
        cluster.down(slurm)
        sys.exit(SKIPPED)
    try:
        here = Campaign(brash, folder / "local", not faults)
        here.run("--jobs", "2")
        there = Campaign(brash, folder / "under-slurm", not faults)
        env = cluster.environment(slurm)
        if faults:
            code = with_faults(there, slurm, env)
            if code != 0:
                print(f"the command that waited ended with exit code {code}")
        else:
            there.run("--on", "slurm", "--jobs", "4", "--wait", env=env)
        status = there.status()
        rounds = json.loads((there.folder / "slurm" / "submitted.json").read_text(encoding="utf-8"))
        print(f"{status}, {len(rounds)} rounds of jobs: {[r['n_jobs'] for r in rounds]}")
        ours, theirs = files_of(here.folder), files_of(there.folder)
        different = sorted(name for name in ours.keys() | theirs.keys() if ours.get(name) != theirs.get(name))
        print(f"{len(ours)} files compared, different: {different or 'none'}")
        sys.exit(0 if status["n_missing"] == status["n_failed"] == 0 and not different else 1)
    finally:
        cluster.down(slurm)


if __name__ == "__main__":
    main()
