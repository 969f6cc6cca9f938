#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solves recorded sheets with FreeFem++ and adds the answers to their file, as lines "independent".

    sheet_reference.py FILE [--scale 1] [--only NAME ...] [--print]

Mesh, elements, loads and the search for the largest stress are its own; the program's code is not used. The laws are
those of docs/theory/fracture-of-the-edge.md: (2), (3), (4), (6) and (8). FreeFem++ solves what sheet_reference.edp says.
A sheet is split too where the stress along the edge at B exceeds 0.75 of the strength.
"""

import argparse
import math
import os
import pathlib
import subprocess
import sys
import tempfile

GRAVITY = 9.80665
FAR = 300.0  # width of the sheet on either side, over l_c
FREE, HELD, CRACK, AXIS, LOADED = 1, 2, 3, 4, 5
EDP = pathlib.Path(__file__).with_suffix(".edp")


# ---- The file

def read(path):
    """The sheets of a file, each a dict; lines keep their text."""
    sheets, ice = [], None
    for line in path.read_text().splitlines():
        kind, *words = line.split() or [""]
        if kind == "ice":
            ice = dict(zip(("h", "E", "nu", "sigma_f", "sigma_c", "R", "rho"), map(float, words)))
        elif kind == "sheet":
            sheets.append({"name": words[0], "ice": ice, "loads": []})
        elif kind == "load":
            v = list(map(float, words))
            sheets[-1]["loads"].append({"from": (v[0], v[1]), "to": (v[2], v[3]), "radius": v[4], "in": (v[5], v[6]),
                                        "out": v[7], "moment": v[8], "verdict": v[9] != 0})
        elif kind == "motion":
            v = list(map(float, words))
            sheets[-1]["motion"] = {"whole": v[:3], "split": v[3:]}
        elif kind == "outline":
            v = list(map(float, words))
            sheets[-1]["outline"] = list(zip(v[::2], v[1::2]))
        elif kind in ("fine", "recorded") and words:
            sheets[-1].setdefault("answers", {})[f"{kind} {words[0]}"] = list(map(float, words[1:]))
    return sheets


def add_answers(path, answers):
    """Writes the file again; a sheet's answers follow its other lines."""
    lines, name = [], None

    def finish():
        for kind, (ratio, place, radial) in answers.get(name, {}).items():
            lines.append(f"independent {kind} {ratio:.5f} {place[0]:.3f} {place[1]:.3f} {radial:.5f}")

    for line in path.read_text().splitlines():
        if line.startswith("sheet "):
            finish()
            name = line.split()[1]
        if not (line.startswith("independent ") and name in answers):
            lines.append(line)
    finish()
    path.write_text("\n".join(lines) + "\n")


# ---- Plane geometry

def minus(a, b):
    return (a[0] - b[0], a[1] - b[1])


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def foot(p, a, b):
    """The nearest point of a stretch, and how far along it lies, 0 to 1."""
    u = minus(b, a)
    square = u[0] ** 2 + u[1] ** 2
    s = 0.0 if square == 0 else max(0.0, min(1.0, ((p[0] - a[0]) * u[0] + (p[1] - a[1]) * u[1]) / square))
    return (a[0] + s * u[0], a[1] + s * u[1]), s


def distance(p, a, b):
    return math.dist(p, foot(p, a, b)[0])


def meet(a, b, c, d):
    return (cross(minus(b, a), minus(c, a)) > 0) != (cross(minus(b, a), minus(d, a)) > 0) and \
        (cross(minus(d, c), minus(a, c)) > 0) != (cross(minus(d, c), minus(b, c)) > 0)


def contains(ring, p):
    inside = False
    for a, b in zip(ring, ring[1:] + ring[:1]):
        if (a[1] > p[1]) != (b[1] > p[1]) and p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1]):
            inside = not inside
    return inside


# ---- The edge as the mesh sees it

