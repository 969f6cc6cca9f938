# SPDX-License-Identifier: GPL-3.0-or-later
"""A copied run and a copied campaign rerun to the same bytes where none of the original paths exists: in a chroot that
holds the program, its libraries, its models and the copies. Needs root."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BRASH, SOURCE = pathlib.Path(os.environ["BRASH"]), pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
MODELS = SOURCE / "experiments/failure_database"
SKIPPED = 77
PLAN = """
[campaign]
case = "mine.toml"
replicates = 2
[set]
time.duration = 1.5
[[grid]]
structure.speed = [1.2, 1.4]
[output]
keep = "run"
"""


def enter(root, *command):
    """Runs a command in the chroot `root` with a /proc of its own, which ends with it."""
    script = 'mount -t proc proc "$0/proc" && exec chroot "$0" "$@"'
    return subprocess.run(["unshare", "--mount", "sh", "-c", script, root, *command], capture_output=True, text=True,
                          env={"TMPDIR": "/tmp", "LSAN_OPTIONS": "detect_leaks=0"})


def make_root(root):
    """The program as it is installed, what it links to, and the units."""
    linked = subprocess.run(["ldd", BRASH], check=True, capture_output=True, text=True).stdout
    for library in re.findall(r"(/\S+) \(0x", linked):
        (root / library[1:]).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(library, root / library[1:])
    for folder in ["opt/brash/bin", "opt/brash/share/brash/models", "proc", "tmp"]:
        (root / folder).mkdir(parents=True)
    shutil.copy(BRASH, root / "opt/brash/bin/brash")
    for model in MODELS.glob("cone_*.json"):
        shutil.copy(model, root / "opt/brash/share/brash/models")
    shutil.copytree("/usr/share/xml/udunits", root / "usr/share/xml/udunits")


class Chroot(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.root = self.path / "root"
        make_root(self.root)
        shutil.copy(SOURCE / "experiments/validation/cone.toml", self.path / "mine.toml")

    def brash(self, *arguments):
        done = subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def rerun_copy_of(self, results):
        shutil.move(results, self.root / "copy")
        self.assertFalse((self.root / str(self.path)[1:]).exists())
        done = enter(str(self.root), "/opt/brash/bin/brash", "rerun", "/copy/manifest.json", "-o", "/again")
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        self.assertNotIn("DIFFERENT", done.stdout)
        return done.stdout

    def test_a_copied_run_with_a_model_of_its_own(self):
        shutil.copy(MODELS / "cone_network.json", self.path / "mine.json")
        self.brash("run", self.path / "mine.toml", "--set", "time.duration=2", "--set", "failure.model=network", "--set",
                   f"failure.file={self.path / 'mine.json'}", "-o", self.path / "run")
        told = self.rerun_copy_of(self.path / "run")
        self.assertEqual(told.count("identical"), 5, told)
        for name in ["run.nc", "history.csv", "events.csv", "summary.json", "plan.svg"]:
            self.assertEqual((self.root / "copy" / name).read_bytes(), (self.root / "again" / name).read_bytes(), name)

    def test_a_copied_campaign(self):
        (self.path / "plan.toml").write_text(PLAN)
        self.brash("campaign", self.path / "plan.toml", "-o", self.path / "campaign")
        told = self.rerun_copy_of(self.path / "campaign")
        self.assertIn("4 of 4 cases identical", told)
        for case in (self.root / "copy/cases").iterdir():
            if case.is_dir():
                self.assertEqual((case / "run.nc").read_bytes(), (self.root / "again" / case.name / "run.nc").read_bytes())


if __name__ == "__main__":
    if os.geteuid() != 0 or subprocess.run(["unshare", "--mount", "true"], capture_output=True).returncode != 0:
        print("skipped: a chroot with a /proc of its own needs root")
        sys.exit(SKIPPED)
    unittest.main()
