# SPDX-License-Identifier: GPL-3.0-or-later
"""Folders and files whose permissions forbid what is asked; as another user where this one may do everything."""
import os
import unittest

from program import BRASH, FaultTest, call, campaign_command, database_command, run_command

NOBODY = 65534


class Permission(FaultTest):
    def setUp(self):
        super().setUp()
        self.path.chmod(0o755)
        self.theirs = self.path / "theirs"
        self.theirs.mkdir()
        self.theirs.chmod(0o777)
        self.other = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.geteuid() == 0 else {}
        if self.other and call(["test", "-x", BRASH], **self.other).returncode != 0:
            self.skipTest("another user cannot reach the program: a folder above it is closed")

    def call(self, command):
        return call(command, **self.other, timeout=60, cwd="/")

    def test_a_folder_that_may_not_be_written_is_refused_before_anything_runs(self):
        closed = self.path / "closed"
        closed.mkdir()
        closed.chmod(0o555)
        for target in (closed, closed / "new"):
            for command in (run_command, campaign_command, database_command):
                longer = ["--set", "time.duration=1000"] if command is run_command else []
                self.fails_clearly(self.call(command(target, *longer)), {1, 2}, str(closed), "Permission denied")
        self.assertEqual(list(closed.iterdir()), [])

    def test_a_case_that_may_not_be_read_is_named(self):
        case = self.theirs / "case.toml"
        case.write_text("")
        case.chmod(0)
        self.fails_clearly(self.call([BRASH, "run", str(case), "-o", str(self.theirs / "run")]), {2}, str(case),
                           "Permission denied")
        self.assertFalse((self.theirs / "run").exists())

    def test_a_checkpoint_that_may_not_be_read_is_named_and_left_alone(self):
        folder = self.theirs / "run"
        self.assertEqual(self.call(run_command(folder)).returncode, 0)
        checkpoint = folder / "checkpoint.nc"
        checkpoint.chmod(0)
        self.fails_clearly(self.call(run_command(folder, "--resume")), {2}, str(checkpoint), "Permission denied")
        self.assertTrue((folder / "summary.json").exists())

    def test_a_folder_closed_while_it_is_used_ends_the_run_with_an_error(self):
        folder = self.theirs / "run"
        self.assertEqual(self.call(run_command(folder)).returncode, 0)
        whole = self.bytes_of(folder)
        folder.chmod(0o555)
        self.fails_clearly(self.call(run_command(folder, "--resume")), {1, 2}, str(folder), "Permission denied")
        self.assertEqual(self.bytes_of(folder), whole)
        folder.chmod(0o755)


if __name__ == "__main__":
    unittest.main()
