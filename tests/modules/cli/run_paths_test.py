# SPDX-License-Identifier: GPL-3.0-or-later
"""A command that reads a run takes its folder or its file, with the same result."""
import os
import pathlib
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


class RunPaths(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "--set", "time.duration=2", "--set",
                        "failure.model=wedge", "--set", "output.statistics_from=1", "-o", cls.folder / "run"],
                       check=True, capture_output=True)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def call(self, *words, code=0):
        done = subprocess.run([BRASH, *map(str, words)], check=False, cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stdout if code == 0 else done.stderr

    def test_an_export_of_the_folder_is_that_of_the_file(self):
        for kind, name in (("vtk", "vtk"), ("openfast", "openfast"), ("gltf", "run.glb"), ("map", "ice.geojson")):
            contents = []
            for given in ("run", "run/run.nc"):
                said = self.call("export", kind, given)
                self.assertIn(f"run/{name}", said)
                place = self.folder / "run" / name
                files = sorted(place.iterdir()) if place.is_dir() else [place]
                contents.append([(file.name, file.read_bytes()) for file in files])
            self.assertEqual(*contents)

    def test_printed_results_of_the_folder_are_those_of_the_file(self):
        cases = [(("stats", "--column", "Fx", "--json"), ("run/run.nc",)),
                 (("pieces", "--born", "--json"), ("run/run.nc",)), (("rerun",), ("run/manifest.json",))]
        if (self.folder / "run/report.html").exists():  # a build without the viewer has no report
            cases.append((("report",), ("run/run.nc", "run/manifest.json")))
        for words, files in cases:
            of_folder = self.call(words[0], "run", *words[1:])
            for file in files:
                self.assertEqual(self.call(words[0], file, *words[1:]), of_folder)

    def test_a_folder_without_the_file_is_refused(self):
        (self.folder / "empty").mkdir()
        for words in (("export", "map"), ("export", "openfast"), ("stats",), ("rerun",), ("pieces",)):
            said = self.call(*words, "empty", code=2)
            self.assertIn("empty: is a folder without", said)
            self.assertIn("give the folder that `brash run` wrote", said)


if __name__ == "__main__":
    unittest.main()
