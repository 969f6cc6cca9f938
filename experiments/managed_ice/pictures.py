# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the floater in managed ice."""

import figures
import study
from figures import BLUE, GREY, ORANGE, RED, plt

AXES = {"ice.thickness": ("thickness [m], floes of 10 m", {"field__size__median": 10.0}),
        "field.size.median": ("median size [m], ice of 1 m", {"ice__thickness": 1.0})}
ROWS = (("mean load [kN]", "horizontal.mean", 1e3, BLUE), ("offset, mean and largest [m]", "mean_offset", 1.0, BLUE))


def draw_means(rows, folder):
    """Load and offset over thickness and size: fields as dots, means with their 95 % intervals."""
    figure, axes = plt.subplots(2, 2, figsize=(8, 5.5), sharex="col", sharey="row", constrained_layout=True)
    for column, (key, (label, fixed)) in enumerate(AXES.items()):
        for row, (title, name, unit, colour) in enumerate(ROWS):
            figures.means(axes[row, column], study.groups(rows, key, name, **fixed), key, colour, "mean", unit)
            axes[row, column].set_ylabel(title if column == 0 else "")
        figures.means(axes[1, column], study.groups(rows, key, "largest_offset", **fixed), key, RED, "largest", 1.0)
        axes[1, column].set_xlabel(label)
    axes[1, 0].legend(fontsize=8)
    for axis in axes[:, 0]:
        axis.set_ylim(bottom=0.0)
    figures.save(figure, folder, "managed_ice")


def spectrum_panel(axis, spectra, names, period, label, lowest=0.01, highest=0.5):
    for name, colour, text in names:
        frequency, density, lower, upper = spectra[name]
        shown = (frequency >= lowest) & (frequency <= highest)
        axis.loglog(frequency[shown], density[shown], color=colour, lw=1.2, label=text)
        axis.fill_between(frequency[shown], lower[shown], upper[shown], color=colour, alpha=0.25, lw=0)
    axis.axvline(1.0 / period, color=GREY, ls="--", lw=1)
    axis.set(xlabel="frequency [Hz]", ylabel=label)
    axis.legend(fontsize=8)


def draw_spectra(cases, spectra, period, folder, shown=4):
    """Offset over time of the first fields; spectra of load and offset with their 95 % bands, and the natural period."""
    figure = plt.figure(figsize=(9, 6), constrained_layout=True)
    grid = figure.add_gridspec(2, 2, height_ratios=(1, 1.5))
    top = figure.add_subplot(grid[0, :])
    for number, case in enumerate(cases[:shown]):
        top.plot(case.history["time"], case.away, lw=0.9, color=plt.cm.viridis(number / shown))
    top.axvline(cases[0].start, color=GREY, ls=":", lw=1)
    top.set(xlabel="time [s]", ylabel="offset [m]", xlim=(0, cases[0].history["time"][-1]))
    spectrum_panel(figure.add_subplot(grid[1, 0]), spectra, [("load", BLUE, "load of the ice")], period, "density [N²/Hz]")
    spectrum_panel(figure.add_subplot(grid[1, 1]), spectra,
                   [("offset", BLUE, "offset"), ("oscillator", ORANGE, "linear oscillator under the load")], period,
                   "density [m²/Hz]")
    figures.save(figure, folder, "spectra")
