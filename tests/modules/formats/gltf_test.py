# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash export gltf`: the file keeps the rules of glTF 2.0, and shows what the run holds.

Khronos' validator checks the rules where Node.js is installed.
"""
import json
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest

import netCDF4
import numpy as np

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
NODE, PACKAGES = os.environ.get("NODE"), os.environ.get("BRASH_PACKAGES")
WIDTHS = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}
TYPES = {5126: "<f4", 5125: "<u4"}


class Glb:
    """A binary glTF file: its JSON, and its accessors as arrays."""

    def __init__(self, data):
        magic, version, length = struct.unpack_from("<4sII", data)
        assert (magic, version, length) == (b"glTF", 2, len(data))
        size, kind = struct.unpack_from("<I4s", data, 12)
        assert kind == b"JSON" and size % 4 == 0
        self.json = json.loads(data[20:20 + size])
        n_bytes, kind = struct.unpack_from("<I4s", data, 20 + size)
        assert kind == b"BIN\0" and 28 + size + n_bytes == len(data)
        self.buffer = data[28 + size:]
        self.nodes = {node["name"]: node for node in self.json["nodes"]}

    def values(self, index):
        accessor = self.json["accessors"][index]
        view = self.json["bufferViews"][accessor["bufferView"]]
        width = WIDTHS[accessor["type"]]
        array = np.frombuffer(self.buffer, TYPES[accessor["componentType"]], accessor["count"] * width,
                              view["byteOffset"])
        return array if width == 1 else array.reshape(-1, width)

    def tracks(self, name):
        """Times and values of each property of a node that moves."""
        animation = self.json["animations"][0]
        node = self.json["nodes"].index(self.nodes[name])
        found = {}
        for channel in animation["channels"]:
            if channel["target"]["node"] == node:
                sampler = animation["samplers"][channel["sampler"]]
                found[channel["target"]["path"]] = (self.values(sampler["input"]), self.values(sampler["output"]))
        return found

    def volume(self, name):
        """Of a node's mesh, by the divergence theorem; positive where faces look outwards."""
        (primitive,) = self.json["meshes"][self.nodes[name]["mesh"]]["primitives"]
        points = self.values(primitive["attributes"]["POSITION"]).astype(float)
        a, b, c = points[self.values(primitive["indices"])].reshape(-1, 3, 3).transpose(1, 0, 2)
        return np.sum(a * np.cross(b, c)) / 6


def visible(tracks, time):
    if "scale" not in tracks:
        return True
    times, scales = tracks["scale"]
    return bool(scales[np.searchsorted(times, np.float32(time), side="right") - 1][0])


class Gltf(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)
        subprocess.run([BRASH, "run", SOURCE / "experiments/validation/cone.toml", "--set", "time.duration=4", "-o",
                        cls.folder / "run"], check=True, capture_output=True)
        subprocess.run([BRASH, "export", "gltf", cls.folder / "run/run.nc"], check=True, capture_output=True)
        cls.file = cls.folder / "run/run.glb"
        cls.glb = Glb(cls.file.read_bytes())
        cls.run_ = netCDF4.Dataset(cls.folder / "run/run.nc")

    @classmethod
    def tearDownClass(cls):
        cls.run_.close()
        cls.temporary.cleanup()

    def test_the_validator_finds_neither_errors_nor_warnings(self):
        if not PACKAGES:
            self.skipTest("Node.js or the packages of the page are not installed")
        said = subprocess.run([NODE, pathlib.Path(__file__).with_name("gltf_validate.mjs"), PACKAGES, self.file],
                              capture_output=True, text=True, check=True).stdout
        report = json.loads(said)
        self.assertEqual((report["issues"]["numErrors"], report["issues"]["numWarnings"]), (0, 0), report["issues"])
        self.assertEqual(report["info"]["version"], "2.0")

    def test_every_floe_of_a_frame_is_shown_there_with_its_pose(self):
        run, shown = self.run_, {}
        times = run["frame_time"][:].data
        first = np.concatenate([[0], np.cumsum(run["frame_pose_count"][:].data)])
        for i, time in enumerate(times):
            for row in range(first[i], first[i + 1]):
                shown.setdefault(int(run["pose_floe"][row]), []).append((i, time, row))
        self.assertGreater(len(shown), 5)
        for floe, rows in shown.items():
            tracks = self.glb.tracks(f"floe {floe}")
            at, places = tracks["translation"]
            np.testing.assert_array_equal(at, np.float32([time for _, time, _ in rows]))
            index = [row for _, _, row in rows]
            wanted = np.stack([run[name][:].data[index] for name in ("pose_x", "pose_y", "pose_z")], axis=1)
            np.testing.assert_array_equal(places, np.float32(wanted))
            present = {i for i, _, _ in rows}
            self.assertEqual({i for i, time in enumerate(times) if visible(tracks, time)}, present)

    def test_rotations_have_unit_length_and_turn_the_short_way(self):
        for name in self.glb.nodes:
            if name.startswith("floe "):
                _, rotations = self.glb.tracks(name)["rotation"]
                np.testing.assert_allclose(np.linalg.norm(rotations, axis=1), 1.0, atol=1e-6)  # of single precision
                self.assertTrue(np.all(np.sum(rotations[1:] * rotations[:-1], axis=1) > 0.0))

    def test_one_sheet_is_shown_at_every_frame(self):
        sheets = [self.glb.tracks(name) for name in self.glb.nodes if name.startswith("level ice")]
        self.assertGreater(len(sheets), 1)
        for time in self.run_["frame_time"][:].data:
            self.assertEqual(sum(visible(tracks, time) for tracks in sheets), 1, time)

    def test_volumes_are_those_of_the_ice(self):
        thickness = 0.33
        area = self.run_["floe_area"][:].data
        for floe in (0, 3):
            self.assertAlmostEqual(self.glb.volume(f"floe {floe}"), area[floe] * thickness, delta=1e-4)
        last = [name for name in self.glb.nodes if name.startswith("level ice")][-1]
        # Single precision keeps a coordinate of 50 m to 4e-6 m.
        self.assertAlmostEqual(self.glb.volume(last), float(self.run_["area_sheet"][-1]) * thickness, delta=0.05)
        self.assertGreater(self.glb.volume("structure"), 100.0)

    def test_the_replay_does_not_take_the_place_of_its_run(self):
        said = subprocess.run([BRASH, "export", "gltf", self.folder / "run/run.nc", "-o", self.folder / "run/run.nc"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(said.returncode, 2)
        self.assertIn("Fx", self.run_.variables)

    def test_a_file_that_is_no_run_is_refused(self):
        said = subprocess.run([BRASH, "export", "gltf", SOURCE / "README.md", "-o", self.folder / "no.glb"],
                              capture_output=True, text=True, check=False)
        self.assertEqual(said.returncode, 2)
        self.assertFalse((self.folder / "no.glb").exists())


if __name__ == "__main__":
    unittest.main()
