# SPDX-License-Identifier: GPL-3.0-or-later
"""`--ice` of `brash new` and `brash schema --template`: the ice of sites, with sources."""
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import tomllib
import unittest

BRASH, SOURCE = os.environ["BRASH"], pathlib.Path(os.environ["BRASH_SOURCE_DIR"])
DATA = json.loads((SOURCE / "modules/io/site_ice.json").read_text(encoding="utf-8"))
SITES = {name: site for name, site in DATA["sites"].items() if site["values"]}
UNITS = {"GPa": 1e9, "MPa": 1e6, "kPa": 1e3, "kg/m3": 1, "m": 1}


def number(value):
    """A value of the data in SI."""
    if not isinstance(value, str):
        return value
    size, unit = value.split()
    return float(size) * UNITS[unit]


def sea_water(salinity):
    """Density at the freezing point under one atmosphere, EOS-80 [kg/m3]."""
    s, t = salinity, -0.0575 * salinity + 1.710523e-3 * salinity**1.5 - 2.154996e-4 * salinity**2
    pure = (999.842594 + 6.793952e-2 * t - 9.095290e-3 * t**2 + 1.001685e-4 * t**3 - 1.120083e-6 * t**4
            + 6.536332e-9 * t**5)
    return (pure + s * (0.824493 - 4.0899e-3 * t + 7.6438e-5 * t**2 - 8.2467e-7 * t**3 + 5.3875e-9 * t**4)
            + s**1.5 * (-5.72466e-3 + 1.0227e-4 * t - 1.6546e-6 * t**2) + 4.8314e-4 * s**2)


def brine(site):
    return site["ice_salinity"] * (49.185 / abs(site["ice_temperature"]) + 0.532) / 1000


