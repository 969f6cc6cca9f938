# SPDX-License-Identifier: GPL-3.0-or-later
"""The surge of a moored floater: a linear oscillator, and spectra over several fields of floes."""
import re
import subprocess

import numpy as np
from scipy import signal, stats


def natural_period(brash, case):
    """The period [s] that `brash check` calls surge; docs/theory/structures.md, (B12)."""
    text = subprocess.run([str(brash), "check", str(case)], check=True, capture_output=True, text=True).stdout
    return float(re.search(r"natural period\s+([\d.]+) s, mostly surge", text)[1])


def oscillator(load, dt, period, damping, stiffness):
    """The way [m] of a mass on a spring under a load [N], shape=(n,), from rest: m x'' + c x' + k x = load, in steps of dt.

    The mass follows from the natural period [s] and the stiffness [N/m]. The load changes linearly within a step.
    """
    mass = stiffness * (period / (2.0 * np.pi)) ** 2
    system = signal.TransferFunction([1.0], [mass, damping, stiffness])
    return signal.lsim(system, load, np.arange(len(load)) * dt)[1]


def pooled_spectrum(brash_module, records, dt, segment):
    """Frequency [Hz], mean density over the records, and the bounds of its 95 % interval, shape=(n,) each.

    Records are independent, so the degrees of freedom of Welch's estimates add up; docs/theory/statistics.md, (S7).
    """
    estimates = [brash_module.welch_spectrum(record, dt, round(segment / dt)) for record in records]
    density = np.mean([estimate[1] for estimate in estimates], axis=0)
    freedom = np.sum([estimate[2] for estimate in estimates], axis=0)
    return (estimates[0][0], density, density * freedom / stats.chi2.ppf(0.975, freedom),
            density * freedom / stats.chi2.ppf(0.025, freedom))
