# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash resistance`: campaigns whose resistance is known, the plan that it writes, a small campaign of its own, refusals."""
import csv
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import tomllib
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
PYTHON = pathlib.Path(os.environ["BRASH_PYTHON"])
SHIP = SOURCE / "experiments/ships/icebreaker.toml"
LENGTH = 90.0  # m, of its hull
THICKNESSES, SPEEDS = (0.4, 0.8, 1.2), (1.0, 2.0, 4.0)
REPLICATES = {"r0000": 0.95, "r0001": 1.05}  # times the mean
K, B, N = 3e5, 1.3, 0.4


def resistance(thickness, speed):
    return K * thickness**B * speed**N


def summary(force, start, warnings=()):
    return {"statistics_from": start, "warnings": [{"id": name, "text": ""} for name in warnings],
            "horizontal": {"mean": force, "mean_95": [0.9 * force, 1.1 * force],
                           "mean_by_cause": {"crushing": 0.5 * force, "floe_normal": 0.3 * force, "floe_friction": 0.2 * force}},
            "mean_by_region": {"bottom": {"covered": 0.3}}}


def write_campaign(folder, thicknesses=THICKNESSES, speeds=SPEEDS, replicates=REPLICATES, lengths=2.5, filling=()):
    """The files of a finished campaign. `filling`: replicates whose bottom still gathers ice."""
    text, rows, settings = SHIP.read_text(), ["case,setting,replicate,status"], []
    (folder / "settings").mkdir(parents=True)
    for thickness in thicknesses:
        for speed in speeds:
            name = f"thickness-{thickness}_speed-{speed}"
            case = text.replace('thickness = "0.8 m"', f"thickness = {thickness}").replace('speed = "2 m/s"', f"speed = {speed}")
            (folder / f"settings/icebreaker_{name}.toml").write_text(case)
            settings.append({"setting": name, "values": {"ice.thickness": thickness, "structure.speed": speed}})
            for replicate, factor in replicates.items():
                run = folder / "cases" / f"{name}-{replicate}"
                run.mkdir(parents=True)
                warnings = ["filling-hull"] if replicate in filling else []
                run.joinpath("summary.json").write_text(json.dumps(
                    summary(factor * resistance(thickness, speed), lengths * LENGTH / speed, warnings)))
                rows.append(f"{name}-{replicate},{name},{replicate[1:]},done")
    (folder / "summary.json").write_text(json.dumps({"settings": settings}))
    (folder / "campaign.csv").write_text("\n".join(rows) + "\n")


def between(points, at):
    """Straight lines through points [(x, y)]."""
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= at <= x1:
            return y0 + (y1 - y0) * (at - x0) / (x1 - x0)
    raise ValueError(at)


def root(function, low, high):
    """Where a falling function is zero."""
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) > 0 else (low, middle)
    return low


