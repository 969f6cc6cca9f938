# SPDX-License-Identifier: GPL-3.0-or-later
"""Too little memory, and clocks that go backwards or fast."""
import json
import os
import resource
import unittest

from program import (BRASH, CASE, SANITIZED, FaultTest, call, campaign_command, database_command, run_command, start,
                     wait_for)

MEGABYTE = 1 << 20


def limited(megabytes):
    return lambda: resource.setrlimit(resource.RLIMIT_AS, (megabytes * MEGABYTE, megabytes * MEGABYTE))


@unittest.skipIf(SANITIZED, "a sanitizer reserves more address space than there is memory")
class Memory(FaultTest):
    def setUp(self):
        super().setUp()
        # Below it not even the libraries find a place, and the one that reads units ends the program.
        self.least = next(megabytes for megabytes in range(32, 4096, 4)
                          if call([BRASH, "check", str(CASE)], preexec_fn=limited(megabytes)).returncode == 0)

    def test_a_run_without_enough_memory_ends_with_an_error_and_goes_on_with_more(self):
        self.succeeds(run_command(self.path / "whole"))
        whole = self.bytes_of(self.path / "whole")
        for megabytes in range(self.least, 4096, 8):
            folder = self.path / str(megabytes)
            done = call(run_command(folder), preexec_fn=limited(megabytes))
            if done.returncode == 0:
                break
            self.fails_clearly(done, {1}, "memory")
            self.assertFalse((folder / "manifest.json").exists())
            self.has_no_half_files(folder)
            self.succeeds(run_command(folder, "--resume"))
            self.assertEqual(self.bytes_of(folder), whole)
        self.assertGreater(megabytes, self.least)
        self.assertEqual(self.bytes_of(folder), whole)

    def test_a_campaign_without_enough_memory_records_no_case_as_failed(self):
        folder = self.path / "campaign"
        for megabytes in (self.least, self.least + 8):
            done = call(campaign_command(folder, "--resume"), preexec_fn=limited(megabytes))
            self.fails_clearly(done, {1}, "memory")
            self.assertEqual(list(folder.glob("cases/*.failed")), [])
        self.succeeds(campaign_command(folder, "--resume"))


class Clock(FaultTest):
    def test_no_result_depends_on_the_time_of_day(self):
        """What runs while the clock is set back gives the same bytes; only the manifest says when it was."""
        backwards = {**os.environ, "LD_PRELOAD": os.environ["BRASH_BACKWARD_CLOCK"],
                     "ASAN_OPTIONS": "verify_asan_link_order=0"}
        self.succeeds(run_command(self.path / "forwards"))
        self.succeeds(run_command(self.path / "backwards"), env=backwards)
        self.assertEqual(self.bytes_of(self.path / "forwards"), self.bytes_of(self.path / "backwards"))
        times = [json.loads((self.path / name / "manifest.json").read_text())["volatile"]["started_at"]
                 for name in ("forwards", "backwards")]
        self.assertLess(times[1], times[0])
        self.succeeds(database_command(self.path / "one.nc"))
        self.succeeds(database_command(self.path / "two.nc"), env=backwards)
        self.assertEqual((self.path / "one.nc").read_bytes(), (self.path / "two.nc").read_bytes())

    def test_a_long_run_keeps_a_state_every_two_minutes_whatever_its_interval(self):
        fast = {**os.environ, "LD_PRELOAD": os.environ["BRASH_FAST_CLOCK"], "ASAN_OPTIONS": "verify_asan_link_order=0"}
        rare = ("--set", "output.checkpoint_interval=1000")  # of simulated time: longer than the run
        self.succeeds(run_command(self.path / "whole", *rare))
        run = start(run_command(self.path / "fast", *rare), env=fast)
        found = wait_for((self.path / "fast" / "checkpoint.nc").exists, run)
        run.kill()
        self.assertTrue(found, f"no state in two minutes of the clock: {run.communicate()[1]}")
        self.succeeds(run_command(self.path / "fast", *rare, "--resume"))
        self.assertEqual(self.bytes_of(self.path / "fast"), self.bytes_of(self.path / "whole"))


if __name__ == "__main__":
    unittest.main()
