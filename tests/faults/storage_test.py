# SPDX-License-Identifier: GPL-3.0-or-later
"""Disks that are full and folders that cannot be written, on a file system of the test's own.

It is mounted in a mount namespace, which ends with the test; where that is not permitted the test is skipped.
"""
import os
import subprocess
import sys
import unittest

sys.path.append(str(__import__("pathlib").Path(__file__).resolve().parents[1] / "modules" / "campaign"))
from files import different
from program import BRASH, SOURCE, FaultTest, call, campaign_command, database_command, run_command

FULL = "No space left on device"


class Storage(FaultTest):
    def setUp(self):
        super().setUp()
        self.disk = self.path / "disk"
        self.disk.mkdir()
        subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64m,mode=755", "tmpfs", self.disk], check=True)
        self.addCleanup(subprocess.run, ["umount", "--lazy", self.disk], check=True)

    def limit(self, kilobytes):
        subprocess.run(["mount", "-o", f"remount,size={kilobytes}k", self.disk], check=True)

    def test_a_run_on_a_full_disk_ends_with_an_error_and_goes_on_when_there_is_space(self):
        self.succeeds(run_command(self.path / "whole"))
        whole = self.bytes_of(self.path / "whole")
        # Nothing, the first checkpoints, all checkpoints but not the results.
        for kilobytes in (4, 300, 460):
            folder = self.disk / str(kilobytes)
            self.limit(kilobytes)
            done = call(run_command(folder))
            self.fails_clearly(done, {1}, str(folder), f"cannot be written: {FULL}")
            self.has_no_half_files(folder)
            self.assertFalse((folder / "manifest.json").exists())
            self.limit(65536)
            self.succeeds(run_command(folder, "--resume"))
            self.assertEqual(self.bytes_of(folder), whole)
            subprocess.run(["rm", "-r", folder], check=True)

    def test_a_campaign_on_a_full_disk_counts_what_it_has_and_goes_on_when_there_is_space(self):
        self.succeeds(campaign_command(self.path / "whole"))
        folder = self.disk / "campaign"
        self.limit(400)
        done = call(campaign_command(folder))
        self.fails_clearly(done, {1}, FULL)
        self.assertFalse((folder / "summary.json").exists())
        self.assertEqual(list(folder.glob("cases/*.failed")), [])
        self.has_no_half_files(folder)
        status = self.succeeds(campaign_command(folder, "--status")).stdout
        self.assertIn("0 failed", status)
        self.limit(65536)
        self.succeeds(campaign_command(folder, "--resume"))
        self.assertEqual(different(self.path / "whole", folder), [])

    def test_a_database_on_a_full_disk_goes_on_when_there_is_space(self):
        self.succeeds(database_command(self.path / "whole.nc"))
        file = self.disk / "cone.nc"
        for kilobytes in (4, 120):
            self.limit(kilobytes)
            self.fails_clearly(call(database_command(file)), {1}, f"cannot be written: {FULL}")
            self.assertFalse(file.exists())
            self.has_no_half_files(self.disk)
        self.limit(65536)
        self.succeeds(database_command(file))
        self.assertEqual(file.read_bytes(), (self.path / "whole.nc").read_bytes())
        self.assertEqual([p.name for p in self.disk.iterdir()], ["cone.nc"])

    def test_other_commands_leave_the_old_file_when_the_new_one_has_no_space(self):
        self.succeeds(run_command(self.path / "run"))
        history = str(self.path / "run" / "history.csv")
        self.limit(4)
        for name, command in {
            "spectrum.csv": ["stats", history, "--from", "0.5", "--spectrum"],
            "pieces.geojson": ["crack", "--sheet", self.sheet(), "--events", self.events(), "-o"],
            "comparison.svg": ["compare", history, history, "--from", "0", "--measured-from", "0", "-o"],
        }.items():
            file = self.disk / name
            file.write_text("old")
            self.fails_clearly(call([BRASH, *command, str(file)]), {1}, f"cannot be written: {FULL}")
            self.assertEqual(file.read_text(), "old")
            self.assertEqual(list(self.disk.iterdir()), [file])
            file.unlink()

    def test_what_is_printed_into_a_full_disk_is_not_lost_in_silence(self):
        self.succeeds(run_command(self.path / "run"))
        with open("/dev/full", "w", encoding="utf-8") as full:
            for command in (["stats", self.path / "run" / "history.csv", "--from", "0", "--json"], ["schema"], ["--help"]):
                done = subprocess.run([BRASH, *command], stdout=full, stderr=subprocess.PIPE, text=True)
                self.fails_clearly(done, {1}, f"cannot be written: {FULL}")

    def test_a_folder_on_a_disk_that_cannot_be_written_is_refused_before_anything_runs(self):
        folder = self.disk / "there"
        folder.mkdir()
        subprocess.run(["mount", "-o", "remount,ro", self.disk], check=True)
        for target in (folder, self.disk / "new"):
            for command in (run_command, campaign_command, database_command):
                # A thousand seconds of simulation would not end within the time that the test waits.
                longer = ["--set", "time.duration=1000"] if command is run_command else []
                done = call(command(target, *longer), timeout=60)
                self.fails_clearly(done, {1, 2}, str(target), "Read-only file system")

    def sheet(self):
        file = self.path / "sheet.wkt"
        file.write_text("POLYGON ((0 0, 50 0, 50 50, 0 50, 0 0))\n")
        return str(file)

    def events(self):
        file = self.path / "events.csv"
        file.write_text("x,y,radius,wedges\n" + "".join(f"0,{y},2,4\n" for y in range(5, 46)))
        return str(file)


def own_mounts():
    """Runs this file again in a mount namespace of its own; the exit status 77 where that is not permitted."""
    unshare = ["unshare", "--mount"] if os.geteuid() == 0 else ["unshare", "--user", "--map-root-user", "--mount"]
    trial = subprocess.run([*unshare, "mount", "-t", "tmpfs", "tmpfs", "/mnt"], capture_output=True, text=True)
    if trial.returncode != 0:
        print(f"skipped: no file system of its own may be mounted here: {trial.stderr.strip()}")
        return 77
    return subprocess.run([*unshare, sys.executable, "-B", *sys.argv], env={**os.environ, "BRASH_OWN_MOUNTS": "1"}).returncode


if __name__ == "__main__":
    if os.environ.get("BRASH_OWN_MOUNTS") != "1":
        sys.exit(own_mounts())
    unittest.main()
