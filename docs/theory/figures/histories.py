# SPDX-License-Identifier: GPL-3.0-or-later
"""statistics.md: autocorrelation time, return levels and spectrum of a process that is known exactly."""
import brash
import matplotlib.pyplot as plt
import numpy as np

from style import GREY, SERIES

DT, MEMORY, N = 0.05, 0.4, 20_000                      # [s], [s], samples
KEPT = np.exp(-DT / MEMORY)


def process(seed):
    """A first-order process of deviation 1."""
    noise = np.random.default_rng(seed).standard_normal(N) * np.sqrt(1 - KEPT**2)
    state = np.empty(N)
    state[0] = noise[0] / np.sqrt(1 - KEPT**2)
    for i in range(1, N):
        state[i] = KEPT * state[i - 1] + noise[i]
    return state


def correlation(axis, samples):
    found = brash.autocorrelation_time(samples, DT)
    lag = np.arange(81)
    exact = DT * (0.5 + KEPT / (1 - KEPT))
    axis.set_title(f"autocorrelation: $\\tau$ = {found.tau:.3f} s, exact {exact:.3f} s (S2)", loc="left")
    axis.plot(DT * lag, KEPT**lag, color=GREY, lw=3, alpha=0.5, label="exact")
    axis.plot(DT * lag, brash.autocorrelation(samples, 80), color=SERIES[0], lw=1.2, label="estimated")
    axis.axvline(DT * found.window, color=SERIES[1], ls="--", lw=1, label="window $W$")
    axis.set(xlabel="lag [s]", ylabel=r"$\rho$")
    axis.legend()


def extremes(axis, samples):
    """The fit of one history beside the maxima of a hundred others."""
    block = round(20 * MEMORY / DT)
    maxima = np.sort(brash.block_maxima(samples, block))
    many = np.sort(np.concatenate([brash.block_maxima(process(100 + i), block) for i in range(100)]))
    fit, periods = brash.fit_gumbel(maxima), np.logspace(0.1, 3.5, 40)
    levels = [brash.return_level(fit, period) for period in periods]
    axis.set_title("block maxima, Gumbel (S5)", loc="left")
    axis.fill_between(periods, [x.interval.lower for x in levels], [x.interval.upper for x in levels], color=SERIES[0],
                      alpha=0.2, lw=0, label="95 % interval")
    axis.semilogx(periods, [x.value for x in levels], color=SERIES[0], label=f"fit of {maxima.size} blocks")
    for values, style in ((many, {"color": GREY, "lw": 3, "alpha": 0.5, "label": "100 histories"}),
                          (maxima, {"color": "black", "marker": ".", "ls": "", "ms": 3, "label": "its maxima"})):
        axis.plot(1 / (1 - (np.arange(values.size) + 0.5) / values.size), values, **style)
    axis.set(xlabel="return period [blocks]", ylabel="level / deviation", xlim=(1, 3500))
    axis.legend()


def spectrum(axis, samples):
    frequency, density, freedom = brash.welch_spectrum(samples, DT, 512)
    # Quantiles of chi2 over its degrees of freedom by Wilson and Hilferty: within a per cent at these degrees.
    low, high = ((1 - 2 / (9 * freedom) + z * np.sqrt(2 / (9 * freedom)))**3 for z in (-1.96, 1.96))
    exact = 2 * DT * (1 - KEPT**2) / np.abs(1 - KEPT * np.exp(-2j * np.pi * frequency * DT))**2
    shown = slice(1, -1)
    axis.set_title("Welch's spectrum (S7)", loc="left")
    axis.fill_between(frequency[shown], (density / high)[shown], (density / low)[shown], color=SERIES[0], alpha=0.3, lw=0,
                      label="95 % band")
    axis.loglog(frequency[shown], density[shown], color=SERIES[0], lw=0.8, label="estimated")
    axis.loglog(frequency[shown], exact[shown], color=GREY, lw=3, alpha=0.5, label="exact")
    axis.set(xlabel="frequency [Hz]", ylabel="density [1/Hz]")
    axis.legend()


def draw():
    samples = process(3)
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.2), constrained_layout=True)
    correlation(axes[0], samples)
    extremes(axes[1], samples)
    spectrum(axes[2], samples)
    return figure