class Resistance(unittest.TestCase):
    def setUp(self):
        self.place = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.place.name)
        self.addCleanup(self.place.cleanup)

    def run_command(self, *arguments, code=0):
        done = subprocess.run([BRASH, "resistance", *map(str, arguments)], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return done.stderr if code else done.stdout

    def json(self, *arguments):
        return json.loads(self.run_command(*arguments, "--json"))

    def test_means_parts_intervals_and_the_fit(self):
        write_campaign(self.folder)
        found = self.json(self.folder)
        self.assertEqual(found["case"], "icebreaker")
        self.assertEqual([(p["thickness"], p["speed"]) for p in found["points"]], [(h, v) for h in THICKNESSES for v in SPEEDS])
        for point in found["points"]:
            force = resistance(point["thickness"], point["speed"])
            self.assertAlmostEqual(point["resistance"] / force, 1.0, 12)
            self.assertAlmostEqual((point["breaking"] + point["pieces"] + point["friction"]) / force, 1.0, 12)
            # Student's interval of two values 5 % off their mean: t(1) = 12.7062.
            self.assertAlmostEqual(point["resistance_95"][1] / force, 1.0 + 12.7062 * 0.05, 4)
            self.assertTrue(point["steady"])
        # The mean of the logarithms lies below the mean: ln sqrt(0.95 1.05).
        fit = found["fit"]
        self.assertAlmostEqual(fit["k"]["value"] / (K * math.sqrt(0.95 * 1.05)), 1.0, 9)
        self.assertAlmostEqual(fit["b"]["value"], B, 9)
        self.assertAlmostEqual(fit["n"]["value"], N, 9)
        loads = json.loads(subprocess.run([BRASH, "loads", SHIP, "--json"], check=True, capture_output=True).stdout)["loads"]
        lindqvist = next(load["horizontal"] for load in loads if load["formula"] == "Lindqvist")
        at = next(p for p in found["points"] if (p["thickness"], p["speed"]) == (0.8, 2.0))
        self.assertAlmostEqual(at["lindqvist"], lindqvist)

    def test_speed_and_thickness_where_the_thrust_is_the_resistance(self):
        write_campaign(self.folder)
        bollard, open_water, at_speed = 5.5e5, 8.0, 1.5
        thrust = lambda v: bollard * (1 - v / open_water / 3 - 2 / 3 * (v / open_water)**2)
        curve = lambda h: [(v, resistance(h, v)) for v in SPEEDS]
        found = self.json(self.folder, "--bollard-pull", bollard, "--open-water-speed", open_water, "--at-speed", at_speed)
        thin, middle, thick = found["attained"]
        self.assertEqual((thin["speed"], thin["outside"]), (None, "above"))  # 159 kN at 4 m/s, the thrust is 367
        self.assertAlmostEqual(middle["speed"], root(lambda v: thrust(v) - between(curve(0.8), v), 1.0, 4.0), 6)
        self.assertAlmostEqual(thick["speed"], root(lambda v: thrust(v) - between(curve(1.2), v), 1.0, 4.0), 6)
        line = list(zip(*found["attained_lines"][0].values()))
        for h, v in ((0.8, middle["speed"]), (1.2, thick["speed"])):
            self.assertAlmostEqual(between(line, h), v, 6)
        between_points = lambda h, v: between([(x, between(curve(x), v)) for x in THICKNESSES], h)
        for h in (0.784, 1.0):
            self.assertAlmostEqual(between(line, h), root(lambda v: thrust(v) - between_points(h, v), 1.0, 4.0), 6)
        self.assertGreater(min(h for h, _ in line), 0.4)  # where the fastest run has thrust left, nothing is known
        across = [(h, between(curve(h), at_speed)) for h in THICKNESSES]
        self.assertEqual(found["thickness_at"]["outside"], "above")  # 440 kN in 1.2 m, the thrust is 503
        weak = self.json(self.folder, "--bollard-pull", 3e5, "--open-water-speed", 8, "--at-speed", at_speed)
        self.assertEqual(weak["attained"][2]["outside"], "below")
        thrust = lambda v: 3e5 * (1 - v / 24 - 2 / 3 * (v / 8)**2)
        self.assertAlmostEqual(weak["thickness_at"]["thickness"], root(lambda h: thrust(at_speed) - between(across, h), 0.4, 1.2), 6)

    def test_the_attained_speed_has_a_gap_where_none_is_attained(self):
        write_campaign(self.folder)
        for path in self.folder.glob("cases/thickness-0.8_*/summary.json"):
            path.write_text(json.dumps(summary(1e4, 225.0)))
        lines = self.json(self.folder, "--bollard-pull", 1.5e5, "--open-water-speed", 8)["attained_lines"]
        self.assertEqual(len(lines), 2)  # about 0.8 m each speed of the runs has thrust left
        self.assertLess(max(lines[0]["thickness"]), 0.8)
        self.assertGreater(min(lines[1]["thickness"]), 0.8)

    def test_the_interval_of_a_speed_is_that_of_the_resistance(self):
        write_campaign(self.folder, replicates={"r0000": 1.0})
        found = self.json(self.folder, "--bollard-pull", 4.6e5, "--open-water-speed", 8)["attained"][1]
        thrust = lambda v: 4.6e5 * (1 - v / 24 - 2 / 3 * (v / 8)**2)
        for end, factor in zip(found["speed_95"], (1.1, 0.9)):
            expected = root(lambda v: thrust(v) - factor * between([(x, resistance(0.8, x)) for x in SPEEDS], v), 1.0, 4.0)
            self.assertAlmostEqual(end, expected, 6)

    def test_a_table_of_thrust(self):
        write_campaign(self.folder / "ship")
        table = self.folder / "thrust.csv"
        table.write_text("speed,thrust\n0,600000\n5,100000\n")
        found = self.json(self.folder / "ship", "--thrust", table)["attained"][1]
        expected = root(lambda v: 6e5 - 1e5 * v - between([(x, resistance(0.8, x)) for x in SPEEDS], v), 1.0, 4.0)
        self.assertAlmostEqual(found["speed"], expected, 6)
        table.write_text("speed,thrust\n0,600000\n3,100000\n")
        self.assertEqual(self.json(self.folder / "ship", "--thrust", table)["attained"][1]["outside"], "unknown")
        for text, what in (("speed,force\n0,1\n1,1\n", "thrust"), ("speed,thrust\n0,x\n1,1\n", ":2"), ("speed,thrust\n1,1\n1,1\n", ":3"),
                           ("speed,thrust\n1,1\n", "two rows")):
            table.write_text(text)
            self.assertIn(what, self.run_command(self.folder / "ship", "--thrust", table, code=2))

    def test_what_is_not_steady_says_why(self):
        write_campaign(self.folder / "short", lengths=1.2)
        write_campaign(self.folder / "filling", filling=("r0001",))
        for name, why in (("short", "after 1.2 lengths of the hull"), ("filling", "gathers ice in 1 of 2 runs")):
            found = self.json(self.folder / name)
            self.assertFalse(any(point["steady"] for point in found["points"]))
            self.assertIn(why, found["points"][0]["reason"])
            text = self.run_command(self.folder / name)
            self.assertEqual(text.count("  not steady\n"), 9)
            self.assertEqual(text.count(why), 1)
            self.assertIn("(all 9 points)", text)
            self.assertIn("the law, and the speeds and the thickness below, are of means that are not steady", text)

    def test_replicates_that_coincide_count_once(self):
        write_campaign(self.folder)
        table = self.folder / "campaign.csv"
        head, *rows = table.read_text().splitlines()
        rows = [row + (",same-as-a-replicate" if "r0001" in row else ",") for row in rows]
        table.write_text("\n".join([head + ",warnings", *rows]) + "\n")
        point = self.json(self.folder)["points"][0]
        self.assertEqual(point["runs"], 1)
        self.assertAlmostEqual(point["resistance"] / resistance(0.4, 1.0), 0.95, 12)

    def test_files_beside_the_campaign(self):
        write_campaign(self.folder)
        self.run_command(self.folder, "--bollard-pull", 6e5, "--open-water-speed", 8)
        with open(self.folder / "resistance.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 9)
        self.assertAlmostEqual(float(rows[4]["resistance"]), resistance(0.8, 2.0), 1)
        self.assertEqual(json.loads((self.folder / "resistance.json").read_text()),
                         self.json(self.folder, "--bollard-pull", 6e5, "--open-water-speed", 8))
        picture = (self.folder / "resistance.svg").read_text()
        for words in ("resistance, 95 %", "speed that the thrust attains", "net thrust", "ice of 1.2 m"):
            self.assertIn(words, picture)

    def test_the_plan_goes_the_same_distance_at_each_speed(self):
        self.run_command(SHIP, "--thickness", "0.4,0.8", "--speed", "0.5,4", "-o", self.folder, "--plan")
        plan = tomllib.loads((self.folder / "plan.toml").read_text())
        axis = plan["grid"][1]
        self.assertEqual(axis["time"]["duration"], [630, 78.75])  # 3.5 lengths of 90 m
        self.assertEqual(axis["output"]["statistics_from"], [450, 56.25])
        self.assertEqual(axis["time"]["step"], [0.02, 0.005])
        self.assertEqual(plan["set"]["field"]["length"], 360)  # the way less 45.5 m of water, and a length, rounded up
        counts = subprocess.run([BRASH, "campaign", self.folder / "plan.toml", "-o", self.folder, "--status", "--json"],
                                check=True, capture_output=True)
        self.assertEqual(json.loads(counts.stdout)["n_cases"], 8)
        self.assertIn("is another plan",
                      self.run_command(SHIP, "--thickness", "0.4", "--speed", "0.5", "-o", self.folder, code=2))

    def test_a_campaign_that_runs_and_goes_on(self):
        small = ("-o", self.folder / "ship", "--replicates", 1, "--lengths", 0.1, "--set=field.width=60")
        self.run_command(SHIP, "--thickness", "0.8", "--speed", "3,4", *small)
        found = self.json(self.folder / "ship")
        self.assertEqual([p["speed"] for p in found["points"]], [3.0, 4.0])
        self.assertTrue(all(p["resistance"] > 0 and not p["steady"] for p in found["points"]))
        self.assertIn("refused", found["fit"])
        before = (self.folder / "ship/cases").stat().st_mtime_ns
        self.run_command(SHIP, "--thickness", "0.8", "--speed", "3,4", *small, "--resume")
        self.assertEqual((self.folder / "ship/cases").stat().st_mtime_ns, before)  # nothing ran again
        self.assertEqual(len(json.loads(self.run_command(SHIP, "--thickness", "0.8", "--speed", "3,4,5", *small, "--resume",
                                                         "--json"))["points"]), 3)

    def test_a_plan_is_told_with_the_command_that_runs_it(self):
        said = self.run_command(SHIP, "--thickness", "0.8", "--speed", "3", "--set", "ice.flexural_strength='400 kPa'", "-o",
                                self.folder / "ship", "--plan")
        words = shlex.split(re.search("`(.*)`", said)[1])
        self.assertEqual(words, ["brash", "campaign", f"{self.folder}/ship/plan.toml", "-o", f"{self.folder}/ship", "--set",
                                 "ice.flexural_strength='400 kPa'"])

    def test_refusals_name_what_is_allowed(self):
        cone = SOURCE / "experiments/validation/cone.toml"
        grid = ("--thickness", "0.8", "--speed", "1", "-o", self.folder)
        for arguments, words in (((SHIP,), "--thickness, --speed and -o FOLDER"),
                                 ((cone, *grid), "hull.length"),
                                 ((SOURCE / "experiments/ships/free.toml", *grid), 'kind = "towed"'),
                                 ((self.folder / "none.toml", *grid), "none.toml")):
            self.assertIn(words, self.run_command(*arguments, code=2))
        write_campaign(self.folder / "ship")
        (self.folder / "thrust.csv").write_text("speed,speed,thrust\n0,1,1e6\n8,9,0\n")
        self.assertIn("has two columns 'speed'",
                      self.run_command(self.folder / "ship", "--thrust", self.folder / "thrust.csv", code=2))
        self.assertIn("--speed has no effect", " ".join(self.run_command(self.folder / "ship", "--speed", 2, code=2).replace(":", "").split()))
        for setting in (self.folder / "ship/settings").iterdir():
            setting.write_text(cone.read_text())
        self.assertIn("without [hull] length", self.run_command(self.folder / "ship", code=2))
        (self.folder / "cases").mkdir()
        self.assertIn("campaign", self.run_command(self.folder, code=2))

    @unittest.skipUnless(PYTHON.is_dir() and not os.environ.get("BRASH_SANITIZE"), "there is no module that Python can load")
    def test_python_gives_the_same(self):
        write_campaign(self.folder)
        program = ("import json, sys, brash; print(json.dumps(brash.resistance(sys.argv[1], bollard_pull=6e5, open_water_speed=8)))")
        done = subprocess.run([sys.executable, "-c", program, str(self.folder)], capture_output=True, text=True,
                              env={**os.environ, "PYTHONPATH": str(PYTHON)})
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout), self.json(self.folder, "--bollard-pull", 6e5, "--open-water-speed", 8))


if __name__ == "__main__":
    unittest.main()
