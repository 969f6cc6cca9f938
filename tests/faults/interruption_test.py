# SPDX-License-Identifier: GPL-3.0-or-later
"""Ctrl-C, requests to end, closed terminals, kills, and two processes on one folder."""
import json
import resource
import shutil
import signal
import unittest

from program import (BRASH, FaultTest, call, campaign_command, database_command, run_command, start, wait_for)


class Interruption(FaultTest):
    def setUp(self):
        super().setUp()
        self.folder = self.path / "run"

    def begun(self, command=None, **options):
        """A run that has kept a checkpoint."""
        process = start(command or run_command(self.folder), **options)
        self.assertTrue(wait_for((self.folder / "checkpoint.nc").exists, process))
        return process

    def whole(self):
        self.succeeds(run_command(self.path / "whole"))
        return self.bytes_of(self.path / "whole")

    def test_a_run_that_is_asked_to_end_keeps_its_state_says_how_to_go_on_and_does(self):
        whole = self.whole()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            process = self.begun()
            process.send_signal(number)
            _, said = process.communicate()
            self.assertEqual(process.returncode, 3, said)
            self.assertIn("the same command with `--resume` continues", said)
            self.assertEqual([p.name for p in self.folder.iterdir()], ["checkpoint.nc"])
            self.succeeds(run_command(self.folder, "--resume"))
            self.assertEqual(self.bytes_of(self.folder), whole)
            shutil.rmtree(self.folder)

    def test_a_run_that_another_program_goes_on_with_says_so_for_good(self):
        other = self.path / "brash"
        shutil.copy(BRASH, other)
        with open(other, "ab") as program:
            program.write(b"\0")

        def stopped(command):
            checkpoint = self.folder / "checkpoint.nc"
            before = checkpoint.stat().st_mtime_ns if checkpoint.exists() else 0
            process = start(command)
            self.assertTrue(wait_for(lambda: checkpoint.exists() and checkpoint.stat().st_mtime_ns > before, process))
            process.send_signal(signal.SIGINT)
            _, said = process.communicate()
            self.assertEqual(process.returncode, 3, said)

        def warnings():
            return [w for w in json.loads((self.folder / "summary.json").read_text())["warnings"] if w["id"] == "several-programs"]

        others_command = [other, *run_command(self.folder)[1:]]
        stopped(others_command)
        self.succeeds([*others_command, "--resume"])
        self.assertEqual(warnings(), [])
        shutil.rmtree(self.folder)
        stopped(others_command)
        stopped(run_command(self.folder, "--resume"))
        done = self.succeeds(run_command(self.folder, "--resume"))
        self.assertIn("several-programs: another program (sha256 ", done.stdout)
        self.assertEqual(len(warnings()), 1)

    def test_what_ignores_a_closed_terminal_runs_on(self):
        process = self.begun(["nohup", *run_command(self.folder)])
        process.send_signal(signal.SIGHUP)
        _, said = process.communicate()
        self.assertEqual(process.returncode, 0, said)
        folder = self.path / "campaign"
        process = start(["nohup", *campaign_command(folder)])
        self.assertTrue(wait_for(lambda: list(folder.glob("cases/*[0-9]")), process))
        process.send_signal(signal.SIGHUP)
        _, said = process.communicate()
        self.assertEqual(process.returncode, 0, said)

    def test_a_campaign_that_is_asked_to_end_goes_on_with_resume(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            folder = self.path / str(number)
            process = start(campaign_command(folder))
            self.assertTrue(wait_for(lambda: list(folder.glob("cases/*[0-9]")), process))
            process.send_signal(number)
            _, said = process.communicate()
            self.assertEqual(process.returncode, 3, said)
            self.assertIn("`--resume` continues", said)
            self.assertFalse((folder / "summary.json").exists())
            self.has_no_half_files(folder)
            self.succeeds(campaign_command(folder, "--resume"))

    def test_a_database_that_is_asked_to_end_goes_on(self):
        file = self.path / "cone.nc"
        process = start(database_command(file))
        self.assertTrue(wait_for(lambda: list(self.path.glob("cone.nc.chunks/*.nc")), process))
        process.send_signal(signal.SIGINT)
        _, said = process.communicate()
        self.assertEqual(process.returncode, 3, said)
        self.assertIn("the same command continues", said)
        self.assertFalse(file.exists())
        self.succeeds(database_command(file))
        self.succeeds(database_command(self.path / "whole.nc"))
        self.assertEqual(file.read_bytes(), (self.path / "whole.nc").read_bytes())

    def test_what_a_killed_run_left_half_written_is_removed(self):
        process = self.begun()
        process.kill()
        process.communicate()
        (self.folder / "checkpoint.nc.123.part").write_bytes(b"half")
        (self.folder / "run.nc.99.part").write_bytes(b"half")
        (self.folder / "my-notes.part").write_bytes(b"mine")
        self.succeeds(run_command(self.folder, "--resume"))
        self.has_no_half_files(self.folder)
        self.assertFalse((self.folder / "run.lock").exists())
        self.assertTrue((self.folder / "my-notes.part").exists())

    def test_a_second_process_on_the_folder_of_a_run_is_refused_and_the_first_goes_on(self):
        whole = self.whole()
        process = self.begun()
        process.send_signal(signal.SIGSTOP)
        second = call(run_command(self.folder, "--resume"))
        process.send_signal(signal.SIGCONT)
        self.fails_clearly(second, {2}, str(self.folder), f"is in use by process {process.pid} on ")
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertEqual(self.bytes_of(self.folder), whole)

    def test_a_second_process_on_a_database_is_refused(self):
        file = self.path / "cone.nc"
        process = start(database_command(file))
        lock = self.path / "cone.nc.chunks" / "lock"
        # Its holder writes its name into it.
        self.assertTrue(wait_for(lambda: lock.exists() and lock.stat().st_size > 0, process))
        process.send_signal(signal.SIGSTOP)
        second = call(database_command(file))
        process.send_signal(signal.SIGCONT)
        self.fails_clearly(second, {2}, "is in use by process")
        process.communicate()
        self.assertEqual(process.returncode, 0)
        self.assertFalse((self.path / "cone.nc.chunks").exists())

    def test_results_of_an_earlier_run_stay_until_those_of_the_next_are_whole(self):
        whole = self.whole()
        folder = self.path / "whole"
        (folder / "checkpoint.nc").unlink()
        before = sorted(p.name for p in folder.iterdir())
        process = start(run_command(folder, "--seed", "2", "--replace"))
        self.assertTrue(wait_for((folder / "checkpoint.nc").exists, process))
        process.send_signal(signal.SIGINT)
        process.communicate()
        self.assertEqual(process.returncode, 3)
        self.assertEqual(sorted(p.name for p in folder.iterdir()), sorted([*before, "checkpoint.nc"]))
        self.assertEqual(self.bytes_of(folder), whole)
        self.succeeds(run_command(folder, "--seed", "2", "--resume"))
        self.succeeds(run_command(self.path / "other", "--seed", "2"))
        self.assertEqual(self.bytes_of(folder), self.bytes_of(self.path / "other"))

    def test_a_run_that_dies_while_it_writes_its_results_leaves_the_folder_to_the_next_one(self):
        none = ("--set", "output.checkpoint_interval=0")
        self.succeeds(run_command(self.path / "whole", *none))
        whole = self.bytes_of(self.path / "whole")
        limit = len(whole["run.nc"]) // 2  # the picture is smaller
        self.assertLess(len(whole["plan.svg"]), limit)

        def dies(*options):
            died = call(run_command(self.folder, *none, *options),
                        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit)))
            self.fails_clearly(died, {1}, "cannot be written")

        for options in ((), ("--resume",), ("--replace",)):
            dies()
            part = self.folder / "results.part"  # as a kill leaves it
            part.mkdir(parents=True)
            (part / "run.begun").touch()
            (part / "history.csv").write_text("half")
            self.succeeds(run_command(self.folder, *none, *options))
            self.assertEqual(self.bytes_of(self.folder), whole)
            self.assertFalse((self.folder / "results.part").exists())
            dies("--replace", "--seed", "2")
            self.assertEqual(self.bytes_of(self.folder), whole)
            refused = call(run_command(self.folder, *none))
            self.fails_clearly(refused, {2}, "holds a finished run", "--replace")
            shutil.rmtree(self.folder)

    def test_results_that_were_whole_when_the_run_was_killed_get_their_names(self):
        whole = self.whole()
        part = self.path / "results.part"
        (self.path / "whole").rename(part)
        (part / "run.begun").touch()
        self.folder.mkdir()
        part.rename(self.folder / "results.part")
        (self.folder / "results.part/history.csv").rename(self.folder / "history.csv")
        self.fails_clearly(call(run_command(self.folder)), {2}, "holds a finished run", "--replace")
        self.assertFalse((self.folder / "results.part").exists())
        self.assertEqual(self.bytes_of(self.folder), whole)

    def test_a_run_that_was_killed_before_its_mark_was_whole_leaves_the_folder_to_the_next_one(self):
        part = self.folder / "results.part"
        part.mkdir(parents=True)
        (part / "run.begun.4711.part").write_text("The results")
        self.succeeds(run_command(self.folder))
        self.assertFalse(part.exists())

    def test_a_folder_of_somebody_else_is_not_taken_for_results_of_a_run(self):
        mine = self.folder / "results.part/mine"
        mine.parent.mkdir(parents=True)
        mine.write_text("mine")
        self.fails_clearly(call(run_command(self.folder)), {2}, "results.part", "no run left it")
        self.assertEqual(mine.read_text(), "mine")

    def test_a_resume_without_a_checkpoint_says_so_and_runs_from_the_start(self):
        done = self.succeeds(run_command(self.path / "new", "--resume"))
        self.assertIn(f"warning: there is no {self.path / 'new' / 'checkpoint.nc'} to resume from", done.stderr)
        self.assertEqual(self.bytes_of(self.path / "new"), self.whole())

    def test_bad_input_leaves_an_earlier_run_as_it_was_and_makes_no_folder(self):
        whole = self.whole()
        for options in (["--set", "ice.thickness=-1"], ["--set", "failure.model=network", "--set", "failure.file=none.json"],
                        ["--resume", "--seed", "3"]):
            done = call(run_command(self.path / "whole", *options))
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(self.bytes_of(self.path / "whole"), whole)
            if "--resume" not in options:
                self.assertEqual(call(run_command(self.path / "a" / "b", *options)).returncode, 2)
                self.assertFalse((self.path / "a").exists())


if __name__ == "__main__":
    unittest.main()
