# SPDX-License-Identifier: GPL-3.0-or-later
"""A unit for co-simulation in a bare Debian: unit_elsewhere.py PROGRAM [RELEASE] [FOLDER]

Exports the validation case as a unit and steps it here and in a Debian without any package of the program (13 by default,
made in FOLDER, or the one that is there): whole steps of the case, and steps that are no multiple of it. Prints what the
library is linked with in both, the mean load, and how far the loads are apart. Needs root, debootstrap and a C compiler.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zipfile

import debian

SOURCE = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
STEPS = ((0.01, 300), (0.0137, 219))  # the first is the step of the case
MOST_APART = 1e-9  # of the largest load: the C libraries round differently


def main():
    lacks = debian.missing()
    if lacks:
        sys.exit(f"not shown: needs {lacks}")
    program = sys.argv[1]
    release = sys.argv[2] if len(sys.argv) > 2 else "13"
    folder = pathlib.Path(sys.argv[3] if len(sys.argv) > 3 else SOURCE / f"build/platform/bare-{release}")
    root = debian.Debian(folder, release)
    place = pathlib.Path(tempfile.mkdtemp(prefix="unit", dir=root.path / "tmp"))
    try:
        compare(root, program, place)
    finally:
        shutil.rmtree(place)


def compare(root, program, place):
    """Steps the unit in `place`, a folder of the other Debian, from both sides."""
    subprocess.run([program, "export", "fmu", SOURCE / "experiments/validation/cone.toml", "-o", place / "cone.fmu"],
                   check=True, stdout=subprocess.DEVNULL)
    with zipfile.ZipFile(place / "cone.fmu") as archive:
        archive.extractall(place)
    subprocess.run(["cc", "-O1", "-o", place / "step_unit", HERE / "step_unit.c", "-ldl"], check=True)
    description = xml.etree.ElementTree.parse(place / "modelDescription.xml").getroot()
    reference = next(variable.get("valueReference") for variable in description.iter("ScalarVariable")
                     if variable.get("name") == "Fx")
    library = next((place / "binaries").glob("*/" + description.find("CoSimulation").get("modelIdentifier") + ".so"))

    def inside(path):
        return "/" + str(path.relative_to(root.path))

    def command(name, step, n):
        return [name(place / "step_unit"), name(library), "file://" + name(place / "resources"),
                description.get("guid"), reference, str(step), str(n)]

    print("linked here, and there:")
    print(subprocess.run(["ldd", library], check=True, capture_output=True, text=True).stdout)
    print(root(f"ldd {inside(library)}"))
    for step, n in STEPS:
        here = subprocess.run(command(str, step, n), check=True, capture_output=True, text=True).stdout.split()
        there = root(" ".join(f"'{word}'" for word in command(inside, step, n))).split()
        loads = [[float(load) for load in side] for side in (here, there)]
        largest = max(map(abs, loads[0]))
        apart = max(abs(a - b) for a, b in zip(*loads)) if len(here) == len(there) == n else float("inf")
        print(f"{n} steps of {step} s: mean Fx {sum(loads[0]) / n:.9g} N here, {sum(loads[1]) / len(there):.9g} N there, "
              f"at most {apart:.3g} N apart of {largest:.6g} N")
        if not apart <= MOST_APART * largest:
            sys.exit("the loads differ")


if __name__ == "__main__":
    main()
