# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases are read, changed and checked as the command does it."""
import copy
import multiprocessing
import os
import pathlib
import pickle
import re
import subprocess
import tempfile
import unittest

import numpy as np

import brash

CONE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments/validation/cone.toml"


def length_of(case):
    return brash.characteristic_length(case)


class Cases(unittest.TestCase):
    def setUp(self):
        self.case = brash.Case.from_file(CONE)

    def test_values_are_si(self):
        self.assertEqual(self.case.name, "cone")
        self.assertEqual(self.case["ice.thickness"], 0.33)
        self.assertEqual(self.case["ice.flexural_strength"], 539e3)
        self.assertEqual(self.case["failure.wedges"], [3, 5])

    def test_a_case_is_pickled_and_goes_to_other_processes(self):
        self.case["ice.thickness"] = 0.4
        again = pickle.loads(pickle.dumps(self.case))
        self.assertEqual(again, self.case)
        again["ice.thickness"] = 0.5  # from its file, with its other changes
        self.assertEqual((again["ice.thickness"], self.case["ice.thickness"], again.name), (0.5, 0.4, "cone"))
        text = brash.Case.from_text(self.case.to_toml(), "text")
        self.assertEqual(pickle.loads(pickle.dumps(text)), text)
        with multiprocessing.get_context("spawn").Pool(1) as pool:
            self.assertEqual(pool.map(length_of, [self.case]), [brash.characteristic_length(self.case)])

    def test_the_mesh_of_the_structure_is_closed_and_as_high_as_the_case_says(self):
        vertices, triangles = self.case.mesh()
        self.assertEqual((vertices.shape, triangles.shape), ((128, 3), (252, 3)))
        self.assertAlmostEqual(np.ptp(vertices[:, 2]), 9.08)
        edges = {(t[i], t[(i + 1) % 3]) for t in triangles.tolist() for i in range(3)}
        self.assertTrue(all((b, a) in edges for a, b in edges))

    def test_a_key_of_a_section_within_a_section_is_read(self):
        self.assertEqual(self.case["structure.motion.kind"], "towed")
        self.case["structure.motion.kind"] = "driven"
        self.assertEqual(self.case["structure.motion.kind"], "driven")
        self.assertEqual(self.case["structure.motion.frame"], "structure-moves")
        with self.assertRaises(KeyError):
            self.case["structure.motion.mass"]

    def test_the_speed_is_read_by_both_of_its_names(self):
        case = brash.Case.from_file(CONE)
        self.assertEqual(case["structure.motion.speed"], case["structure.speed"])

    def test_a_key_is_set_with_a_unit_or_as_a_number(self):
        self.case["ice.thickness"] = "40 cm"
        self.assertEqual(self.case["ice.thickness"], 0.4)
        self.case["ice.thickness"] = np.float64(0.5)
        self.assertEqual(self.case["ice.thickness"], 0.5)
        self.case["failure.wedges"] = np.array([4, 4])
        self.assertEqual(self.case["failure.wedges"], [4, 4])
        self.case["field.initial_crack"] = False
        self.assertIs(self.case["field.initial_crack"], False)

    def test_a_refused_change_changes_nothing_and_says_what_the_command_says(self):
        before = self.case.copy()
        said = subprocess.run([os.environ["BRASH"], "check", CONE, "--set", "ice.thicknes=0.4"], capture_output=True,
                              text=True)
        self.assertEqual(said.returncode, 2)
        with self.assertRaises(brash.InputError) as raised:
            self.case["ice.thicknes"] = 0.4
        self.assertEqual(f"brash: {raised.exception}\n", said.stderr)
        self.assertEqual(self.case, before)
        self.assertIsInstance(raised.exception, ValueError)

    def test_keys_that_depend_on_each_other_are_changed_together(self):
        with self.assertRaises(brash.InputError):
            self.case["structure.height_under_water"] = 9.5
        self.case.update({"structure.height": 12, "structure.height_under_water": 9.5})
        self.assertEqual(self.case["structure.height_under_water"], 9.5)

    def test_the_resolved_text_gives_the_same_case(self):
        self.case["ice.thickness"] = 0.4
        again = brash.Case.from_text(self.case.to_toml(), "cone")
        self.assertEqual(again, self.case)
        self.assertEqual(copy.deepcopy(again), again)
        self.assertEqual(again.to_dict()["ice"]["thickness"], 0.4)

    def test_bad_values_and_keys_are_exceptions(self):
        for value in (float("nan"), float("inf"), -1, "3 kg", "", "\x00\"\n", [], [1, 2], True, 10**40):
            with self.assertRaises(brash.InputError, msg=repr(value)):
                self.case["ice.thickness"] = value
        for value in (None, {}, object(), 1j):
            with self.assertRaises(TypeError, msg=repr(value)):
                self.case["ice.thickness"] = value
        for key in ("", "ice", ".", "ice.", "a=b.c", "ice.thickness.x", "\n", "ice.\x00"):
            with self.assertRaises(brash.InputError, msg=repr(key)):
                self.case[key] = 1
            with self.assertRaises(KeyError, msg=repr(key)):
                self.case[key]

    def test_a_key_that_is_no_text_is_named(self):
        before = self.case.copy()
        for change in (self.case.update, lambda changes: brash.Case.from_file(CONE, changes=changes)):
            for key in (1, None, b"ice.thickness"):
                with self.assertRaises(TypeError) as raised:
                    change({"ice.thickness": 0.4, key: 2})
                self.assertIn(f"{key!r} is not a key", str(raised.exception))
            with self.assertRaises(UnicodeEncodeError):
                change({"ice.\ud800": 2})
        self.assertEqual(self.case, before)

    def test_bad_files_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            missing = pathlib.Path(folder) / "none.toml"
            with self.assertRaisesRegex(brash.InputError, "none.toml"):
                brash.Case.from_file(missing)
            with self.assertRaisesRegex(brash.InputError, "is a folder"):
                brash.Case.from_file(folder)
        with self.assertRaisesRegex(brash.InputError, "mine"):
            brash.Case.from_text("[ice", name="mine")

    def test_names_of_files_stay_with_the_folders_in_which_they_were_given(self):
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        with tempfile.TemporaryDirectory() as folder:
            text = re.sub(r"(?m)^(speed|start_distance|initial_crack) .*$", "", CONE.read_text())
            pathlib.Path(folder, "cone.toml").write_text(text)
            pathlib.Path(folder, "lead.wkt").write_text("POLYGON ((10 -9, 12 -9, 12 -5, 10 -5, 10 -9))")
            pathlib.Path(folder, "path.csv").write_text("time,x,y,heading\n0,-7,0,0\n30,20,0,0\n")
            os.chdir(folder)
            case = brash.Case.from_file("cone.toml", {"field.openings": "lead.wkt", "structure.motion.path": "path.csv"})
            text = CONE.read_text().replace("initial_crack = true", 'openings = "lead.wkt"')
            pathlib.Path("named.toml").write_text(text)
            named = brash.Case.from_file("named.toml")
            os.chdir(before)
            for one in (case, named):
                one["ice.thickness"] = 0.4
                self.assertEqual(one["field.openings"], os.path.join(os.path.realpath(folder), "lead.wkt"))
            self.assertEqual(case["structure.motion.path"], [[0, -7, 0, 0], [30, 20, 0, 0]])

    def test_derived_scales_are_those_of_the_command(self):
        derived = self.case.derived()
        self.assertAlmostEqual(derived["characteristic_length"], brash.characteristic_length(self.case), places=12)
        said = subprocess.run([os.environ["BRASH"], "check", CONE], capture_output=True, text=True, check=True).stdout
        self.assertIn(f"l_c      {derived['characteristic_length']:.4g} m", said)

    def test_template_and_schema_are_there(self):
        self.assertIn("[ice]", brash.template())
        brash.Case.from_text(brash.template())
        self.assertEqual(brash.template(), brash.template(ice="basin"))

    def test_templates_take_the_ice_of_a_site(self):
        self.assertEqual(brash.site_ice(), ["basin", "baltic", "bohai", "arctic"])
        for text in (brash.template(ice="arctic"), brash.new_case(ice="arctic"), brash.new_case("ship", "arctic")):
            self.assertIn("Timco and O'Brien 1994", text)
            self.assertEqual(brash.Case.from_text(text)["ice.youngs_modulus"], 2.8e9)
        with self.assertRaisesRegex(brash.InputError, "there is no ice 'artic'"):
            brash.template(ice="artic")

    def test_a_case_names_its_preset_and_the_program(self):
        program = f"program: brash {brash.__version__}"
        self.assertEqual(self.case.copy().origin, f"preset: {self.case['algorithm.preset']}; {program}")
        changed = brash.Case.from_file(CONE, {"algorithm.preset": "paper", "failure.pieces": "break"})
        self.assertEqual(changed.origin, f"preset: paper (1 key changed); {program}")
        self.assertIn('"thickness"', brash.schema())


if __name__ == "__main__":
    unittest.main()
