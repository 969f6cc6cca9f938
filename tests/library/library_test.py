# SPDX-License-Identifier: GPL-3.0-or-later
"""The library without files: a C++ program of thirty lines gives what the command gives, and links no file formats.

library_test.py PROGRAM BRASH
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, BRASH = sys.argv[1:3]
SOURCE = pathlib.Path(__file__).resolve().parents[2]
SECONDS = "3"


class Library(unittest.TestCase):
    def test_a_program_without_files_gives_what_the_command_gives(self):
        said = subprocess.run([PROGRAM, SECONDS], capture_output=True, text=True, check=True).stdout
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "-o", folder, "--set",
                            "algorithm.preset=brash", "--set", f"time.duration={SECONDS}"],
                           capture_output=True, check=True)
            summary = json.loads((pathlib.Path(folder) / "summary.json").read_text())
        mean = summary["mean_whole_history"]["horizontal"]
        self.assertEqual(said, f"{mean:.10g} N mean over {SECONDS} s, {summary['n_breaks']} breaks\n")

    def test_it_links_no_library_of_files(self):
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True, check=True).stdout
        for library in ("netcdf", "hdf5", "udunits", "CLI"):
            self.assertNotIn(library, linked)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
