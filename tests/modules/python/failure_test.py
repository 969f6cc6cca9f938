# SPDX-License-Identifier: GPL-3.0-or-later
"""Failure models and closed forms on arrays."""
import json
import os
import pathlib
import subprocess
import sys
import unittest

import numpy as np

import brash

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
CONE = SOURCE / "experiments/validation/cone.toml"
DEMO = SOURCE / "experiments/validation/demo.toml"  # the same with the default preset
ROW = dict(b_lc=0.2, c_lc=0.1, theta=1.0, mu1=0.5, mu2=0.1)


class Models(unittest.TestCase):
    def test_they_say_what_the_command_says(self):
        rows = "b_lc,c_lc,theta_deg,mu1,mu2,lc_over_h\n0.2,0.1,60,0.5,0.1,9\n0.4,0.2,30,0.6,0,8\n"
        for model in ("network", "deep-network", "superposition", "fem", str(SOURCE / "experiments/failure_database/cone_network.json")):
            said = subprocess.run([os.environ["BRASH"], "failure", "predict", "--model", model], input=rows, text=True,
                                  capture_output=True, check=True).stdout.splitlines()[1:]
            wanted = np.array([line.split(",")[6:8] for line in said], float)
            got = brash.FailureModel(model)([0.2, 0.4], [0.1, 0.2], np.radians([60, 30]), [0.5, 0.6], [0.1, 0], 1 / np.array([9, 8]))
            np.testing.assert_allclose(np.stack([got.sigma_over_p, got.lbreak_over_lc], 1), wanted, rtol=1e-5)

    def test_arrays_broadcast(self):
        model = brash.FailureModel()
        grid = model(**{**ROW, "b_lc": np.linspace(0, 0.4, 3)[:, None], "c_lc": np.linspace(0.1, 0.4, 4)})
        self.assertEqual(grid.sigma_over_p.shape, (3, 4))
        self.assertEqual(grid.in_range.dtype, bool)
        one = model(**{**ROW, "b_lc": 0.2, "c_lc": 0.3})
        self.assertEqual(one.sigma_over_p.shape, ())
        self.assertEqual(one.sigma_over_p, grid.sigma_over_p[1, 2])
        self.assertEqual(model(**{**ROW, "b_lc": np.zeros((0, 3))}).sigma_over_p.shape, (0, 3))

    def test_an_input_outside_the_range_is_told(self):
        got = brash.FailureModel("network")(**{**ROW, "mu1": [0.5, 50]})
        self.assertEqual(got.in_range.tolist(), [True, False])

    def test_a_failed_allocation_raises_and_the_interpreter_lives_on(self):
        code = ("import resource, numpy as np, brash\n"
                "wide = np.broadcast_to(1.0, 10**9)  # a view without memory of its own\n"
                "model = brash.FailureModel()\n"
                "resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))\n"
                "long = np.full((30_000, 1), 0.2)\n"
                "for call in (lambda: model(b_lc=long, c_lc=long.T, theta=1.0, mu1=0.5, mu2=0.1),\n"
                "             lambda: model(b_lc=0.2, c_lc=wide, theta=1.0, mu1=0.5, mu2=0.1),\n"
                "             lambda: brash.moments(wide), lambda: brash.Polygon(np.broadcast_to(1.0, (10**9, 2)))):\n"
                "    try:\n"
                "        call()\n"
                "    except MemoryError:\n"
                "        print('MemoryError')\n")
        done = subprocess.run([sys.executable, "-c", code], text=True, capture_output=True)
        self.assertEqual((done.returncode, done.stdout.split()), (0, ["MemoryError"] * 4), done.stderr)

    def test_bad_inputs_are_refused(self):
        model = brash.FailureModel("superposition")
        for change in ({"b_lc": -6}, {"c_lc": 0}, {"theta": np.pi}, {"mu1": 0}, {"mu1": np.nan}, {"mu2": np.inf},
                       {"b_lc": "x"}, {"b_lc": None}, {"thickness_over_lc": 0}, {"b_lc": [1, 2], "c_lc": [1, 2, 3]},
                       {"mu1": [0.5, -0.5]}):
            with self.subTest(change), self.assertRaises(brash.InputError):
                model(**{**ROW, **change})
        for name in ("none.json", "", str(CONE), "/"):
            with self.subTest(name), self.assertRaises(brash.InputError):
                brash.FailureModel(name)
        with self.assertRaisesRegex(brash.InputError, "network, deep-network, superposition, fem"):
            brash.FailureModel("netwrk")

    def test_criteria_assess_the_ice_of_a_case(self):
        case = brash.Case.from_file(CONE)
        load = dict(depth=0.5, contact_length=0.4, angle=1.0, mu1=0.5, mu2=0.1)
        for model in (None, "network", "deep-network", "superposition", "plate", "wedge"):
            answer = brash.Criterion(case, model)(**load, pressure=[0, 1e5, 1e7])
            self.assertEqual(answer.fails[[0, 2]].tolist(), [False, True], model)
            self.assertGreater(answer.breaking_length[2], 0)
        with self.assertRaises(brash.InputError):
            brash.Criterion(case, "nonsense")
        with self.assertRaises(brash.InputError):
            brash.Criterion(case)(**load, pressure=np.nan)

    def test_a_criterion_by_name_keeps_the_options_of_the_case(self):
        case = brash.Case.from_file(CONE, {"algorithm.preset": "brash", "failure.model": "superposition"})
        load = dict(depth=0.0, contact_length=0.5, angle=1.0, mu1=0.511, mu2=0.01, pressure=[4e5, 9e5])
        own, named = brash.Criterion(case)(**load), brash.Criterion(case, "superposition")(**load)
        plain = brash.Criterion(brash.Case.from_file(CONE), "superposition")(**load)
        np.testing.assert_array_equal(own.sigma_max, named.sigma_max)
        self.assertTrue((plain.sigma_max != named.sigma_max).all())

    def test_a_criterion_by_name_is_that_of_the_case_with_this_model(self):
        load = dict(depth=0.0, contact_length=0.5, angle=1.0, mu1=0.511, mu2=0.01, pressure=[4e5, 9e5])
        # The network knows none of the options of the preset.
        case = brash.Case.from_file(CONE, {"algorithm.preset": "brash", "failure.model": "network"})
        for model in ("plate", "plate-outline", "superposition"):
            changed = case.copy()
            changed.update({"failure.model": model})
            named, own = brash.Criterion(case, model)(**load), brash.Criterion(changed)(**load)
            np.testing.assert_array_equal(named.sigma_max, own.sigma_max, model)
            np.testing.assert_array_equal(named.breaking_length, own.breaking_length, model)
        self.assertEqual(case["failure.model"], "network")

    def test_a_criterion_by_name_leaves_out_the_options_that_its_model_does_not_take(self):
        load = dict(depth=0.0, contact_length=0.5, angle=1.0, mu1=0.511, mu2=0.01, pressure=4e5)
        case = brash.Case.from_file(CONE, {"algorithm.preset": "brash"})
        written = brash.Case.from_text(case.to_toml())  # with every key
        for model in ("network", "wedge", "superposition"):
            np.testing.assert_array_equal(brash.Criterion(written, model)(**load), brash.Criterion(case, model)(**load))

    def test_a_criterion_judges_where_its_case_says(self):
        load = dict(depth=0.0, contact_length=0.5 * 3.27, angle=0.0, mu1=0.511, mu2=0.0, pressure=3e5)
        def stress(judged):
            changes = {"algorithm.preset": "brash", "failure.order": "circumferential-first", "failure.second_order": False,
                       "failure.pattern": "disc", "failure.judged": judged}
            return brash.Criterion(brash.Case.from_file(CONE, changes))(**load).sigma_max
        # docs/theory/fracture-of-the-edge.md, beside the centre line: 1.23 with the fine mesh, 1.19 with the fast one
        self.assertAlmostEqual(float(stress("anywhere") / stress("centre-line")), 1.21, delta=0.03)

    def test_load_ratios_of_a_frictionless_slope(self):
        ratios = brash.load_ratios(np.radians([30, 45]), 0)
        np.testing.assert_allclose(ratios.mu1, 1 / np.tan(np.radians([30, 45])))
        np.testing.assert_allclose(ratios.mu2, 0)
        with self.assertRaises(brash.InputError):
            brash.load_ratios(2, 0)


