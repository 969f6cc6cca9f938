# SPDX-License-Identifier: GPL-3.0-or-later
"""A case file under another name, in another folder, gives the same results: seed, replicate and purpose make the random
numbers, and no name does."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
DRAWN = ("--set", "ice.variation.thickness=0.1", "--set", "field.edge_roughness=0.05", "--set", "time.duration=2.5")


class CopiedCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def results(self, name, *words):
        """Histories of a copy of the case called `name`, of its loads and of its events."""
        case = self.path / name
        case.parent.mkdir(exist_ok=True)
        shutil.copy(SOURCE / "experiments/validation/cone.toml", case)
        run = case.with_suffix("")
        done = subprocess.run([BRASH, "run", case, "-o", run, *DRAWN, *words], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [(run / file).read_bytes() for file in ("history.csv", "events.csv")]

    def test_a_copy_under_another_name_gives_the_same_loads(self):
        for preset in ("paper", "brash"):
            with self.subTest(preset):
                words = ("--set", f"algorithm.preset={preset}")
                first = self.results(f"{preset}.toml", *words)
                self.assertGreater(len(first[1].splitlines()), 1, "no break, and so hardly a random number")
                self.assertEqual(self.results(f"elsewhere/copy of {preset}.toml", *words), first)
                self.assertNotEqual(self.results(f"{preset} 2.toml", "--seed", "2", *words), first)


if __name__ == "__main__":
    unittest.main()
