# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash export vtk`: the files are read without VTK, and with its own reader where python3-vtk9 is installed."""
import collections
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree as ET

import numpy as np
import xarray as xr

try:
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy
except ImportError:
    vtk = None

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
TYPES = {"Float64": np.float64, "Int64": np.int64}


def read_vtp(path):
    """Arrays by name, from the offsets that the XML states."""
    head, raw = path.read_bytes().split(b'<AppendedData encoding="raw">\n_', 1)
    arrays = {}
    for attributes in re.findall(rb"<DataArray ([^>]*)/>", head):
        a = dict(re.findall(r'(\w+)="([^"]*)"', attributes.decode()))
        at = int(a["offset"])
        n_bytes = int(np.frombuffer(raw, np.uint64, 1, at)[0])
        values = np.frombuffer(raw, TYPES[a["type"]], n_bytes // 8, at + 8)
        arrays[a["Name"]] = values.reshape(-1, 3) if a["NumberOfComponents"] == "3" else values
    return arrays


def faces_of(arrays):
    return np.split(arrays["connectivity"], arrays["offsets"][:-1]) if len(arrays["offsets"]) else []


def volume(arrays):
    """By the divergence theorem; positive when faces look outwards."""
    total = 0.0
    for face in faces_of(arrays):
        p = arrays["Points"][face]
        total += sum(np.dot(p[0], np.cross(p[i], p[i + 1])) for i in range(1, len(p) - 1)) / 6
    return total


class Export(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "--set", "time.duration=3", "--set",
                        "output.frames_per_second=4", "-o", cls.path], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([BRASH, "export", "vtk", cls.path / "run.nc"], check=True, stdout=subprocess.DEVNULL)
        cls.run_ = xr.open_dataset(cls.path / "run.nc")
        cls.steps = collections.defaultdict(list)
        for step in ET.parse(cls.path / "vtk/run.pvd").getroot().iter("DataSet"):
            cls.steps[int(step.get("part"))].append((float(step.get("timestep")), cls.path / "vtk" / step.get("file")))

    @classmethod
    def tearDownClass(cls):
        cls.run_.close()
        cls.folder.cleanup()

    def test_each_frame_has_floes_sheet_and_structure_at_its_time(self):
        for part in (0, 1, 2):
            np.testing.assert_array_equal([time for time, _ in self.steps[part]], self.run_.frame_time)

    def test_floes_are_closed_prisms_where_they_float_with_the_ice_s_volume(self):
        first = np.concatenate([[0], np.cumsum(self.run_.frame_pose_count)])
        area = dict(zip(self.run_.floe_id.values, self.run_.floe_area.values))
        birth = dict(zip(self.run_.floe_id.values, self.run_.floe_birth.values))
        parent = dict(zip(self.run_.floe_id.values, self.run_.floe_parent.values))
        for frame, (time, path) in enumerate(self.steps[0]):
            arrays = read_vtp(path)
            ids = self.run_.pose_floe.values[first[frame]:first[frame + 1]]
            self.assertEqual(set(arrays["id"]), set(ids))
            force = dict(zip(ids, self.run_.pose_contact_force.values[first[frame]:first[frame + 1]]))
            np.testing.assert_array_equal(arrays["contact_force"], [force[i] for i in arrays["id"]])
            np.testing.assert_array_equal(arrays["parent"], [parent[i] for i in arrays["id"]])
            np.testing.assert_array_equal(arrays["thickness"], np.full(len(arrays["id"]), 0.33))
            np.testing.assert_allclose(arrays["age"], [time - birth[i] for i in arrays["id"]], atol=1e-12)
            edges = collections.Counter()
            for face in faces_of(arrays):
                edges.update(zip(face, np.roll(face, -1)))
            self.assertTrue(all(edges[b, a] == n for (a, b), n in edges.items()), "an open edge")
            # 2^-30 m of the grid on the sides of a floe of some metres.
            self.assertAlmostEqual(volume(arrays), 0.33 * sum(area[i] for i in ids), delta=1e-6)

    def test_the_replayed_sheet_is_the_run_s_to_the_width_of_a_frame(self):
        wanted = self.run_.area_sheet.values
        for time, path in self.steps[1][1:]:
            row = int(np.argmin(np.abs(self.run_.time.values - time)))
            crushed_in_a_frame = 13.6 * 1.202 * 0.25
            self.assertAlmostEqual(volume(read_vtp(path)) / 0.33, wanted[row], delta=crushed_in_a_frame)
        self.assertAlmostEqual(volume(read_vtp(self.steps[1][-1][1])) / 0.33, wanted[-1], delta=1e-6)

    def test_all_sheets_are_replayed_also_where_they_drift_and_overlap_along_a_crack(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            (path / "crack.wkt").write_text("LINESTRING (-1 19, 51 18)\n")
            for border in ("fixed", "free"):
                sets = (f"field.border={border}", f"field.cracks={path / 'crack.wkt'}", "field.initial_crack=false",
                        "field.smallest_plate=1", "time.duration=1", "output.frames_per_second=4",
                        "output.statistics_from=0.1")
                subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "-o", path / border,
                                *(word for one in sets for word in ("--set", one))], check=True, capture_output=True)
                (path / border / "run.nc").rename(path / f"{border}.nc")  # without the copies of its inputs
                subprocess.run([BRASH, "export", "vtk", path / f"{border}.nc", "-o", path / f"{border}_vtk"], check=True,
                               capture_output=True)
                with xr.open_dataset(path / f"{border}.nc") as run:
                    for frame, time in enumerate(run.frame_time.values):
                        row = int(np.argmin(np.abs(run.time.values - time)))
                        shown = volume(read_vtp(path / f"{border}_vtk/sheet_{frame:05d}.vtp")) / 0.33
                        self.assertAlmostEqual(shown, run.area_sheet.values[row], delta=13.6 * 1.202 * 0.25)

    def test_a_field_of_floes_has_no_files_of_a_sheet(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            subprocess.run([BRASH, "run", SOURCE / "experiments/fields/cone.toml", "-o", path, "--set", "time.duration=0.5",
                            "--set", "output.statistics_from=0", "--set", "output.frames_per_second=4"], check=True,
                           capture_output=True)
            subprocess.run([BRASH, "export", "vtk", path], check=True, capture_output=True)
            self.assertEqual(len(list((path / "vtk").glob("floes_*.vtp"))), len(list((path / "vtk").glob("structure_*.vtp"))))
            self.assertEqual(list((path / "vtk").glob("sheet_*.vtp")), [])
            files = {step.get("file") for step in ET.parse(path / "vtk/run.pvd").getroot().iter("DataSet")}
            self.assertEqual(files, {file.name for file in (path / "vtk").glob("*.vtp")})

    def test_each_floe_has_its_own_thickness(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "-o", path, "--set", "time.duration=2",
                            "--set", "ice.variation.thickness=0.3", "--set", "output.frames_per_second=1"], check=True,
                           capture_output=True)
            subprocess.run([BRASH, "export", "vtk", path / "run.nc"], check=True, capture_output=True)
            last = read_vtp(max((path / "vtk").glob("floes_*.vtp")))
            with xr.open_dataset(path / "run.nc") as run:
                ice = dict(zip(run.floe_id.values, run.floe_area.values * run.floe_thickness.values))
                self.assertGreater(np.ptp(run.floe_thickness.values), 0.01)
            floes = set(last["id"])
            self.assertGreater(len(floes), 2)
            self.assertAlmostEqual(volume(last), sum(ice[floe] for floe in floes), delta=1e-6)

    def test_the_structure_is_a_closed_frustum_that_moves(self):
        first, last = (read_vtp(self.steps[2][i][1]) for i in (0, -1))
        np.testing.assert_allclose((last["Points"] - first["Points"])[:, 0], 1.202 * 3, atol=1e-9)
        self.assertGreater(volume(first), 0)
        self.assertAlmostEqual(np.ptp(first["Points"][:, 2]), 9.08, places=9)

    def test_a_run_is_exported_and_reported_when_the_model_that_it_used_is_gone(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            model = path / "mine.json"
            shutil.copy(SOURCE / "experiments/failure_database/cone_superposition.json", model)
            subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "-o", path / "run", "--set",
                            "failure.model=superposition", "--set", f"failure.file={model}", "--set", "time.duration=0.3"],
                           check=True, capture_output=True)
            model.unlink()
            (path / "run").rename(path / "moved")
            commands = [["export", "vtk", path / "moved/run.nc"]]
            if (path / "moved/report.html").exists():  # a build without the viewer has no report
                commands.append(["report", path / "moved"])
            for command in commands:
                done = subprocess.run([BRASH, *command], capture_output=True, text=True)
                self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_is_no_run_is_refused(self):
        for name in ("history.csv", "none.nc", "vtk"):
            done = subprocess.run([BRASH, "export", "vtk", self.path / name], capture_output=True, text=True)
            self.assertEqual(done.returncode, 2, done.stderr)

    @unittest.skipIf(vtk is None, "python3-vtk9 is not installed")
    def test_vtk_s_reader_sees_closed_surfaces_of_the_same_volume(self):
        for part, files in self.steps.items():
            for _, path in files:
                reader = vtk.vtkXMLPolyDataReader()
                reader.SetFileName(str(path))
                reader.Update()
                data, arrays = reader.GetOutput(), read_vtp(path)
                self.assertEqual(reader.GetErrorCode(), 0)
                self.assertEqual(data.GetNumberOfCells(), len(arrays["offsets"]))
                if not data.GetNumberOfCells():
                    continue
                np.testing.assert_array_equal(vtk_to_numpy(data.GetPoints().GetData()), arrays["Points"])
                triangles, mass = vtk.vtkTriangleFilter(), vtk.vtkMassProperties()
                triangles.SetInputData(data)
                mass.SetInputConnection(triangles.GetOutputPort())
                self.assertAlmostEqual(mass.GetVolume() / volume(arrays), 1, places=6)
                if part != 1:  # holes of the sheet may touch its outline in a point
                    edges = vtk.vtkFeatureEdges()
                    edges.SetInputData(data)
                    edges.FeatureEdgesOff(), edges.ManifoldEdgesOff()
                    edges.Update()
                    self.assertEqual(edges.GetOutput().GetNumberOfCells(), 0)


if __name__ == "__main__":
    unittest.main()
