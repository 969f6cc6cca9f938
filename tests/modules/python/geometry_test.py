# SPDX-License-Identifier: GPL-3.0-or-later
"""Polygons go in and out as arrays, WKT, GeoJSON and shapely geometries; cuts are exact."""
import copy
import json
import pathlib
import pickle
import tempfile
import threading
import time
import unittest

import numpy as np

import brash
from brash import geometry

try:
    import shapely.geometry
except ImportError:
    shapely = None

FIELD = [[0, -25], [50, -25], [50, 25], [0, 25]]

COMPLEX_WARNING = getattr(np, "exceptions", np).ComplexWarning  # NumPy 2 has it in a module


class Polygons(unittest.TestCase):
    def test_every_way_in_gives_the_same_polygon(self):
        ring = np.array([[0, 0], [2, 0], [2, 1], [0, 1]])
        wanted = brash.Polygon(ring)
        geometry = {"type": "Polygon", "coordinates": [[*ring.tolist(), ring[0].tolist()]]}
        for value in (ring, ring.tolist(), ring[::-1].astype(np.float32), wanted, wanted.to_wkt(),
                      "POLYGON ((0 0, 2 0, 2 1, 0 1, 0 0))", geometry, json.dumps(geometry)):
            polygon = brash.Polygon.read(value)
            self.assertEqual(polygon.area, 2)
            self.assertEqual({tuple(v) for v in polygon.outline}, {tuple(v) for v in ring})
        self.assertEqual(wanted.centroid.tolist(), [1, 0.5])

    def test_holes_go_round(self):
        polygon = brash.Polygon([[0, 0], [4, 0], [4, 4], [0, 4]], [[[1, 1], [2, 1], [2, 2], [1, 2]]])
        self.assertEqual(polygon.exact_area, 15)
        self.assertEqual(brash.Polygon.read(polygon.to_wkt()), polygon)
        self.assertEqual(brash.Polygon(polygon.outline, polygon.holes), polygon)
        self.assertEqual(brash.Polygon.read(polygon.__geo_interface__).exact_area, 15)
        self.assertEqual(sum(brash.Polygon(part).exact_area for part in polygon.convex_parts()), 15)

    @unittest.skipIf(shapely is None, "python3-shapely is not installed")
    def test_shapely_reads_and_writes_them(self):
        square = shapely.geometry.box(0, 0, 3, 2)
        self.assertEqual(brash.Polygon.read(square).area, 6)
        two = shapely.geometry.MultiPolygon([square, shapely.geometry.box(10, 0, 11, 1)])
        self.assertEqual(brash.IceSheet(two).area, 7)
        self.assertEqual(shapely.geometry.shape(brash.Polygon.read(square)).area, 6)

    def test_polygons_and_sheets_are_copied_and_pickled(self):
        polygon = brash.Polygon([[0, 0], [4, 0], [4, 4.1], [0, 4]], [[[1, 1], [2, 1], [2, 2.3], [1, 2]]])
        sheet = brash.IceSheet([polygon, [[9, 0], [10, 0], [10, 1]]])
        sheet.cut_circumferential([0, 1], radius=0.7, wedges=3)
        for again in (copy.deepcopy, lambda value: pickle.loads(pickle.dumps(value))):
            self.assertEqual(again(polygon), polygon)
            self.assertEqual(again(sheet).polygons(), sheet.polygons())
        other = copy.copy(sheet)
        other.cut([[3, 3], [5, 3], [5, 5], [3, 5]])
        self.assertLess(other.exact_area, sheet.exact_area)
        sheet.cut([[-1, -1], [11, -1], [11, 6], [-1, 6]])
        self.assertEqual(copy.copy(sheet).polygons(), [])

    def test_masked_complex_text_and_date_vertices_are_refused(self):
        masked = np.ma.masked_equal([[0.0, 0], [10, 0], [99, 99], [10, 10], [0, 10]], 99)
        square = np.array([[0, 0], [10, 0], [10, 10], [0, 10]])
        sheet = brash.IceSheet(FIELD)
        for ring in (masked, square + 0j, square.astype(str), square.astype("datetime64[s]"), square.astype("timedelta64[s]")):
            for call in (brash.IceSheet, brash.Polygon.read, sheet.cut, sheet.within, sheet.contacts, lambda r: brash.pieces([r])):
                with np.testing.suppress_warnings() as quiet:
                    quiet.filter(COMPLEX_WARNING)
                    self.assertRaises(brash.InputError, call, ring)

    def test_what_is_no_polygon_is_refused(self):
        bad = ([[0, 0], [1, 1]], [[0, 0], [1, 1], [2, 2]], [[0, 0], [2, 2], [2, 0], [0, 2]], [[0, 0, 0]] * 3,
               [[0, np.nan], [1, 0], [1, 1]], [[0, np.inf], [1, 0], [1, 1]], [[0, 1e9], [1, 0], [1, 1]], [], 3, None,
               "POLYGON", "POINT (1 1)", "{", "", "MULTIPOLYGON EMPTY", {"type": "Point", "coordinates": [1, 2]},
               [[0, 0], [1]], [[[0, 0], [1, 0], [1, 1]], "x"], object(), [["a", "b"]] * 3, np.zeros((3, 2, 2)), [None],
               np.zeros((0, 2)), [[1j, 0], [1, 0], [1, 1]])
        for value in bad:
            with self.subTest(repr(value)[:40]), np.testing.suppress_warnings() as quiet:
                quiet.filter(COMPLEX_WARNING)
                with self.assertRaises(brash.InputError):
                    brash.Polygon.read(value)

    def test_a_refusal_names_argument_and_place(self):
        with self.assertRaisesRegex(brash.InputError, r"outline\[1\] = \(nan, 0\)"):
            brash.Polygon([[0, 0], [np.nan, 0], [1, 1]])
        with self.assertRaisesRegex(brash.InputError, r"outline: has shape \(2, 3\), must have shape \(n, 2\)"):
            brash.Polygon(np.zeros((2, 3)))


