#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`brash stats` on histories of 2 x 10^5 samples against NumPy and SciPy: stats_scipy.py BRASH FOLDER."""
import json
import subprocess
import sys
import unittest
from pathlib import Path

import netCDF4
import numpy as np
from scipy import optimize, signal, stats

N, DT, SEGMENT, BLOCK = 200_000, 0.02, 40.0, 20.0
GENERATOR = np.random.default_rng(20240601)


def history():
    """A sawtooth with noise of two time scales, in newtons."""
    t = DT * np.arange(N)
    fast = signal.lfilter([1.0], [1.0, -0.9], GENERATOR.standard_normal(N))
    slow = signal.lfilter([0.02], [1.0, -0.999], GENERATOR.standard_normal(N))
    return 1.1e5 + 3e4 * signal.sawtooth(2 * np.pi * (0.7 * t + slow)) + 8e3 * np.exp(0.4 * fast)


def brash_stats(file, *arguments):
    spectrum = FOLDER / "spectrum.csv"
    done = subprocess.run([BRASH, "stats", str(file), "--json", "--spectrum", str(spectrum), *map(str, arguments)],
                          capture_output=True, text=True, check=True)
    return json.loads(done.stdout), np.genfromtxt(spectrum, delimiter=",", names=True)


class Even(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.x = history()
        file = FOLDER / "even.csv"
        with open(file, "w", encoding="utf-8") as out:
            out.write("time,Fx\n")
            out.writelines(f"{0.02 * i!r},{value!r}\n" for i, value in enumerate(cls.x.tolist()))
        cls.threshold = float(np.quantile(cls.x, 0.97))
        cls.ours, cls.spectrum = brash_stats(file, "--segment", SEGMENT, "--block", BLOCK, "--threshold", cls.threshold)

    def close(self, ours, theirs, rtol=1e-10):
        np.testing.assert_allclose(ours, theirs, rtol=rtol)

    def test_moments(self):
        o, x = self.ours, self.x
        self.close([o["n"], o["mean"], o["standard_deviation"], o["skewness"], o["excess_kurtosis"], o["minimum"], o["maximum"]],
                   [N, x.mean(), x.std(ddof=1), stats.skew(x), stats.kurtosis(x), x.min(), x.max()])

    def test_quantiles(self):
        self.close([self.ours[f"quantile_{q}"] for q in (50, 95, 99)], np.quantile(self.x, [0.50, 0.95, 0.99]))

    def test_spectrum_and_its_band(self):
        frequency, density = signal.welch(self.x, 1 / DT, nperseg=round(SEGMENT / DT))
        self.close(self.spectrum["frequency"], frequency)
        # Line 0 is what is left of the mean under the window: compared to the peak.
        np.testing.assert_allclose(self.spectrum["density"], density, rtol=1e-10, atol=1e-12 * density.max())
        segments = 1 + (N - round(SEGMENT / DT)) // (round(SEGMENT / DT) // 2)
        nu = 36 * segments**2 / (19 * segments - 1)
        self.close(self.spectrum["lower_95"][1:], density[1:] * nu / stats.chi2.ppf(0.975, nu), rtol=1e-8)

    def test_autocorrelation_time(self):
        d = self.x - self.x.mean()
        products = signal.correlate(d, d, method="fft")[N - 1 :]
        rho = products[: N // 2] / products[0]
        tau = 0.5 + np.cumsum(rho[1:])
        window = np.flatnonzero(np.arange(1, len(rho)) >= 5.0 * tau)[0] + 1
        self.close(self.ours["autocorrelation_time"], DT * tau[window - 1] * (1 + (2 * window + 1) / N), rtol=1e-9)

    def events(self):
        """Peaks and their samples between a rise above the dead band and a fall below it."""
        x = self.x
        noise = np.median(np.abs(np.diff(x, 2))) / (0.6744897501960817 * np.sqrt(6))
        level, half = x.mean(), min(2.5 * noise, 1.5 * x.std(ddof=1))
        upper = min(level + half, max(level, 0.5 * (level + x.max())))
        lower = max(level - half, min(level, 0.5 * (level + x.min())))
        peaks, inside, start, end = [], False, None, None
        for i in range(1, len(x)):
            if x[i - 1] <= level < x[i] and not inside:
                start = i
            if x[i - 1] > level >= x[i]:
                end = i
            if start is not None and x[i] > upper:
                inside = True
            if inside and x[i] < lower:
                peaks.append(start + int(np.argmax(x[start:end])))
                inside, start = False, None
        return np.array(peaks)

    def test_load_events(self):
        peaks = self.x[self.events()]
        self.assertEqual(self.ours["peaks"]["count"], len(peaks))
        self.close(self.ours["peaks"]["mean"], peaks.mean())

    def test_gumbel_fit_of_block_maxima(self):
        block = round(BLOCK / DT)
        maxima = self.x[: N // block * block].reshape(-1, block).max(axis=1)
        ours = self.ours["block_maxima"]
        self.assertEqual(ours["blocks"], len(maxima))
        # SciPy solves the same equation to about 1e-7.
        self.close([ours["location"], ours["scale"]], stats.gumbel_r.fit(maxima), rtol=1e-6)
        self.close(ours["level"], stats.gumbel_r.ppf(1 - BLOCK / 3600, ours["location"], ours["scale"]))

    def test_generalised_pareto_fit_of_peaks(self):
        ours = self.ours["extremes"]
        peaks = self.events()
        peaks = peaks[self.x[peaks] > self.threshold]
        clusters = np.split(peaks, np.flatnonzero(DT * np.diff(peaks) >= ours["separation"] - 1e-9) + 1)
        excesses = np.array([self.x[c].max() for c in clusters]) - self.threshold
        self.assertEqual(ours["peaks"], len(excesses))

        def cost(p):
            return min(1e9, stats.genpareto.nnlf((p[0], 0.0, np.exp(p[1])), excesses))

        best = optimize.minimize(cost, [0.0, np.log(excesses.mean())], method="Nelder-Mead",
                                 options={"xatol": 1e-10, "fatol": 1e-12, "maxiter": 5000})
        # A maximum of the likelihood is flat: its place is known to about the root of the likelihood's rounding.
        np.testing.assert_allclose([ours["shape"], np.log(ours["scale"])], best.x, rtol=0, atol=5e-6)
        level = stats.genpareto.isf(N * DT / (3600 * len(excesses)), ours["shape"], self.threshold, ours["scale"])
        self.close(ours["level"], level, rtol=1e-9)

    def test_netcdf_gives_the_same(self):
        file = FOLDER / "even.nc"
        with netCDF4.Dataset(file, "w") as data:
            data.createDimension("sample", N)
            data.createVariable("station", "i4", ())
            data.createVariable("force", "f8", ("sample",))[:] = self.x
            times = data.createVariable("time", "f8", ("sample",))
            times.units = "milliseconds since 2024-01-01 00:00:00"
            times[:] = 20.0 * np.arange(N)
        ours, spectrum = brash_stats(file, "--column", "force", "--segment", SEGMENT, "--block", BLOCK, "--threshold",
                                     self.threshold)
        self.assertTrue(ours["sampling"]["even"])
        for key in ("mean", "standard_deviation", "skewness", "quantile_99", "autocorrelation_time"):
            self.close(ours[key], self.ours[key], rtol=1e-12)
        np.testing.assert_allclose(spectrum["density"], self.spectrum["density"], rtol=1e-9)


class Packed(unittest.TestCase):
    def test_a_packed_variable_with_missing_values_and_uneven_times(self):
        steps = GENERATOR.uniform(0.5, 1.5, 2000)
        times, x = np.cumsum(steps), 1e3 * GENERATOR.standard_normal(2000)
        x[500:520] = np.nan
        file = FOLDER / "packed.nc"
        with netCDF4.Dataset(file, "w") as data:
            data.createDimension("t", 2000)
            data.createVariable("t", "f8", ("t",))[:] = times
            force = data.createVariable("force", "i2", ("t",), fill_value=-32768)
            force.scale_factor, force.add_offset = 0.5, 100.0
            force[:] = np.ma.masked_invalid(x)
        with netCDF4.Dataset(file) as data:
            stored = np.ma.filled(data["force"][:], np.nan)
        ours, _ = brash_stats(file)
        known = ~np.isnan(stored)
        t, x = times[known], stored[known]
        d = np.diff(t)
        gap = d > 5 * np.median(d)
        step = d[~gap].mean()
        half = 0.5 * np.where(gap, step, d)
        weights = np.r_[0.5 * step, half] + np.r_[half, 0.5 * step]
        self.assertEqual(ours["sampling"]["missing_values"], 20)
        self.assertEqual(len(ours["sampling"]["gaps"]), 1)
        np.testing.assert_allclose(ours["mean"], np.average(x, weights=weights), rtol=1e-10)
        np.testing.assert_allclose(ours["duration"], weights.sum(), rtol=1e-10)


if __name__ == "__main__":
    FOLDER = Path(sys.argv.pop(2))
    FOLDER.mkdir(parents=True, exist_ok=True)
    BRASH = sys.argv.pop(1)
    unittest.main(verbosity=1)
