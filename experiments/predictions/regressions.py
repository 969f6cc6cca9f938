# SPDX-License-Identifier: GPL-3.0-or-later
"""Regressions that stand beside the predictions: fits to measurements, with no law of mechanics to be tested.

Forces in N; the sources give kN and degrees.
"""
import math

GRAVITY = 9.80665


def riska(*, length, breadth, draught, midbody, bow_length, stem_angle, thickness, speed):
    """Resistance of a ship in level ice [N]; lengths in m, stem angle in rad, speed in m/s. Riska et al. 1997.

    R = C1 + C2 v, as quoted by Hu and Zhou 2016. Constants of Baltic merchant ships.
    """
    L, B, T, h, phi = length, breadth, draught, thickness, math.degrees(stem_angle)
    still = (0.23 * B * midbody * h / (2 * T / B + 1)
             + (1 + 0.021 * phi) * (4.58 * B * h**2 + 1.47 * bow_length * h**2 + 0.29 * B * bow_length * h))
    moving = ((1 + 0.063 * phi) * (18.9 * h**1.5 + 0.67 * B * h) + 1.55 * h * (1 + 1.2 * T / B) * B**2 / math.sqrt(L))
    return 1e3 * (still + moving * speed)


def jeong(*, breadth, draught, thickness, speed, flexural_strength, ice_density, water_density, buoyancy_factor=0.499):
    """Resistance of a ship in level ice [N], SI. Jeong 2010, as quoted by Hu and Zhou 2016.

    buoyancy_factor: C_B, so that C_B (rho_w - rho_i) is the source's 37.4 kg/m3 at a difference of 75 kg/m3.
    """
    B, T, h, v = breadth, draught, thickness, speed
    froude = v / math.sqrt(GRAVITY * h)
    strength = v / math.sqrt(flexural_strength * h / (ice_density * B))
    inertia = ice_density * B * h * v**2
    return (buoyancy_factor * (water_density - ice_density) * GRAVITY * h * B * T + 1.11 * froude**-1.157 * inertia
            + 2.73 * strength**-1.54 * inertia)


def edwards(*, width, thickness, flexural_strength, water_density=1025.0):
    """Peak horizontal load of an upward cone of 45 deg [N], SI. Edwards and Croasdale 1976, constants recalled."""
    return 1.6 * flexural_strength * thickness**2 + 6.0 * water_density * GRAVITY * width * thickness**2


def ship_breaking_length(characteristic_length, speed):
    """Breaking length of ships [m]: 0.32 l_c (1 - 0.144 s/m V), constants recalled."""
    return 0.32 * characteristic_length * (1.0 - 0.144 * speed)
