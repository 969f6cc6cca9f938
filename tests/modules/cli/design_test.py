# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash design` on campaigns whose peaks have a known law: pooled levels, a scatter table, refusals."""
import json
import math
import os
import pathlib
import random
import re
import shutil
import struct
import subprocess
import tempfile
import unittest

BRASH = os.environ["BRASH"]
CYCLES = 400  # of a replicate, one second each
SETTINGS = {"thin": (0.3, 40.0), "thick": (0.6, 80.0)}  # thickness, mean excess of the peaks above 100


def sawtooth(excess, generator):
    """Rows of a load that rises straight to an exponential peak in each second."""
    lines, time = ["time [s],Fx [N]"], 0.0
    for _ in range(CYCLES):
        peak = 100.0 + generator.expovariate(1.0 / excess)
        for i in range(1, 11):
            time += 0.1
            lines.append(f"{time:.1f},{20.0 + (peak - 20.0) * i / 10:.6f}")
    return "\n".join(lines) + "\n"


def write_campaign(folder, replicates):
    generator = random.Random(7)
    for name, (_, excess) in SETTINGS.items():
        for replicate in range(replicates):
            run = folder / "cases" / f"{name}-r{replicate:04d}"
            run.mkdir(parents=True)
            (run / "history.csv").write_text(sawtooth(excess, generator))
            (run / "summary.json").write_text('{"statistics_from": 0.0}')
    settings = [{"setting": name, "values": {"ice.thickness": thickness}} for name, (thickness, _) in SETTINGS.items()]
    (folder / "summary.json").write_text(json.dumps({"settings": settings}))
    rows = [f"{name}-r{i:04d},{name},{i},done" for name in SETTINGS for i in range(replicates)]
    (folder / "campaign.csv").write_text("\n".join(["case,setting,replicate,status", *rows]) + "\n")


class Two:
    """Peaks of two heights, one in twenty the higher."""
    def __init__(self):
        self.n = 0

    def expovariate(self, _):
        self.n += 1
        return 50.0 if self.n % 20 == 0 else 20.0


