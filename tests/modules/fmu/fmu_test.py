# SPDX-License-Identifier: GPL-3.0-or-later
"""Units against the program: loads, parameters, saved states and driven structures, to the bit."""
import functools
import math
import operator
import os
import pathlib
import tempfile
import unittest

import brash as module
from units import (CASE, Common, DRIVEN, INPUTS, LEG_LOADS, LOADS, OUTPUTS, SOURCE, STEP, TURNS, TWO_LEGS, UNITS, Under2, Under3,
                   Unit, brash, quaternion, rows, started, swaying)


class Tests(Common):
    def test_loads_are_those_of_a_run_to_the_bit(self):
        for overrides, seconds in (({}, 3), ({"algorithm.preset": "brash"}, 1)):
            instance = self.keep(started(self.unit(**overrides)))
            history = UNITS.history(seconds, **overrides)
            self.assertEqual(rows(instance, 0, len(history)), history)
            self.assertTrue(any(row[LOADS.index("crushing_Fx")] > 0 for row in history))

    def test_loads_by_leg_are_those_of_a_run_and_go_through_a_state(self):
        outputs = OUTPUTS + LEG_LOADS
        history = UNITS.history(1.5, outputs, **TWO_LEGS)
        instance = self.keep(started(self.unit(**TWO_LEGS)))
        self.assertEqual(rows(instance, 0, 100, outputs), history[:100])
        state = instance.get_state()
        self.assertEqual(rows(instance, 100, len(history), outputs), history[100:])
        instance.set_state(state)
        self.assertEqual(instance.get(outputs), history[99])
        instance.step(100 * STEP, 20 * STEP)
        for name, mean in zip(LEG_LOADS, instance.get(LEG_LOADS)):
            of_run = [row[outputs.index(name)] for row in history[100:120]]
            self.assertEqual(mean, functools.reduce(operator.add, of_run) / 20)  # sum() carries the rounding from Python 3.12 on
        self.assertTrue(all(any(row[outputs.index(f"Fx_leg_{leg}_crushing")] > 0 for row in history) for leg in (1, 2)))

    def test_a_unit_has_the_regions_of_its_structure(self):
        def regions(**options):
            names = [name for name in self.unit(**options).references if name[0] == "F" and "_" in name]
            return sorted({name[3:].removesuffix("_crushing") for name in names})
        self.assertEqual(regions(), [])
        self.assertEqual(regions(**TWO_LEGS), ["leg_1", "leg_2"])
        self.assertEqual(regions(case=SOURCE / "experiments/ships/icebreaker.toml"),
                         ["bottom", "bow", "shoulders", "sides", "stern"])

    def test_a_structure_afloat_tells_its_turns_as_a_run_does(self):
        ship, seconds = SOURCE / "experiments/ships/free.toml", 1
        history = UNITS.history(seconds, TURNS, ship, **{"output.statistics_from": 0})
        instance = self.keep(started(self.unit(case=ship)))
        found = [0.0] * len(TURNS)
        for i, row in enumerate(history[:40]):
            instance.step(i * STEP, STEP)
            self.assertEqual(instance.get(TURNS), row)
            found = [largest or number for largest, number in zip(found, row)]
        self.assertTrue(all(found), found)
        instance.step(40 * STEP, 20 * STEP)
        for name, number in zip(TURNS, instance.get(TURNS)):
            of_run = [row[TURNS.index(name)] for row in history[40:60]]
            rate = name[len("structure_")] in "vw"
            self.assertAlmostEqual(number, sum(of_run) / 20 if rate else of_run[-1], delta=1e-15, msg=name)

    def test_a_unit_on_a_path_tells_its_heading_from_the_start(self):
        names = ["structure_heading", "structure_wz"]
        instance = self.keep(self.unit(case=self.path_case()).instantiate())
        instance.enter_initialization()
        for found, wanted in zip(instance.get(names), (0.3, 0.2)):
            self.assertAlmostEqual(found, wanted, delta=1e-12)
        self.assertNotIn("structure_roll", instance.unit.references)
        instance.exit_initialization()
        self.assertEqual(rows(instance, 0, 40, names), UNITS.history(1, names, self.path_case())[:40])

    def test_a_long_step_gives_the_mean_load_and_the_last_place(self):
        history = UNITS.history(3)
        instance = self.keep(started(self.unit()))
        place, speed = OUTPUTS.index("structure_x"), OUTPUTS.index("structure_vx")
        for first in range(0, 60, 20):
            instance.step(first * STEP, 20 * STEP)
            found, of_run = instance.get(OUTPUTS), history[first:first + 20]
            for i in [*range(len(LOADS)), speed]:
                total = 0.0
                for row in of_run:
                    total += row[i]
                self.assertEqual(found[i], total / 20)
            self.assertEqual(found[place], of_run[-1][place])

    def test_a_step_that_is_no_multiple_leaves_its_rest_to_the_next(self):
        history = UNITS.history(3)
        for part in (0.4, 1.0 / 3.0, 1.5, 2.25):
            instance, at = self.keep(started(self.unit())), 0.0
            for i in range(1, 100):
                before, done = int((i - 1) * part + 1e-6), int(i * part + 1e-6)
                instance.step(at, part * STEP)
                at += part * STEP
                self.assertAlmostEqual(instance.get(["time"])[0], i * part * STEP, delta=1e-9)
                if done > before:
                    self.assertEqual(instance.get(["structure_x"]), history[done - 1][OUTPUTS.index("structure_x"):][:1])
                if done == before + 1:
                    self.assertEqual(instance.get(OUTPUTS), history[done - 1])

    def test_a_saved_state_keeps_the_rest_of_a_step(self):
        unit, history = self.unit(), UNITS.history(3)
        instance = self.keep(started(unit))
        instance.step(0.0, 60.7 * STEP)
        other = self.keep(unit.instantiate())
        other.set_state(other.deserialize(instance.serialize(instance.get_state())))
        other.step(60.7 * STEP, 0.4 * STEP)
        self.assertEqual(other.get(OUTPUTS), history[60])

    def test_a_driven_structure_goes_evenly_through_steps_that_are_no_multiples(self):
        unit = self.unit(**DRIVEN, **{"field.initial_crack": False})

        def crushing(part):
            instance, found = self.keep(started(unit)), {}
            for i in range(round(26 / part)):
                instance.set({"structure_x": -7.0 + 1.2 * i * part * STEP, "structure_vx": 1.2})
                instance.step(i * part * STEP, part * STEP)
                if abs(round((i + 1) * part) - (i + 1) * part) < 1e-6:
                    found[round((i + 1) * part)] = instance.get(["crushing_Fx"])[0]
            return found
        whole, odd = crushing(1.0), crushing(0.25)
        self.assertEqual(set(odd), set(range(1, 27)))
        self.assertGreater(max(whole.values()), 1e4)
        for n, load in whole.items():  # the place at the end of a time step differs by round-off
            self.assertAlmostEqual(odd[n], load, delta=1e-6 * max(whole.values()), msg=n)

    def test_time_goes_on_from_the_hosts_start(self):
        instance = self.keep(self.unit().instantiate())
        instance.enter_initialization(start=100.0)
        instance.exit_initialization()
        self.assertEqual(instance.get(["time"]), [100.0])
        instance.step(100.0, 2 * STEP)
        self.assertEqual(instance.get(["time"]), [100.0 + 2 * STEP])

    def test_outputs_have_their_place_before_the_first_step(self):
        instance = self.keep(self.unit().instantiate())
        instance.enter_initialization()
        self.assertEqual(instance.get(["structure_x", "structure_vx", "Fx"]), [-7.0, 1.202, 0.0])

    def test_parameters_act_as_the_keys_of_the_case(self):
        history = UNITS.history(1, **{"ice.flexural_strength": 4e5, "structure.speed": 1.5, "random.seed": 7})
        instance = self.keep(started(self.unit(), ice__flexural_strength=4e5, structure__speed=1.5,
                                     whole={"random.seed": 7}))
        self.assertEqual(rows(instance, 0, len(history)), history)
        self.assertEqual(instance.get(["ice.flexural_strength"]), [4e5])
        self.assertEqual(instance.get(["random.seed"], whole=True), [7])

    def test_a_saved_state_goes_on_to_the_bit(self):
        history = UNITS.history(3)
        instance = self.keep(started(self.unit()))
        rows(instance, 0, 120)
        state = instance.get_state()
        self.assertEqual(rows(instance, 120, 200), history[120:200])
        instance.set_state(state)
        self.assertEqual(instance.get(OUTPUTS), history[119])
        self.assertEqual(rows(instance, 120, 200), history[120:200])
        instance.set_state(state)
        self.assertEqual(rows(instance, 120, 150), history[120:150])
        instance.free_state(state)
        self.assertIsNone(state.value)
        instance.free_state(state)

    def test_a_state_goes_through_bytes_into_another_instance_to_the_bit(self):
        for overrides, n in (({}, 120), ({"algorithm.preset": "brash"}, 60)):
            unit = self.unit(**overrides)
            history = UNITS.history(3 if not overrides else 1, **overrides)
            instance = self.keep(started(unit))
            rows(instance, 0, n)
            data = instance.serialize(instance.get_state())
            other = self.keep(unit.instantiate())
            state = other.deserialize(data)
            self.assertEqual(other.serialize(state), data)
            other.set_state(state)
            self.assertEqual(rows(other, n, n + 40), history[n:n + 40])

    def test_a_state_of_a_unit_with_files_goes_into_the_same_unit_unpacked_elsewhere(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "shore.wkt").write_text("POLYGON ((30 10, 40 10, 40 20, 30 20, 30 10))")
            said = brash("export", "fmu", SOURCE / "experiments/fields/cone.toml", "-o", path / "shore.fmu", "--fmi",
                         self.fmi, "--set", f"field.shore={path / 'shore.wkt'}", "--set", "field.length=40", "--set",
                         "field.width=40", "--set", "field.concentration=0.4")
            self.assertEqual(said.returncode, 0, said.stderr)
            instance = self.keep(started(Unit(path / "shore.fmu", path / "first")))
            rows(instance, 0, 20)
            data = instance.serialize(instance.get_state())
            on = rows(instance, 20, 40)
            (path / "first/resources/inputs/shore/shore.wkt").unlink()
            other = self.keep(Unit(path / "shore.fmu", path / "second").instantiate())
            other.set_state(other.deserialize(data))
            self.assertEqual(rows(other, 20, 40), on)

    def test_a_state_holds_parameters_and_phase(self):
        instance = self.keep(self.unit().instantiate())
        instance.set({"ice.flexural_strength": 4e5})
        state = instance.get_state()
        instance.set({"ice.flexural_strength": 5e5})
        instance.enter_initialization()
        instance.set_state(state)
        self.assertEqual(instance.get(["ice.flexural_strength"]), [4e5])
        instance.enter_initialization()

    def test_instances_do_not_know_of_each_other(self):
        history = UNITS.history(3)
        first, second = self.keep(started(self.unit())), self.keep(started(self.unit(), structure__speed=1.5))
        for i in range(60):
            second.step(i * STEP, STEP)
            self.assertEqual(rows(first, i, i + 1), history[i:i + 1])
        self.assertNotEqual(second.get(OUTPUTS), history[59])

    def test_a_driven_unit_gives_the_loads_of_a_simulation_that_goes_the_same_way(self):
        seconds, overrides = 0.5, {**DRIVEN, "field.initial_crack": False}
        case = module.Case.from_file(str(CASE), overrides)
        simulation, wanted = module.Simulation(case), []
        for i in range(round(seconds / STEP)):
            place, angles, velocity = swaying(i * STEP)
            goal = [p + STEP * v for p, v in zip(place, velocity)]
            loads = simulation.step(pose=(goal, quaternion(*angles)), twist=(velocity, (0, 0, 0))).loads
            wanted.append([float(loads[name][0]) for name in LOADS])
        # Floes let round-off grow: the edge alone is compared, until the first floe bears on the structure.
        floe = LOADS.index("floe_normal_Fx")
        wanted = wanted[:next(i for i, row in enumerate(wanted) if row[floe] != 0.0)]
        found = self.drive(self.keep(started(self.unit(**overrides))), 0, len(wanted))
        self.assertGreater(max(row[LOADS.index("crushing_Fx")] for row in wanted), 1e4)
        # The quaternions of both differ by round-off. Turns in another order would change these loads by percents.
        for column in range(len(LOADS)):
            largest = max(abs(row[column]) for row in wanted)
            for a, b in zip(found, wanted):
                self.assertAlmostEqual(a[column], b[column], delta=1e-9 * largest, msg=LOADS[column])

    def test_loads_turn_with_the_heading_and_the_formula_of_the_tutorial_turns_them_back(self):
        unit = self.unit(**DRIVEN, **{"field.initial_crack": False})

        def loads_at(heading):
            """Along the sheet's axes, of the cone that goes ahead at this heading."""
            instance, found, first = self.keep(started(unit)), [], 20
            for i in range(1, first + 1):  # nothing turns to port in one step
                instance.set({"structure_yaw": heading * i / first})
                instance.step((i - 1) * STEP, STEP)
            for i in range(26):  # until two steps after the first break: floes let round-off grow
                instance.set({"structure_x": -7.0 + 1.2 * i * STEP, "structure_yaw": heading, "structure_vx": 1.2})
                instance.step((first + i) * STEP, STEP)
                found.append([])
                for kind in "FM":
                    x, y, z = instance.get([kind + axis for axis in "xyz"])
                    c, s = math.cos(heading), math.sin(heading)
                    found[-1] += [-(x * c - y * s), -(x * s + y * c), z]
            return found

        ahead, abeam = loads_at(0.0), loads_at(0.5 * math.pi)
        self.assertLess(ahead[-1][0], -1e5)  # along the sheet's x it is against the motion
        self.assertLess(ahead[-1][1], -100)
        for a, b in zip(ahead, abeam):
            for number, turned in zip(a, b):
                self.assertAlmostEqual(turned, number, delta=1e-9 * max(map(abs, ahead[-1])))

    def load_of_host(self, velocity, unit=None, seconds=1.0):
        """The mean load of a host that goes ahead at 1.2 m/s and gives this velocity, and what the unit says to it."""
        instance = (unit or self.unit(**DRIVEN)).instantiate(logging=False)
        self.keep(instance).enter_initialization()
        instance.exit_initialization()
        loads = []
        for i in range(round(seconds / STEP)):
            instance.set({"structure_x": -7.0 + 1.2 * i * STEP})
            if velocity is not None:
                instance.set({"structure_vx": velocity(i * STEP)})
            instance.step(i * STEP, STEP)
            loads += instance.get(["Fx"])
        instance.terminate()
        return sum(loads) / len(loads), instance.messages

    def test_a_host_that_gives_poses_alone_is_warned_once(self):
        for velocity in (None, lambda _: 1.2 / 3.6, lambda _: 1.1, lambda _: -1.2):
            _, said = self.load_of_host(velocity)
            self.assertEqual(len(said), 2, said)
            self.assertIn("--velocity-from-poses", said[0])
            self.assertRegex(said[1], "did not fit in [0-9]+ of 99 steps")

    def test_a_host_whose_velocity_is_of_the_start_or_the_end_of_a_step_is_not_warned(self):
        for shift in (0.0, 0.5, 1.0):
            instance = self.keep(started(self.unit(**DRIVEN)))
            for i in range(150):
                time = i * STEP
                instance.set({"structure_x": -7.5 + 0.5 * math.cos(4.0 * time), "structure_roll": 0.1 * math.sin(2.0 * time),
                              "structure_vx": -2.0 * math.sin(4.0 * (time + shift * STEP)),
                              "structure_wx": 0.2 * math.cos(2.0 * (time + shift * STEP))})
                instance.step(time, STEP)
            self.assertEqual(instance.messages, [])

    def test_a_unit_takes_velocities_from_poses_on_request(self):
        path = UNITS.folder / f"poses{self.fmi}.fmu"
        said = brash("export", "fmu", CASE, "-o", path, "--fmi", self.fmi, "--velocity-from-poses", "--set",
                     "structure.motion.kind=driven")
        self.assertEqual(said.returncode, 0, said.stderr)
        unit = Unit(path, UNITS.folder / f"poses{self.fmi}")
        self.assertEqual([name for name in unit.references if name in INPUTS], INPUTS[:6])
        wanted, _ = self.load_of_host(lambda _: 1.2)
        found, warnings = self.load_of_host(None, unit)
        self.assertEqual(warnings, [])
        # The first step, far from the ice, has no velocity yet. Floes let round-off grow. Without the velocity nothing is left.
        self.assertGreater(wanted, 1e4)
        self.assertAlmostEqual(found, wanted, delta=0.01 * wanted)
        towed = brash("export", "fmu", CASE, "-o", path, "--velocity-from-poses")
        self.assertEqual(towed.returncode, 2)
        self.assertIn("structure.motion.kind=driven", towed.stderr)

    def test_a_driven_unit_goes_on_from_a_saved_state_to_the_bit(self):
        unit = self.unit(**DRIVEN)
        instance = self.keep(started(unit))
        self.drive(instance, 0, 60)
        data = instance.serialize(instance.get_state())
        on = self.drive(instance, 60, 90)
        other = self.keep(unit.instantiate())
        other.set_state(other.deserialize(data))
        self.assertEqual(other.get(INPUTS), list(swaying(59 * STEP)[0]) + [0.02, -0.03, 0.01]
                         + list(swaying(59 * STEP)[2]) + [0.0, 0.0, 0.0])
        self.assertEqual(self.drive(other, 60, 90), on)

    def test_a_structure_at_rest_out_of_the_ice_bears_no_load(self):
        instance = self.keep(started(self.unit(**DRIVEN)))
        instance.step(0.0, 20 * STEP)
        self.assertEqual(instance.get(LOADS), [0.0] * len(LOADS))

    def test_models_come_from_the_unit_whatever_the_environment_names(self):
        os.environ["BRASH_MODEL_PATH"] = "/nowhere"
        try:
            instance = self.keep(started(self.unit()))
        finally:
            del os.environ["BRASH_MODEL_PATH"]
        self.assertEqual(rows(instance, 0, 30), UNITS.history(3)[:30])

    def test_a_unit_carries_all_that_its_failure_model_reads(self):
        carried = {"deep-network": {"deep-network"}, "superposition": {"superposition", "superposition_split"},
                   "plate": {"superposition"}, "plate-outline": {"superposition", "edge"}, "wedge": set()}
        for name, files in carried.items():
            unit = self.unit(**{"algorithm.preset": "brash", "failure.model": name})
            found = {path.stem.removeprefix("cone_") for path in unit.folder.glob("resources/models/*.json")}
            self.assertEqual(found, files, name)
            self.keep(started(unit)).step(0.0, 20 * STEP)

    def test_a_model_file_of_ones_own_travels_along(self):
        own = {"failure.file": SOURCE / "experiments/failure_database/cone_network.json"}
        instance = self.keep(started(self.unit(**own)))
        self.assertEqual(rows(instance, 0, 30), UNITS.history(3)[:30])


class Fmi2(Under2, Tests, unittest.TestCase):
    pass


class Fmi3(Under3, Tests, unittest.TestCase):
    pass


if __name__ == "__main__":
    unittest.main()
