#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws trapezoid-fit.svg: the recognition (Fig. 3) and the re-identification (Fig. 4) of the free edge.

usage: trapezoid_fit.py BRASH OUT.svg       BRASH is the built command; the trapezoids drawn are what `brash fit` finds
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

REACH = 3.0
SCALE = 55.0  # pixels a metre
ICE, WATER, EDGE, FIT = "#e8f1f8", "#ffffff", "#2b5c8a", "#c4411a"


def cusp(y0, y1, x0, x1, bulge, n=10):
    """An arc from (x0, y0) to (x1, y1) whose middle lies `bulge` deeper in the ice."""
    points = []
    for i in range(1, n + 1):
        t = i / n
        points.append((x0 + t * (x1 - x0) + 4 * bulge * t * (1 - t), y0 + t * (y1 - y0)))
    return points


def regular_edge():
    """From +y to -y, ice at larger x: a tooth between cusps."""
    edge = [(0.75, 6.0), (0.75, 3.6)]
    edge += cusp(3.6, 2.2, 0.75, 0.3, 0.45)
    edge += cusp(2.2, 0.3, 0.3, 0.0, 0.75)
    edge += [(0.02, 0.1), (0.0, -0.3)]
    edge += cusp(-0.3, -2.0, 0.0, 0.25, 0.8)
    edge += cusp(-2.0, -3.5, 0.25, 0.7, 0.35)
    return edge + [(0.7, -6.0)]


def distorted_edge():
    """The same with an overhang on one side and a slot on the other."""
    edge = [(0.8, 6.0), (0.8, 1.7), (1.5, 1.5), (1.7, 0.9), (1.2, 0.55), (0.75, 1.1), (0.3, 0.9), (0.0, 0.4)]
    edge += [(0.0, -0.4), (0.5, -0.9), (0.75, -1.3), (2.6, -1.2), (2.6, -1.35), (0.8, -1.5), (0.95, -2.4), (0.8, -3.5)]
    return edge + [(0.8, -6.0)]


def sheet_text(edge):
    ring = edge + [(20.0, -6.0), (20.0, 6.0)]
    return "POLYGON ((" + ", ".join(f"{x} {y}" for x, y in ring + ring[:1]) + "))\n"


def fit(brash, edge, contact_length):
    with tempfile.TemporaryDirectory() as folder:
        sheet = pathlib.Path(folder) / "sheet.wkt"
        sheet.write_text(sheet_text(edge))
        command = [brash, "fit", "--sheet", str(sheet), "--at", "0,0", "--towards", "1,0", "--reach", str(REACH),
                   "--contact-length", str(contact_length)]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def envelope(edge, n=600):
    """The smallest x of the edge over y, as the structure sees it."""
    points = []
    for i in range(n + 1):
        y = REACH - 2 * REACH * (i + 0.5) / (n + 1)
        crossings = [x0 + (y - y0) / (y1 - y0) * (x1 - x0)
                     for (x0, y0), (x1, y1) in zip(edge, edge[1:]) if (y0 - y) * (y1 - y) < 0]
        points.append((min(crossings), y))
    return points


class Panel:
    """One drawing: y to the right of the page is -y of the frame, x (into the ice) up."""

    def __init__(self, left, top, title):
        self.left, self.top, self.items = left, top, []
        self.text(-REACH, 3.25, title, anchor="start", weight="bold")

    def at(self, x, y):
        return f"{self.left - y * SCALE:.1f},{self.top - x * SCALE:.1f}"

    def path(self, points, style, close=False):
        self.items.append(f'<path d="M {" L ".join(self.at(*p) for p in points)}{" Z" if close else ""}" {style}/>')

    def text(self, y, x, text, anchor="middle", weight="normal", colour="#222"):
        px, py = self.left + y * SCALE, self.top - x * SCALE
        self.items.append(f'<text x="{px:.1f}" y="{py:.1f}" text-anchor="{anchor}" font-weight="{weight}" '
                          f'fill="{colour}">{text}</text>')

    def window(self, edge, clip):
        self.items.append(f'<clipPath id="{clip}"><rect x="{self.left - REACH * SCALE}" y="{self.top - 3 * SCALE}" '
                          f'width="{2 * REACH * SCALE}" height="{3.6 * SCALE}"/></clipPath>')
        self.items.append(f'<g clip-path="url(#{clip})">')
        self.path(edge + [(9, -6), (9, 6)], f'fill="{ICE}" stroke="none"', close=True)
        self.path(edge, f'fill="none" stroke="{EDGE}" stroke-width="2"')
        self.items.append("</g>")
        self.path([(0, REACH), (REACH, REACH), (REACH, -REACH), (0, -REACH)],
                  'fill="none" stroke="#999" stroke-dasharray="2 4"', close=True)

    def between(self, profile, shape):
        self.path(profile + shape[::-1], f'fill="{FIT}" fill-opacity="0.18" stroke="none" fill-rule="evenodd"', True)

    def trapezoid(self, shape):
        self.path(shape, f'fill="none" stroke="{FIT}" stroke-width="2.5" stroke-dasharray="8 4"')

    def point_b(self):
        x, y = self.at(0, 0).split(",")
        self.items.append(f'<circle cx="{x}" cy="{y}" r="4" fill="#222"/>')
        self.text(0, -0.28, "B")
        self.text(0, -0.62, "structure comes from here &#8593;", colour="#777")


def outline(found):
    b, c, run = found["b"], found["c"], found["b"] * math.tan(found["theta"] / 2)
    return [(b, REACH), (b, c / 2 + run), (0, c / 2), (0, -c / 2), (b, -c / 2 - run), (b, -REACH)]


def caption(found):
    again = ", re-identified" if found["reidentified"] else ""
    return (f'b = {found["b"]:.2f} m, c = {found["c"]:.2f} m, &#952; = {found["theta_deg"]:.0f}&#176;, '
            f'error {found["error"]:.3f}{again}')


def main():
    brash, target = sys.argv[1:]
    regular, distorted = regular_edge(), distorted_edge()
    first, second = fit(brash, regular, 0.4), fit(brash, distorted, 0.8)

    left = Panel(190, 235, "Recognition (Fig. 3)")
    left.window(regular, "window3")
    left.between(envelope(regular), outline(first))
    left.trapezoid(outline(first))
    left.point_b()
    left.text(0, -1.0, caption(first))
    left.text(0, 2.4, "ice", colour="#557")

    right = Panel(570, 235, "Re-identification (Fig. 4)")
    right.window(distorted, "window4")
    right.path(envelope(distorted), 'fill="none" stroke="#111" stroke-width="1.5"')
    right.between(envelope(distorted), outline(second))
    right.trapezoid(outline(second))
    right.point_b()
    right.text(0, -1.0, caption(second))
    right.text(0, 2.4, "ice", colour="#557")

    legend = "".join(f'<text x="380" y="{y}" text-anchor="middle" fill="#555">{text}</text>' for y, text in (
        (308, "blue: free edge; black: what the structure sees; dotted: window"),
        (325, "dashed red: fitted trapezoid; shaded: the area that the fit makes least")))
    body = "\n".join(left.items + right.items + [legend])
    pathlib.Path(target).write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 38 760 300" font-family="sans-serif" font-size="12">\n'
        f'<rect y="38" width="760" height="300" fill="{WATER}"/>\n{body}\n</svg>\n')


if __name__ == "__main__":
    main()