class Design(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        write_campaign(cls.folder, 3)

    @classmethod
    def tearDownClass(cls):
        cls.place.cleanup()

    def design(self, *arguments, code=0):
        done = subprocess.run([BRASH, "design", str(self.folder), *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr if code else done.stdout

    def test_the_table_of_a_campaign_serves_as_its_folder(self):
        done = subprocess.run([BRASH, "design", str(self.folder / "campaign.csv"), "--hours", "1", "--json"],
                              capture_output=True, text=True)
        self.assertEqual((done.returncode, done.stdout), (0, self.design("--hours", 1, "--json")))

    def scatter(self, text):
        file = self.folder / "states.csv"
        file.write_text(text)
        return file

    def test_loads_below_zero_are_warned_of(self):
        plain, turned = (json.loads(self.design("--hours", 1, "--json", *more)) for more in ((), ("--negate",)))
        told = lambda found: [any("the mean is negative" in text for text in state["warnings"]) for state in found["settings"]]
        self.assertEqual(told(plain), [False, False])
        self.assertEqual(told(turned), [True, True])
        self.assertIn("the mean is negative", self.design("--hours", 1, "--negate"))

    def test_peaks_that_correlate_are_warned_of(self):
        self.assertNotIn("successive peaks correlate", self.design("--hours", 1))
        file = self.folder / "cases/thin-r0000/history.csv"
        kept = file.read_text()
        self.addCleanup(file.write_text, kept)
        # Twenty cycles high, twenty low.
        rows = [f"{0.1 * i:.1f},{(300 if i // 200 % 2 else 150) * (1 + i % 10) / 10:.1f}" for i in range(10 * CYCLES)]
        file.write_text("\n".join(["time [s],Fx [N]", *rows]) + "\n")
        warned = json.loads(self.design("--hours", 1, "--json"))["settings"][0]["warnings"]
        self.assertTrue(any("successive peaks correlate by 0." in text for text in warned), warned)
        self.assertIn("warning: successive peaks correlate by 0.", self.design("--hours", 1))

    def test_replicates_are_pooled_and_levels_hold_the_truth(self):
        found = json.loads(self.design("--hours", 1, "--hours", 5, "--json"))
        for state, (_, excess) in zip(found["settings"], SETTINGS.values()):
            self.assertEqual(state["replicates"], 3)
            self.assertAlmostEqual(state["duration"], 3 * CYCLES, delta=1)
            self.assertGreater(state["load_events"], 0.9 * 3 * CYCLES)  # small peaks are below the mean
            for level in state["levels"]:
                truth = 100.0 + excess * math.log(3600 * level["hours"])
                self.assertLess(level["level_95"][0], truth)
                self.assertGreater(level["level_95"][1], truth)

    def test_a_scatter_table_weighs_the_states(self):
        table = self.scatter("ice.thickness,hours\n0.3,100\n0.6,2\n")
        found = json.loads(self.design("--scatter", table, "--years", "1,50", "--annual", 0.01, "--json", "--exponent", 4))
        self.assertEqual([round(level["years"], 2) for level in found["annual"]], [1, 50, 99.5])

        def rate(x):
            return sum(3600 * h * math.exp(-(x - 100.0) / e) for h, e in ((100, 40.0), (2, 80.0)))

        for level in found["annual"]:
            low, high = 100.0, 1e4
            for _ in range(80):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if rate(middle) > -math.log1p(-level["probability"]) else (low, middle)
            self.assertLess(level["level_95"][0], low)
            self.assertGreater(level["level_95"][1], low)
            self.assertGreater(level["shares"]["thick"], 0.9)  # thicker ice decides, though it is rare
            self.assertAlmostEqual(sum(level["shares"].values()), 1.0)
        loads = [state["fatigue"][0]["equivalent_load"] for state in found["settings"]]
        pooled = ((100 * loads[0]**4 + 2 * loads[1]**4) / 102)**0.25
        self.assertAlmostEqual(found["fatigue"][0]["equivalent_load"], pooled, places=6)

    def test_equivalent_loads_have_the_unit_of_the_levels_and_warnings_of_runs_are_whole(self):
        file = self.folder / "cases/thin-r0000/summary.json"
        kept = file.read_text()
        self.addCleanup(file.write_text, kept)
        words = "of many words, " * 20 + "and a remedy at its end"
        file.write_text(json.dumps({"statistics_from": 0.0, "warnings": [{"id": "short-run", "text": words}]}))
        said = self.design("--hours", 1, "--exponent", 4)
        self.assertIn(f"warning: of 1 of 3 runs: short-run: {words} (thin)\n", said)
        found = json.loads(self.design("--hours", 1, "--exponent", 4, "--json"))
        for state, (number, unit) in zip(found["settings"], re.findall(r"equivalent load +(\S+) (k?N) ", said), strict=True):
            self.assertAlmostEqual(float(number) * {"N": 1, "kN": 1e3}[unit], state["fatigue"][0]["equivalent_load"], delta=1e-2)

    def test_a_warning_of_several_settings_is_said_once_with_their_names(self):
        said = self.design("--hours", 1, "--negate", "--scatter", self.scatter("ice.thickness,hours\n0.3,500\n0.6,50\n"))
        warnings = [line for line in said.splitlines() if "warning: " in line]
        self.assertEqual(len(warnings), len({line.rpartition(" (")[0] for line in warnings}))
        self.assertTrue(any("the mean is negative" in line and line.endswith(" (thin, thick)") for line in warnings), said)
        far = self.design("--hours", 50, "--scatter", self.scatter("ice.thickness,hours\n0.3,500\n0.6,50\n"))
        self.assertIn("more than on data (return periods, thin, thick)\n", far)
        # A warning of runs has numbers of each setting's own.
        for name, seconds in (("thin", 30), ("thick", 50)):
            file = self.folder / f"cases/{name}-r0000/summary.json"
            self.addCleanup(file.write_text, file.read_text())
            warning = {"id": "short-run", "text": f"run {seconds} s: or more"}
            file.write_text(json.dumps({"statistics_from": 0.0, "warnings": [warning]}))
        self.assertIn("warning: of 1 of 3 runs: short-run: run 30 s: or more (thin; with other numbers thick)\n",
                      self.design("--hours", 1))

    def test_a_scatter_table_of_a_spreadsheet_begins_with_a_byte_order_mark(self):
        text = "ice.thickness,hours\r\n0.3,100\r\n0.6,2\r\n"
        plain, marked = (self.design("--scatter", self.scatter(mark + text)) for mark in ("", "\ufeff"))
        self.assertIn("all settings", plain)
        self.assertEqual(marked, plain)

    def years(self, scatter, *arguments):
        return json.loads(self.design("--scatter", self.scatter(scatter), "--json", *arguments))["annual"]

    def test_one_state_alone_has_the_level_of_its_hours(self):
        table = self.scatter("ice.thickness,hours\n0.6,1\n")
        found = json.loads(self.design("--scatter", table, "--years", 4, "--hours", 4, "--json"))
        level = found["settings"][1]["levels"][0]
        for key in ("level", "level_95", "records"):
            self.assertEqual(found["annual"][0][key], level[key])

    def test_twice_the_hours_is_twice_the_period(self):
        once, twice = (self.years(f"ice.thickness,hours\n0.3,{hours}\n0.6,{hours / 10}\n", "--years", years)[0]
                       for hours, years in ((200, 50), (400, 25)))
        self.assertAlmostEqual(once["level"] / twice["level"], 1.0, places=9)
        longer = self.years("ice.thickness,hours\n0.3,400\n0.6,40\n", "--years", "50")[0]
        self.assertGreater(longer["level"], once["level"])

    def test_a_state_that_is_left_out_takes_its_share(self):
        both = self.years("ice.thickness,hours\n0.3,500\n0.6,50\n", "--years", 50)[0]
        thick = self.years("ice.thickness,hours\n0.6,50\n", "--years", 50)[0]
        thin = self.years("ice.thickness,hours\n0.3,500\n", "--years", 50)[0]
        self.assertLess(abs(both["level"] / thick["level"] - 1), 0.01)  # thin ice has 1 % of the exceedances
        self.assertLess(thin["level"], 0.7 * both["level"])

    def test_four_times_the_replicates_halve_the_interval_of_the_shape(self):
        widths = []
        for replicates in (4, 16):
            with tempfile.TemporaryDirectory() as place:
                write_campaign(pathlib.Path(place), replicates)
                done = subprocess.run([BRASH, "design", place, "--json"], capture_output=True, text=True)
                low, high = json.loads(done.stdout)["tail"]["shape_95"]
                widths.append(high - low)
        self.assertAlmostEqual(widths[1] / widths[0], 0.5, delta=0.2)  # within the chance of one campaign

    def test_a_century_is_given_and_marked(self):
        table = self.scatter("ice.thickness,hours\n0.3,500\n0.6,50\n")
        text = self.design("--scatter", table)
        self.assertIn("% from thick\n", text)
        self.assertIn("warning: beyond 4 times the histories a level rests on the law more than on data", text)
        self.assertIn("--resume --replicates 12`", text)

    def test_few_load_events_have_no_level(self):
        for run in (self.folder / "cases").glob("*/history.csv"):
            kept = run.read_text()
            self.addCleanup(run.write_text, kept)
            run.write_text("".join(kept.splitlines(True)[:51]))  # five cycles
        self.assertIn("no level: all states together have", self.design("--hours", 1))
        self.assertIn("all settings: no level", self.design("--scatter", self.scatter("ice.thickness,hours\n0.3,5\n")))

    def test_a_state_whose_peaks_are_all_equal_leaves_the_others_their_levels(self):
        with tempfile.TemporaryDirectory() as place:
            folder = pathlib.Path(place)
            write_campaign(folder, 3)
            alone = json.loads(self.design("--hours", 1, "--json"))
            self.folder, before = folder, self.folder
            self.addCleanup(setattr, self, "folder", before)
            for run in (folder / "cases").glob("thick-*"):
                (run / "history.csv").write_text(sawtooth(1.0, Two()))
            states = folder / "states.csv"
            states.write_text("ice.thickness,hours\n0.3,100\n0.6,200\n")
            found = json.loads(self.design("--hours", 1, "--scatter", states, "--json"))
            thin, thick = ({s["setting"]: s for s in found["settings"]}[name] for name in ("thin", "thick"))
            self.assertEqual(thick["levels"][0]["refused"], "all peaks over the threshold are equal")
            self.assertIn("its 200 hours a year add nothing", thick["warnings"][0])
            # One shape was fitted to both states before.
            one = {s["setting"]: s for s in alone["settings"]}["thin"]["levels"][0]
            self.assertLess(abs(thin["levels"][0]["level"] / one["level"] - 1.0), 0.2)
            self.assertEqual(list(found["annual"][0]["shares"]), ["thin"])

    def test_equivalent_loads_have_the_unit_of_the_levels(self):
        for line in self.design("--hours", 1, "--exponent", 5).splitlines():
            if "equivalent load" in line:
                self.assertRegex(line, r"equivalent load +[\d.]+ m?k?N   95 % interval")
                unit = line.split()[3]
        self.assertRegex(self.design("--hours", 1), rf"hours +{unit} ")

    def test_cases_are_those_that_the_table_counts_as_done(self):
        table = self.folder / "campaign.csv"
        kept = table.read_text()
        self.addCleanup(table.write_text, kept)
        # The first replicate was done after the tables were written.
        table.write_text(kept.replace("thin-r0000,thin,0,done\n", "").replace("thick-r0001,thick,1,done",
                                                                             "thick-r0001,thick,1,failed"))
        found = json.loads(self.design("--json"))["settings"]
        self.assertEqual([state["replicates"] for state in found], [2, 2])
        table.write_text(kept.replace("thin-r0000", "thin-r0007"))
        shutil.copytree(self.folder / "cases/thin-r0000", self.folder / "cases/thin-r0007")
        self.addCleanup(shutil.rmtree, self.folder / "cases/thin-r0007")
        self.assertEqual(json.loads(self.design("--json"))["settings"][0]["replicates"], 3)
        table.unlink()
        self.assertIn("it has no campaign.csv", self.design(code=2))

    def test_a_name_that_a_spreadsheet_would_compute_keeps_its_case(self):
        table = self.folder / "campaign.csv"
        kept = table.read_text()
        self.addCleanup(table.write_text, kept)
        table.write_text(kept.replace("thin-r0000,", "\"'-thin-r0000\","))
        (self.folder / "cases/thin-r0000").rename(self.folder / "cases/-thin-r0000")
        self.addCleanup((self.folder / "cases/-thin-r0000").rename, self.folder / "cases/thin-r0000")
        self.assertEqual(json.loads(self.design("--json"))["settings"][0]["replicates"], 3)

    def test_a_picture_is_drawn(self):
        picture = self.folder / "design.svg"
        self.design("--scatter", self.scatter("ice.thickness,hours\n0.3,5\n0.6,1\n"), "-o", picture)
        self.assertIn("level of a return period", picture.read_text())
        # Each state has a panel of its own, on common axes.
        for name in SETTINGS:
            self.assertEqual(picture.read_text().count(f">{name}</text>"), 1)
        self.assertEqual(picture.read_text().count(">exposure [h]</text>"), len(SETTINGS))

    @unittest.skipUnless(shutil.which("rsvg-convert"), "rsvg-convert is not installed")
    def test_a_picture_may_be_png(self):
        picture = self.folder / "design.png"
        self.design("-o", picture)
        data = picture.read_bytes()
        self.assertEqual(data[:8], b"\x89PNG\r\n\x1a\n")
        self.assertEqual(struct.unpack(">I", data[16:20]), (1340,))  # two pixels for one of the drawing
        self.assertEqual([file.name for file in self.folder.glob("*design.png*")], ["design.png"])

    def test_a_png_without_its_program_is_refused(self):
        done = subprocess.run([BRASH, "design", str(self.folder), "-o", "x.png"], capture_output=True, text=True,
                              cwd=self.folder, env={**os.environ, "PATH": str(self.folder)})
        self.assertEqual(done.returncode, 2)
        self.assertIn("x.png: rsvg-convert, which makes a PNG of a drawing, is not on the path", done.stderr)
        self.assertIn("install Debian's package librsvg2-bin", done.stderr)
        self.assertEqual(list(self.folder.glob("*x.png*")), [])

    def test_a_case_counts_once(self):
        table = self.folder / "campaign.csv"
        before = table.read_text()
        self.addCleanup(table.write_text, before)
        head, *rows = before.splitlines()
        table.write_text("\n".join([head, *rows, rows[0]]) + "\n")
        for command in (("design",), ("trend", "--along", "ice.thickness"), ("compare", self.folder / "history.csv"),
                        ("export", "openfast", "--join", "100")):
            words = [*command[:2], self.folder, *command[2:]] if command[0] == "export" else [command[0], self.folder, *command[1:]]
            done = subprocess.run([BRASH, *map(str, words)], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, f"{command}: {done.stdout}")
            self.assertIn("case 'thin-r0000' is there twice\n  allowed: one line for each case", done.stderr)
        table.write_text(head + "\n")
        for command in ("openfast",), ("openfast", "--join", "100"):
            done = subprocess.run([BRASH, "export", command[0], self.folder, *command[1:]], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn("has no case that is done", done.stderr)

    def test_what_cannot_be_pooled_is_refused(self):
        for head, name in (("ice.thickness,hours,hours", "hours"), ("ice.thickness,ice.thickness,hours", "ice.thickness")):
            self.assertIn(f"has two columns '{name}'", self.design("--scatter", self.scatter(f"{head}\n0.3,10,20\n"), code=2))
        refused = self.design("--scatter", self.scatter("ice.thickness,hours\n0.5,10\n"), code=2)
        self.assertIn("states.csv:2: the campaign has no setting of the state '0.5,10'", refused)
        refused = self.design("--scatter", self.scatter("ice.strength,hours\n0.5,10\n"), code=2)
        self.assertIn("column 'ice.strength' is not a varied key\n  allowed: `hours` and: ice.thickness", refused)
        refused = self.design("--scatter", self.scatter("ice.thickness,hours\n0.3,9000\n"), code=2)
        self.assertIn("hours '9000'\n  allowed: hours of a year, 0 to 8784", refused)
        refused = self.design("--scatter", self.scatter("ice.thickness,hours\n0.3,8000\n0.6,800\n"), code=2)
        self.assertIn("states.csv: all states together last 8800 hours a year\n  allowed: hours of a year, 8784 together "
                      "at most", refused)
        for option, value, needed in (("--annual", 0.01, "--scatter"), ("--frequency", 2, "--exponent")):
            self.assertIn(f"{option} requires {needed}", self.design(option, value, code=2))
        self.assertIn("no setting matches 'x*'\n  allowed: one of: thin, thick", self.design("--where", "x*", code=2))
        done = subprocess.run([BRASH, "design", str(self.folder / "cases")], capture_output=True, text=True)
        self.assertIn("is not a campaign: it has no campaign.csv", done.stderr)


if __name__ == "__main__":
    unittest.main()
