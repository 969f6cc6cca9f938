# SPDX-License-Identifier: GPL-3.0-or-later
"""Structures from meshes and from particulars: run, copied, repeated, resumed; bad meshes are refused with places."""
import csv
import math
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
REGIONS = ("bow", "shoulders", "sides", "stern", "bottom")
SHIPS = SOURCE / "experiments/ships"
CASE = """
[algorithm]
preset = "paper"
[ice]
thickness = 0.33
youngs_modulus = "0.35 GPa"
flexural_strength = "539 kPa"
[structure]
kind = "mesh"
file = "hull.off"
draught = 5.68
speed = 1.202
start_distance = 7
[field]
length = 50
width = 50
initial_crack = false
[failure]
crushed_ice = "leaves"
pressure = "edge"
[contact]
engine = "brash"
area = "surface"
crushing_bound = "all"
[hydrodynamics]
drag = "surface"
added_mass_law = "isotropic"
[time]
duration = 0.8
[output]
statistics_from = 0.2
"""


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0", *(" ".join(map(str, v)) for v in vertices),
             *(" ".join(map(str, [len(f), *f])) for f in faces)]
    return "\n".join(lines) + "\n"


def cone(n=64):
    """The cone of the validation case as a mesh of itself, its keel at 0."""
    slope = math.tan(math.radians(61.4))
    rings = [(z, 6.8 + (z - 5.68) / slope) for z in (0, 9.08)]
    vertices = [(r * math.cos(2 * math.pi * i / n), r * math.sin(2 * math.pi * i / n), z) for z, r in rings for i in range(n)]
    sides = [(i, (i + 1) % n, n + (i + 1) % n, n + i) for i in range(n)]
    return vertices, [*sides, tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))]


def brash(*arguments):
    return subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True)


def columns(folder):
    with open(folder / "history.csv", encoding="utf-8") as stream:
        rows = list(csv.DictReader(line for line in stream if not line.startswith("#")))
    return {name: [float(row[name]) for row in rows] for name in rows[0]}


