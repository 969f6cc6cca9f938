# SPDX-License-Identifier: GPL-3.0-or-later
"""Units and runs of the validation case, and the calls that their tests share."""
import atexit
import ctypes
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import netCDF4

sys.path.insert(0, os.path.join(os.environ["BRASH_SOURCE_DIR"], "experiments/coupling"))
from fmu_host import DISCARD, ERROR, Refused, Unit  # noqa: E402, F401: the tests take them from here

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
CASE = SOURCE / "experiments/validation/second_reading.toml"  # its steps are functions of their states
STEP = 0.01
CAUSES = ("", "crushing_", "floe_normal_", "floe_friction_")
LOADS = [cause + axis for cause in CAUSES for axis in ("Fx", "Fy", "Fz", "Mx", "My", "Mz")]
OUTPUTS = LOADS + ["structure_x", "structure_y", "structure_vx", "structure_vy"]
TURNS = [f"structure_{name}" for name in ("z", "vz", "roll", "pitch", "heading", "wx", "wy", "wz")]
TWO_LEGS = {"structure.legs": "[[0, 6], [0, -6]]", "structure.waterline_width": 8, "structure.start_distance": 4.1,
            "field.initial_crack": False}
LEG_LOADS = [f"F{axis}_leg_{leg}{part}" for leg in (1, 2) for part in ("", "_crushing") for axis in "xyz"]


def brash(*arguments):
    return subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True, check=False)


def sets(overrides):
    return [argument for key, value in overrides.items()
            for argument in ("--set", f"{key}={str(value).lower() if isinstance(value, bool) else value}")]


class Units:
    """Units and runs of the validation case, each made once."""

    def __init__(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.temporary.name)
        self.made = {}

    def _once(self, key, make):
        if key not in self.made:
            self.made[key] = make(self.folder / f"made{len(self.made)}")
        return self.made[key]

    def file(self, fmi, case=CASE, **overrides):
        def make(path):
            said = brash("export", "fmu", case, "-o", f"{path}.fmu", "--fmi", fmi,
                         *sets({"output.statistics_from": 0, **overrides}))
            assert said.returncode == 0, said.stderr
            return f"{path}.fmu"
        return self._once(("file", fmi, case, *overrides.items()), make)

    def unit(self, fmi, case=CASE, **overrides):
        file = self.file(fmi, case, **overrides)
        return self._once(("unit", fmi, case, *overrides.items()), lambda path: Unit(file, path))

    def history(self, seconds, outputs=OUTPUTS, case=CASE, **overrides):
        """These outputs of `brash run`, a row each step."""
        def make(path):
            said = brash("run", case, "-o", path, *sets({"output.statistics_from": 0, **overrides, "time.duration": seconds}))
            assert said.returncode == 0, said.stderr
            with netCDF4.Dataset(path / "run.nc") as run:
                columns = [run[name][:].data for name in outputs]
            return [[float(column[i]) for column in columns] for i in range(len(columns[0]))]
        return self._once(("run", seconds, *outputs, case, *overrides.items()), make)


UNITS = Units()
atexit.register(UNITS.temporary.cleanup)
DRIVEN = {"structure.motion.kind": "driven"}
INPUTS = [f"structure_{name}" for name in ("x", "y", "z", "roll", "pitch", "yaw", "vx", "vy", "vz", "wx", "wy", "wz")]


def swaying(time):
    """A pose and a velocity that a host could have: ahead with a sway, heeled and trimmed."""
    place = (-7.0 + 1.2 * time, 0.05 * math.sin(3.0 * time), 0.02 * math.sin(2.0 * time))
    velocity = (1.2, 0.15 * math.cos(3.0 * time), 0.04 * math.cos(2.0 * time))
    return place, (0.02, -0.03, 0.01), velocity


def quaternion(roll, pitch, yaw):
    """Of three turns, each about an axis of the structure: the product of their quaternions."""
    def product(a, b):
        return (a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3], a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
                a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1], a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0])
    half = [(math.cos(0.5 * angle), math.sin(0.5 * angle)) for angle in (yaw, pitch, roll)]
    z, y, x = (half[0][0], 0, 0, half[0][1]), (half[1][0], 0, half[1][1], 0), (half[2][0], half[2][1], 0, 0)
    return product(product(z, y), x)


def started(unit, whole=None, **parameters):
    instance = unit.instantiate()
    if parameters:
        instance.set({name.replace("__", "."): value for name, value in parameters.items()})
    if whole:
        instance.set(whole, whole=True)
    instance.enter_initialization()
    instance.exit_initialization()
    return instance


def rows(instance, first, last, outputs=OUTPUTS):
    """These outputs after each of the steps from `first` to `last`."""
    found = []
    for i in range(first, last):
        instance.step(i * STEP, STEP)
        found.append(instance.get(outputs))
    return found


class Common:
    """What the tests under both versions share; `fmi` is the version."""

    fmi = 0

    def setUp(self):
        self.instances = []

    def tearDown(self):
        for instance in self.instances:
            instance.free()

    def unit(self, **overrides):
        return UNITS.unit(self.fmi, **overrides)

    def path_case(self):
        """The cone on a path of a second that turns it evenly."""
        file = UNITS.folder / "path.toml"
        lines = [line for line in CASE.read_text(encoding="utf-8").splitlines(keepends=True)
                 if not line.startswith(("speed", "start_distance", "duration"))]
        path = "[structure.motion]\npath = [[0, -7, 0, 0.3], [1, -6, 0.1, 0.5]]\n\n[field]"
        file.write_text("".join(lines).replace("[field]", path).replace("[time]", "[time]\nduration = 1"), encoding="utf-8")
        return file

    def keep(self, instance):
        self.instances.append(instance)
        return instance

    def refuses(self, status, call, *arguments, **options):
        with self.assertRaises(Refused) as caught:
            call(*arguments, **options)
        self.assertEqual(caught.exception.status, status, caught.exception)
        return caught.exception

    def drive(self, instance, first, last, step=STEP):
        found = []
        for i in range(first, last):
            place, angles, velocity = swaying(i * step)
            instance.set(dict(zip(INPUTS, (*place, *angles, *velocity, 0.0, 0.0, 0.0))))
            instance.step(i * step, step)
            found.append(instance.get(LOADS))
        return found


class Under2:
    """The differences of FMI 2.0."""

    fmi = 2

    def flag(self, on):
        return ctypes.c_int(on)

    def value_element(self, variable):
        (value,) = variable
        self.assertIn(value.tag, ("Real", "Integer"))
        return value


class Under3:
    """The differences of FMI 3.0."""

    fmi = 3

    def flag(self, on):
        return ctypes.c_bool(on)

    def value_element(self, variable):
        self.assertIn(variable.tag, ("Float64", "Int64"))
        return variable
