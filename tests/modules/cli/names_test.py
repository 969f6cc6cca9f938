# SPDX-License-Identifier: GPL-3.0-or-later
"""A file is not written under a name that promises another format: the command says which endings there are."""
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
CASE = SOURCE / "experiments/validation/cone.toml"
PICTURES = "a name that ends in .svg or .png"


class Names(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)
        (self.folder / "floes.wkt").write_text("POLYGON ((0 0, 1 0, 0 1, 0 0))\n")
        (self.folder / "history.csv").write_text("time,Fx\n" + "".join(f"{0.1 * i},{i % 7}\n" for i in range(400)))

    def brash(self, *words, **options):
        return subprocess.run([BRASH, *map(str, words)], cwd=self.folder, capture_output=True, text=True, **options)

    def test_a_name_of_another_format_is_refused_with_the_endings_that_there_are(self):
        before = sorted(self.folder.rglob("*"))
        for allowed, words in (
                (PICTURES, ("check", CASE, "--picture")),
                (PICTURES, ("pieces", "floes.wkt", "-o")),
                (PICTURES, ("stats", "history.csv", "--picture")),
                (PICTURES, ("compare", "history.csv", "history.csv", "-o")),
                (PICTURES, ("design", ".", "-o")),
                ("a name that ends in .fmu", ("export", "fmu", CASE, "-o")),
                ("a name that ends in .glb", ("export", "gltf", "run.nc", "-o"))):
            for name in ("x.txt", "svg", "x.fmu.zip"):
                with self.subTest(" ".join(map(str, (*words, name)))):
                    done = self.brash(*words, name)
                    self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
                    self.assertIn(f"brash: {name}: is not a name of a", done.stderr)
                    self.assertIn(f"\n  allowed: {allowed}\n", done.stderr)
                    self.assertIn("\n  remedy:  change the name", done.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_check_draws_svg_and_with_rsvg_convert_png(self):
        done = self.brash("check", CASE, "--picture", "case.svg")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue((self.folder / "case.svg").read_text().startswith("<svg "))
        without = self.brash("check", CASE, "--picture", "case.png", env={**os.environ, "PATH": "/nowhere"})
        self.assertEqual(without.returncode, 2)
        self.assertIn("rsvg-convert", without.stderr)
        self.assertFalse((self.folder / "case.png").exists())
        if shutil.which("rsvg-convert"):
            done = self.brash("check", CASE, "--picture", "case.png")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual((self.folder / "case.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")


if __name__ == "__main__":
    unittest.main()