def brash(*arguments, code=0):
    done = subprocess.run([BRASH, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == code, done.stderr
    return done


class Data(unittest.TestCase):
    def test_derived_values_are_those_of_their_formulas_rounded_to_two_digits(self):
        for name, site in SITES.items():
            v, value = brine(site), lambda key: number(site["values"][key][0])
            derived = {"ice.flexural_strength": 1.76e6 * math.exp(-5.88 * math.sqrt(v)),
                       "ice.youngs_modulus": (5.31 - 0.436 * math.sqrt(1000 * v)) * 1e9,
                       "ice.compressive_strength": 37e6 * 1e-4**0.22 * (1 - math.sqrt((v + 0.02) / 0.27))}
            for key, expected in derived.items():
                with self.subTest(name, key=key):
                    self.assertEqual(f"{value(key):.1e}", f"{expected:.1e}")
            self.assertEqual(value("water.density"), round(sea_water(site["water_salinity"])))
            self.assertIn(f"v_b = {v:.4f}", site["brine"])

    def test_every_value_has_a_source_that_is_listed(self):
        for name, site in SITES.items():
            self.assertEqual(set(site["values"]), set(DATA["keys"]), name)
            for key, (_, remark) in site["values"].items():
                text = f"{DATA['keys'][key]} {site['brine']} {remark}"
                self.assertTrue(any(source in text for source in DATA["sources"]), (name, key))
        texts = json.dumps([DATA["keys"], DATA["sites"]], ensure_ascii=False)
        for source in DATA["sources"]:
            self.assertIn(source, texts)


class Templates(unittest.TestCase):
    def expect_ice_of(self, site, text):
        """Every value of a site, with the first sentences of its source in comments above it."""
        case, plain = tomllib.loads(text), " ".join(text.replace("#", " ").split())
        for key, (value, remark) in site["values"].items():
            section, name = key.split(".")
            self.assertEqual(case[section][name], value)
            for sentences in (DATA["keys"][key], remark):
                self.assertTrue(sentences in plain, sentences)

    def test_the_template_has_the_values_of_the_site_and_their_sources(self):
        for name, site in SITES.items():
            with self.subTest(name):
                self.expect_ice_of(site, brash("schema", "--template", "--ice", name).stdout)

    def test_the_default_stays_the_ice_of_the_basin(self):
        text = brash("schema", "--template").stdout
        self.assertEqual(text, brash("schema", "--template", "--ice", "basin").stdout)
        self.assertIn('youngs_modulus = "0.35 GPa"', text)
        self.assertEqual(brash("new").stdout, brash("new", "--ice", "basin").stdout)
        self.assertIn('youngs_modulus = "0.35 GPa"', brash("new").stdout)

    def test_a_new_case_is_read_without_a_warning_about_its_ice(self):
        with tempfile.TemporaryDirectory() as folder:
            for name, site in SITES.items():
                for kind in ("cone", "ship"):
                    with self.subTest(name, kind=kind):
                        file = pathlib.Path(folder) / f"{name}-{kind}.toml"
                        brash("new", "-o", file, "--kind", kind, "--ice", name)
                        self.expect_ice_of(site, file.read_text(encoding="utf-8"))
                        said = brash("check", file).stderr
                        for warning in ("youngs-modulus", "flexural-strength", "density", "friction", "strengths"):
                            self.assertNotIn(f"warning: {warning}", said)

    def test_field_and_duration_of_a_new_case_suit_its_ice_and_its_structure(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in SITES:
                for kind in ("cone", "faceted-cone", "wedge-bow", "plane", "ship"):
                    with self.subTest(name, kind=kind):
                        file = pathlib.Path(folder) / f"{name}-{kind}.toml"
                        brash("new", "-o", file, "--kind", kind, "--ice", name)
                        said = brash("check", file).stderr
                        for warning in ("near-side", "near-end", "leaves-field", "no-statistics", "short-run"):
                            self.assertNotIn(f"warning: {warning}", said)

    def test_a_run_of_a_new_case_is_six_characteristic_lengths_long_behind_its_initial_crack(self):
        for name, l_c in (("baltic", 6.55), ("bohai", 4.23), ("arctic", 17.1)):
            case = tomllib.loads(brash("new", "--ice", name).stdout)
            duration, length, width = (float(case[section][key].split()[0]) for section, key in
                                       (("time", "duration"), ("field", "length"), ("field", "width")))
            travel = duration * 1.202 - 7
            self.assertTrue(7 * l_c <= travel <= 7 * l_c + 6.2, (name, travel / l_c))  # rounded up to 5 s
            self.assertTrue(0 <= length - (travel + 6.8 + 3 * l_c) <= 10, (name, length))
            self.assertTrue(0 <= width - (6 * l_c + 13.6) <= 10, (name, width))

    def test_the_page_begins_with_the_new_case(self):
        page = (SOURCE / "modules/simulator/page/new_case.toml").read_text(encoding="utf-8")
        self.assertEqual(page.split("\n", 1)[1], brash("new", "--ice", "baltic").stdout)

    def test_the_page_has_the_keys_of_each_new_kind(self):
        kinds = json.loads((SOURCE / "modules/simulator/page/new_kinds.json").read_text(encoding="utf-8"))
        for kind, text in kinds.items():
            new = tomllib.loads(brash("new", "--kind", kind, "--ice", "baltic").stdout)
            self.assertEqual(tomllib.loads(text), {name: new[name] for name in ("structure", "hull", "field", "time") if name in new})
        refusal = brash("new", "--kind", "cube", "--ice", "baltic", code=2).stderr
        self.assertEqual(set(kinds), set(re.findall(r'"([a-z-]+)"', refusal)))

    def test_the_cone_in_the_ice_of_the_basin_stays_the_validation_case(self):
        new = tomllib.loads(brash("new").stdout)
        self.assertEqual((new["time"]["duration"], new["field"]), ("20 s", {"length": "50 m", "width": "50 m"}))

    def test_the_ice_of_the_basin_is_warned_of_in_a_case_of_no_basin(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "mine.toml"
            file.write_text(brash("new").stdout, encoding="utf-8")
            said = brash("check", file).stderr
            for text in ("warning: youngs-modulus: ice.youngs_modulus = 350 MPa is of model ice",
                         "warning: friction-structure: ice.friction_structure = 0.027 is of model ice"):
                self.assertIn(text, said)
            said = brash("check", file, "--set", "reference.source=a model basin").stderr
            self.assertNotIn("is of model ice", said)

    def test_templates_and_the_schema_have_the_plausible_values(self):
        line = "Plausible: 500 MPa to 12 GPa at sea, 10 MPa to 1 GPa in model ice."
        self.assertIn(f"# Young's modulus E of the ice. {line}", brash("new").stdout)
        template = " ".join(brash("schema", "--template").stdout.replace("#", " ").split())
        self.assertIn(f"{line} At sea: effective modulus of 0.5 GPa", template)
        schema = json.loads(brash("schema").stdout)["properties"]
        self.assertIn(line, schema["ice"]["properties"]["youngs_modulus"]["description"])
        self.assertIn("Plausible: 0 m/s to 5 m/s at sea.", schema["water"]["properties"]["current"]["description"])

    def test_an_ice_that_is_none_is_named(self):
        said = brash("new", "--ice", "baltik", code=2).stderr
        for part in ("there is no ice 'baltik'", "basin, baltic, bohai, arctic", "such as baltic"):
            self.assertIn(part, said)
        self.assertIn("--template", brash("schema", "--ice", "baltic", code=2).stderr)

    def test_the_reference_has_the_table(self):
        page = (SOURCE / "docs/reference/case-file.md").read_text(encoding="utf-8")
        self.assertTrue(re.search(r"^\| `ice.youngs_modulus` \| 0.35 GPa \| 3.1 GPa \| 1.3 GPa \| 2.8 GPa \|", page, re.M))


if __name__ == "__main__":
    unittest.main()
