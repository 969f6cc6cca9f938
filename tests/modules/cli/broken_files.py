# SPDX-License-Identifier: GPL-3.0-or-later
"""Files for the tests of bad input that are too large, or too much alike, to be stored: whole ones, and what breaks them."""
import hashlib
import json
import re
import shutil
import subprocess

import netCDF4
import numpy as np

CASE = """\
[ice]
thickness = 0.33
youngs_modulus = "0.35 GPa"
flexural_strength = "539 kPa"
[structure]
angle = "61.4 deg"
waterline_width = 13.6
height = 9.08
height_under_water = 5.68
speed = 1.2
start_distance = 6.9
[field]
length = 20
width = 30
[failure]
model = "wedge"
[time]
duration = 0.6
[output]
statistics_from = 0.2
"""
DATABASE_PLAN = """\
[design]
geometries = 2
rows_per_geometry = 2
[range]
b_lc = 0.5
c_lc = { from = 0.1, to = 1.0 }
theta_deg = 60.0
mu1 = 0.5
mu2 = 0.0
thickness_over_lc = 0.1
[plate]
poisson_ratio = 0.3
theory = "kirchhoff"
tip_size = 0.2
far_size = 2.0
half_width = 6.0
"""


def make_good(brash, source, folder):
    """Whole files of each kind: what a broken one stands beside, or is made from."""
    def run(*words):
        subprocess.run([brash, *map(str, words)], check=True, stdout=subprocess.DEVNULL, cwd=folder)

    (folder / "case.toml").write_text(CASE)
    (folder / "sheet.wkt").write_text("POLYGON ((0 0, 10 0, 10 10, 0 10, 0 0))\n")
    (folder / "events.csv").write_text("x,y,radius,wedges\n0,5,2,3\n")
    (folder / "rows.csv").write_text("b_lc,c_lc,theta_deg,mu1,mu2\n0.5,0.3,60,0.5,0\n")
    (folder / "history.csv").write_text("time,Fx\n" + "".join(f"{0.1 * i:.1f},{100 + i % 7}\n" for i in range(50)))
    (folder / "plan.toml").write_text("[campaign]\ncase = \"case.toml\"\n")
    (folder / "database.toml").write_text(DATABASE_PLAN)
    for model in ("network", "superposition"):
        shutil.copy(source / f"experiments/failure_database/cone_{model}.json", folder / f"{model}.json")
    run("run", "case.toml", "-o", "run", "--set", "output.checkpoint_interval=0.5")
    run("failure", "database", "database.toml", "-o", "database.nc")
    run("campaign", "plan.toml", "-o", "campaign", "--jobs", "1", "--set", "time.duration=0.3")


def sparse(path):
    """A file of 1 GiB that takes no room."""
    with open(path, "wb") as file:
        file.truncate(1 << 30)


def make_large(folder):
    for kind in ("wkt", "csv", "toml", "json", "nc"):
        sparse(folder / f"gigabyte.{kind}")
    (folder / "gigabyte-of-columns.csv").write_text("," * 3_000_000 + "\n")
    (folder / "brackets.geojson").write_text('{"type":"Polygon","coordinates":' + "[" * 1_000_000)
    (folder / "collections.geojson").write_text(
        '{"type":"GeometryCollection","geometries":[' * 1000 + "]}" * 1000)
    (folder / "brackets.wkt").write_text("POLYGON " + "(" * 1_000_000)
    (folder / "arrays.toml").write_text("a = " + "[" * 100_000 + "]" * 100_000 + "\n")
    (folder / "tables.toml").write_text("a = " + "{ a = " * 20_000 + "1" + " }" * 20_000 + "\n")
    (folder / "dotted.toml").write_text(".".join("a" * 50_000) + " = 1\n")
    (folder / "sections.toml").write_text("[" + ".".join("a" * 50_000) + "]\n")
    (folder / "many-keys.toml").write_text("[ice]\n" + "".join(f"k{i} = {i}\n" for i in range(50_000)))
    deep = "[" * 200_000 + "]" * 200_000
    (folder / "model.json").write_text(
        '{"format":"brash-network","format_version":1,"content_sha256":"","W1":' + deep + "}")
    (folder / "manifest.json").write_text('{"format":' + deep + "}")


