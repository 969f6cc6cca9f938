# SPDX-License-Identifier: GPL-3.0-or-later
"""Files and folders of others are neither written, removed nor followed, whatever they are called."""
import os
import shutil
import subprocess
import unittest

from common import BRASH, DATABASE_PLAN, Hostile

RUN = ("run", "case.toml", "-o", "out")
CAMPAIGN = ("campaign", "plan.toml", "-o", "out", "--jobs", "1")


class Locks(Hostile):
    def test_a_lock_that_is_a_link_is_not_followed(self):
        diary = self.path / "diary.txt"
        diary.write_text("dear diary")
        (self.path / "out").mkdir()
        for command, lock in ((RUN, "run.lock"), (CAMPAIGN, "campaign.lock")):
            (self.path / "out" / lock).symlink_to(diary)
            self.refused(*command, saying=(lock, "is none"))
            self.assertEqual(diary.read_text(), "dear diary")
            (self.path / "out" / lock).unlink()
        (self.path / "out/run.lock").symlink_to(self.path / "nowhere")
        self.refused(*RUN, saying="run.lock")
        self.assertFalse((self.path / "nowhere").exists())

    def test_a_file_of_that_name_is_neither_emptied_nor_removed(self):
        (self.path / "out").mkdir()
        lock = self.path / "out/run.lock"
        lock.write_text("my notes on locks")
        self.refused(*RUN, saying="run.lock")
        self.assertEqual(lock.read_text(), "my notes on locks")
        lock.unlink()
        other = self.path / "empty"
        other.write_text("")
        lock.hardlink_to(other)
        self.refused(*RUN, saying="run.lock")

    def test_resume_removes_its_own_locks_alone(self):
        self.succeeds(*CAMPAIGN)
        mine = self.path / "out/cases/base-r0000/lock"
        mine.write_text("a key and a lock")
        left = self.path / "out/cases/base-r0001/lock"
        left.write_text("process 1 on nobody\n")
        self.succeeds(*CAMPAIGN, "--resume")
        self.assertEqual(mine.read_text(), "a key and a lock")
        self.assertFalse(left.exists())


class FoldersOfOthers(Hostile):
    def test_a_database_leaves_a_folder_that_it_did_not_make(self):
        (self.path / "database.toml").write_text(DATABASE_PLAN)
        command = ("failure", "database", "database.toml", "-o", "cone.nc")
        thesis = self.path / "cone.nc.chunks/thesis.tex"
        thesis.parent.mkdir()
        thesis.write_text("four years")
        self.refused(*command, saying="thesis.tex")
        self.assertEqual(thesis.read_text(), "four years")
        thesis.unlink()
        self.succeeds(*command)
        self.assertTrue(thesis.parent.exists(), "somebody's empty folder stays")
        thesis.parent.rmdir()
        (self.path / "cone.nc").unlink()
        (self.path / "elsewhere").mkdir()
        thesis.parent.symlink_to(self.path / "elsewhere")
        self.refused(*command, saying="cone.nc.chunks")
        self.assertEqual(list((self.path / "elsewhere").iterdir()), [])
        thesis.parent.unlink()
        self.succeeds(*command)
        self.assertFalse(thesis.parent.exists())

    def test_a_campaign_protects_the_files_of_others_as_a_run_does(self):
        for name in ("campaign.csv", "campaign.nc", "summary.json", "report.html", "cases/mine/lock", "settings/mine.toml"):
            for more in ((), ("--resume",)):
                with self.subTest(name + "".join(more)):
                    mine = self.path / "out" / name
                    mine.parent.mkdir(parents=True)
                    mine.write_text("mine")
                    self.refused(*CAMPAIGN, *more, saying=str(self.path / "out").split("/")[-1])
                    self.assertEqual([p for p in (self.path / "out").rglob("*") if p.is_file()], [mine])
                    self.assertEqual(mine.read_text(), "mine")
                    shutil.rmtree(self.path / "out")

    def test_the_name_of_a_checkpoint_proves_nothing(self):
        (self.path / "out").mkdir()
        for names in (["checkpoint.nc"], ["checkpoint.nc", "history.csv"], ["manifest.json", "summary.json", "history.csv"]):
            for name in names:
                (self.path / "out" / name).write_text("{}" if name.endswith("json") else "mine")
            self.refused(*RUN, saying="no run left it")
            for name in names:
                self.assertIn((self.path / "out" / name).read_text(), ("mine", "{}"))
                (self.path / "out" / name).unlink()
        self.succeeds(*RUN, "--set", "output.checkpoint_interval=0.02")

    def test_a_folder_with_the_name_of_a_result_is_found_before_anything_runs(self):
        for name in ("history.csv", "run.nc", "checkpoint.nc", "report.html"):
            (self.path / "out" / name).mkdir(parents=True)
            self.refused(*RUN, "--set", "time.duration=1000", saying=(name, "is a folder"))
            (self.path / "out" / name).rmdir()

    def test_a_case_cannot_be_called_up(self):
        shutil.copy(self.path / "case.toml", self.path / "...toml")
        before = sorted(self.path.parent.iterdir())
        self.refused("run", "...toml", saying="no name")
        self.assertEqual(sorted(self.path.parent.iterdir()), before)


class Pipes(Hostile):
    def test_a_pipe_that_nobody_writes_into_is_not_waited_for(self):
        self.succeeds(*CAMPAIGN)
        run = self.path / "out/cases/base-r0000"
        for name, command in (("summary.json", ("design", "out")), ("history.csv", ("stats", run / "history.csv")),
                              ("manifest.json", ("report", run))):
            with self.subTest(name):
                shutil.move(run / name, self.path / "kept")
                os.mkfifo(run / name)
                self.refused(*command, saying=(name, "is a pipe that nobody writes into"))
                (run / name).unlink()
                shutil.move(self.path / "kept", run / name)

    def test_a_pipe_with_a_writer_is_read(self):
        done = subprocess.run(["bash", "-c", f'"$0" check <(sleep 0.2; cat case.toml)', BRASH], cwd=self.path,
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)


class Links(Hostile):
    def test_links_in_the_folder_of_a_campaign_are_not_followed(self):
        self.succeeds(*CAMPAIGN)
        elsewhere = self.path / "elsewhere"
        for name in ("cases/base-r0000", "cases", "settings"):
            with self.subTest(name):
                place = self.path / "out" / name
                shutil.move(place, elsewhere)
                place.symlink_to(elsewhere)
                before = sorted(elsewhere.rglob("*"))
                self.refused(*CAMPAIGN, "--resume", saying="is a link")
                self.assertEqual(sorted(elsewhere.rglob("*")), before)
                place.unlink()
                shutil.move(elsewhere, place)

    def test_a_report_is_not_written_through_a_link(self):
        self.succeeds(*CAMPAIGN)
        elsewhere = self.path / "elsewhere"
        shutil.move(self.path / "out/cases/base-r0000", elsewhere)
        (elsewhere / "report.html").unlink(missing_ok=True)
        (self.path / "out/cases/base-r0000").symlink_to(elsewhere)
        self.call("report", "out")
        self.assertFalse((elsewhere / "report.html").exists())


if __name__ == "__main__":
    unittest.main()