class Edge:
    """The outline over l_c with the ends of the loads and B as points, straight under loads, thinned elsewhere."""

    def __init__(self, points, loads):
        self.points = points
        self.fixed = set()
        for load in loads:
            for end in ("from", "to"):
                self.insert(load[end])
        if min(distance((0.0, 0.0), a, b) for a, b in zip(points, points[1:])) < 2e-3:
            self.insert((0.0, 0.0))
        self.straighten(loads)
        self.thin()

    def insert(self, p):
        best = min(range(len(self.points) - 1), key=lambda i: distance(p, self.points[i], self.points[i + 1]))
        at = foot(p, self.points[best], self.points[best + 1])[0]
        if p == (0.0, 0.0):
            at = p
        for i in (best, best + 1):
            if math.dist(self.points[i], at) < 1e-3:
                if p == (0.0, 0.0):
                    self.fixed.discard(self.points[i])
                    self.points[i] = p
                self.fixed.add(self.points[i])
                return
        self.points.insert(best + 1, at)
        self.fixed.add(at)

    def nearest(self, p):
        return min(range(len(self.points)), key=lambda i: math.dist(self.points[i], p))

    def straighten(self, loads):
        for load in loads:
            i, j = sorted((self.nearest(load["from"]), self.nearest(load["to"])))
            self.points[i + 1:j] = [p for p in self.points[i + 1:j] if p in self.fixed]

    def thin(self):
        """Leaves out what lies within 0.002 of a chord near B, within 0.01 farther off, and points that are one."""
        kept = [self.points[0]]
        for p in self.points[1:]:
            if math.dist(p, kept[-1]) > 5e-4 or p in self.fixed:
                if math.dist(p, kept[-1]) <= 5e-4 and kept[-1] not in self.fixed:
                    kept.pop()
                kept.append(p)
        stops = [0] + [i for i, p in enumerate(kept) if p in self.fixed and 0 < i < len(kept) - 1] + [len(kept) - 1]
        self.points = [kept[0]]
        for first, last in zip(stops, stops[1:]):
            self.points += self.thinned(kept[first:last + 1])[1:]

    def thinned(self, line):
        def off(p):
            return distance(p, line[0], line[-1]) / (0.002 if math.hypot(*p) < 3 else 0.01)
        if len(line) < 3:
            return line
        far = max(range(1, len(line) - 1), key=lambda i: off(line[i]))
        if off(line[far]) < 1:
            return [line[0], line[-1]]
        return self.thinned(line[:far + 1])[:-1] + self.thinned(line[far:])

    def touches_itself(self):
        p = self.points
        return any(meet(p[i], p[i + 1], p[j], p[j + 1]) for i in range(len(p) - 1) for j in range(i + 2, len(p) - 1))


def axis_stretches(ring):
    """Where the x-axis lies in the ice: the ring with the crossings as points, and stretches of x."""
    snapped = [(x, 0.0 if abs(y) < 5e-4 else y) for x, y in ring]
    result, xs = [], set()
    for a, b in zip(snapped, snapped[1:] + snapped[:1]):
        result.append(a)
        if a[1] == 0.0:
            xs.add(a[0])
        elif a[1] * b[1] < 0:
            x = a[0] + (b[0] - a[0]) * a[1] / (a[1] - b[1])
            result.append((x, 0.0))
            xs.add(x)
    xs = sorted(xs)
    inside = [(a, b) for a, b in zip(xs, xs[1:]) if contains(snapped, (0.5 * (a + b), 1e-7)) and
              not any({p, q} == {(a, 0.0), (b, 0.0)} for p, q in zip(result, result[1:] + result[:1]))]
    return result, inside


# ---- The plate problem in units of l_c, k and D

