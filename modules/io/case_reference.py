#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes docs/reference/case-file.md from case.schema.json and site_ice.json; with --check, fails when the page differs."""
import json
import math
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
PAGE = HERE.parents[1] / "docs" / "reference" / "case-file.md"

INTRODUCTION = """\
<!-- Written by modules/io/case_reference.py from modules/io/case.schema.json and site_ice.json; change those. -->
# The case file

*Which keys has a case, and which values may they have?*

A case file is [TOML](https://toml.io/en/v1.0.0): sections in brackets, and below them lines `key = value`.

- **Units.** A bare number has the unit below (SI, angles in rad). A string has its own, read by UDUNITS-2:
  `thickness = "33 cm"`, `angle = "61.4 deg"`. `nmi` is the nautical mile, `ppt` parts per thousand. Exponents are whole
  numbers, but for a toughness: `"0.15 MPa m^0.5"`. Angles and ratios do not convert into each other.
- **Errors.** A wrong key, unit or value ends the command with exit code 2. The message names the place and the remedy.
- **Overrides.** `--set section.key=value` wins over the file. A value that is not TOML is a string, so
  `--set 'ice.thickness=40 cm'` needs no inner quotes.
- **Templates.** `brash schema --template` prints a case with every key, `brash check CASE.toml --keys` a case in SI with its
  defaults, `brash schema` the JSON Schema. An editor such as Taplo checks a case whose first line is
  `#:schema case.schema.json`.

In the tables, `[0, 1)` is the range from 0 to below 1. Names in brackets after a meaning are the kinds that have the key.
Equations, sections, tables and figures are the paper's. `brash schema --template` prints the source of each default.
"""


DOCUMENT = r"docs/(?:theory|decisions)/[\w-]+(?:\.md)?(?:,? \(\w+\))?"


def toml(value):
    """A default as it would be written in a case file."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float) and value == int(value) and abs(value) < 1e6:
        return str(int(value))
    return json.dumps(value)


def number(value):
    return f"{value:.6g}"


def bounds(key):
    """The range of a number as an interval; of an angle in degrees."""
    in_degrees = key.get("x-unit") == "rad"
    words = {word: f"{math.degrees(key[word]):.4g}" if in_degrees else number(key[word])
             for word in ("minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum") if word in key}
    if len(words) < 2:
        return f"≥ {words['minimum']}" if words else ""
    low = f"[{words['minimum']}" if "minimum" in words else f"({words['exclusiveMinimum']}"
    high = f"{words['maximum']}]" if "maximum" in words else f"{words['exclusiveMaximum']})"
    return f"{low}, {high}" + "°" * in_degrees


def allowed(key):
    """What a key may hold, in a table's cell."""
    if "enum" in key:
        return ", ".join(f"`{name}`" for name in key["enum"])
    kind = key["type"][0] if isinstance(key["type"], list) else key["type"]
    if "x-units" in key:
        return f"{len(key['x-units'])} values in {', '.join(key['x-units'])}"
    if kind == "array":
        least, most = key["minItems"], key.get("maxItems")
        count = f"≥ {least}" if most is None else f"{least}" if least == most else f"{least} to {most}"
        rows = key["items"]["type"] == "array"
        other = ", or a file" if "string" in key["type"] else ""
        of = allowed({"x-unit": key.get("x-unit"), **key["items"]})
        return f"{count} rows of {of}{other}" if rows else f"{count} values, {of}"
    if kind == "boolean":
        return "bool"
    return " ".join(filter(None, ["whole" if kind == "integer" else "text" if kind == "string" else "", bounds(key)]))


OTHER_UNITS = {"kg m-3": "kg/m3", "m s-1": "m/s", "1": ""}


def in_words(value, unit):
    """A value in the unit that keeps it short."""
    for of, name, size in (("Pa", "GPa", 1e9), ("Pa", "MPa", 1e6), ("Pa", "kPa", 1e3), ("m", "m", 1.0), ("m", "cm", 1e-2)):
        if unit == of and (value >= size or name == "cm"):
            return f"{value / size:.4g} {name}"
    return f"{value:.4g} {OTHER_UNITS.get(unit, unit)}".rstrip()


def plausible_ranges(sections):
    """The plausible values of keys, narrower than the allowed ones."""
    lines = ["## Plausible values", "",
             "`check`, `run` and the page of `brash new --page` [warn](warnings.md) of other values. Ice is model ice if it is at most",
             "as thick as model ice in this table, or if `reference.source` names a basin, an ice tank, a model test or model ice. Its",
             "values may be in either column. `brash schema --template` prints the sources.", "",
             "| key | at sea | model ice |", "|---|---|---|"]
    for section, content in sections.items():
        for name, key in content["properties"].items():
            if "x-plausible" not in key:
                continue
            ranges = [key["x-plausible"].get(column) for column in ("sea", "model")]
            cells = [f"{in_words(of['least'], key['x-unit'])} to {in_words(of['most'], key['x-unit'])}" if of else "" for of in ranges]
            lines.append(f"| `{section}.{name}` | {' | '.join(cells)} |")
    return lines + [""]


