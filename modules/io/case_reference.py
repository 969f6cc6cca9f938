#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/reference/case-file.md from case.schema.json and site_ice.json; with --check, fails when the page differs."""
import json
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "reference" / "case-file.md"

INTRODUCTION = """\
<!-- Written by modules/io/case_reference.py from modules/io/case.schema.json and site_ice.json; change those. -->
# The case file

A case file is [TOML](https://toml.io/en/v1.0.0): sections in brackets, and below them lines `key = value`.

- **Units.** A bare number is in the unit of the table below (SI). A string is a quantity with a unit, read by UDUNITS-2:
  `thickness = 0.33` is `thickness = "33 cm"`, an angle is `"61.4 deg"`.
- **Differences from UDUNITS.** `nmi` is the nautical mile and `ppt` parts per thousand. Exponents must be whole numbers,
  but for a toughness: `"0.15 MPa m^0.5"`. Angles and ratios do not convert into each other.
- **Errors.** The file is strict. An unknown, missing or doubled key ends the command with exit code 2, and so does a wrong
  unit or a value out of range. The message names file, line, column, key, value, the allowed values and the remedy.
- **Overrides.** `--set section.key=value` on the command line wins over the file. The value is TOML, or else a plain
  string, so `--set 'ice.thickness=40 cm'` needs no inner quotes.
- **Templates.** `brash schema --template` prints a case with every key. `brash check CASE.toml --keys` prints a case in SI
  with all defaults. `--ice` chooses [the ice of a site](#site-ice).
- **Editors.** `brash schema > case.schema.json` writes a JSON Schema. The first line of a template names it,
  `#:schema case.schema.json`. Editors that know this line, such as Taplo and Even Better TOML, check the keys and show their
  meaning.

In the sources, "paper" is the article whose model the program follows.
"""


def toml(value):
    """A default as it would be written in a case file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float) and value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return json.dumps(value)


def number(value):
    return f"{value:.6g}"


def allowed(key):
    """What a key may hold, in a table's cell."""
    if "enum" in key:
        return ", ".join(f"`{name}`" for name in key["enum"])
    kind = key["type"][0] if isinstance(key["type"], list) else key["type"]
    if "x-units" in key:
        return f"{len(key['x-units'])} values in {', '.join(key['x-units'])}"
    if kind == "array":
        least, most = key["minItems"], key.get("maxItems")
        count = f"{least} or more" if most is None else f"{least}" if least == most else f"{least} to {most}"
        rows = key["items"]["type"] == "array"
        other = ", or a file" if "string" in key["type"] else ""
        return f"{count} {'rows' if rows else 'values'}, each {allowed(key['items'])}{other}"
    if kind == "boolean":
        return "`true`, `false`"
    bounds = [f"{sign} {number(key[word])}" for word, sign in
              (("minimum", "≥"), ("exclusiveMinimum", ">"), ("maximum", "≤"), ("exclusiveMaximum", "<")) if word in key]
    return ", ".join((["whole number"] if kind == "integer" else ["text"] if kind == "string" else []) + bounds)


OTHER_UNITS = {"kg m-3": "kg/m3", "m s-1": "m/s", "1": ""}


def in_words(value, unit):
    """A value in the unit that keeps it short."""
    for of, name, size in (("Pa", "GPa", 1e9), ("Pa", "MPa", 1e6), ("Pa", "kPa", 1e3), ("m", "m", 1.0), ("m", "cm", 1e-2)):
        if unit == of and (value >= size or name == "cm"):
            return f"{value / size:.4g} {name}"
    return f"{value:.4g} {OTHER_UNITS.get(unit, unit)}".rstrip()


def plausible_ranges(sections):
    """The plausible values of keys, narrower than the allowed ones, with their sources."""
    lines = ["## Plausible values", "",
             "`check` and `run` [warn](warnings.md) of other values, and so does the page of `brash new --page`. Templates have the",
             "ranges in comments. **Model ice or sea ice:** ice may be model ice if it is at most as thick as model ice in this",
             "table, or if `reference.source` names a basin, an ice tank, a model test or model ice. Its values may lie in either",
             "column. All other ice must lie in the column of the sea.", "",
             "| key | at sea | model ice | sources |", "|---|---|---|---|"]
    for section, content in sections.items():
        for name, key in content["properties"].items():
            if "x-plausible" not in key:
                continue
            ranges = [key["x-plausible"].get(column) for column in ("sea", "model")]
            cells = [f"{in_words(of['least'], key['x-unit'])} to {in_words(of['most'], key['x-unit'])}" if of else "" for of in ranges]
            sources = "; ".join(f"{title}: {of['source']}" for title, of in zip(("sea", "model ice"), ranges) if of)
            lines.append(f"| `{section}.{name}` | {' | '.join(cells)} | {sources} |")
    return lines + [""]


