# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases drawn from the schema: legal ones over all kinds and keys, with sizes over six decades, and illegal ones with one
fault each. A seed gives the same case everywhere.
"""
import json
import math
import random
import re
from pathlib import Path

SCHEMA = json.loads((Path(__file__).resolve().parents[2] / "modules/io/case.schema.json").read_text(encoding="utf-8"))
GRAVITY = 9.81
# Keys that would make a case long, or that the draw sets as a whole.
NOT_ALONE = {"structure.facets", "field.origin", "failure.file", "output.frames_per_second", "output.statistics_from",
             "output.checkpoint_interval", "contact.iterations"}
# Sections whose keys are optional and independent enough to be drawn one by one.
OPTIONAL = ("ice", "ice.variation", "water", "wind", "failure", "contact", "hydrodynamics", "time", "random", "reference")


def sections(schema, around=""):
    """{section: {key: schema}}, a section within another one as "ice.variation"."""
    found = {}
    for name, part in schema["properties"].items():
        keys = {key: of for key, of in part["properties"].items() if "properties" not in of}
        found[around + name] = keys
        inner = {key: of for key, of in part["properties"].items() if "properties" in of}
        found |= sections({"properties": inner}, f"{around}{name}.") if inner else {}
    return found


SECTIONS = sections(SCHEMA)
KEYS = {f"{section}.{key}": of for section, keys in SECTIONS.items() for key, of in keys.items()}


def toml(value):
    if isinstance(value, bool):
        return str(value).lower()
    return json.dumps(value) if isinstance(value, (str, list)) else repr(value)


def text_of(case):
    """The case file of {key: value}; the name of a section is all before the last dot."""
    lines = {}
    for path, value in case.items():
        section, key = path.rsplit(".", 1)
        lines.setdefault(section, []).append(f"{key} = {toml(value)}")
    return "\n".join(f"[{section}]\n" + "\n".join(lines[section]) + "\n" for section in SECTIONS if section in lines)


class Draw:
    """Random values; numbers have six digits, so that a case is easy to read."""

    def __init__(self, seed):
        self.random = random.Random(seed)

    def even(self, least, most):
        return float(f"{self.random.uniform(least, most):.6g}")

    def decades(self, least, most):
        """Evenly by the logarithm."""
        return float(f"{least * (most / least) ** self.random.random():.6g}")

    def one(self, choices):
        return self.random.choice(list(choices))

    def chance(self, share):
        return self.random.random() < share


def rounded(value):
    """Numbers with nine digits."""
    if isinstance(value, list):
        return [rounded(item) for item in value]
    return float(f"{value:.9g}") if isinstance(value, float) else value


def optional_value(draw, of):
    """A value of a key by its schema alone: about its default, or within its range; None for keys of text and tables."""
    if "enum" in of:
        return draw.one(of["enum"])
    kind = of["type"][0] if isinstance(of["type"], list) else of["type"]
    if kind == "boolean":
        return draw.chance(0.5)
    if kind == "array" and of.get("items", {}).get("type") == ["number", "string"]:
        usual = [item if isinstance(item, (int, float)) else 0.0 for item in of.get("default", [0.0] * of["minItems"])]
        size = min(of["items"].get("maximum", 1.0), 1.0)
        return [float(f"{item + draw.even(-size, size):.6g}") for item in usual]
    if kind not in ("number", "integer"):
        return None
    least, most = of.get("minimum", of.get("exclusiveMinimum", 0.0)), of.get("maximum", of.get("exclusiveMaximum", 100.0))
    usual = of.get("default", 0)
    value = usual * draw.decades(0.1, 10.0) if usual else draw.even(least, min(most, least + 1.0))
    value = min(max(value, least), most * (1.0 - 1e-6))
    return round(value) if kind == "integer" else float(f"{value:.6g}")


def box(width, length, height, draught):
    """A closed mesh of triangles, OFF, the bow along x."""
    corners = [(x, y, z) for x in (-length / 2, length / 2) for y in (-width / 2, width / 2)
               for z in (-draught, height - draught)]
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = [(a, b, c) for a, b, c, d in faces] + [(a, c, d) for a, b, c, d in faces]
    return (f"OFF\n{len(corners)} {len(triangles)} 0\n" + "".join(f"{x:.9g} {y:.9g} {z:.9g}\n" for x, y, z in corners) +
            "".join(f"3 {a} {b} {c}\n" for a, b, c in triangles))


def rectangle(x, y, length, width):
    corners = [(x, y), (x + length, y), (x + length, y + width), (x, y + width), (x, y)]
    return "POLYGON ((" + ", ".join(f"{a:.9g} {b:.9g}" for a, b in corners) + "))\n"


class Legal:
    """One drawn case: `case` {key: value}, and `files` {name: text} that it names."""

    def __init__(self, seed):
        self.draw, self.case, self.files = Draw(seed), {}, {}
        self.ice_file_key = None  # of the file that has the ice
        self.structure()
        self.ice()
        self.motion()
        self.field()
        self.laws()
        self.time()
        self.required = set(self.case)
        self.optional()
        self.case = {path: rounded(value) for path, value in self.case.items()}

    def structure(self):
        draw, width = self.draw, self.draw.decades(2e-3, 1e3)  # [m]
        kind = draw.one(KEYS["structure.kind"]["enum"])
        slope = draw.one([draw.even(20, 85), draw.even(20, 85), 90.0])
        self.angle = math.radians(slope)
        # The retreat of a slope leaves a keel, or a top, of a tenth of the width.
        depth_ratio = min(draw.decades(0.2, 1.5), 0.4 * math.tan(self.angle))
        length_ratio = draw.decades(0.8, 4.0)
        if kind in ("ship", "mesh"):
            depth_ratio, length_ratio = 0.4 if kind == "ship" else 0.5, 4.0 if kind == "ship" else length_ratio
        # No size is below or above what the schema takes.
        width = self.width = min(max(width, 1.01e-3 / depth_ratio), 990.0 / max(1.0, 2.0 * depth_ratio, length_ratio))
        depth, length = width * depth_ratio, width * length_ratio
        self.depth = depth
        case = {"structure.kind": kind, "structure.start_distance": 0.0}
        if kind in ("cone", "faceted-cone", "plane", "wedge-bow"):
            case |= {"structure.angle": f"{slope:g} deg", "structure.waterline_width": width, "structure.height": 2.0 * depth,
                     "structure.height_under_water": depth, "structure.breaking": draw.one(["downward", "upward"])}
        if kind in ("plane", "wedge-bow"):
            case["structure.length"] = min(2.0 * length + 2.0 * depth / math.tan(min(self.angle, 1.5)), 1000.0)
        if kind == "wedge-bow":
            case["structure.entrance"] = f"{draw.even(20, 80):g} deg"
        if kind == "faceted-cone":
            case["structure.sides"] = draw.random.randint(4, 12)
        if kind == "cone":
            case["structure.facets"] = draw.one([16, 64])
        if kind == "ship":
            case |= {"hull.length": length, "hull.breadth": width, "hull.draught": depth,
                     "hull.stem_angle": math.radians(draw.even(20, 60)), "hull.waterline_angle": math.radians(draw.even(25, 60)),
                     "hull.flare": math.radians(draw.even(0, 30))}
        if kind == "mesh":
            self.angle = math.pi / 2
            self.files["box.off"] = box(width, length, width, depth)
            case |= {"structure.file": "box.off", "structure.draught": depth}
        self.kind = kind
        self.case |= case

    def ice(self):
        draw = self.draw
        self.thickness = min(max(self.depth * draw.decades(0.03, 0.6), 1e-3), 10.0)
        modulus, strength = draw.decades(2e7, 1e10), draw.decades(2e4, 2e6)
        water = draw.even(990, 1040)
        self.case |= {"ice.thickness": self.thickness, "ice.youngs_modulus": modulus, "ice.flexural_strength": strength,
                      "ice.compressive_strength": strength * draw.decades(1.0, 10.0), "ice.density": draw.even(720, 940),
                      "water.density": water, "contact.margin": min(max(0.01 * min(self.thickness, self.depth), 1e-6), 0.1),
                      "ice.friction_structure": draw.even(0.0, min(0.3, 0.9 / math.tan(min(self.angle, 1.5))))}
        self.length = (modulus * self.thickness**3 / (12 * (1 - 0.3**2) * water * GRAVITY)) ** 0.25  # l_c [m]

    def motion(self):
        draw, mass = self.draw, 900.0 * max(self.width * self.width * self.depth, 1.0)
        kind = draw.one(["towed", "towed", *KEYS["structure.motion.kind"]["enum"]])
        self.speed = draw.decades(0.03, 3.0)
        self.case |= {"structure.motion.kind": kind, "structure.speed": self.speed,
                      "structure.motion.frame": draw.one(KEYS["structure.motion.frame"]["enum"])}
        if kind == "compliant":
            stiffness = mass * (2 * math.pi / draw.decades(0.5, 20.0)) ** 2
            self.case |= {"structure.motion.mass": mass, "structure.motion.stiffness": float(f"{stiffness:.6g}")}
        if kind == "moored":
            diagonal = [mass * draw.decades(0.01, 10.0) for _ in range(2)] + [0.0] * 3 + [min(mass * self.width**2, 1e15)]
            self.case["structure.motion.stiffness_matrix"] = [[float(f"{diagonal[i]:.6g}") if i == k else 0.0 for k in range(6)]
                                                              for i in range(6)]

    def field(self):
        draw, span = self.draw, self.width + 3.0 * self.length
        length = min(max(1.5 * self.length + self.thickness, span * draw.decades(0.5, 1.5)), 3900.0)
        width = min(1.3 * self.width + span * draw.decades(0.5, 1.5), 3900.0)
        kind = draw.one(["level-ice", "level-ice", "floes"])
        self.case |= {"field.kind": kind, "field.length": length, "field.width": width,
                      "field.border": draw.one(KEYS["field.border"]["x-of-kinds"][kind])}
        if kind == "floes":
            self.floes(min(length, width))
        elif draw.chance(0.25):
            self.ice_file(length, width)
        elif self.angle > 1.56:
            self.case["field.initial_crack"] = False
        else:
            self.case["field.initial_crack"] = draw.chance(0.7)
            if draw.chance(0.15):
                self.case |= {"field.edge_roughness": 0.05 * self.length, "field.edge_correlation_length": 0.5 * self.length}
            if self.case["field.initial_crack"] and draw.chance(0.15):
                self.case["field.initial_crack_radius"] = self.length * draw.even(0.2, 0.6)

    def floes(self, extent):
        draw, law = self.draw, self.draw.one(KEYS["field.size.kind"]["enum"])
        size = max(extent / draw.even(4, 8), 0.011)
        shape = draw.one(KEYS["field.shape"]["enum"])
        most = 0.7 if shape == "voronoi" else 0.4  # more squares and discs find no place
        self.case |= {"field.concentration": draw.even(0.1, most), "field.shape": shape, "field.size.kind": law}
        self.case |= {"power-law": {"field.size.least": 0.9 * size, "field.size.largest": 1.5 * size},
                      "log-normal": {"field.size.median": size, "field.size.deviation": 0.2},
                      "list": {"field.size.values": [size, 1.2 * size]}}[law]

    def ice_file(self, length, width):
        key = self.draw.one(["openings", "cracks", "shore", "file"])
        self.files["ice.wkt"] = {"openings": rectangle(0.4 * length, 0.1 * width, 0.2 * length, 0.2 * width),
                                 "cracks": f"LINESTRING ({0.7 * length:.9g} {-width:.9g}, {0.7 * length:.9g} {width:.9g})\n",
                                 "shore": rectangle(0.8 * length, -0.5 * width, 0.2 * length, 0.3 * width),
                                 "file": rectangle(0.0, -0.45 * width, 0.9 * length, 0.9 * width)}[key]
        self.ice_file_key = f"field.{key}"
        self.case |= {self.ice_file_key: "ice.wkt", "field.initial_crack": False}
        if key == "file":  # its outline reaches no border that could hold it
            self.case["field.border"] = "free"

    def laws(self):
        draw = self.draw
        self.case["algorithm.preset"] = draw.one(KEYS["algorithm.preset"]["enum"])
        if self.case["algorithm.preset"] == "paper":
            self.case["failure.model"] = draw.one(KEYS["failure.model"]["enum"])
        if self.angle > 1.56:  # a vertical face has no area in plan, which `paper` takes
            self.case["contact.area"] = "surface"
        self.case["failure.smallest_floe"] = min(1e-3 * self.length**2, 100.0)

    def time(self):
        """A run of few steps: up to the ice, and half of a characteristic length into it."""
        draw, n_steps = self.draw, self.draw.random.randint(8, 24)
        self.gap = 0.02 * self.width
        way = self.gap + draw.even(0.1, 0.5) * min(self.length, self.width)
        step = min(way / self.speed / n_steps, 1.0)
        self.case["time.step"] = float(f"{step:.6g}")
        self.case |= {"time.duration": float(f"{n_steps * self.case['time.step']:.9g}"),
                      "output.frames_per_second": min(float(f"{0.2 / step:.6g}"), 1000.0),
                      "output.checkpoint_interval": self.interval(n_steps)}

    def interval(self, n_steps):
        """Time between checkpoints: one comes, in the middle [s]."""
        return float(f"{(n_steps // 2 + 1) * self.case['time.step']:.9g}")

    def optional(self):
        for section in OPTIONAL:
            for key, of in SECTIONS[section].items():
                path = f"{section}.{key}"
                if path in self.case or path in NOT_ALONE or "default" not in of or not self.draw.chance(0.12):
                    continue
                value = optional_value(self.draw, of)
                if value is not None:
                    self.case[path] = value

    def write(self, folder):
        folder.mkdir(parents=True, exist_ok=True)
        for name, text in self.files.items():
            (folder / name).write_text(text, encoding="utf-8")
        file = folder / "case.toml"
        # Level ice says how far its edge has to be from the structure's origin, ice of a file only that it is too near.
        before = self.case["structure.start_distance"] == 0.0 and self.ice_file_key
        file.write_text(text_of({path: value for path, value in self.case.items() if path != before}), encoding="utf-8")
        return file

    def follow(self, said):
        """Changes the case as the refusal `said` wants it. @return whether it wants something."""
        if reach := REACH.search(said):
            self.case["structure.start_distance"] = float(f"{float(reach[1]) * 1.0001 + self.gap:.9g}")
        elif longest := LONGEST_STEP.search(said):
            n_steps = round(self.case["time.duration"] / self.case["time.step"])
            self.case["time.step"] = float(f"{0.9 * float(longest[1]):.4g}")
            self.case["time.duration"] = float(f"{n_steps * self.case['time.step']:.9g}")
            self.case["output.frames_per_second"] = min(float(f"{0.2 / self.case['time.step']:.6g}"), 1000.0)
            self.case["output.checkpoint_interval"] = self.interval(n_steps)
        elif reached := CONCENTRATION.search(said):
            self.case["field.concentration"] = float(f"{0.8 * float(reached[1]):.4g}")
        else:
            return self.drop_refused(said)
        return True

    def drop_refused(self, said):
        """Leaves out what the program refuses: the optional keys that it names. @return whether there are any."""
        named = [path for path in self.case if path not in self.required and path.rsplit(".", 1)[1] in said]
        for path in named:
            del self.case[path]
        return bool(named)


REACH = re.compile(r"more than its largest radius in the ice, ([\d.e+-]+) m")
LONGEST_STEP = re.compile(r"is too long for the structure on its restoring loads\n  allowed: less than ([\d.e+-]+) s")
CONCENTRATION = re.compile(r"allowed: at most ([\d.e+-]+), which was reached")


def legal(seed, folder, attempt, tries=8):
    """A case that the program takes, written into `folder`.
    @param attempt  calls the program with the file; it ends with 2 where the case is refused.
    @return the file, or None when the last try was refused, the drawn case, and the call."""
    drawn = Legal(seed)
    for _ in range(tries):
        waits = drawn.ice_file_key and drawn.case["structure.start_distance"] == 0.0
        file = drawn.write(folder)
        done = attempt(file)
        if done.returncode != 2:
            assert not waits, "level ice did not say how far its edge has to be"
            return file, drawn, done
        if not drawn.follow(done.stderr):
            break
    return None, drawn, done


def spoilt(draw, path, of, value):
    """Texts of TOML that a key does not take."""
    texts = ["nan", "inf", "[]", "{}", "2024-02-01", '"3 bananas"', '""']
    kind = of["type"][0] if isinstance(of["type"], list) else of["type"]
    if kind == "number":
        texts += [f'"{value if isinstance(value, (int, float)) else 1} kat"', "true", '"0,5 m"']
    if kind in ("number", "integer"):
        for word, side in (("minimum", -1.0), ("maximum", 1.0)):
            if word in of:
                texts.append(repr(of[word] + side * max(1.0, abs(of[word])) * draw.decades(1e-3, 1e3)) if kind == "number"
                             else str(of[word] + int(side) * draw.random.randint(1, 1000)))
    if kind == "integer":
        texts.append("1.5")
    if kind == "boolean":
        texts += ["1", '"yes"']
    if "enum" in of:
        texts += [toml(draw.one(of["enum"])[:-1] + "q"), toml(draw.one(of["enum"]).upper())]
    if kind == "array":
        texts += ["1.0", '["a", "b"]'] + (["[1]"] if of.get("minItems", 0) > 1 else [])
    allowed_text = kind == "string" and "enum" not in of
    return [text for text in texts if not (allowed_text and text.startswith('"')) and not (kind == "array" and text == "{}")]


def illegal(seed, drawn):
    """A drawn case with one fault. @return text of the file, the key at fault and what its message names besides it."""
    draw, case = Draw(seed), dict(drawn.case)
    path = draw.one(case)
    section, key = path.rsplit(".", 1)
    lines = text_of(case).splitlines()
    at = next(i for i in range(lines.index(f"[{section}]") + 1, len(lines)) if lines[i].startswith(f"{key} = "))
    fault = draw.one(["value", "value", "value", "name", "twice", "missing"])
    if fault == "name":
        wrong = key + draw.one("xyz")
        lines[at] = lines[at].replace(key, wrong, 1)
        return "\n".join(lines) + "\n", f"{section}.{wrong}", ["is not a known key"]
    if fault == "twice":
        lines.insert(at, lines[at])
        return "\n".join(lines) + "\n", key, []
    required = sorted(set(case) & {f"{name}.{key}" for name, part in SCHEMA["properties"].items() for key in part.get("required", [])})
    if fault == "missing" and required:
        gone = draw.one(required)
        section, key = gone.rsplit(".", 1)
        del case[gone]
        return text_of(case), gone, ["is missing"]
    text = draw.one(spoilt(draw, path, KEYS[path], case[path]))
    lines[at] = f"{key} = {text}"
    return "\n".join(lines) + "\n", path, [text.strip('"')] if re.fullmatch(r'"?[\w .,-]+"?', text) else []
