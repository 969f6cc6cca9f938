# SPDX-License-Identifier: GPL-3.0-or-later
"""The polygon kernel: exact cuts, unions, repairs and fits on a grid of 2^-30 m, in metres."""
from . import (ContactRegion, ContractViolation, Cut, IceSheet, InputError, Map, Polygon, Repair, Trapezoid, Union,
               fit_trapezoid, read_map, repair, unite)

__all__ = ["ContactRegion", "ContractViolation", "Cut", "IceSheet", "InputError", "Map", "Polygon", "Repair", "Trapezoid",
           "Union", "fit_trapezoid", "read_map", "repair", "unite"]