class Problem:
    def __init__(self, sheet, is_split, scale):
        ice = sheet["ice"]
        self.sheet, self.is_split, self.scale = sheet, is_split, scale
        rigidity = ice["E"] * ice["h"] ** 3 / (12 * (1 - ice["nu"] ** 2))
        self.l_ice = (rigidity / (ice["rho"] * GRAVITY)) ** 0.25
        length, self.moments, self.radial = sheet["motion"]["split" if is_split else "whole"]
        self.l = length * self.l_ice
        k = ice["rho"] * GRAVITY / length ** 4
        self.force = k * self.l ** 3
        self.h = ice["h"] / self.l
        self.unit = k * self.l / ice["sigma_f"]
        self.loads = [{"from": self.over(o["from"]), "to": self.over(o["to"]), "radius": o["radius"] / self.l,
                       "in": (o["in"][0] / self.force, o["in"][1] / self.force),
                       "out": self.moments * o["out"] / self.force,
                       "moment": self.moments * o["moment"] / (self.force * self.l)} for o in sheet["loads"]]
        self.on_edge = [o for o in self.loads if o["radius"] == 0]
        self.discs = [o for o in self.loads if o["radius"] > 0]
        self.outline = [self.over(p) for p in sheet["outline"]]
        edge = Edge(list(self.outline), self.on_edge)
        if edge.touches_itself():
            raise ValueError("the edge touches itself")
        self.edge = edge
        self.lay_out()
        self.choose_sizes()

    def over(self, p):
        return (p[0] / self.l, p[1] / self.l)

    def lay_out(self):
        """The ring of the ice, counter-clockwise, and where the line from B leaves it."""
        points = self.edge.points
        far = max(p[0] for p in points) + FAR
        first, last = (points[0][0], points[0][1] - FAR), (points[-1][0], points[-1][1] + FAR)
        ring = points[::-1] + [first, (far, first[1]), (far, last[1]), last]
        self.far = far
        self.ring, self.axis = axis_stretches(ring)
        self.line_end = min((b for a, b in self.axis if a < 0.05 < b or abs(a) < 1e-9), default=0.0)

    def choose_sizes(self):
        """Sources of element sizes: stretch, radius around it, size there, growth."""
        s = self.scale
        base = max([p[0] for p in self.outline if math.hypot(*p) < 3] + [0.0])
        b = (0.0, 0.0)
        sizes = [(b, (min(base + 2.0, self.line_end), 0.0), 0.0, 0.07 * s, 0.3), (b, b, 2.3, 0.13 * s, 0.3)]
        for load in self.on_edge:
            long = max(0.01, math.dist(load["from"], load["to"]))
            away = max(0.0, min(math.hypot(*load["from"]), math.hypot(*load["to"])) - 2.0)
            sizes.append((load["from"], load["to"], 0.0, min(0.06, 0.2 * long) * s + 0.1 * away, 0.3))
        for disc in self.discs:
            size = max(0.02, min(0.06, 0.25 * disc["radius"])) * s
            sizes.append((disc["from"], disc["from"], disc["radius"], size, 0.3))
        ring = self.edge.points
        for a, b, c in zip(ring, ring[1:], ring[2:]):
            turn = math.atan2(cross(minus(b, a), minus(c, b)), (b[0]-a[0])*(c[0]-b[0]) + (b[1]-a[1])*(c[1]-b[1]))
            r = math.hypot(*b)
            if turn > 0.15 and r < 4.0:  # re-entrant
                sizes.append((b, b, 0.0, (0.025 + 0.02 * max(0.0, r - 1.0)) * s, 0.3))
        self.sizes = sizes

    def size_at(self, p):
        return min(size + growth * max(0.0, distance(p, a, b) - radius) for a, b, radius, size, growth in self.sizes)

    def pieces(self, a, b):
        """Points from a to b as far apart as the elements there are large."""
        length, at, points = math.dist(a, b), 0.0, [a]
        while True:
            p = (a[0] + (b[0] - a[0]) * at / length, a[1] + (b[1] - a[1]) * at / length)
            step = self.size_at(p)
            ahead = min(1.0, (at + step) / length)
            step = min(step, self.size_at((a[0] + (b[0] - a[0]) * ahead, a[1] + (b[1] - a[1]) * ahead)))
            at += step
            if at > length - 0.5 * step:
                return points + [b]
            points.append((a[0] + (b[0] - a[0]) * at / length, a[1] + (b[1] - a[1]) * at / length))

    def segments(self):
        """Pieces of the boundary with labels, and the forces of each label."""
        labels = [[0.0] * 5 for _ in range(LOADED)]
        pieces = []
        n = len(self.ring)
        on_edge = [self.stretch_of(load) for load in self.on_edge]
        for i in range(n):
            a, b = self.ring[i], self.ring[(i + 1) % n]
            middle = (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
            label = HELD if self.is_far(a, b) else FREE
            acting = [k for k, stretch in enumerate(on_edge) if stretch is not None and label == FREE and
                      any(distance(middle, p, q) < 1e-6 and distance(a, p, q) < 1e-6 and distance(b, p, q) < 1e-6
                          for p, q in stretch)]
            if acting:
                label = len(labels)
                # The ring runs against the outline, whose ice is on its right: outward is on its left.
                length = math.dist(a, b)
                outward = ((b[1] - a[1]) / length, -(b[0] - a[0]) / length)
                total = [0.0] * 5
                for k in acting:
                    load, whole = self.on_edge[k], sum(math.dist(p, q) for p, q in on_edge[k])
                    for c, value in enumerate((*load["in"], load["out"], load["moment"] * outward[0],
                                               load["moment"] * outward[1])):
                        total[c] += value / whole
                labels.append(total)
            steps = self.pieces(a, b)
            pieces += [(p, q, label) for p, q in zip(steps, steps[1:])]
        if self.is_split:
            for a, b in self.axis:
                steps = self.pieces((a, 0.0), (b, 0.0))
                label = CRACK if abs(a) < 1e-9 else AXIS
                pieces += [(p, q, label) for p, q in zip(steps, steps[1:])]
        return pieces, labels

    def stretch_of(self, load):
        points = self.edge.points
        i, j = sorted((self.edge.nearest(load["from"]), self.edge.nearest(load["to"])))
        if i == j:
            j = min(i + 1, len(points) - 1)
        return list(zip(points[i:j], points[i + 1:j + 1]))

    def is_far(self, a, b):
        points = self.edge.points
        low, high = points[0][1] - FAR, points[-1][1] + FAR
        return all(abs(p[0] - self.far) < 1e-9 for p in (a, b)) or a[1] == b[1] == low or a[1] == b[1] == high

    def write(self, path, stations):
        pieces, labels = self.segments()
        rows = [(self.sheet["ice"]["nu"],), (self.h,), (int(self.is_split),), (1,), (FAR,), (len(pieces),),
                (len(labels),), (len(self.discs),), (len(self.sizes),), (len(stations),)]
        rows += [(*a, *b, label) for a, b, label in pieces]
        rows += labels
        rows += [(*d["from"], max(d["radius"], 0.02), d["out"]) for d in self.discs]
        rows += [(*a, *b, radius, size, growth) for a, b, radius, size, growth in self.sizes]
        rows += [(s,) for s in stations]
        path.write_text("\n".join(" ".join(f"{v:.12g}" for v in row) for row in rows) + "\n")

    def fields(self):
        base = max([p[0] for p in self.outline if math.hypot(*p) < 3] + [0.0])
        end = min(self.line_end, base + 3.0)
        stations = [max(1e-6, end * i / 500 * (1 - 1e-9)) for i in range(501)]
        with tempfile.TemporaryDirectory() as folder:
            given, found = pathlib.Path(folder, "sheet"), pathlib.Path(folder, "fields")
            self.write(given, stations)
            run = subprocess.run(["FreeFem++", "-nw", "-ne", str(EDP), "-in", str(given), "-out", str(found)],
                                 capture_output=True, text=True,
                                 env={**os.environ, "FF_LOADPATH": "/usr/lib/freefem++"})
            if run.returncode != 0 or not found.exists():
                raise ValueError("FreeFem++: " + " ".join((run.stdout + run.stderr).split()[-40:]))
            head, *rows = found.read_text().splitlines()
        self.n_elements = int(head.split()[0])
        rows = [tuple(map(float, row.split())) for row in rows]
        return rows[:len(stations)], rows[len(stations):]


# ---- The largest stress at places of the contact's own load

def share(d):
    return math.exp(-((d / 1.75) ** 1.4))


class Rule:
    """Which places the contact's verdict looks at; lengths in metres."""

    def __init__(self, problem):
        self.h, self.l, self.l_ice = problem.sheet["ice"]["h"], problem.l, problem.l_ice
        self.split = problem.is_split
        self.loads = [(o["from"], o["to"], o["radius"], abs(o["out"]) + abs(o["moment"]) / self.l_ice, o["verdict"])
                      for o in problem.sheet["loads"]]
        outline = problem.sheet["outline"]
        self.edge = [(a, b) for a, b in zip(outline, outline[1:])
                     if distance((0.0, 0.0), a, b) < 2.5 * self.l + self.h]

    def away(self, load, p):
        if load[2] > 0:
            return max(0.0, math.dist(p, load[0]) - load[2])
        return distance(p, load[0], load[1])

    def owns(self, p):
        own = self.loads[0][3] * share(self.away(self.loads[0], p) / self.l_ice)
        for other in self.loads[1:]:
            d = self.away(other, p)
            if d < self.h or (other[4] and other[3] * share(d / self.l_ice) > own):
                return False
        return True

    def looks_beside(self, p):
        if math.hypot(*p) >= 2.5 * self.l or (self.split and abs(p[1]) < self.h):
            return False
        if self.away(self.loads[0], p) < self.h or not self.owns(p):
            return False
        return not any(distance(p, a, b) < self.h for a, b in self.edge)


def surface(side, row, h):
    m = [side * 6.0 / h ** 2 * v for v in row[2:5]]
    return [m[i] + row[5 + i] / h for i in range(3)]


def larger(s):
    return 0.5 * (s[0] + s[1]) + math.hypot(0.5 * (s[0] - s[1]), s[2])


LATTICE = [(i / 8, j / 8, (8 - i - j) / 8) for i in range(9) for j in range(9 - i)]


def inside_triangle(nodes):
    """Places in a triangle with their fields, from its corners and the middles of the sides opposite to them."""
    for a, b, c in LATTICE:
        shares = (a * (2 * a - 1), b * (2 * b - 1), c * (2 * c - 1), 4 * b * c, 4 * c * a, 4 * a * b)
        yield tuple(sum(s * node[k] for s, node in zip(shares, nodes)) for k in range(8))


def largest_beside(problem, rule, rows, best):
    """The best place, or a better one in a triangle near B."""
    def stress(row):
        return problem.unit * larger(surface(1, row, problem.h))

    triangles = [rows[i:i + 6] for i in range(0, len(rows), 6)]
    peaks = sorted(((max(map(stress, nodes)), nodes) for nodes in triangles), reverse=True)
    for peak, nodes in peaks:
        if 1.1 * peak < best[0]:  # no triangle has a hump so high between its nodes
            break
        for row in inside_triangle(nodes):
            value = stress(row)
            p = (row[0] * problem.l, row[1] * problem.l)
            if value > best[0] and rule.looks_beside(p):
                best = (value, p)
    return best


def largest(problem):
    """Largest stress over the strength, its place [m], and the stress along the edge at B over the strength."""
    line, inside = problem.fields()
    rule = Rule(problem)
    best = (0.0, (0.0, 0.0))
    for row in line:
        p = (row[0] * problem.l, 0.0)
        if row[0] < problem.h or not rule.owns(p):
            continue
        best = max(best, (problem.unit * max(larger(surface(1, row, problem.h)), surface(-1, row, problem.h)[0]), p))
    best = largest_beside(problem, rule, inside, best)
    at_b = line[0]
    bending, membrane = -6.0 / problem.h ** 2 * at_b[3], at_b[6] / problem.h
    radial = problem.unit * (problem.radial / problem.moments * bending + membrane)
    return best[0], best[1], radial


def solve(sheet, scale):
    answers = {}
    problem = Problem(sheet, False, scale)
    answers["whole"] = largest(problem)
    sheet["n"] = problem.n_elements
    if answers["whole"][2] > 0.75:
        value, place, _ = largest(Problem(sheet, True, scale))
        answers["split"] = (value, place, 0.0)
    return answers


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("file", type=pathlib.Path)
    parser.add_argument("--scale", type=float, default=1.0, help="of the element sizes")
    parser.add_argument("--only", nargs="*", help="names of sheets")
    parser.add_argument("--print", action="store_true", help="leave the file as it is")
    arguments = parser.parse_args()
    answers = {}
    for sheet in read(arguments.file):
        if arguments.only and sheet["name"] not in arguments.only:
            continue
        try:
            found = solve(sheet, arguments.scale)
        except ValueError as error:
            print(f"{sheet['name']}: {error}", file=sys.stderr)
            continue
        for kind, (ratio, place, radial) in found.items():
            others = " ".join(f"{k} {v[0]:.4f}" for k, v in sheet.get("answers", {}).items() if k.endswith(kind))
            print(f"{sheet['name']} {kind} {ratio:.5f} {place[0]:.3f} {place[1]:.3f} {radial:.5f}",
                  f"elements {sheet['n']} {others}", flush=True)
        answers[sheet["name"]] = found
        if not arguments.print:
            add_answers(arguments.file, {sheet["name"]: found})


if __name__ == "__main__":
    main()
