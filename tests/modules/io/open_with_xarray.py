# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens the sample run with xarray and checks what docs/reference/outputs.md promises of run.nc."""
import pathlib
import sys

import numpy as np
import xarray as xr

run = xr.open_dataset(sys.argv[1])
assert run.attrs["Conventions"] == "CF-1.9"
assert "[ice]" in run.attrs["case"]
assert "x against the structure's heading" in run.attrs["comment"]

# The load history is indexed by time, in seconds as plain numbers.
assert run["time"].dtype == np.float64 and run["time"].attrs["units"] == "s"
assert np.allclose(run["Fz"].sel(time=0.03, method="nearest"), 3e5)
for cause in ("", "crushing_", "floe_normal_", "floe_friction_"):
    for component, unit in zip(("Fx", "Fy", "Fz", "Mx", "My", "Mz"), ("N",) * 3 + ("N m",) * 3):
        variable = run[cause + component]
        assert variable.dims == ("time",) and variable.attrs["units"] == unit, variable
for name in ("area_sheet", "area_floes", "area_crushed", "area_deleted", "area_brash", "area_snap"):
    assert run[name].attrs["units"] == "m2"
assert run["n_floes"].dtype == np.int32

# Outlines are CF polygons: ring by ring, holes marked.
outline = run["floe_outline"].attrs
assert outline["geometry_type"] == "polygon"
assert run[outline["node_count"]].values.tolist() == [7, 3, 4]
assert run[outline["part_node_count"]].values.tolist() == [4, 3, 3, 4]
assert run[outline["interior_ring"]].values.tolist() == [0, 1, 0, 0]
x, y = (run[name].values for name in outline["node_coordinates"].split())
assert x[:4].tolist() == [-1, 1, 1, -1] and y[:4].tolist() == [-1, -1, 1, 1]

# Poses lie frame after frame; death and its cause are flags. A sample dimension needs a feature type (CF 9.4).
assert "featureType" in run.attrs or not any("sample_dimension" in run[name].attrs for name in run.variables)
assert run["frame_pose_count"].values.tolist() == [0, 2, 1]
assert run["pose_floe"].values.tolist() == [0, 7, 0]
assert run["pose_x"].values.tolist() == [1, 4, 1.5]
end = run["floe_end"]
meanings = end.attrs["flag_meanings"].split()
assert [meanings[list(end.attrs["flag_values"]).index(v)] for v in end.values] == ["alive", "crushed", "broken"]

assert run["event_theta"].attrs["units"] == "rad"
assert run["event_in_range"].values.tolist() == [1, 0]
assert run["final_sheet_part_node_count"].values.tolist() == [4, 3]

# Every variable has a unit and a meaning.
for name, variable in run.variables.items():
    assert variable.attrs["long_name"], name
    if name not in ("floe_outline", "cracked_sheet_outline"):
        assert variable.attrs["units"], name

# The page names every variable; families of a vector's components are named by their first and last, and variables of a crack
# event by the columns of events.csv.
page = (pathlib.Path(__file__).parents[3] / "docs/reference/outputs.md").read_text(encoding="utf-8")
families = ("crushing_", "floe_birth_", "floe_normal_", "floe_friction_", "frame_structure_")
for name in run.variables:
    column = name.removeprefix("event_")
    assert f"`{name}`" in page or f"`{column}`" in page or name.startswith(families), name

# The example of the page.
first = np.concatenate([[0], np.cumsum(run.frame_pose_count)])
poses = run.isel(pose=slice(first[2], first[3]))
start = np.concatenate([[0], np.cumsum(run.floe_outline_node_count)])
floe = int(np.flatnonzero(run.floe_id == poses.pose_floe[0])[0])
outline = np.stack([run.floe_outline_x, run.floe_outline_y], axis=1)[start[floe]:start[floe + 1]]
assert outline.shape == (7, 2) and outline[2].tolist() == [1, 1]