class Mesh(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        self.case, self.mesh = self.path / "mine.toml", self.path / "hull.off"
        self.case.write_text(CASE)
        self.mesh.write_text(off(*cone()))

    def run_case(self, name, *options):
        done = brash("run", self.case, "-o", self.path / name, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.path / name

    def test_a_cone_as_a_mesh_of_itself_loads_as_the_cone_does(self):
        mesh = columns(self.run_case("mesh"))
        keys = {"kind": "'cone'", "angle": "'61.4 deg'", "waterline_width": "13.6", "height": "9.08",
                "height_under_water": "5.68"}
        text = CASE.replace('kind = "mesh"\nfile = "hull.off"\ndraught = 5.68',
                            "\n".join(f"{key} = {value}" for key, value in keys.items()))
        self.case.write_text(text)
        round_cone = columns(self.run_case("cone"))
        self.assertGreater(max(round_cone["Fx"]), 1e4)
        # Up to the first break at 0.25 s. The round cone has 64 facets in contacts too; the mesh's outlines lie on a grid
        # of a micrometre and leave out vertices nearer than 0.2 mm.
        for one, other in list(zip(mesh["Fx"], round_cone["Fx"]))[:25]:
            self.assertAlmostEqual(one, other, delta=1e-4 * max(round_cone["Fx"]))

    def test_a_copied_folder_reruns_with_its_mesh_and_a_changed_mesh_is_named(self):
        folder = self.run_case("a")
        elsewhere = self.path / "elsewhere"
        shutil.copytree(folder, elsewhere)
        self.mesh.unlink()
        shutil.rmtree(folder)
        done = brash("rerun", elsewhere / "manifest.json")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertNotIn("DIFFERENT", done.stdout)
        self.assertEqual(brash("export", "vtk", elsewhere / "run.nc", "-o", self.path / "vtk").returncode, 0)
        copy = elsewhere / "inputs/hull/hull.off"
        copy.write_text(off(*cone(63)))
        refused = brash("rerun", elsewhere / "manifest.json")
        self.assertEqual(refused.returncode, 2)
        self.assertIn(str(copy), refused.stderr)

    def test_a_run_resumes_with_its_mesh_and_not_with_another_one(self):
        often = ("--set", "output.checkpoint_interval=0.3")
        whole, begun = self.run_case("whole", *often), self.path / "begun"
        begun.mkdir()
        shutil.copy(whole / "checkpoint.nc", begun)
        self.run_case("begun", *often, "--resume")
        self.assertEqual((begun / "history.csv").read_bytes(), (whole / "history.csv").read_bytes())
        self.mesh.write_text(off(*cone(63)))
        other = self.path / "other"
        other.mkdir()
        shutil.copy(whole / "checkpoint.nc", other)
        refused = brash("run", self.case, "-o", other, *often, "--resume")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("mesh", refused.stderr)

    def test_check_prints_repairs_and_displacement(self):
        vertices, faces = cone()
        faces[3] = faces[3][::-1]
        self.mesh.write_text(off(vertices, [*faces, faces[5]]))
        done = brash("check", self.case)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2 triangles dropped, 2 turned, 0 holes filled", done.stdout)
        self.assertRegex(done.stdout, r"displacement +505\.\d")
        self.assertRegex(done.stdout, r"convex parts of the mesh +1,")

    def test_check_draws_over_no_file_that_it_reads(self):
        mesh = self.mesh.read_bytes()
        refused = brash("check", self.case, "--picture", self.mesh)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("which is an input", refused.stderr)
        self.assertEqual(self.mesh.read_bytes(), mesh)

    def test_check_draws_hull_waterlines_and_field(self):
        picture = self.path / "case.svg"
        done = brash("check", self.case, "--picture", picture)
        self.assertEqual(done.returncode, 0, done.stderr)
        drawing = xml.etree.ElementTree.parse(picture).getroot()
        classes = [path.get("class") for path in drawing.iter("{http://www.w3.org/2000/svg}path")]
        # The middle section, the waterline and the structure at its start; the ice from the side and from above.
        self.assertEqual([classes.count(one) for one in ("hull", "ice", "ice sheet", "end")], [3, 1, 1, 1])
        self.assertEqual(classes.count("thin"), 16)
        self.assertEqual(classes.count("land"), 0)
        shallow = brash("check", self.case, "--set", "water.depth=4 m", "--picture", self.path / "shallow.svg")
        self.assertEqual(shallow.returncode, 0, shallow.stderr)
        drawing = xml.etree.ElementTree.parse(self.path / "shallow.svg").getroot()
        classes = [path.get("class") for path in drawing.iter("{http://www.w3.org/2000/svg}path")]
        self.assertEqual(classes.count("land"), 1)  # the bed
        self.assertEqual(brash("check", self.case, "--picture", self.case).returncode, 2)

    def refusal(self, *options):
        done = brash("check", self.case, *options)
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        for word in ("structure.file", "allowed", "remedy"):
            self.assertIn(word, done.stderr)
        return done.stderr

    def test_bad_meshes_are_refused_with_file_key_places_and_remedy(self):
        vertices, faces = cone()
        self.mesh.write_text(off(vertices, faces[:-1]))
        self.assertIn("is open: 1 hole, one of 64 edges from (", self.refusal())
        more = [(x + 3, y, z + 1) for x, y, z in vertices]
        self.mesh.write_text(off(vertices + more, [*faces, *([i + 128 for i in face] for face in faces)]))
        self.assertIn("crosses itself", self.refusal())
        self.mesh.write_text(off([(1e3 * x, 1e3 * y, 1e3 * z) for x, y, z in vertices], faces))
        self.assertIn("write structure.scale = 0.001", self.refusal())
        self.mesh.write_text("no mesh")
        self.assertIn("is not in the format off", self.refusal())
        self.assertIn("there is no file", self.refusal("--set", "structure.file=missing.off"))
        self.assertIn("names no file", self.refusal("--set", "structure.file=''"))
        self.case.write_text(CASE.replace('"hull.off"', '"../hull.off"'))
        self.assertIn("leads out of the folder", self.refusal())


class Ships(unittest.TestCase):
    def test_the_example_ships_run_and_have_a_load(self):
        for name in ("icebreaker", "uikku"):
            with tempfile.TemporaryDirectory() as folder:
                done = brash("run", SHIPS / f"{name}.toml", "-o", folder, "--set", "time.duration=1.5", "--set",
                             "output.statistics_from=0.5", "--set", "algorithm.preset=paper")
                self.assertEqual(done.returncode, 0, done.stderr)
                loads = columns(pathlib.Path(folder))
                self.assertGreater(max(loads["Fx"]), 1e3)
                self.check_regions(loads)
                self.assertRegex(done.stdout, r"Lindqvist \(regression of a ship\), mean +\d")
                self.assertNotIn("Croasdale", done.stdout)

    def check_regions(self, loads):
        """The regions' loads add up to the whole, and a ship that has just touched the ice bears it at her bow."""
        for axis in ("Fx", "Fy", "Fz"):
            for part, whole in (("", axis), ("_crushing", f"crushing_{axis}")):
                zero = [0.0] * len(loads["Fx"])
                parts = [loads.get(f"{axis}_{name}{part}", zero) for name in REGIONS]
                for row, total in zip(zip(*parts), loads[whole]):
                    self.assertAlmostEqual(sum(row), total, delta=1e-9 * (1.0 + max(map(abs, loads["Fx"]))))
        self.assertFalse({"Fx_sides", "Fx_stern"} & set(loads))  # columns without a load are left out

    def test_a_ship_without_particulars_and_one_that_ends_before_its_keel_are_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "ship.toml"
            text = (SHIPS / "icebreaker.toml").read_text()
            case.write_text(text[:text.index("\n[hull]")] + text[text.index("[field]"):])
            self.assertIn("has no particulars in [hull]", brash("check", case).stderr)
        for change, words in (("hull.midbody=10", "bow and stern meet"), ("hull.midbody=80", "no room for the stern"),
                              ("hull.depth=6", "the deck lies under water"),
                              ("hull.bow_length=10", "the bow is shorter than a wedge"),
                              ("hull.flare='60 deg'", "the sides meet above the keel")):
            refused = brash("check", SHIPS / "icebreaker.toml", "--set", change)
            self.assertEqual(refused.returncode, 2, change)
            self.assertIn(words, refused.stderr)


if __name__ == "__main__":
    unittest.main()
