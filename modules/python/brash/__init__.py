# SPDX-License-Identifier: GPL-3.0-or-later
"""How a structure breaks level ice. SI units and radians throughout; x along the structure's track, z upwards."""

try:
    import numpy as _numpy  # noqa: F401

    from ._brash import *  # noqa: F401,F403
    from ._brash import __version__  # noqa: F401
    from .history import History  # noqa: F401
except ModuleNotFoundError as _error:
    import sys as _sys

    raise ImportError(f"brash is built for Debian's Python with python3-numpy, /usr/bin/python3; {_sys.executable} "
                      f"{_sys.version.split()[0]} has {str(_error)[0].lower()}{str(_error)[1:]}") from _error

# They are named as they are imported, also in tracebacks.
for _value in list(globals().values()):
    if getattr(_value, "__module__", "") == "brash._brash":
        _value.__module__ = "brash"
