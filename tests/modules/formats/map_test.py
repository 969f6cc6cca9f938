# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash export map`: the ice of a run lies where the run has it, in the coordinates of the case's origin."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import netCDF4

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
EAST, NORTH = 500000, 8700000
CRS = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::32633"}}


def brash(*words):
    return subprocess.run([BRASH, *map(str, words)], check=True, capture_output=True, text=True)


def square(x, y, side):
    corners = [(x, y), (x + side, y), (x + side, y + side), (x, y + side), (x, y)]
    return {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [
        [[EAST + a, NORTH + b] for a, b in corners]]}}


def box(feature):
    ring = feature["geometry"]["coordinates"][0]
    return [f(p[i] for p in ring) for f in (min, max) for i in (0, 1)]


class Map(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def run_case(self, case, *settings):
        words = [f"--set={text}" for text in ("time.duration=2", "output.statistics_from=0", *settings)]
        brash("run", SOURCE / case, "-o", self.folder / "run", *words)
        return self.folder / "run"

    def test_floes_of_a_map_come_back_with_their_coordinates_and_crs(self):
        given = {"type": "FeatureCollection", "crs": CRS,
                 "features": [square(1 + 12 * i, -28 + 12 * j, 8) for i in range(4) for j in range(5)]}
        (self.folder / "floes.geojson").write_text(json.dumps(given))
        case = self.folder / "field.toml"
        text = (SOURCE / "experiments/fields/cone.toml").read_text().split("[field]")[0]
        case.write_text(text + f"""[field]
kind = "floes"
file = "floes.geojson"
origin = [{EAST}, {NORTH}]
length = 60
width = 60

[time]
duration = 2

[output]
statistics_from = 0
frames_per_second = 2
""")
        brash("run", case, "-o", self.folder / "run")
        made = self.folder / "ice.geojson"
        brash("export", "map", self.folder / "run" / "run.nc", "-o", made, "--time", 0)
        first = json.loads(made.read_text())
        self.assertEqual(first["crs"], CRS)
        self.assertEqual([float(value) for value in first["origin"]], [EAST, NORTH])
        self.assertEqual({feature["properties"]["kind"] for feature in first["features"]}, {"floe"})
        for before, after in zip(sorted(map(box, given["features"])), sorted(map(box, first["features"]))):
            for a, b in zip(before, after):
                self.assertLess(abs(a - b), 1e-8)  # the grid of 2^-30 m, and a floe's frame in its middle
        # At the end the cone has pushed some of them ahead.
        brash("export", "map", self.folder / "run" / "run.nc", "-o", made)
        last = json.loads(made.read_text())
        self.assertEqual(len(last["features"]), 20)
        self.assertGreater(max(box(f)[0] - box(g)[0] for f, g in zip(last["features"], first["features"])), 0.05)
        self.assertIn("20", brash("pieces", made).stdout)

    def test_level_ice_and_its_floes_have_the_areas_of_the_ledger(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=2", "time.duration=4")
        made = run / "ice.geojson"
        brash("export", "map", run / "run.nc")
        features = json.loads(made.read_text())["features"]
        ledger = json.loads((run / "summary.json").read_text())["ledger"]
        areas = {kind: sum(f["properties"]["area"] for f in features if f["properties"]["kind"] == kind)
                 for kind in ("sheet", "floe")}
        self.assertAlmostEqual(areas["sheet"], float(ledger["sheet"]), places=6)
        self.assertAlmostEqual(areas["floe"], float(ledger["floes"]), places=5)
        with netCDF4.Dataset(run / "run.nc") as data:
            known = set(data["floe_id"][:].tolist())
        self.assertLessEqual({f["properties"]["id"] for f in features if f["properties"]["kind"] == "floe"}, known)
        self.assertEqual({f["properties"].get("thickness") for f in features if f["properties"]["kind"] == "floe"}, {0.33})

    def test_no_two_polygons_of_a_map_have_one_id(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=2", "time.duration=2")
        brash("export", "map", run)
        features = json.loads((run / "ice.geojson").read_text())["features"]
        ids = [feature["properties"]["id"] for feature in features]
        self.assertEqual({feature["properties"]["kind"] for feature in features}, {"sheet", "floe"})
        self.assertEqual(len(set(ids)), len(ids))
        # The same of a map that is cracked, whose floes are parts of one feature.
        ring = lambda x: [[[x, 0], [x + 4, 0], [x + 4, 4], [x, 4], [x, 0]]]
        given = {"type": "FeatureCollection", "features": [
            {"type": "Feature", "properties": {"kind": "floe", "id": 0},
             "geometry": {"type": "MultiPolygon", "coordinates": [ring(0), ring(10)]}},
            {"type": "Feature", "properties": {"id": 0}, "geometry": {"type": "Polygon", "coordinates": ring(20)}}]}
        (self.folder / "given.geojson").write_text(json.dumps(given))
        (self.folder / "away.wkt").write_text("POLYGON ((22 -1, 30 -1, 30 9, 22 9, 22 -1))")
        brash("crack", "--sheet", self.folder / "given.geojson", "--cutters", self.folder / "away.wkt", "-o",
              self.folder / "cut.geojson")
        cut = json.loads((self.folder / "cut.geojson").read_text())["features"]
        self.assertEqual(len({feature["properties"]["id"] for feature in cut}), 4)

    def test_a_named_crs_is_written_and_read_back(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=0", "time.duration=0.5")
        made = self.folder / "ice.geojson"
        said = subprocess.run([BRASH, "export", "map", run, "-o", made], check=True, capture_output=True, text=True).stderr
        self.assertIn("names no coordinate reference system", said)
        self.assertNotIn("crs", json.loads(made.read_text()))
        said = brash("export", "map", run, "-o", made, "--crs", "EPSG:32633").stderr
        self.assertEqual((said, json.loads(made.read_text())["crs"]), ("", CRS))
        self.assertIn("pieces", brash("pieces", made).stdout)
        for name, part in (("EPSG:4326", "is a system of degrees"), ("32633", "is not a code of a system")):
            done = subprocess.run([BRASH, "export", "map", run, "--crs", name], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2)
            self.assertIn(part, done.stderr)

    def area_at(self, run, *time):
        made = self.folder / "ice.geojson"
        brash("export", "map", run / "run.nc", "-o", made, *time)
        return sum(float(feature["properties"]["area"]) for feature in json.loads(made.read_text())["features"])

    def test_ice_and_floes_are_of_one_frame_also_where_the_last_one_is_not_at_the_end(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=0", "time.duration=3")
        ledger = json.loads((run / "summary.json").read_text())["ledger"]
        self.assertGreater(float(ledger["floes"]), 20.0)
        with netCDF4.Dataset(run / "run.nc") as data:
            self.assertEqual(data["frame_time"][:].tolist(), [0.0])
            born = data["floe_area"][:][data["floe_birth"][:] == 0.0].sum()
        self.assertAlmostEqual(self.area_at(run), 2500.0, delta=1e-6)  # of the field, of which floes at the start have
        self.assertLess(born, 20.0)

    def test_a_frame_is_found_by_its_time_as_it_is_written(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=10", "time.duration=1.5")
        with netCDF4.Dataset(run / "run.nc") as data:
            times = data["frame_time"][:].tolist()
        missed = [time for time in times if round(time, 6) < time]
        self.assertTrue(missed)
        made = self.folder / "ice.geojson"
        for time in missed:
            texts = []
            for asked in (round(time, 6), time + 1e-6):
                brash("export", "map", run / "run.nc", "-o", made, "--time", asked)
                texts.append(made.read_text())
            self.assertEqual(*texts)

    def test_a_time_before_the_first_frame_and_an_unknown_format_are_refused(self):
        run = self.run_case("experiments/validation/cone.toml", "output.frames_per_second=0", "time.duration=0.5")
        for words, part in ((["--time", "-1"], "--time"), (["-o", self.folder / "ice.shp"], "is not a format that is written")):
            done = subprocess.run([BRASH, "export", "map", run / "run.nc", *map(str, words)], capture_output=True, text=True)
            self.assertNotEqual(done.returncode, 0)
            self.assertIn(part, done.stderr)


if __name__ == "__main__":
    unittest.main()
