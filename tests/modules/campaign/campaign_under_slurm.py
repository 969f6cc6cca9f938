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
from files import DATABASE_PLAN, PLAN, different

SKIPPED = 77


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
    return int(Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()[1])


def processes_on(node, folder):
    """What runs on a node of the cluster in `folder`: the processes of its tasks, and Slurm's own that look after them."""
    wanted = {f"SLURMD_NODENAME={node}".encode(), f"SLURM_CONF={folder}/slurm.conf".encode()}
    found = set()
    for entry in Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and wanted <= set((entry / "environ").read_bytes().split(b"\0")):
                parent = parent_of(entry.name)
                is_step = Path(f"/proc/{parent}/comm").read_text(encoding="utf-8").startswith("slurmstepd")
                found |= {int(entry.name)} | ({parent} if is_step else set())
        except OSError:
            pass
    return found


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
    end = time.monotonic() + 60
    while not (tasks := commands_with(str(campaign.folder / "slurm" / "round-"))):
        if time.monotonic() > end:
            raise RuntimeError("no task is running")
        time.sleep(0.01)
    os.kill(tasks[-1], signal.SIGKILL)
    print(f"killed a task (process {tasks[-1]})", flush=True)


def kill_a_node(folder):
    """Kills a node's daemon and everything that runs on the node."""
    end = time.monotonic() + 60
    while not (processes := processes_on("right", folder)) and time.monotonic() < end:
        time.sleep(0.01)
    for process in [cluster.process_of(folder, "right"), *processes]:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass
    print(f"killed the daemon of a node and the {len(processes)} processes on it", flush=True)


def kill_the_controller(folder):
    os.kill(cluster.process_of(folder, "slurmctld"), signal.SIGKILL)
    print("killed the controller", flush=True)


def with_faults(campaign, folder, env):
    """Runs the campaign under Slurm while its parts are killed."""
    waiting = subprocess.Popen([*campaign.command, "--on", "slurm", "--jobs", "8", "--wait"], env=env,
                               stdout=subprocess.DEVNULL)
    campaign.wait_for(20)
    kill_a_task(campaign)
    campaign.wait_for(50)
    kill_a_node(folder)
    campaign.wait_for(80)
    kill_the_controller(folder)
    time.sleep(3)
    cluster.start(folder, "slurmctld")
    campaign.wait_for(100)
    cluster.start(folder, "right")
    return waiting.wait()


def database_under_slurm(brash, folder, env):
    """The failure database has the bytes that it has without Slurm."""
    here, there = folder / "here.nc", folder / "there.nc"
    command = [brash, "failure", "database", DATABASE_PLAN, "-o"]
    subprocess.run([*command, here], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([*command, there, "--on", "slurm", "--jobs", "2"], check=True, stdout=subprocess.DEVNULL, env=env)
    end = time.monotonic() + 120
    while not there.exists() and time.monotonic() < end:
        time.sleep(0.1)
    if here.read_bytes() != there.read_bytes():
        raise RuntimeError("the failure database differs")


def check_addresses(folder):
    """The controller and the nodes accept connections from this machine only."""
    addresses = cluster.listening_addresses(folder)
    # 127.0.0.1 as the kernel prints it on a little-endian machine, and the same in IPv6.
    loopback = ("0100007F:", "0000000000000000FFFF00000100007F:", "00000000000000000000000001000000:")
    if len(addresses) < 1 + len(cluster.NODES) or not all(address.startswith(loopback) for address in addresses):
        raise RuntimeError(f"the daemons listen on {addresses}")


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
        check_addresses(slurm)
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
            database_under_slurm(brash, folder, env)
        status = there.status()
        rounds = json.loads((there.folder / "slurm" / "submitted.json").read_text(encoding="utf-8"))
        print(f"{status}, {len(rounds)} rounds of jobs: {[r['n_jobs'] for r in rounds]}")
        faults_found = different(here.folder, there.folder)
        print(f"different files: {faults_found or 'none'}")
        sys.exit(0 if status["n_missing"] == status["n_failed"] == 0 and not faults_found else 1)
    finally:
        cluster.down(slurm)


if __name__ == "__main__":
    main()
