# SPDX-License-Identifier: GPL-3.0-or-later
"""A name that netCDF would take for an address or for options is a name, and what is no file is not opened. What lies
outside of a file: netcdf_outside.cpp."""
import os
import shutil
import socket
import threading
import unittest

import netCDF4

from common import Hostile


class Names(Hostile):
    def test_an_address_is_a_name_of_a_file_that_is_not_there(self):
        server = socket.create_server(("127.0.0.1", 0))
        self.addCleanup(server.close)
        calls = []

        def listen():
            try:
                while True:
                    calls.append(server.accept())
            except OSError:
                pass

        threading.Thread(target=listen, daemon=True).start()
        port = server.getsockname()[1]
        for name in (f"http://127.0.0.1:{port}/data.nc", f"https://127.0.0.1:{port}/data.nc", f"dap4://127.0.0.1:{port}/data.nc",
                     f"http://127.0.0.1:{port}/data.nc#mode=bytes", f"s3://127.0.0.1:{port}/bucket/data.nc",
                     f"[mode=dap2]http://127.0.0.1:{port}/data.nc", "file:///tmp/zarr.nc#mode=nczarr,file"):
            for command in (("stats", name), ("failure", "train", name, "-o", "model.json"), ("export", "vtk", name),
                            ("compare", "history.csv", name)):
                with self.subTest(command):
                    self.refused(*command, timeout=30)
        self.assertEqual(calls, [])

    def test_what_looks_like_options_is_part_of_a_name(self):
        self.succeeds("run", "case.toml", "-o", "out")
        for name in ("a#mode=zarr.nc", "[mode=dap4]b.nc", "c%20d.nc"):
            shutil.copy(self.path / "out/run.nc", self.path / name)
            self.succeeds("stats", name, "--column", "Fx")
        self.succeeds("run", "case.toml", "-o", "x#mode=nczarr,file")
        netCDF4.Dataset(self.path / "x#mode=nczarr,file/run.nc").close()

    def test_pipes_devices_and_folders_are_refused_and_not_waited_for(self):
        os.mkfifo(self.path / "pipe.nc")
        (self.path / "folder.nc").mkdir()
        (self.path / "zero.nc").symlink_to("/dev/zero")
        (self.path / "text.nc").write_text("CDF? not really")
        (self.path / "cut.nc").write_bytes(b"\x89HDF\r\n\x1a\n" + bytes(64))
        for name in ("pipe.nc", "folder.nc", "zero.nc", "text.nc", "cut.nc"):
            for command in (("stats", name), ("export", "vtk", name), ("failure", "train", name, "-o", "model.json")):
                with self.subTest(command):
                    self.refused(*command, saying=name, timeout=30)


if __name__ == "__main__":
    unittest.main()
