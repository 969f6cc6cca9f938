# SPDX-License-Identifier: GPL-3.0-or-later
"""Streams that are closed, full or left by their reader, and files that may not grow, change no exit code."""
import json
import os
import resource
import shutil
import unittest

from common import Hostile


class Streams(Hostile):
    def test_a_closed_or_full_stderr_leaves_the_exit_codes_as_they_are(self):
        commands = {0: ("run", "case.toml", "-o", "out"), 2: ("check", "missing.toml"), 1: ("rerun", "changed/manifest.json")}
        self.succeeds("run", "case.toml", "-o", "changed")
        manifest = json.loads((self.path / "changed/manifest.json").read_text())
        for output in manifest["outputs"]:
            output["sha256"] = "0" * 64
            (self.path / "changed" / output["path"]).unlink()
        (self.path / "changed/manifest.json").write_text(json.dumps(manifest))
        self.assertEqual(self.call(*commands[1]).returncode, 1)
        (self.path / "warned.toml").write_text((self.path / "case.toml").read_text().replace("0.05", "0.055"))
        for code, command in [*commands.items(), (0, ("check", "warned.toml")), (2, ("no-such-command",)), (2, ())]:
            for name, options in {"closed": {"stderr": None, "preexec_fn": lambda: os.close(2)},
                                  "full": {"stderr": open("/dev/full", "wb")}, "left": {"stderr": self.left_pipe()}}.items():
                with self.subTest(f"{name}: {command}"):
                    shutil.rmtree(self.path / "out", ignore_errors=True)
                    self.assertEqual(self.call(*command, **options).returncode, code)

    def left_pipe(self):
        reading, writing = os.pipe()
        os.close(reading)
        self.addCleanup(os.close, writing)
        return writing

    def test_a_closed_stderr_does_not_give_its_number_to_a_result(self):
        self.succeeds("run", "case.toml", "-o", "open", "--set", "output.checkpoint_interval=0.01")
        self.call("run", "case.toml", "-o", "closed", "--set", "output.checkpoint_interval=0.01", "--set", "time.step=0.005",
                  stderr=None, preexec_fn=lambda: os.close(2))
        for folder in ("open", "closed"):
            for file in (self.path / folder).rglob("*.*"):
                self.assertNotIn(b"warning:", file.read_bytes(), file)

    def test_what_cannot_be_printed_is_an_error(self):
        for options in ({"stdout": None, "preexec_fn": lambda: os.close(1)}, {"stdout": open("/dev/full", "wb")}):
            for command in (("check", "case.toml"), ("schema",), ("--help",), ("stats", "history.csv", "--json")):
                with self.subTest(command):
                    self.refused(*command, code=1, saying="cannot be written", **options)

    def test_a_reader_that_has_left_is_no_reason_to_complain(self):
        for command in (("check", "case.toml"), ("schema",), ("--help",), ("stats", "history.csv", "--json")):
            with self.subTest(command):
                done = self.call(*command, stdout=self.left_pipe())
                complaints = [line for line in done.stderr.splitlines() if not line.startswith(b"warning: ")]
                self.assertEqual((done.returncode, complaints), (1, []))

    def test_a_limit_on_the_size_of_files_is_an_error_and_no_signal(self):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))

        for command in (("run", "case.toml", "-o", "out"), ("stats", "history.csv", "--spectrum", "spectrum.csv"),
                        ("export", "vtk", "none.nc")):
            done = self.call(*command, preexec_fn=limit)
            self.assertIn(done.returncode, (1, 2), done.stderr)
            self.assertNotEqual(done.stderr, b"")


if __name__ == "__main__":
    unittest.main()
