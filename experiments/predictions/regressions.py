# SPDX-License-Identifier: GPL-3.0-or-later
"""Regressions beside the predictions whose constants are recalled; `brash loads` has the sourced ones. SI."""

GRAVITY = 9.80665


def edwards(*, width, thickness, flexural_strength, water_density=1025.0):
    """Peak horizontal load of an upward cone of 45 deg [N], SI. Edwards and Croasdale 1976, constants recalled."""
    return 1.6 * flexural_strength * thickness**2 + 6.0 * water_density * GRAVITY * width * thickness**2


def ship_breaking_length(characteristic_length, speed):
    """Breaking length of ships [m]: 0.32 l_c (1 - 0.144 s/m V), constants recalled."""
    return 0.32 * characteristic_length * (1.0 - 0.144 * speed)
