# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash check` and `brash loads`: what they derive of a case."""
import json
import os
import pathlib
import subprocess
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


class Check(unittest.TestCase):
    def check(self, *options):
        done = subprocess.run([BRASH, "check", str(SOURCE / "experiments/validation/cone.toml"), *options],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_a_radius_is_named_where_a_crack_is_cut(self):
        line = "# initial crack radius"
        self.assertIn(line, self.check())
        self.assertNotIn(line, self.check("--set", "field.initial_crack=false"))


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