def content_hash(model):
    """As the program computes it: of the compact text with sorted keys, without the hash itself."""
    model = {key: value for key, value in model.items() if key != "content_sha256"}
    return hashlib.sha256(json.dumps(model, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def make_models(good, folder):
    """Models that say of themselves that they are whole."""
    def write(name, change):
        model = json.loads((good / "network.json").read_text())
        change(model)
        model["content_sha256"] = content_hash(model)
        (folder / f"{name}.json").write_text(json.dumps(model))

    def put(*place):
        *path, key, value = place

        def change(model):
            for step in path:
                model = model[step]
            model[key] = value
        return change

    whole = json.loads((good / "network.json").read_text())
    assert content_hash(whole) == whole["content_sha256"], "the test does not know how the hash is made"
    write("row-missing", lambda m: m["W1"].pop())
    write("weight-missing", lambda m: m["W1"][3].pop())
    write("weight-null", put("W1", 0, 2, None))
    write("weight-text", put("W2", 0, 0, "1"))
    write("hidden-huge", put("hidden", 10**12))
    write("hidden-negative", put("hidden", -1))
    write("hidden-fraction", put("hidden", 1.5))
    write("factor-zero", put("features", 1, "factor", 0))
    write("feature-unknown", put("features", 0, "value", "log(b)"))
    write("range-reversed", put("inputs", 0, "lower", 1e9))
    write("range-negative", put("inputs", 1, "lower", -1))
    write("unit-degrees", put("inputs", 2, "unit", "deg"))
    write("input-missing", lambda m: m["inputs"].pop())
    write("thickness-negative", put("thickness_over_lc", -0.1))
    write("newer-version", put("format_version", 2))
    make_profiles((good / "superposition.json").read_text().strip(), folder)


def make_profiles(text, folder):
    """The same for the other kind, which is compact: its text without the hash is what is hashed."""
    stated = re.search(r'"content_sha256":"([0-9a-f]{64})",', text)
    content = text.replace(stated[0], "")
    digest = hashlib.sha256(content.encode()).hexdigest()
    assert digest == stated[1], "the test does not know how the hash is made"

    def write(name, pattern, replacement):
        changed_text, n = re.subn(pattern, replacement, content, count=1)
        assert n == 1, name
        new = hashlib.sha256(changed_text.encode()).hexdigest()
        (folder / f"{name}.json").write_text(changed_text[:-1] + f',"content_sha256":"{new}"}}')

    write("older-version", r'"format_version":\d+', '"format_version":1')
    write("stations-missing", r'"n_stations":\d+', '"n_stations":3')
    write("modes-huge", r'"n_modes":\d+', '"n_modes":1000000')
    write("centres-none", r'"n_centres":\d+', '"n_centres":0')
    write("centre-missing", r'"centres":\[\[[^,]+,', '"centres":[[')
    write("profile-weight-null", r'"weights":\[\[[^,]+,', '"weights":[[null,')
    write("factor-negative", r'"factor":\[[^,]+,', '"factor":[-1.0,')
    write("reach-negative", r'"reach":[^,}]+', '"reach":-1.0')
    write("mean-missing", r'"mean":', '"means":')
    (folder / "cut.json").write_text(text[:len(text) // 2])
    digit = text.index("0.1") + 2
    (folder / "digit-changed.json").write_text(text[:digit] + "7" + text[digit + 1:])


def make_histories(folder):
    def history(name, times=(0.0, 0.1, 0.2), units="s", loads=(1.0, 2.0, 3.0), time="time", kind="f8"):
        with netCDF4.Dataset(folder / f"{name}.nc", "w") as file:
            file.createDimension("n", None if name == "huge" else len(times))
            t = file.createVariable(time, kind, ("n",))
            f = file.createVariable("Fx", "f8", ("n",))
            if units:
                t.units = units
            if name == "huge":
                t[(1 << 40)] = 1.0
                return
            t[:] = np.array(times, dtype=kind)
            f[:] = loads

    history("whole")
    whole = (folder / "whole.nc").read_bytes()
    (folder / "whole.nc").unlink()
    (folder / "empty.nc").write_bytes(b"")
    (folder / "text.nc").write_text("time,Fx\n0,1\n1,2\n")
    (folder / "cut.nc").write_bytes(whole[:len(whole) // 2])
    (folder / "damaged.nc").write_bytes(whole[:64] + bytes(512) + whole[576:])
    history("no-time", time="clock", units="")
    history("unit-unknown", units="fortnigths")
    history("unit-of-length", units="m")
    history("one-sample", times=(0.0,), loads=(1.0,))
    history("times-fall", times=(0.0, 0.2, 0.1))
    history("time-missing", times=(0.0, np.nan, 0.2))
    history("nothing-measured", loads=(np.nan,) * 3)
    history("huge")
    with netCDF4.Dataset(folder / "nothing-in-it.nc", "w"):
        pass
    with netCDF4.Dataset(folder / "time-in-a-plane.nc", "w") as file:
        file.createDimension("a", 2)
        file.createDimension("b", 3)
        file.createVariable("time", "f8", ("a", "b"))[:] = np.arange(6).reshape(2, 3)


def changed(path, change):
    """Changes a netCDF file in place."""
    with netCDF4.Dataset(path, "r+") as file:
        change(file)


def without(source, target, leave_out=(), other_lengths=None):
    """Copies a netCDF file without some variables and attributes, or with dimensions of other lengths."""
    with netCDF4.Dataset(source) as old, netCDF4.Dataset(target, "w") as new:
        for name, dimension in old.dimensions.items():
            new.createDimension(name, (other_lengths or {}).get(name, len(dimension) or None))
        new.setncatts({k: old.getncattr(k) for k in old.ncattrs() if k not in leave_out})
        for name, variable in old.variables.items():
            if name in leave_out:
                continue
            copy = new.createVariable(name, variable.dtype, variable.dimensions)
            if not other_lengths and (not variable.shape or min(variable.shape) > 0):
                copy[:] = variable[:]


def make_databases(good, folder):
    whole = good / "database.nc"

    def broken(name, change):
        shutil.copy(whole, folder / f"{name}.nc")
        changed(folder / f"{name}.nc", change)

    def put(name, value, index=0):
        def change(file):
            file[name][index] = value
        return change

    data = whole.read_bytes()
    (folder / "empty.nc").write_bytes(b"")
    (folder / "cut.nc").write_bytes(data[:len(data) // 2])
    broken("plan-changed", lambda f: f.setncattr("plan", "[design]\n"))
    broken("depth-nan", put("depth", np.nan))
    broken("thickness-negative", put("thickness", -0.1))
    broken("stations-huge", put("n_stations", 2**31 - 1))
    broken("stations-negative", put("n_stations", -1))
    broken("stations-none", put("n_stations", 0))
    broken("loads-none", put("n_loads", 0))
    broken("profile-nan", put("bending_xx", np.nan, (0, 3)))
    broken("stations-fall", put("station", 1e9, (0, 3)))
    broken("stress-infinite", put("sigma_over_p", np.inf, (0, 1)))
    without(whole, folder / "plan-missing.nc", ("plan",))
    without(whole, folder / "variable-missing.nc", ("mu1",))
    without(whole, folder / "larger-than-its-dimensions.nc", (), {"geometry": 1000})
    without(whole, folder / "huge.nc", (), {"geometry": 1 << 31})
    shutil.copy(good / "run/run.nc", folder / "a-run.nc")


def make_runs(good, folder):
    def copy(name):
        shutil.copytree(good / "run", folder / name)
        return folder / name

    def broken(name, change):
        # Written anew: the library does not open for writing what was made in memory.
        without(good / "run/run.nc", copy(name) / "run.nc")
        changed(folder / name / "run.nc", change)

    def put(variable, value, index=0):
        def change(file):
            file[variable][index] = value
        return change

    data = (good / "run/run.nc").read_bytes()
    (copy("run-cut") / "run.nc").write_bytes(data[:len(data) // 2])
    (copy("run-empty") / "run.nc").write_bytes(b"")
    (copy("run-of-text") / "run.nc").write_text("time,Fx\n")
    (copy("run-missing") / "run.nc").unlink()
    shutil.copy(good / "database.nc", copy("run-a-database") / "run.nc")
    broken("load-nan", put("Fx", np.nan, 3))
    broken("outline-nan", put("floe_outline_x", np.nan))
    broken("outline-huge", put("floe_outline_x", 1e12))
    broken("outline-crossing", lambda f: f["initial_sheet_x"].__setitem__(slice(0, 2), f["initial_sheet_x"][1::-1]))
    broken("pose-nan", put("pose_x", np.nan))
    broken("attitude-zero", put("pose_qw", 0.0, slice(None)))
    broken("floe-unknown", put("pose_floe", 10**6))
    broken("floe-twice", put("floe_id", 0, slice(None)))
    broken("counts-wrong", put("frame_pose_count", 10**9))
    broken("counts-negative", put("floe_outline_part_node_count", -5))
    broken("end-unknown", put("floe_end", 77))
    broken("case-broken", lambda f: f.setncattr("case", "[ice]\nthickness = -1\n"))
    without(good / "run/run.nc", copy("variable-missing") / "run.nc", ("Fx",))
    without(good / "run/run.nc", copy("run-huge") / "run.nc", (), {"time": 1 << 36})
    for name, text in (("empty", ""), ("cut", '{"statistics_from": 0.'), ("list", "[]"), ("of-text", '{"statistics_from": "0.2"}'),
                       ("deep", "[" * 200_000 + "]" * 200_000)):
        (copy(f"summary-{name}") / "summary.json").write_text(text)
    for name, text in (("empty", ""), ("cut", '{"case": {"toml": "'), ("list", "[]"), ("without-case", "{}"),
                       ("case-broken", '{"format": "brash-manifest-1", "case": {"name": "x", "toml": "[ice"}, '
                        '"program": {"version": "0"}, "inputs": [], "outputs": []}')):
        (copy(f"manifest-{name}") / "manifest.json").write_text(text)
    (copy("manifest-missing") / "manifest.json").unlink()


def make_checkpoints(good, folder):
    """Folders in which a run was interrupted."""
    whole = (good / "run/checkpoint.nc").read_bytes()
    seal = whole.rindex(b"brash-sha256:")

    def checkpoint(name, data):
        (folder / name).mkdir()
        (folder / name / "checkpoint.nc").write_bytes(data)

    def sealed(data):
        return data + b"brash-sha256:" + hashlib.sha256(data).hexdigest().encode()

    checkpoint("whole", whole)
    checkpoint("empty", b"")
    checkpoint("cut", whole[:len(whole) // 2])
    checkpoint("digit-changed", whole[:1000] + bytes([whole[1000] ^ 1]) + whole[1001:])
    checkpoint("seal-changed", whole[:-1] + (b"0" if whole[-1:] != b"0" else b"1"))
    checkpoint("more-behind-the-seal", whole + b"more")
    checkpoint("sealed-text", sealed(b"time,Fx\n"))
    checkpoint("sealed-and-cut", sealed(whole[:seal // 2]))
    checkpoint("sealed-run", sealed((good / "run/run.nc").read_bytes()))
    def restated(name, change):
        """The whole checkpoint with another content, and a good seal."""
        inner = folder / "inner.nc"
        inner.write_bytes(whole[:seal])
        without(inner, folder / "other.nc")
        changed(folder / "other.nc", change)
        checkpoint(name, sealed((folder / "other.nc").read_bytes()))
        inner.unlink()
        (folder / "other.nc").unlink()

    restated("tables-missing", lambda f: f.setncattr("tables", "[]"))
    restated("tables-of-text", lambda f: f.setncattr("tables", '{"floe": "much"}'))
    restated("floe-without-area", lambda f: f["state_floe_outline_x"].__setitem__(slice(None), 7))
    restated("counts-wrong", lambda f: f["state_floe_outline_part_count"].__setitem__(0, 99))
    (folder / "gigabyte").mkdir()
    sparse(folder / "gigabyte/checkpoint.nc")


def make_campaigns(good, folder):
    """Folders of campaigns that go on, and that are reported."""
    def copy(name):
        shutil.copytree(good / "campaign", folder / name)
        return folder / name

    (copy("setting-changed") / "settings/case.toml").write_text(CASE)
    (copy("campaign-summary-cut") / "summary.json").write_text('{"settings": [')
    (copy("campaign-manifest-cut") / "manifest.json").write_text("{")


def make_broken(good, folder):
    for name in ("large", "models", "histories", "databases", "runs", "checkpoints", "campaigns"):
        (folder / name).mkdir()
    make_large(folder / "large")
    make_models(good, folder / "models")
    make_histories(folder / "histories")
    make_databases(good, folder / "databases")
    make_runs(good, folder / "runs")
    make_checkpoints(good, folder / "checkpoints")
    make_campaigns(good, folder / "campaigns")
