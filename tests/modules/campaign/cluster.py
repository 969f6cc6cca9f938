#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm cluster on this machine alone, for tests: munged, slurmctld and two slurmd, without systemd.

cluster.py up FOLDER     starts it and prints the line that makes Slurm's commands use it
cluster.py down FOLDER   ends it

Everything lies in FOLDER: configuration, a key of its own that only its owner may read, state, logs. The daemons listen on
the loopback address, on ports that were free. FOLDER's path has to be short: it holds a socket.
"""
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path

NODES = ["left", "right"]
CONFIGURATION = """\
ClusterName=brash
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CryptoType=crypto/munge
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdLogFile={folder}/slurmd-%n.log
SlurmdSpoolDir={folder}/spool-%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerType=sched/backfill
SchedulerParameters=batch_sched_delay=0,sched_interval=2,bf_interval=2
ReturnToService=2
SlurmdTimeout={node_timeout}
SlurmctldTimeout=10
InactiveLimit=0
KillWait=5
MinJobAge=600
MaxArraySize=10001
MailProg=/bin/true
{nodes}
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(n):
    """Ports that nobody listens on now."""
    sockets = [socket.socket() for _ in range(n)]
    for s in sockets:
        s.bind(("127.0.0.1", 0))
    ports = [s.getsockname()[1] for s in sockets]
    for s in sockets:
        s.close()
    return ports


def configure(folder):
    user = subprocess.run(["id", "-un"], check=True, capture_output=True, text=True).stdout.strip()
    controller, *ports = free_ports(1 + len(NODES))
    host = socket.gethostname().split(".")[0]
    # Nodes are two names of one machine; each may run as many tasks as half of its cores, one at least.
    cpus = max(1, (os.cpu_count() or 1) // len(NODES))
    nodes = "\n".join(f"NodeName={name} NodeHostname={host} NodeAddr=127.0.0.1 Port={port} CPUs={cpus} State=UNKNOWN"
                      for name, port in zip(NODES, ports))
    (folder / "slurm.conf").write_text(
        CONFIGURATION.format(folder=folder, user=user, host=host, controller_port=controller, nodes=nodes,
                             node_timeout=20), encoding="utf-8")
    for name in ["state"] + [f"spool-{node}" for node in NODES]:
        (folder / name).mkdir(mode=0o700)


def make_key(folder):
    """A key for this cluster alone; nobody else may read it at any time."""
    with open(os.open(folder / "munge.key", os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o400), "wb") as key:
        key.write(os.urandom(1024))


def munged(folder):
    return ["/usr/sbin/munged", "--force", f"--key-file={folder}/munge.key", f"--socket={folder}/munge.socket",
            f"--pid-file={folder}/munged.pid", f"--log-file={folder}/munged.log", f"--seed-file={folder}/munged.seed"]


def prepare(folder):
    """Makes FOLDER with all that the daemons need; starts nothing."""
    folder.mkdir(parents=True, mode=0o700)
    os.chmod(folder, 0o700)
    make_key(folder)
    configure(folder)


def environment(folder):
    return {**os.environ, "SLURM_CONF": str(folder / "slurm.conf")}


def start(folder, name):
    """Starts munged, slurmctld or the slurmd of a node, as a daemon."""
    if name == "munged":
        subprocess.run(munged(folder), check=True)
        return
    command = ["/usr/sbin/slurmctld"] if name == "slurmctld" else ["/usr/sbin/slurmd", "-N", name]
    with open(folder / f"{name}.out", "ab") as out:
        subprocess.run(command, check=True, env=environment(folder), stdout=out, stderr=out, stdin=subprocess.DEVNULL)


def wait_until_idle(folder, seconds=30):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        seen = subprocess.run(["sinfo", "-h", "-N", "-o", "%N %t"], env=environment(folder), capture_output=True, text=True)
        if seen.returncode == 0 and seen.stdout.split() == [w for node in sorted(NODES) for w in (node, "idle")]:
            return
        time.sleep(0.05)
    raise RuntimeError(f"the nodes did not come up: {seen.stdout}{seen.stderr}; see the logs in {folder}")


def process_of(folder, name):
    """The running process of a daemon, or None."""
    file = folder / {"munged": "munged.pid", "slurmctld": "slurmctld.pid"}.get(name, f"slurmd-{name}.pid")
    try:
        process = int(file.read_text(encoding="utf-8"))
        command = Path(f"/proc/{process}/comm").read_text(encoding="utf-8").strip()
    except (OSError, ValueError):
        return None
    return process if command.startswith("slurmd" if name in NODES else name) else None


def listening_addresses(folder):
    """Addresses on which the running daemons accept connections, "address:port" as in /proc/net/tcp."""
    sockets = set()
    for name in ["munged", "slurmctld", *NODES]:
        process = process_of(folder, name)
        for descriptor in Path(f"/proc/{process}/fd").iterdir():
            try:
                sockets.add(os.readlink(descriptor))
            except OSError:
                pass  # closed since
    found = []
    for table in ("tcp", "tcp6", "udp", "udp6"):
        for line in Path(f"/proc/net/{table}").read_text(encoding="utf-8").splitlines()[1:]:
            cells = line.split()
            is_listening = cells[3] == "0A" or table.startswith("udp")
            if is_listening and f"socket:[{cells[9]}]" in sockets:
                found.append(cells[1])
    return found


def up(folder):
    folder = folder.resolve()
    down(folder)
    prepare(folder)
    for name in ["munged", "slurmctld", *NODES]:
        start(folder, name)
    wait_until_idle(folder)


def down(folder):
    """Ends the daemons whose process numbers FOLDER holds, and removes it."""
    folder = folder.resolve()
    if not folder.exists():
        return
    for name in [*NODES, "slurmctld", "munged"]:
        process = process_of(folder, name)
        for attempt in range(100):
            if process is None:
                break
            os.kill(process, signal.SIGTERM if attempt < 60 else signal.SIGKILL)
            time.sleep(0.05)
            process = process_of(folder, name)
    shutil.rmtree(folder, ignore_errors=True)


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in ("up", "down"):
        sys.exit(__doc__)
    folder = Path(sys.argv[2])
    if sys.argv[1] == "down":
        down(folder)
        return
    up(folder)
    print(f"export SLURM_CONF={folder.resolve()}/slurm.conf")


if __name__ == "__main__":
    main()