FAR_MAP = """{"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"EPSG:32633"}},
"origin":[500000,9000000],"features":[
{"type":"Feature","properties":{"kind":"sheet","id":0},"geometry":{"type":"Polygon","coordinates":
[[[500000,9000000],[500004.0000000019,9000000],[500004,9000003],[500000,9000000]]]}},
{"type":"Feature","properties":{"kind":"floe","id":5},"geometry":{"type":"Polygon","coordinates":
[[[500010,9000000],[500011,9000000],[500011,9000001],[500010,9000000]]]}}]}"""


class Maps(unittest.TestCase):
    def test_a_union_accounts_for_every_area(self):
        union = geometry.unite([[[0, 0], [4, 0], [4, 2], [0, 2]], "POLYGON ((1 -1, 2 -1, 2 5, 1 5, 1 -1))"])
        self.assertEqual((union.given, union.united, union.overlap, union.snap, union.n_rounded), (14, 12, 2, 0, 4))
        self.assertEqual([polygon.exact_area for polygon in union.polygons], [12])
        with self.assertRaisesRegex(brash.InputError, "polygon 0: crosses itself"):
            geometry.unite("POLYGON ((0 0, 3 2, 3 0, 0 1, 0 0))")

    def test_a_repair_gives_each_place_to_the_first_polygon(self):
        bow, box = "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", [[1.5, -1], [4, -1], [4, 3], [1.5, 3]]
        found = geometry.repair([bow, box, box])
        self.assertEqual((found.given, found.kept, found.overlap, found.folded, found.snap), (20, 11.25, 10.75, -2, 0))
        self.assertEqual((found.sources, found.changed, found.gone), ([0, 0, 1], [0, 1, 2], [2]))
        self.assertEqual(found.faults[0], "polygon 0 crosses itself at (1, 1)")
        self.assertEqual(sum(polygon.exact_area for polygon in found.polygons), found.kept)
        self.assertEqual(geometry.repair(found.polygons).changed, [])

    def test_the_kernel_has_a_module_of_its_own(self):
        for name in geometry.__all__:
            self.assertIs(getattr(geometry, name), getattr(brash, name))

    def test_a_hole_in_another_polygon_is_refused(self):
        text = ("MULTIPOLYGON (((0 0,10 0,10 10,0 10,0 0)),((20 0,30 0,30 10,20 10,20 0),(2 2,4 2,4 4,2 4,2 2)))")
        for read in (brash.IceSheet, brash.read_map):
            with self.assertRaisesRegex(brash.InputError, r"polygon 1: there is no ice for a hole"):
                read(text)

    def test_what_a_text_has_and_the_plan_has_not_is_warned_of(self):
        text = "POLYGON Z ((0 0 1, 1 0 1, 1 1 1, 0 0 1))"
        for read in (brash.Polygon.read, brash.IceSheet, brash.read_map):
            with self.assertWarnsRegex(UserWarning, r"left out: heights \(4\)"):
                read(text)

    def test_a_projected_map_is_read_from_its_origin_and_written_as_it_was(self):
        ice = brash.read_map(FAR_MAP)
        self.assertEqual((ice.origin, ice.kinds, ice.ids), ((500000, 9000000), ["sheet", "floe"], [0, 5]))
        self.assertEqual(ice.crs["properties"]["name"], "EPSG:32633")
        self.assertEqual(ice.sheet[0].outline[1].tolist(), [4 + 2 / 2**30, 0])
        self.assertEqual([p.area for p in ice.floes], [0.5])
        self.assertEqual(brash.read_map(ice.to_geojson()).to_geojson(), ice.to_geojson())
        self.assertEqual(ice.polygons, ice.sheet + ice.floes)
        self.assertFalse(ice.looks_like_degrees)
        broken = ice.with_polygons(sheet=[], floes=ice.polygons)
        self.assertEqual((broken.kinds, broken.ids, broken.origin), (["floe", "floe"], [0, 1], ice.origin))
        self.assertEqual(ice.with_polygons(sheet=ice.sheet, floes=ice.floes).ids, [0, 1])
        other = brash.read_map(FAR_MAP, origin=("499999.5", 9000000))
        self.assertEqual(other.sheet[0].outline[0].tolist(), [0.5, 0])
        for origin in (1, "ab", (1, 2, 3), ("x", 1), (float("nan"), 0)):
            with self.assertRaises(brash.InputError):
                brash.read_map(FAR_MAP, origin=origin)
        crossed = FAR_MAP.replace("[500011,9000000],", "[500012,9000000],[500010,9000001],")
        with self.assertRaisesRegex(brash.InputError, "text: polygon 1 crosses itself"):
            brash.read_map(crossed)

    def test_a_sheet_leaves_the_floes_of_its_map_out(self):
        near = FAR_MAP.replace("5000", "1").replace("900000", "")
        self.assertEqual(brash.IceSheet(near).area, 6.0 + 3 / 2**30)
        with self.assertRaisesRegex(brash.InputError, r"is beyond .*read_map\(\) reads projected maps"):
            brash.IceSheet(FAR_MAP)

    def test_sizes_of_polygons_and_files(self):
        squares = [[[x, 0], [x + a, 0], [x + a, a], [x, a]] for a, x in zip(range(1, 61), range(-6000, 6000, 200))]
        sizes = brash.pieces(squares, picture=True)
        self.assertEqual((sizes["n"], sizes["area"]), (60, 73810))
        self.assertTrue(sizes["picture"].startswith("<svg"))
        self.assertEqual([fit["law"] for fit in sizes["fits"]], ["log-normal", "Weibull", "power law of the tail"])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "map.geojson"
            path.write_text(FAR_MAP)
            self.assertEqual(brash.pieces(path)["n"], 1)
        for bad in ([], 7, "/none/of/this.wkt"):
            with self.assertRaises(brash.InputError):
                brash.pieces(bad)