class ClosedForms(unittest.TestCase):
    ICE = dict(thickness=0.33, flexural_strength=539e3, youngs_modulus=0.35e9)
    PLATE = dict(**ICE, poisson_ratio=0.3, friction_structure=0.1, friction_ice=0.1, ice_density=900, water_density=1025)
    SHIP = dict(length=100, breadth=20, draught=7, stem_angle=0.4, waterline_angle=0.5, friction=0.1, speed=2,
                poisson_ratio=0.3, ice_density=900, water_density=1025, **ICE)
    CONE = dict(slope=1.0, waterline_width=10, end_width=2, thickness=0.33, flexural_strength=539e3,
                friction_structure=0.1, ice_density=900, water_density=1025, breaking="upward")

    HULL = dict(length=150, breadth=22.2, draught=9.5, midbody=12, bow_length=61, stem_angle=np.radians(16), thickness=1.04,
                speed=1)
    BASIN = dict(breadth=22.2, draught=9.5, thickness=1.04, speed=1, flexural_strength=592e3, ice_density=900, water_density=1000)
    KEEL = dict(width=100, keel_depth=16, keel_porosity=0.3, keel_cohesion=6e3, keel_friction_angle=np.radians(30),
                ice_density=910, water_density=1024)
    WALL = dict(width=100, thickness=1, strength_coefficient=2.8e6)
    FLOATING = dict(thickness=0.33, youngs_modulus=0.35e9, poisson_ratio=0.3, water_density=1025)

    @classmethod
    def calls(cls):
        """Each closed form with arguments in its range."""
        layer = dict(layer_thickness=2, strength_coefficient=1.8e6)
        return ((brash.croasdale, dict(slope=1.0, width=13.6, **cls.PLATE)), (brash.ralston, cls.CONE),
                (brash.nevel, dict(wedge_angle=0.8, loaded_length=0.33, water_density=1025, **cls.ICE)),
                (brash.global_crushing, cls.WALL), (brash.keel, cls.KEEL), (brash.ridge, {**cls.KEEL, **layer}),
                (brash.lindqvist, cls.SHIP), (brash.riska, cls.HULL), (brash.jeong, cls.BASIN),
                (brash.characteristic_length, cls.FLOATING), (brash.breaking_length, cls.FLOATING))

    def test_numbers_of_their_sources(self):
        # tests/modules/standards says where each comes from.
        self.assertAlmostEqual(brash.riska(**self.HULL).total / 1e3, 1026, delta=0.5)
        self.assertAlmostEqual(brash.jeong(**self.BASIN, buoyancy_factor=0.374).total / 1e3, 963, delta=0.5)
        tower = brash.global_crushing(width=5, thickness=1, strength_coefficient=2.2e6)
        self.assertAlmostEqual(tower.horizontal, 8.50271e6, delta=5)
        self.assertAlmostEqual(brash.keel(**self.KEEL, gravity=9.81).horizontal / 1e6, 65.0048, places=4)
        self.assertAlmostEqual(brash.characteristic_length(**self.FLOATING), 3.272, places=3)
        self.assertAlmostEqual(brash.breaking_length(**self.FLOATING), 3.272 * np.pi / 2**1.5, places=3)

    def test_arrays_broadcast_and_have_the_values_of_floats(self):
        def fields(result):
            return result if isinstance(result, tuple) else (result,)

        factors = np.array([1.0, 1.02, 1.05])
        for form, given in self.calls():
            first, second = [name for name in given if name != "breaking"][:2]
            rows, columns = given[first] * factors[:2, None], given[second] * factors
            table = fields(form(**{**given, first: rows, second: columns}))
            for i, j in np.ndindex(2, 3):
                one = fields(form(**{**given, first: rows[i, 0], second: columns[j]}))
                self.assertEqual([array[i, j] for array in table], list(one), form.__name__)

    def test_a_result_is_a_named_tuple_of_floats_or_arrays(self):
        load = brash.riska(**self.HULL)
        self.assertEqual(load._fields, ("total", "at_rest", "per_speed"))
        self.assertIs(type(load.total), float)
        table = brash.riska(**{**self.HULL, "speed": [0.5, 1.0]})
        self.assertIsInstance(table, brash.RiskaLoad)
        self.assertEqual(table.total.shape, (2,))
        self.assertEqual(brash.riska(**{**self.HULL, "speed": np.zeros((0, 3))}).total.shape, (0, 3))
        self.assertIs(type(brash.nevel(wedge_angle=0.8, loaded_length=0.33, water_density=1025, **self.ICE).in_range), bool)
        with self.assertRaisesRegex(brash.InputError, r"cannot be broadcast together: .*thickness \(3,\).*speed \(2,\)"):
            brash.riska(**{**self.HULL, "speed": [0, 1], "thickness": [1, 1, 1]})

    def test_elements_out_of_a_formula_s_range_are_nan_with_one_warning(self):
        with self.assertWarnsRegex(UserWarning, r"global_crushing: 2 of 6 elements are nan.* \[0, 0\]: the face is narrower"):
            load = brash.global_crushing(width=[[1], [20], [50]], thickness=[1, 2], strength_coefficient=2.8e6)
        np.testing.assert_array_equal(np.isnan(load.horizontal), [[True, True], [False, False], [False, False]])

    def test_a_value_out_of_range_is_named_with_what_is_allowed(self):
        for form, given in self.calls():
            with self.assertRaisesRegex(brash.InputError, rf"^{form.__name__}: \w+ = -1 .* is out of range: it must be .*\. Give "):
                form(**{name: -1.0 if name != "breaking" else "upward" for name in given})
        with self.assertRaisesRegex(brash.InputError, r"croasdale: slope\[1\] = 60 rad is out of range: it must be above 0 and "
                                                      r"below 1.5708. Give angles in radians: numpy.radians\(45\)"):
            brash.croasdale(slope=[1.0, 60.0], width=13.6, **self.PLATE)
        with self.assertRaisesRegex(brash.InputError, "jeong: must hold: .*water_density > in.ice_density"):
            brash.jeong(**{**self.BASIN, "ice_density": 1030})

    def test_forms_of_a_case_are_the_forms_of_its_numbers(self):
        cone, ice = brash.Case.from_file(DEMO), dict(thickness=0.33, youngs_modulus=0.35e9, water_density=1025)
        self.assertEqual(brash.breaking_length_of(cone), brash.breaking_length(**self.FLOATING))
        self.assertAlmostEqual(brash.characteristic_length(cone), brash.characteristic_length(**self.FLOATING), places=12)
        self.assertEqual(brash.nevel_of(cone, 4), brash.nevel(wedge_angle=np.pi / 4, loaded_length=0.33, flexural_strength=539e3, **ice))
        self.assertEqual(brash.global_crushing_of(cone, strength_coefficient=1.8e6),
                         brash.global_crushing(width=13.6, thickness=0.33, strength_coefficient=1.8e6))
        of_ridge = dict(layer_thickness=1, strength_coefficient=1.8e6, keel_depth=[5, 9], keel_porosity=0.3, keel_cohesion=6e3,
                        keel_friction_angle=0.5)
        with self.assertRaisesRegex(brash.NotApplicable, "the face slopes"):
            brash.ridge_of(cone, **of_ridge)
        pile = brash.Case.from_file(DEMO, {"structure.angle": "90 deg", "field.initial_crack": False})
        np.testing.assert_array_equal(brash.ridge_of(pile, **of_ridge).keel,
                                      brash.ridge(width=13.6, ice_density=900, water_density=1025, **of_ridge).keel)
        with self.assertRaisesRegex(TypeError, "width is set by the case"):
            brash.ridge_of(pile, width=3, **of_ridge)
        with self.assertRaisesRegex(brash.NotApplicable, "two at least"):
            brash.nevel_of(cone, 1)

    def test_the_case_s_loads_are_those_of_the_command(self):
        case = brash.Case.from_file(CONE)
        said = subprocess.run([os.environ["BRASH"], "loads", CONE], capture_output=True, text=True, check=True).stdout
        self.assertIn(f"{brash.croasdale_of(case).horizontal / 1e3:10.1f}", said)
        self.assertIn(f"{brash.ralston_of(case, 'johansen').horizontal / 1e3:10.1f}", said)

    def test_each_is_callable_by_keywords(self):
        self.assertGreater(brash.croasdale(slope=1.07, width=13.6, **self.PLATE).horizontal, 0)
        crushing = brash.global_crushing(width=100, thickness=1, strength_coefficient=2.8e6)
        self.assertAlmostEqual(crushing.pressure / 1e6, 1.340, places=3)
        with self.assertRaises(brash.NotApplicable):
            brash.global_crushing(width=1, thickness=1, strength_coefficient=2.8e6)
        self.assertGreater(brash.nevel(wedge_angle=0.8, loaded_length=0.33, water_density=1025, **self.ICE).vertical, 0)
        ship = brash.lindqvist(**self.SHIP)
        self.assertGreater(ship.total, ship.crushing + ship.bending + ship.submersion)
        self.assertGreater(brash.ralston(**self.CONE, yield_criterion="johansen").breaking_horizontal,
                           brash.ralston(**self.CONE).breaking_horizontal)
        with self.assertRaises(brash.InputError):
            brash.ralston(**{**self.CONE, "breaking": "sideways"})

    def test_what_changes_a_load_has_no_default(self):
        for form, given in self.calls():
            form(**given)
            for name in given:
                with self.subTest(form=form, name=name), self.assertRaisesRegex(TypeError, name):
                    form(**{key: value for key, value in given.items() if key != name})
        with self.assertRaisesRegex(TypeError, r"lindqvist\(\) misses friction \[-\]: the load depends on it"):
            brash.lindqvist(**{key: value for key, value in self.SHIP.items() if key != "friction"})

    def test_rubble_with_a_height_has_properties(self):
        plate = dict(slope=1.0, width=13.6, **self.PLATE)
        rubble = dict(rubble_porosity=0.3, rubble_cohesion=0, rubble_angle=0.6, rubble_friction_angle=0.7)
        self.assertEqual(brash.croasdale(**plate, rubble_height=0).horizontal, brash.croasdale(**plate).horizontal)
        with self.assertRaisesRegex(TypeError, "misses rubble_porosity .*rubble_cohesion .*rubble_friction_angle"):
            brash.croasdale(**plate, rubble_height=1)
        self.assertGreater(brash.croasdale(**plate, rubble_height=1, **rubble).horizontal,
                           brash.croasdale(**plate).horizontal)

    def test_a_case_with_a_hull_has_the_resistance_of_the_command(self):
        hull = {"hull.length": 75.2, "hull.breadth": 18, "hull.draught": 6.5, "hull.stem_angle": "30 deg",
                "hull.waterline_angle": "35 deg"}
        given = [f"--set={key}={value}" for key, value in hull.items()]
        said = subprocess.run([os.environ["BRASH"], "loads", CONE, "--json", *given], capture_output=True, text=True,
                              check=True).stdout
        ship, cone = brash.Case.from_file(CONE, hull), brash.Case.from_file(CONE)
        for form, load in zip((brash.lindqvist_of, brash.riska_of, brash.jeong_of), json.loads(said)["loads"][-3:], strict=True):
            self.assertAlmostEqual(form(ship).total, load["horizontal"], places=6)
            with self.assertRaisesRegex(brash.NotApplicable, r"no section \[hull\]"):
                form(cone)

    def test_what_does_not_apply_and_what_is_wrong_are_told_apart(self):
        with self.assertRaises(brash.NotApplicable):
            brash.croasdale(slope=1.5, width=13.6, **{**self.PLATE, "friction_structure": 0.9})
        for bad in (dict(slope=0), dict(slope=np.nan), dict(width=-1)):
            with self.subTest(bad), self.assertRaises(brash.InputError):
                brash.croasdale(**{**dict(slope=1.0, width=13.6), **bad}, **self.PLATE)
        for bad in (dict(slop=1), dict(width="wide"), dict(width=None)):
            with self.subTest(bad), self.assertRaises((TypeError, ValueError)):
                brash.croasdale(**{**dict(slope=1.0, width=13.6), **bad}, **self.PLATE)
        with self.assertRaisesRegex(TypeError, "misses width"):
            brash.croasdale(slope=1.0, **self.PLATE)


