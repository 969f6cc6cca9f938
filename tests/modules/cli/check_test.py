# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash check`: what it derives of a case."""
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


if __name__ == "__main__":
    unittest.main()
