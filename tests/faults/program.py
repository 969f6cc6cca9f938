# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of faults share: the program, a small case, a small campaign, a small database."""
import os
import pathlib
import re
import subprocess
import tempfile
import time
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
SANITIZED = bool(os.environ.get("BRASH_SANITIZE"))
CASE = SOURCE / "experiments" / "validation" / "cone.toml"
CAMPAIGN = SOURCE / "tests" / "modules" / "campaign" / "plan.toml"
DATABASE = SOURCE / "tests" / "modules" / "campaign" / "database_plan.toml"
RESULTS = ["run.nc", "history.csv", "events.csv", "summary.json", "plan.svg"]


def run_command(folder, *more):
    """The command of a run that resumes to the bit, with a checkpoint every 0.1 s; of 2 s, unless `more` says otherwise."""
    return [BRASH, "run", str(CASE), "--set", "failure.model=wedge", "--set", "contact.engine=brash", "--set", "time.duration=2",
            "--set", "output.checkpoint_interval=0.1", "-o", str(folder), *more]


def campaign_command(folder, *more):
    return [BRASH, "campaign", str(CAMPAIGN), "--quick", "--jobs", "2", "-o", str(folder), *more]


def database_command(file, *more):
    return [BRASH, "failure", "database", str(DATABASE), "-o", str(file), *more]


def call(command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def start(command, **options):
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, **options)


def wait_for(found, process, seconds=60.0):
    """Waits until `found()` or the process has ended; what found() gave."""
    end = time.monotonic() + seconds
    while not (value := found()) and process.poll() is None and time.monotonic() < end:
        time.sleep(0.002)
    return value


class FaultTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)

    def succeeds(self, command, **options):
        done = call(command, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def fails_clearly(self, done, codes, *parts):
        """Ended by itself with one of `codes`, and said why and what to do."""
        self.assertIn(done.returncode, codes, done.stderr)
        for part in [*parts, "remedy:"]:
            self.assertIn(part, done.stderr)

    def bytes_of(self, folder):
        return {name: (folder / name).read_bytes() for name in RESULTS}

    def has_no_half_files(self, folder, parts_allowed=False):
        """Whether every file of a run that has its final name is whole, and no part of one lies beside it."""
        import netCDF4
        for path in folder.rglob("*"):
            if re.search(r"\.\d+\.part$", path.name):
                self.assertTrue(parts_allowed, path)
            elif path.suffix == ".nc":
                netCDF4.Dataset(path).close()
            elif path.suffix in (".csv", ".json", ".svg"):
                self.assertIn(path.read_bytes()[-1:], (b"\n", b"}", b">"), path)
