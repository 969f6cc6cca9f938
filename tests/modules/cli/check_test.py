# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash check` and `brash loads`: what they derive of a case."""
import json
import os
import pathlib
import subprocess
import tomllib
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


class Check(unittest.TestCase):
    def check(self, *options):
        done = subprocess.run([BRASH, "check", str(SOURCE / "experiments/validation/cone.toml"), *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_radius_is_named_where_a_crack_is_cut(self):
        line = "initial crack radius"
        self.assertIn(line, self.check())
        self.assertNotIn(line, self.check("--set", "field.initial_crack=false"))

    def test_lengths_and_times_come_first_and_keys_on_request(self):
        said = self.check().splitlines()
        self.assertLess(len(said), 20)
        self.assertEqual(said[0][:8], "preset: ")
        self.assertRegex(said[1], r"^characteristic length l_c +3\.38")  # with the density of ice, as the paper has it
        self.assertFalse([line for line in said if " = " in line])
        with_keys = self.check("--keys")
        self.assertEqual(with_keys.splitlines()[:len(said)], ["# " + line for line in said])
        self.assertEqual(tomllib.loads(with_keys)["ice"]["thickness"], 0.33)

    def test_duration_and_the_part_for_statistics_are_known_before_the_run(self):
        self.assertRegex(self.check(), r"(?m)^simulated time +20 s in \d+ steps$")
        default = ["--set", "algorithm.preset=brash"]
        begins = "they begin when the structure's axis has passed the last floe of the initial crack"
        self.assertRegex(self.check(*default), rf"(?m)^statistics +from 8\.162 s to 20 s; {begins}$")
        self.assertRegex(self.check("--set", "output.statistics_from=9"), r"(?m)^statistics +from 9 s to 20 s; they begin when output")
        self.assertRegex(self.check(*default, "--set", "time.duration=5"), r"(?m)^statistics +none: the run is over before")

    def test_what_is_zero_but_for_rounding_is_zero(self):
        said = subprocess.run([BRASH, "check", str(SOURCE / "experiments/ships/icebreaker.toml")], capture_output=True,
                              text=True, check=True).stdout
        self.assertIn(" ahead, 0 m to port, ", said)


class Loads(unittest.TestCase):
    def loads(self, *options):
        done = subprocess.run([BRASH, "loads", str(SOURCE / "experiments/validation/cone.toml"), *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def test_the_warnings_of_the_case_come_with_the_loads(self):
        weak = ["--set", "ice.flexural_strength=500"]
        done = self.loads(*weak)
        self.assertIn('warning: flexural-strength: ice.flexural_strength = 500 Pa', done.stderr)
        self.assertIn('was "500 kPa" meant?', done.stderr)
        self.assertNotIn("flexural-strength", done.stdout)
        done = self.loads("--json", *weak)
        self.assertIn("flexural-strength", [w["id"] for w in json.loads(done.stdout)["warnings"]])
        self.assertIn("warning: flexural-strength", done.stderr)

    def test_a_case_without_a_warning_has_none(self):
        self.assertEqual(self.loads().stderr, "")
        self.assertEqual(json.loads(self.loads("--json").stdout)["warnings"], [])


if __name__ == "__main__":
    unittest.main()
