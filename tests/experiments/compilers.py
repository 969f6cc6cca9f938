#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the program with another optimisation and another compiler: all must give the same bytes.

compilers.py BRASH FOLDER [SECONDS]

Builds into FOLDER (minutes each) and runs the first SECONDS [4] of the validation case with the trained network and with
the closed form, beside the program BRASH. Prints a hash for each; the exit status is 1 when two differ.
"""
import hashlib
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
CASE = ROOT / "experiments" / "validation" / "cone.toml"
BUILDS = {"g++-O3": ("g++", "-O3 -DNDEBUG"), "clang++-O2": ("clang++", "-O2 -DNDEBUG")}
MODELS = ["network", "wedge"]
FILES = ["run.nc", "history.csv", "events.csv", "summary.json"]


def build(folder, compiler, flags):
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", f"-DCMAKE_CXX_COMPILER={compiler}",
                    "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_UNITY_BUILD=ON", f"-DCMAKE_CXX_FLAGS={flags}"], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run(["cmake", "--build", folder, "--target", "brash", "--", "--quiet"], check=True)
    return folder / "bin" / "brash"


def trajectory(brash, folder, model, seconds):
    subprocess.run([brash, "run", CASE, "-o", folder, "--set", f"failure.model={model}",
                    "--set", f"time.duration={seconds}"], check=True, stdout=subprocess.DEVNULL)
    return hashlib.sha256(b"".join((folder / name).read_bytes() for name in FILES)).hexdigest()


def main():
    given, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    seconds = sys.argv[3] if len(sys.argv) > 3 else "4"
    hashes = {model: set() for model in MODELS}
    for name in ["given", *BUILDS]:
        brash = given if name == "given" else build(folder / name, *BUILDS[name])
        for model in MODELS:
            sha256 = trajectory(brash, folder / f"{name}-{model}", model, seconds)
            hashes[model].add(sha256)
            print(f"{model:8s} {name:11s} {sha256}", flush=True)
    return 0 if all(len(found) == 1 for found in hashes.values()) else 1


if __name__ == "__main__":
    sys.exit(main())
