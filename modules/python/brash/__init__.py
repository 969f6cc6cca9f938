# SPDX-License-Identifier: GPL-3.0-or-later
"""How a structure breaks level ice. SI units and radians throughout; x along the structure's track, z upwards."""

from ._brash import *  # noqa: F401,F403
from ._brash import __version__  # noqa: F401
