# SPDX-License-Identifier: GPL-3.0-or-later
"""This tree in another Debian: another_debian.py RELEASE [--test]

Makes a bare Debian in build/platform/RELEASE, or takes the one of the last time, and copies the tree there: every file that
git tracks or does not ignore. There `./dev demo` installs, builds and runs. With --test `./dev test` runs every test. Prints
the times, the versions of the compiler and the libraries, and how far the histories of the demo's case are from those of
this machine's program in build/release. Exit code 1 if a command failed there. `./dev platform` calls it.
"""
import csv
import itertools
import json
import pathlib
import subprocess
import sys
import time

import debian

SOURCE = pathlib.Path(__file__).resolve().parents[2]
TREE = "brash"  # the tree's folder in the other Debian
RESULTS = "build/platform/results"  # in both trees
PRESETS = ("brash", "paper")


def copy_tree(root):
    """Replaces the tree in the other Debian, except its builds. Files keep their times: ninja builds what changed."""
    target = root.path / TREE
    target.mkdir(exist_ok=True)
    subprocess.run("find . -mindepth 1 -maxdepth 1 ! -name build -exec rm -rf {} +", shell=True, check=True, cwd=target)
    listing = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard", "--deduplicate"]
    names = subprocess.run(listing, check=True, capture_output=True, cwd=SOURCE).stdout.split(b"\0")
    present = b"\0".join(name for name in names if name and (SOURCE / name.decode()).is_file())
    packed = subprocess.run(["tar", "-c", "--null", "-T", "-"], check=True, input=present, capture_output=True, cwd=SOURCE)
    subprocess.run(["tar", "-x"], check=True, input=packed.stdout, cwd=target)


def timed(root, command):
    """Runs a command in the other tree, with its output passed on. Returns whether it succeeded."""
    begun = time.monotonic()
    done = root.run(f"cd /{TREE} && {command}")
    what = "took" if done.returncode == 0 else f"failed with exit code {done.returncode} after"
    print(f"there: {command} {what} {(time.monotonic() - begun) / 60:.1f} min", flush=True)
    return done.returncode == 0


def print_versions(root):
    """Prints the versions of the packages that build the program, there and here."""
    building = (SOURCE / "packages.txt").read_text().partition("\n[")[0]
    names = [line.split()[0] for line in building.splitlines() if line and not line.startswith("#")]
    query = "dpkg-query -W -f '${Package} ${Version}\\n' " + " ".join(names) + " 2>/dev/null || true"
    there, here = (dict(line.split() for line in text.splitlines() if " " in line)
                   for text in (root(query), debian.output("sh", "-c", query)))
    print(f"{'package':20} {'there':36} here")
    for name in names:
        print(f"{name:20} {there.get(name, '-'):36} {here.get(name, '-')}")


def difference(there, here):
    """How far two load histories are apart, in words."""
    with open(there, newline="") as one, open(here, newline="") as other:
        rows = list(itertools.zip_longest(csv.DictReader(one), csv.DictReader(other)))
    apart = [(a, b) for a, b in rows if a != b]
    if not apart:
        return "the same numbers"
    if any(a is None or b is None or a.keys() != b.keys() for a, b in apart):
        return "other times or columns"
    largest, name, at = max((abs(float(a[name]) - float(b[name])), name, a["time"]) for a, b in apart for name in a)
    return f"equal before {apart[0][0]['time']} s; the largest difference is {largest:.3g}, {name} at {at} s"


def compare_histories(root):
    """Runs the demo's case with each preset, there and here, and prints how far the histories are apart."""
    manifest = json.loads((root.path / TREE / "results/demo/manifest.json").read_text())
    case = manifest["inputs"][0]["path"]
    for preset in PRESETS:
        folder = f"{RESULTS}/{preset}"
        command = f"build/release/bin/brash run {case} --set algorithm.preset={preset} -o {folder} --replace"
        root(f"cd /{TREE} && {command}")
        subprocess.run(command.split(), check=True, cwd=SOURCE, capture_output=True)
        words = difference(root.path / TREE / folder / "history.csv", SOURCE / folder / "history.csv")
        print(f"{case}, preset {preset}: {words}", flush=True)


def main(release, *options):
    if release not in debian.SUITES or not set(options) <= {"--test"}:
        sys.exit(f"found {' '.join([release, *options])}\n  allowed: {' or '.join(debian.SUITES)}, then --test or nothing")
    if missing := debian.missing():
        sys.exit(f"./dev platform needs {missing}")
    begun = time.monotonic()
    root = debian.Debian(SOURCE / "build/platform" / release, release)
    print(f"Debian {release} in {root.path} after {(time.monotonic() - begun) / 60:.1f} min", flush=True)
    copy_tree(root)
    passed = timed(root, "./dev demo")
    print_versions(root)
    if passed:
        compare_histories(root)
    if "--test" in options:
        passed = timed(root, "./dev test") and passed
    sys.exit(0 if passed else 1)


if __name__ == "__main__":
    main(*(sys.argv[1:] or ["13"]))
