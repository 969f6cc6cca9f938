#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ralston and Lindqvist derived a second way on random inputs, edges among them: scipy_check.py DRIVER.

Ralston: the ride-up terms are not taken from their closed forms but integrated around the front half of the cone, the
elliptic integrals by quadrature; Lindqvist by a second transcription in terms of vectors of the hull's surface.
"""
import itertools
import json
import math
import subprocess
import sys
import unittest

import numpy as np
from scipy import integrate

GENERATOR = np.random.default_rng(1977)
G0 = 9.80665


def ralston_inputs():
    def one(slope, friction, tresca, downward):
        width = GENERATOR.uniform(2.0, 60.0)
        return {"slope": math.radians(slope), "friction": friction, "tresca": tresca, "downward": downward,
                "waterline_width": width, "end_width": GENERATOR.uniform(0.0, 1.0) * width,
                "thickness": GENERATOR.uniform(0.05, 3.0), "ride_thickness": GENERATOR.uniform(0.05, 6.0),
                "flexural_strength": GENERATOR.uniform(1e5, 1.5e6), "ice_density": GENERATOR.uniform(850, 930),
                "water_density": GENERATOR.uniform(995, 1030)}

    edges = [one(s, mu, t, d) for s, mu in itertools.product((20, 80), (0.0, 0.3)) for t in (True, False)
             for d in (True, False)]
    return edges + [one(GENERATOR.uniform(20, 80), GENERATOR.uniform(0, 0.3), bool(i % 2), bool(i // 2 % 2))
                    for i in range(50)]


def lindqvist_inputs():
    def one(stem, waterline, friction, speed):
        length = GENERATOR.uniform(20, 300)
        return {"stem_angle": math.radians(stem), "waterline_angle": math.radians(waterline), "friction": friction,
                "speed": speed, "length": length, "breadth": length * GENERATOR.uniform(0.12, 0.35),
                "draught": length * GENERATOR.uniform(0.03, 0.12), "thickness": GENERATOR.uniform(0.1, 2.5),
                "flexural_strength": GENERATOR.uniform(1e5, 1e6), "youngs_modulus": 10 ** GENERATOR.uniform(8, 10),
                "poisson_ratio": GENERATOR.uniform(0.25, 0.35), "ice_density": GENERATOR.uniform(850, 930),
                "water_density": GENERATOR.uniform(995, 1030)}

    edges = [one(s, w, mu, v) for s, w, mu, v in itertools.product((20, 80), (20, 80), (0.0, 0.3), (0.0, 8.0))]
    return edges + [one(GENERATOR.uniform(20, 80), GENERATOR.uniform(20, 80), GENERATOR.uniform(0, 0.3),
                        GENERATOR.uniform(0, 8)) for _ in range(50)]


def ralston(p):
    a, mu, h, w, sigma = p["slope"], p["friction"], p["thickness"], p["waterline_width"], p["flexural_strength"]
    sine, cosine = math.sin(a), math.cos(a)
    rho = p["water_density"] - p["ice_density"] if p["downward"] else p["ice_density"]
    yields = 2.711 if p["tresca"] else 3.422

    def around(f):
        """Integral over the quarter circle."""
        return integrate.quad(f, 0.0, 0.5 * math.pi, epsabs=0, epsrel=1e-12)[0]

    first = around(lambda t: 1.0 / math.sqrt(1.0 - (sine * math.sin(t)) ** 2))
    second = around(lambda t: math.sqrt(1.0 - (sine * math.sin(t)) ** 2))
    g_r = (sine + a / cosine) / (0.5 * math.pi * sine**2 + 2.0 * mu * a * cosine)
    slip = 1.0 - mu * g_r
    if slip <= 0.0:
        return None
    g = rho * G0 * w * w / (4.0 * sigma * h)
    x = 1.0 + 1.0 / math.sqrt(3.0 * g + 0.5 * yields)
    # Work per unit of sinking of the crack's hinges and lifted ice, divided by what the horizontal force does.
    hinges = (1.0 + yields * x * math.log(x)) / (x - 1.0)
    lifted = g * (x * x + x - 2.0)
    breaking = sigma * h * h * (hinges + lifted) * sine / (3.0 * cosine * slip)
    # Weight of the layer: area of the frustum's front half, from its generators' length.
    slant = 0.5 * (w - p["end_width"]) / cosine
    weight = rho * G0 * p["ride_thickness"] * slant * 0.5 * (w + p["end_width"])
    f = sine + mu * first * cosine
    ride = weight * (sine / cosine + mu * second - mu * f * g_r * cosine) / slip
    h_v = (f * cosine - mu * second) / (0.25 * math.pi * sine**2 + mu * a * cosine)
    breaking_up = breaking * h_v
    ride_up = weight * cosine * (0.5 * math.pi * cosine - mu * a - f * h_v) + ride * h_v
    return [breaking, ride, breaking_up, ride_up, breaking + ride, breaking_up + ride_up, x]


def lindqvist(p):
    phi, alpha, mu, h = p["stem_angle"], p["waterline_angle"], p["friction"], p["thickness"]
    # Normal angle psi by the hull's slopes: tan psi = tan phi / sin alpha.
    tan_psi = math.tan(phi) / math.sin(alpha)
    sec_psi = math.hypot(1.0, tan_psi)
    if mu * math.sin(phi) * sec_psi >= 1.0:
        return None
    crushing = (0.5 * p["flexural_strength"] * h**2 * (math.tan(phi) + mu * math.cos(phi) * sec_psi)
                / (1.0 - mu * math.sin(phi) * sec_psi))
    # Square of the characteristic length: sqrt(E h^3 / (12 (1 - nu^2) rho g)).
    length2 = math.sqrt(p["youngs_modulus"] * h**3 / (12.0 * (1.0 - p["poisson_ratio"] ** 2) * p["water_density"] * G0))
    bending = (27.0 / 64.0 * p["flexural_strength"] * p["breadth"] * h**3 / length2
               * (tan_psi + mu * math.cos(phi) / math.sin(alpha) * sec_psi) * (1.0 + sec_psi))
    b, t = p["breadth"], p["draught"]
    under_bow = t * math.cos(phi) / sec_psi * math.hypot(1.0 / math.sin(phi), 1.0 / math.tan(alpha))
    flat_bottom = 0.7 * p["length"] - t / math.tan(phi) - 0.25 * b / math.tan(alpha)
    pressure = (p["water_density"] - p["ice_density"]) * G0 * h
    submersion = pressure * b * (t * (b + t) / (b + 2.0 * t) + mu * (flat_bottom + under_bow))
    total = ((crushing + bending) * (1.0 + 1.4 * p["speed"] / math.sqrt(G0 * h))
             + submersion * (1.0 + 9.4 * p["speed"] / math.sqrt(G0 * p["length"])))
    return [crushing, bending, submersion, total]


class ClosedForms(unittest.TestCase):
    def compare(self, name, inputs, derive):
        applicable = 0
        for ours, given in zip(OURS[name], inputs, strict=True):
            expected = derive(given)
            self.assertEqual(ours is None, expected is None, given)
            if expected is None:
                continue
            applicable += 1
            # Terms of either sign may cancel: compared to the largest of them. Quadrature is good to 1e-12.
            np.testing.assert_allclose(ours, expected, rtol=1e-10, atol=1e-11 * max(map(abs, expected)), err_msg=str(given))
        self.assertGreater(applicable, 50)
        self.assertLess(applicable, len(inputs))  # some lock

    def test_ralston(self):
        self.compare("ralston", RALSTON, ralston)

    def test_lindqvist(self):
        self.compare("lindqvist", LINDQVIST, lindqvist)


if __name__ == "__main__":
    RALSTON, LINDQVIST = ralston_inputs(), lindqvist_inputs()
    done = subprocess.run([sys.argv.pop(1)], input=json.dumps({"ralston": RALSTON, "lindqvist": LINDQVIST}),
                          capture_output=True, text=True, check=True)
    OURS = json.loads(done.stdout)
    unittest.main(verbosity=1)