class MovingEdges(unittest.TestCase):
    def test_an_edge_breaks_at_any_speed_as_the_reference(self):
        case = brash.Case.from_file(DEMO)
        broken = brash.MovingEdge(case)(b_lc=0.4, c_lc=0.3, theta=np.radians(60), speed=[0.0, 1.202])
        # An independent calculation has 49.5 and 55.3 kN; the model is within 2 % of the plate.
        np.testing.assert_allclose(broken.load, [49.5e3, 55.3e3], rtol=0.03)
        np.testing.assert_allclose(broken.deflection, [0.185, 0.032], rtol=0.05)
        self.assertFalse(broken.radial_first.any())
        self.assertTrue(broken.in_range.all())

    def test_a_bay_bears_more_than_a_straight_edge_and_is_solved_not_looked_up(self):
        case = brash.Case.from_file(CONE)
        edge = dict(c_lc=0.3, theta=np.radians(60), speed=[0.0, 1.202])
        straight, bay = (brash.MovingEdge(case, "fem")(b_lc=b, **edge) for b in (0.0, -0.4))
        self.assertTrue((bay.load > 1.5 * straight.load).all())
        self.assertTrue((bay.breaking_length > straight.breaking_length).all())
        self.assertTrue(bay.in_range.all())
        self.assertFalse(brash.MovingEdge(case)(b_lc=-0.4, **edge).in_range.any())

    def test_a_speed_beyond_that_of_any_case_is_refused_by_its_name(self):
        edge = brash.MovingEdge(brash.Case.from_file(CONE))
        for speed in (1e9, 50.1, np.inf, -1.0):
            with self.subTest(speed), self.assertRaisesRegex(ValueError, "^speed: value .* must be >= 0 and <= 50"):
                edge(b_lc=0.0, c_lc=0.3, theta=0.0, speed=[1.0, speed])
        self.assertTrue(np.isfinite(edge(b_lc=0.0, c_lc=0.3, theta=0.0, speed=[0.01, 50.0]).load).all())
        slow = edge(b_lc=0.0, c_lc=0.3, theta=0.0, speed=[0.0, 1e-6, 1e-3])  # without end, step by step
        np.testing.assert_allclose(slow.load, slow.load[0], rtol=1e-4)
        np.testing.assert_allclose(slow.time[1], 1e3 * slow.time[2], rtol=1e-4)

    def test_inputs_outside_the_range_are_told_and_impossible_ones_refused(self):
        edge = brash.MovingEdge(brash.Case.from_file(CONE))
        self.assertFalse(edge(b_lc=3.0, c_lc=0.3, theta=1.0, speed=1.0).in_range)
        with self.assertRaises(brash.InputError):
            edge(b_lc=0.0, c_lc=0.0, theta=1.0, speed=1.0)


if __name__ == "__main__":
    unittest.main()
