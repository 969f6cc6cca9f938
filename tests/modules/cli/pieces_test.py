# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash pieces` and `brash crack` of maps, and of a field, whose plates are floes too."""
import json
import os
import pathlib
import subprocess
import tempfile
import unittest

SQUARE = "POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))"
BOW = "POLYGON ((0 0, 10 10, 10 0, 0 9, 0 0))"
BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])


class Pieces(unittest.TestCase):
    def test_a_map_knows_no_floes_that_are_gone(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "floes.wkt").write_text("POLYGON ((0 0, 1 0, 0 1, 0 0))")
            said = subprocess.run([BRASH, "pieces", "floes.wkt", "--born"], cwd=folder, capture_output=True, text=True)
            self.assertEqual(said.returncode, 2)
            self.assertIn("floes.wkt: is a map, which knows no floes that are gone", said.stderr)
            self.assertIn("remedy:  leave --born out", said.stderr)

    def test_plates_of_a_field_are_counted_at_the_start_and_at_the_end(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "floes.wkt").write_text("MULTIPOLYGON (((10 -20, 40 -20, 40 20, 10 20, 10 -20)),"
                                            "((42 -3, 48 -3, 48 3, 42 3, 42 -3)))")
            subprocess.run([BRASH, "run", SOURCE / "tests/experiments/field-of-file.toml", "-o", path / "run", "--set",
                            f"field.file={path / 'floes.wkt'}", "--set", "time.duration=0.05", "--set",
                            "output.statistics_from=0"], check=True, capture_output=True)
            for options in ([], ["--born"]):
                said = subprocess.run([BRASH, "pieces", path / "run", "--json", *options], check=True,
                                      capture_output=True, text=True)
                sizes = json.loads(said.stdout)
                self.assertEqual(sizes["n"], 2)
                self.assertAlmostEqual(sizes["area"], 1200 + 36, delta=1e-6)


def feature(geometry, crs=None, **properties):
    """The text of a GeoJSON file with one feature."""
    head = {"crs": {"type": "name", "properties": {"name": crs}}} if crs else {}
    return json.dumps({"type": "Feature", "properties": properties, "geometry": geometry, **head})


RING = {"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 10], [0, 10], [0, 0]]]}
CROSSED = {"type": "Polygon", "coordinates": [[[0, 0], [10, 10], [10, 0], [0, 9], [0, 0]]]}
LINE = {"type": "LineString", "coordinates": [[-1, 5], [11, 5]]}


class Maps(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.write("sheet.wkt", SQUARE)

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def brash(self, *words):
        return subprocess.run([BRASH, *words], cwd=self.folder, capture_output=True, text=True)

    def refused(self, message, *words):
        said = self.brash(*words)
        self.assertEqual(said.returncode, 2)
        self.assertIn(message, said.stderr)
        self.assertIn("remedy:", said.stderr)

    def notes(self, lines):
        self.write("lines", lines)
        return self.brash("crack", "--sheet", "sheet.wkt", "--along", "lines").stderr.replace("note: lines: ", "")

    def test_a_second_crack_splits_the_parts_of_the_first(self):
        lines = ["LINESTRING (-1 4.1, 11 6.3)", "LINESTRING (3.3 -1, 5.7 11)", "LINESTRING (-1 -2, 11 12.7)",
                 "LINESTRING (-1 9.1, 4.7 5.3)"]
        for ending in ("wkt", "geojson"):
            last, n_floes = "sheet.wkt", []
            for i, line in enumerate(lines):
                self.write("line.wkt", line)
                said = self.brash("crack", "--sheet", last, "--along", "line.wkt", "-o", f"{i}.{ending}")
                ledger, last = json.loads(said.stdout), f"{i}.{ending}"
                self.assertEqual((ledger["missing"], ledger["closes"]), ("0", True))
                n_floes.append(ledger["n_floes"])
            self.assertEqual(n_floes, [2, 4, 7, 8], ending)  # the last line ends in the ice

    def test_lines_that_split_nothing_are_told(self):
        tail = "left a tail that ends inside the ice and splits nothing, the first is line"
        for lines, note in (
                ("LINESTRING EMPTY", "holds no line\n"),
                ("LINESTRING (-1 5, 11 5) LINESTRING (20 5, 30 5, 30 6)",
                 "1 of 2 lines met no ice, the first is line 2\n"),
                ("LINESTRING (0 0, 10 0)", "1 of 1 lines met no ice, the first is line 1\n"),  # along an edge
                ("LINESTRING (-1 5, 11 5) LINESTRING (2 2, 3 3, 4 3)", f"1 of 2 lines {tail} 2\n"),
                ("LINESTRING (-1 5, 5 5, 5 7)", f"1 of 1 lines {tail} 1\n"),
                ("LINESTRING (-1 5, 11 5) LINESTRING (5 5, 5 11)", ""),
                ("LINESTRING (0 2.3, 10 7.1)", "")):
            self.assertEqual(self.notes(lines), note, lines)

    def test_files_in_other_coordinates_are_refused(self):
        self.write("sheet.geojson", feature(RING, "urn:ogc:def:crs:EPSG::32633"))
        for option, geometry in (("--along", LINE), ("--cutters", RING)):
            self.write("other.geojson", feature(geometry, "EPSG:32635"))
            self.refused("other.geojson: has the crs EPSG:32635, and sheet.geojson has urn:ogc:def:crs:EPSG::32633",
                         "crack", "--sheet", "sheet.geojson", option, "other.geojson")
            for crs in ("EPSG:32633", None):
                self.write("same.geojson", feature(geometry, crs))
                said = self.brash("crack", "--sheet", "sheet.geojson", option, "same.geojson")
                self.assertEqual((said.returncode, said.stderr), (0, ""))

    def test_a_map_of_floes_has_no_edge_to_fit(self):
        self.write("floe.geojson", feature(RING, kind="floe"))
        self.refused("floe.geojson: holds floes only, and no sheet", "fit", "--sheet", "floe.geojson", "--at", "0,5",
                     "--towards", "1,0")
        said = self.brash("crack", "--sheet", "floe.geojson", "--cutters", "sheet.wkt")
        self.assertIn("note: floe.geojson: holds floes only, and --cutters cuts the sheet", said.stderr)

    def test_a_place_may_have_blanks(self):
        self.assertEqual(self.brash("fit", "--sheet", "sheet.wkt", "--at", "0, 5", "--towards", " 1 , 0 ").returncode, 0)

    def test_polygons_that_cross_themselves_are_refused(self):
        self.write("bow.wkt", SQUARE + "\n" + BOW)
        self.refused("bow.wkt: polygon 1 crosses itself at (4.7", "pieces", "bow.wkt")
        self.write("bow.geojson", feature(CROSSED, kind="floe"))
        self.write("line.geojson", feature(LINE))
        self.refused("bow.geojson: polygon 0 crosses itself at (4.7", "crack", "--sheet", "bow.geojson",
                     "--along", "line.geojson")


if __name__ == "__main__":
    unittest.main()
