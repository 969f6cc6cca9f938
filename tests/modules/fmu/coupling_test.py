# SPDX-License-Identifier: GPL-3.0-or-later
"""A compliant tower in a host, the ice in a unit, against the program's own compliant structure."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

import numpy as np

SOURCE = pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
sys.path.insert(0, str(SOURCE / "experiments/coupling"))
import tower  # noqa: E402


class Coupling(unittest.TestCase):
    def test_the_hosts_oscillator_follows_the_closed_form(self):
        oscillator, force = tower.Oscillator(tower.STEP), 1e5
        for _ in range(300):
            stretch, _ = oscillator.advance(np.array([force, 0.0]))
        decay, time = 0.5 * tower.DAMPING / tower.MASS, 300 * tower.STEP
        ring = np.sqrt(tower.STIFFNESS / tower.MASS - decay**2)
        shape = np.exp(-decay * time) * (np.cos(ring * time) + decay / ring * np.sin(ring * time))
        self.assertAlmostEqual(stretch, force / tower.STIFFNESS * (1 - shape), delta=1e-14)

    def test_the_foundation_bears_a_steady_load_when_the_tower_is_at_rest(self):
        force = tower.reaction(np.full(20000, 1e5))  # 200 s: the swing has fallen to e^-30
        self.assertAlmostEqual(force[-1], 1e5, delta=1e-3)
        self.assertGreater(force.max(), 1.5e5)  # it swings beyond the load at first

    def test_the_coupled_tower_is_the_programs_own(self):
        with tempfile.TemporaryDirectory() as folder:
            drawing = pathlib.Path(folder) / "tower.svg"
            subprocess.run([sys.executable, "-B", SOURCE / "experiments/coupling/tower.py", "-o", folder, "--seconds", "3",
                            "--picture", drawing, "--brash", os.environ["BRASH"]], check=True, capture_output=True)
            self.assertTrue(xml.etree.ElementTree.parse(drawing).getroot().tag.endswith("svg"))
            found = json.loads((pathlib.Path(folder) / "coupling.json").read_text())
        # Both runs differ by round-off until a contact falls into another step. Such an impulse, 1e5 N over 0.01 s, moves
        # this tower by 1 mm/s. The whole stretch is 50 mm and more.
        self.assertLess(found["first_difference_of_place"], 1e-12)
        self.assertLess(found["largest_difference_of_place"], 2e-3)
        self.assertGreater(found["largest_stretch"], 0.03)
        mean = found["mean_load"]
        self.assertAlmostEqual(mean["coupled"], mean["own"], delta=0.02 * mean["own"])
        reactions = [found["from_first_touch"][f"reaction_{way}"] for way in ("two_way", "own")]
        for name, force in reactions[0].items():
            self.assertAlmostEqual(force, reactions[1][name], delta=0.02 * reactions[1]["largest"], msg=name)


if __name__ == "__main__":
    unittest.main()