def site_value(schema, site, path):
    """The value of a key in the ice of a site; of model ice, the default or the example of the schema."""
    section, name = path.split(".")
    key = schema["properties"][section]["properties"][name]
    usual = key.get("examples", [key.get("default")])[0]
    return site["values"].get(path, [usual])[0]


def site_ice(schema):
    """Typical ice of sites."""
    ice = json.loads((HERE / "site_ice.json").read_text(encoding="utf-8"))
    sites = ice["sites"]
    lines = ["## Site ice", "",
             "`brash new --ice NAME` and `brash schema --template --ice NAME` write the ice and water of a site, with a source beside each",
             "value (Python: `brash.new_case(ice=NAME)`). The default `basin` is the validation case's. The others are typical values of",
             "first-year ice in the northern Baltic, the Bohai Sea and the Arctic in winter: put in what is known of your site.", "",
             "| key | " + " | ".join(f"`{name}`" for name in sites) + " |",
             "|---|" + "---|" * len(sites)]
    for path in ice["keys"]:
        values = " | ".join(str(site_value(schema, site, path)) for site in sites.values())
        lines.append(f"| `{path}` | {values} |")
    lines += ["", "| source | title |", "|---|---|"]
    lines += [f"| {name} | {title} |" for name, title in ice["sources"].items()]
    return lines + [""]


def default_of(key, name, section):
    """The default of a key, and of the presets and kinds that differ."""
    depends = "default" not in key and ("x-kinds" in key or "x-short-for" in key or "x-required" in key)
    optional = key.get("x-optional-for", [])
    depends = depends and set(optional) != set(key.get("x-kinds", [None]))
    required = depends or name in section.get("required", [])
    default = "**required**" if required else f"`{toml(key['default'])}`" if "default" in key else "absent"
    if required and optional:
        default += f"; {', '.join(optional)}: absent"
    if "x-presets" in key:
        default += "".join(f"; {preset}: `{toml(value)}`" for preset, value in key["x-presets"].items())
    for kind, names in key.get("x-of-kinds", {}).items():
        if key["default"] not in names:
            default += f"; {kind}: `{toml(names[0])}`"
    return default


def linked(path):
    """The name of a page of the documents as a link from this page: docs/decisions/0005 or docs/theory/ice.md, (F8)."""
    folder, name, label = re.match(r"docs/(\w+)/([\w-]+)(?:\.md)?(?:,? \((\w+)\))?", path).groups()
    file = next((PAGE.parents[1] / folder).glob(f"{name}*.md")).name
    title = label or (f"decision {int(name[:4])}" if folder == "decisions" else name.replace("-", " "))
    return f"[{title}](../{folder}/{file})"


def meaning_of(key):
    """The description, with links to the pages that its sources name; the other sources are left out, but for assumptions."""
    text, _, sources = re.sub(r" Validation case: .*$", "", key["description"]).partition(" Source: ")
    text = re.sub(DOCUMENT, lambda match: linked(match[0]), text)
    pages = ", ".join(dict.fromkeys(linked(page) for page in re.findall(DOCUMENT, sources)))
    return text + " Assumed." * sources.startswith("assumed") + f" ({pages})" * bool(pages)


def row(key, name, section):
    unit = key.get("x-unit", "1")
    named = f"`{name}`" + f" [{OTHER_UNITS.get(unit, unit)}]" * (unit != "1")
    kinds = ", ".join(f"`{kind}`" for kind in key.get("x-kinds", []))
    return f"| {named} | {default_of(key, name, section)} | {allowed(key)} | {meaning_of(key)}{f' ({kinds})' * bool(kinds)} |"


def page():
    schema = json.loads((HERE / "case.schema.json").read_text(encoding="utf-8"))
    lines = [INTRODUCTION]
    sections = {}
    for name, content in schema["properties"].items():
        keys = content["properties"]
        sections[name] = content
        sections |= {f"{name}.{key}": inner for key, inner in keys.items() if "properties" in inner}
    for section, content in sections.items():
        lines += [f"## `[{section}]`", "", content["description"], "", "| key | default | allowed | meaning |", "|---|---|---|---|"]
        lines += [row(key, name, content) for name, key in content["properties"].items() if "properties" not in key]
        lines.append("")
    return "\n".join(lines + plausible_ranges(sections) + site_ice(schema))


if sys.argv[1:] == ["--check"]:
    if not PAGE.exists() or PAGE.read_text(encoding="utf-8") != page():
        sys.exit(f"{PAGE}: differs from the schema; run modules/io/case_reference.py")
else:
    PAGE.write_text(page(), encoding="utf-8")