def site_value(schema, site, path):
    """The value of a key in the ice of a site; of model ice, the default or the example of the schema."""
    section, name = path.split(".")
    key = schema["properties"][section]["properties"][name]
    usual = key.get("examples", [key.get("default")])[0]
    return site["values"].get(path, [usual])[0]


def site_ice(schema):
    """Typical ice of sites, with what each value rests on."""
    ice = json.loads((HERE / "site_ice.json").read_text(encoding="utf-8"))
    sites = ice["sites"]
    lines = ["## Site ice", "",
             "`brash schema --template --ice NAME` and `brash new --ice NAME` write the ice and the water of a site, with the",
             "source of each value in a comment. In Python, `brash.template(ice=NAME)` and `brash.new_case(ice=NAME)` do. The",
             "default is the ice of the validation case, `basin`, whose sources are above. The others are typical values to",
             "begin with: put in what is known of your site.", "",
             "| key | " + " | ".join(f"`{name}`" for name in sites) + " | source |",
             "|---|" + "---|" * len(sites) + "---|"]
    for path, source in ice["keys"].items():
        values = " | ".join(str(site_value(schema, site, path)) for site in sites.values())
        lines.append(f"| `{path}` | {values} | {source} |")
    lines += ["", "| ice | what it is | remarks |", "|---|---|---|"]
    for name, site in sites.items():
        remarks = [site.get("brine", "")] + [remark for _, remark in site["values"].values()]
        lines.append(f"| `{name}` | {site['name']} | {' '.join(filter(None, remarks))} |")
    lines += ["", "| source | title |", "|---|---|"]
    lines += [f"| {name} | {title} |" for name, title in ice["sources"].items()]
    return lines + [""]


def page():
    schema = json.loads((HERE / "case.schema.json").read_text(encoding="utf-8"))
    lines = [INTRODUCTION]
    sections = {}
    for name, content in schema["properties"].items():
        keys = content["properties"]
        sections[name] = content
        sections |= {f"{name}.{key}": inner for key, inner in keys.items() if "properties" in inner}
    for section, content in sections.items():
        lines += [f"## `[{section}]`", "", content["description"], "",
                  "| key | unit | default | allowed | meaning |", "|---|---|---|---|---|"]
        for name, key in content["properties"].items():
            if "properties" in key:
                continue
            depends = "default" not in key and ("x-kinds" in key or "x-short-for" in key or "x-required" in key)
            optional = key.get("x-optional-for", [])
            depends = depends and set(optional) != set(key.get("x-kinds", [None]))
            required = depends or name in content.get("required", [])
            default = "**required**" if required else f"`{toml(key['default'])}`" if "default" in key else "absent"
            if required and optional:
                default += f"; {', '.join(optional)}: absent"
            if "x-presets" in key:
                default += "".join(f"; {preset}: `{toml(value)}`" for preset, value in key["x-presets"].items())
            for kind, names in key.get("x-of-kinds", {}).items():
                if key["default"] not in names:
                    default += f"; {kind}: `{toml(names[0])}`"
            unit = key.get("x-unit", "")
            kinds = ", ".join(f"`{kind}`" for kind in key.get("x-kinds", []))
            meaning = key["description"] + f" Only with the `kind` {kinds}." * bool(kinds)
            lines.append(f"| `{name}` | {'' if unit == '1' else unit} | {default} | {allowed(key)} | {meaning} |")
        lines.append("")
    return "\n".join(lines + plausible_ranges(sections) + site_ice(schema))


if sys.argv[1:] == ["--check"]:
    if not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        sys.exit(f"{PAGE}: differs from the schema; run modules/io/case_reference.py")
else:
    PAGE.write_text(page(), encoding="utf-8")