class Sheets(unittest.TestCase):
    def setUp(self):
        self.sheet = brash.IceSheet(FIELD)

    def test_sheet_and_pieces_tile_the_old_sheet_exactly(self):
        before = self.sheet.exact_area
        cut = self.sheet.cut_circumferential([0, 0.3], radius=3, wedges=4)
        self.assertEqual(len(cut.pieces), 4)
        self.assertEqual(before, self.sheet.exact_area + sum(p.exact_area for p in cut.pieces) + cut.snap)
        self.sheet.check()

    def test_angles_place_the_radial_cracks(self):
        cut = self.sheet.cut_circumferential([0, 0], radius=2, angles=[-0.5, 0.0, 0.5])
        self.assertEqual(len(cut.pieces), 4)

    def test_a_region_is_cut_along_cracks(self):
        cut = self.sheet.cut("POLYGON ((10 0, 12 0, 12 2, 10 2, 10 0))", cracks=[[[11, -1], [11, 3]]])
        self.assertEqual([p.area for p in cut.pieces], [2, 2])
        self.assertEqual(self.sheet.contains([[11, 1], [13, 1]]).tolist(), [False, True])
        self.assertIs(self.sheet.contains([1, 1]), True)
        self.assertEqual(len(self.sheet.polygons()[0].holes), 1)

    def test_cracks_come_as_a_map_or_a_geometry_library_has_them(self):
        class Geometry:  # as shapely's, geopandas' and brash's own
            def __init__(self, kind, coordinates):
                self.__geo_interface__ = {"type": kind, "coordinates": coordinates}

        region = "POLYGON ((10 0, 12 0, 12 2, 10 2, 10 0))"
        straight, bent = [[11, -1], [11, 3]], [[9, 1], [11, 1], [13, 1.5]]
        wkt = "LINESTRING (11 -1, 11 3)", "LINESTRING (9 1, 11 1, 13 1.5)"
        both = "MULTILINESTRING ((11 -1, 11 3), (9 1, 11 1, 13 1.5))"
        first = brash.IceSheet(self.sheet.polygons()).cut(region, [straight[:], *([p, q] for p, q in zip(bent, bent[1:]))])
        self.assertEqual(len(first.pieces), 4)
        for cracks in (list(wkt), both, [straight, bent], [np.array(straight), np.array(bent)],
                       [Geometry("LineString", straight), Geometry("LineString", bent)],
                       (Geometry("LineString", line) for line in (straight, bent)),
                       Geometry("MultiLineString", [straight, bent]), [wkt[0], Geometry("LineString", bent)],
                       {"type": "MultiLineString", "coordinates": [straight, bent]}):
            with self.subTest(cracks=cracks):
                cut = brash.IceSheet(self.sheet.polygons()).cut(region, cracks)
                self.assertEqual(sorted(p.area for p in cut.pieces), sorted(p.area for p in first.pieces))
        for cracks in ("POLYGON ((0 0, 1 0, 1 1, 0 0))", "POINT (1 1)", "not a line", [straight, 7], [straight, [[1, 2, 3]]],
                       Geometry("Polygon", [bent]), 7, [[1, 1]], [["2024-01-01", "x"]]):
            with self.subTest(cracks=cracks), self.assertRaises(brash.InputError) as caught:
                brash.IceSheet(self.sheet.polygons()).cut(region, cracks)
            self.assertIn("cracks", str(caught.exception))
        # Lines of one length, which NumPy takes for one array.
        bends = [bent, [[9, 1.9], [11, 1.9], [13, 1.8]]]
        for cracks in (bends, np.array(bends), [Geometry("LineString", line) for line in bends]):
            self.assertEqual(len(brash.IceSheet(self.sheet.polygons()).cut(region, cracks).pieces), 3)
        # A line that misses the edge by rounding parts the ice, as with `brash crack --along`.
        self.assertEqual(len(brash.IceSheet(self.sheet.polygons()).cut(region, ["LINESTRING (11 0.00000001, 11 3)"]).pieces), 2)
        at = Geometry("Point", [0, 0.3])
        self.assertEqual(len(self.sheet.cut_circumferential(at, radius=3, wedges=4).pieces), 4)

    def test_a_severed_part_is_released(self):
        self.sheet.cut([[20, -30], [21, -30], [21, 30], [20, 30]])
        released = self.sheet.release_detached()
        self.assertEqual([p.area for p in released], [1000])
        self.assertEqual(self.sheet.area, 1450)

    def test_contacts_and_free_edge(self):
        [contact] = self.sheet.contacts([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        self.assertEqual(contact.contact_length, 2)
        self.assertEqual(contact.normal.tolist(), [1, 0])
        self.assertEqual(contact.midpoint.tolist(), [0, 0])
        self.assertEqual(contact.overlap.area, 2)
        [chain] = self.sheet.free_edge([0, 0], 2)
        np.testing.assert_allclose(np.abs(chain[[0, -1], 1]), 2)
        self.assertEqual([p.area for p in self.sheet.within([[-1, -1], [1, -1], [1, 1], [-1, 1]])], [2])

    def test_the_trapezoid_of_a_trapezoid_is_itself(self):
        b, c, theta = 1.0, 0.8, np.radians(60)
        half = c / 2 + b * np.tan(theta / 2)
        edge = [[b, 25], [b, half], [0, c / 2], [0, -c / 2], [b, -half], [b, -25]]
        sheet = brash.IceSheet([*edge, [50, -25], [50, 25]])
        for ice in (sheet, [edge]):
            fit = brash.fit_trapezoid(ice, at=[0, 0], towards=[2, 0], reach=3)
            np.testing.assert_allclose([fit.depth, fit.contact_length, fit.angle], [b, c, theta], atol=2e-3)
            self.assertLess(fit.error, 1e-3)

    def test_bad_arguments_are_refused_and_leave_the_sheet_alone(self):
        sheet, area = self.sheet, self.sheet.exact_area
        calls = [lambda: sheet.cut_circumferential([0, 0], 0), lambda: sheet.cut_circumferential([0, 0], np.nan),
                 lambda: sheet.cut_circumferential([0, 0], 1e5), lambda: sheet.cut_circumferential([0], 1),
                 lambda: sheet.cut_circumferential([0, 0], 1, wedges=0),
                 lambda: sheet.cut_circumferential([0, 0], 1, sides=2),
                 lambda: sheet.cut_circumferential([0, 0], 1, wedges=10**6),
                 lambda: sheet.cut_circumferential([0, 0], 1, angles=[np.nan]),
                 lambda: sheet.cut_circumferential([0, 0], 1, angles=[[0.0]]),
                 lambda: sheet.cut_circumferential([0, 0], 1, angles=[-60, 0, 60]),  # degrees
                 lambda: brash.fit_trapezoid(sheet, [0, 0], [-1, 0], 3),  # out of the ice
                 lambda: sheet.cut([[0, 0], [1, 1], [1, 0], [0, 1]]), lambda: sheet.cut(FIELD, cracks=[[0, 0]]),
                 lambda: sheet.cut(FIELD, cracks=[[[0, 0], [np.inf, 0]]]),
                 lambda: sheet.contacts([[0, 0], [4, 4], [4, 0], [0, 4]]), lambda: sheet.contains([[1, 2, 3]]),
                 lambda: sheet.free_edge([0, 0], -1), lambda: sheet.within([[0, 0], [1, 1]]),
                 lambda: brash.fit_trapezoid(sheet, [0, 0], [0, 0], 3),
                 lambda: brash.fit_trapezoid(sheet, [0, 0], [1, 0], 0),
                 lambda: brash.fit_trapezoid(sheet, [0, 0], [1, 0], np.inf),
                 lambda: brash.fit_trapezoid(sheet, [0, 0], [1, 0], 3, -1),
                 lambda: brash.fit_trapezoid("sheet", [0, 0], [1, 0], 3),
                 lambda: brash.fit_trapezoid(None, [0, 0], [1, 0], 3),
                 lambda: brash.IceSheet([FIELD, FIELD])]
        for number, call in enumerate(calls):
            with self.subTest(number), self.assertRaises(brash.InputError):
                call()
        self.assertEqual(sheet.exact_area, area)

    def test_a_sheet_that_another_thread_reads_is_not_changed(self):
        sheet = brash.IceSheet([[0, 0], [90, 0], [90, 90], [0, 90]])
        points = np.random.default_rng(1).uniform(0, 90, (400_000, 2))
        inside, refused = [], 0
        reader = threading.Thread(target=lambda: inside.append(sheet.contains(points)))
        reader.start()
        while reader.is_alive():
            try:
                sheet.release_detached()  # of a whole sheet it takes nothing
            except RuntimeError as error:
                self.assertIn("in use by another thread", str(error))
                refused += 1
                time.sleep(1e-4)
        reader.join()
        self.assertGreater(refused, 0)
        self.assertTrue(inside[0].all())  # of the whole sheet
        sheet.cut_circumferential([20, 20], 3)
        sheet.check()


if __name__ == "__main__":
    unittest.main()
