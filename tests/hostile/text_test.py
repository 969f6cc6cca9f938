# SPDX-License-Identifier: GPL-3.0-or-later
"""What files say steers neither a terminal nor a spreadsheet nor a browser."""
import base64
import csv
import hashlib
import json
import re
import tomllib
import unittest

from common import QUICK, Hostile

#: ESC [ 2 J, the one-byte CSI of C1, an operating-system command, and the marks that turn the direction of writing.
NASTY = ["\x1b[2J", "\u009b2J", "\u009d0;owned\u009c", "\u202eexe.fdp", "\u2066hidden\u2069", "\u200f", "\u2028", "\ufeff"]


class Terminals(Hostile):
    def assert_harmless(self, done):
        for text in (done.stdout.decode(), done.stderr.decode()):
            bad = [c for c in text if (ord(c) < 0x20 and c not in "\n\t") or 0x7f <= ord(c) < 0xa0 or c in "".join(NASTY)[3:] and
                   not c.isascii()]
            self.assertEqual(bad, [], text)

    def test_names_and_values_of_others_are_printed_escaped(self):
        for nasty in NASTY:
            with self.subTest(repr(nasty)):
                quoted = json.dumps(nasty)
                (self.path / "bad.toml").write_text(QUICK + f'[reference]\nmean_horizontal = 1\nsource = {quoted}\n')
                checked = self.succeeds("check", "bad.toml", "--keys")
                self.assert_harmless(checked)
                (self.path / "again.toml").write_bytes(checked.stdout)
                again = self.succeeds("check", "again.toml", "--keys")
                self.assertEqual(tomllib.loads(again.stdout.decode()), tomllib.loads(checked.stdout.decode()))
                self.assertEqual(tomllib.loads(checked.stdout.decode())["reference"]["source"], nasty)
                self.assert_harmless(self.succeeds("run", "bad.toml", "-o", "out", "--replace"))
                (self.path / "bad.toml").write_text(QUICK + f"[reference]\n{quoted} = 1\n")
                self.assert_harmless(self.call("check", "bad.toml"))
                (self.path / "bad.csv").write_text(f"time,{nasty}\n" + "".join(f"{i},{i % 5}\n" for i in range(99)))
                for more in ((), ("--json",), ("--column", "none")):
                    self.assert_harmless(self.call("stats", "bad.csv", *more))
                self.assert_harmless(self.call("compare", "bad.csv", "bad.csv", "--column", nasty))
                (self.path / f"a{nasty}b.toml").write_text(QUICK)
                self.assert_harmless(self.call("run", f"a{nasty}b.toml"))
                self.assert_harmless(self.call("check", f"a{nasty}b.json"))
                self.assert_harmless(self.call(nasty))


class Spreadsheets(Hostile):
    def test_cells_of_text_that_a_spreadsheet_would_compute_are_quoted(self):
        (self.path / "plan.toml").write_text('''[campaign]
case = "case.toml"
[set]
water.current = [-1, 0]
[[grid]]
reference.source = ["=1+1", "+cmd|x", "@SUM(1)", "-2+3"]
reference.mean_horizontal = [1, 2, 3, 4]
labels = ["=a", "+b", "-c", "-1"]
[[grid]]
water.density = [1025.0]
''')
        self.succeeds("campaign", "plan.toml", "-o", "out", "--jobs", "2")
        text = (self.path / "out/campaign.csv").read_text()
        rows = list(csv.reader(text.splitlines()))
        self.assertEqual(len(rows), 5)
        for row in rows[1:]:
            self.assertNotRegex(row[0][0], "[=+@-]")
            self.assertIn(row[4], ("'=1+1", "'+cmd|x", "'@SUM(1)", "-2+3"))
            for cell in row:
                self.assertTrue(not cell or cell[0] not in "=@", cell)
                if cell and cell[0] in "+-":
                    self.assertRegex(cell, r"^[-+0-9.eE ]+$")


class Pages(Hostile):
    def test_the_policy_of_a_page_allows_its_own_script_and_no_other(self):
        self.succeeds("run", "case.toml", "-o", "out")
        page = self.path / "out/report.html"
        if not page.exists():
            self.skipTest("built without the page")
        text = page.read_text()
        policy = re.search(r'Content-Security-Policy" content="([^"]*)"', text)[1]
        rules = {rule.split()[0]: rule.split()[1:] for rule in policy.split(";")}
        self.assertEqual(rules["default-src"], ["'none'"])
        self.assertEqual(rules["base-uri"], ["'none'"])
        self.assertEqual(rules["form-action"], ["'none'"])
        script = re.search(r"<script>(.*)</script>\s*</body>", text, re.DOTALL)[1]
        digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
        self.assertEqual(rules["script-src"], [f"'sha256-{digest}'"])


if __name__ == "__main__":
    unittest.main()
