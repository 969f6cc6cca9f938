# SPDX-License-Identifier: GPL-3.0-or-later
"""What the hostile tests share: the program, a quick case, a quick plan, a folder of their own."""
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "modules/cli"))
from broken_files import CASE, DATABASE_PLAN, content_hash  # noqa: E402,F401

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
QUICK = CASE.replace("duration = 0.6", "duration = 0.05").replace("statistics_from = 0.2", "statistics_from = 0")
HISTORY = "time,Fx\n" + "".join(f"{0.1 * i:.1f},{100 + i % 7}\n" for i in range(200))


class Hostile(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.path = pathlib.Path(scratch.name).resolve()
        (self.path / "case.toml").write_text(QUICK)
        (self.path / "plan.toml").write_text('[campaign]\ncase = "case.toml"\nreplicates = 2\n[output]\nkeep = "run"\n')
        (self.path / "history.csv").write_text(HISTORY)

    def call(self, *words, **options):
        options = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "stdin": subprocess.DEVNULL, "timeout": 120} | options
        return subprocess.run([BRASH, *map(str, words)], cwd=self.path, **options)

    def succeeds(self, *words, **options):
        done = self.call(*words, **options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def refused(self, *words, saying=(), code=2, **options):
        """Ends with `code`, and says why in words of the program and not of its insides."""
        done = self.call(*words, **options)
        text = done.stderr.decode(errors="replace")
        self.assertEqual(done.returncode, code, f"{words}: {text}")
        self.assertNotIn("contract broken", text)
        for part in [saying] if isinstance(saying, str) else saying:
            self.assertIn(part, text)
        return text
