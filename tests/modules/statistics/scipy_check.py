# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the statistics room with NumPy and SciPy on the same samples: scipy_check.py DRIVER."""
import itertools
import json
import subprocess
import sys
import unittest

import numpy as np
from scipy import optimize, signal, stats

GENERATOR = np.random.default_rng(20240501)
DT = 0.02


def history():
    """A sawtooth-like load in newtons with noise, skewed, about 1e5."""
    noise = signal.lfilter([1.0], [1.0, -0.9], GENERATOR.standard_normal(5000))
    return 1.1e5 + 3e4 * signal.sawtooth(2 * np.pi * 0.7 * DT * np.arange(5000)) + 8e3 * np.exp(0.4 * noise)


X = history()
LEVELS = [0.0, 0.01, 0.25, 0.5, 0.9, 0.95, 0.99, 1.0]
MAXIMA = stats.gumbel_r.rvs(loc=2e5, scale=3e4, size=60, random_state=GENERATOR)
THRESHOLD = 1.5e5
PEAKS = {
    name: THRESHOLD + stats.genpareto.rvs(shape, scale=2e4, size=400, random_state=GENERATOR)
    for name, shape in {"bounded": -0.3, "exponential": 0.0, "heavy": 0.4}.items()
}
EXACT = np.arange(20.0), np.arange(20.0) + 8 * GENERATOR.standard_normal(20)
LONG = np.arange(80.0), 0.02 * np.arange(80.0) + GENERATOR.standard_normal(80)
TIED = np.round(3 * GENERATOR.standard_normal(40)), np.round(3 * GENERATOR.standard_normal(40))
PAIRS = {"exact": EXACT, "falling": (EXACT[0], -EXACT[0]), "long": LONG, "tied": TIED}
ORIGIN, LAW_AT = 1.0e5, 2.4e5
LAW_PEAKS = ORIGIN + stats.weibull_min.rvs(1.7, scale=6e4, size=80, random_state=GENERATOR)
SAMPLES = {
    "plain": (GENERATOR.standard_normal(12) + 1.0, 3.0 * GENERATOR.standard_normal(25)),
    "tied": (np.round(2 * GENERATOR.standard_normal(30)), np.round(2 * GENERATOR.standard_normal(20) + 1)),
}
GROUPS = [list(np.round(GENERATOR.standard_normal(6 + i) + 0.3 * i, 1)) for i in range(4)]
OTHER = 1.3 * history()[:4000]  # another length and deviation
# Steps that vary by three to one, with two gaps.
TIMES = np.cumsum(GENERATOR.uniform(0.01, 0.03, 4000))
KEPT = np.ones(4000, bool)
KEPT[1000:1200] = KEPT[2500:2900] = False
TIMES, VALUES = TIMES[KEPT], X[:4000][KEPT]
SEGMENT = 240
HISTOGRAM = [float(np.quantile(X, 0.05)), float(X.max())]
PEAK_LEVEL, SEPARATION = float(np.quantile(X, 0.8)), 15


def run_driver(path):
    data = {
        "history": X.tolist(), "other": OTHER.tolist(), "dt": DT,
        "uneven": {"times": TIMES.tolist(), "values": VALUES.tolist(), "segment": SEGMENT, "levels": LEVELS}, "levels": LEVELS, "histogram": HISTOGRAM,
        "threshold": PEAK_LEVEL, "separation": SEPARATION,
        "maxima": MAXIMA.tolist(), "peaks": {k: v.tolist() for k, v in PEAKS.items()}, "pareto_threshold": THRESHOLD,
        "law_peaks": LAW_PEAKS.tolist(), "law_origin": ORIGIN, "law_at": LAW_AT,
        "pairs": {k: [list(a), list(b)] for k, (a, b) in PAIRS.items()},
        "samples": {k: [list(a), list(b)] for k, (a, b) in SAMPLES.items()}, "groups": GROUPS,
    }
    done = subprocess.run([path], input=json.dumps(data), capture_output=True, text=True, check=True)
    return json.loads(done.stdout)


class History(unittest.TestCase):
    def setUp(self):
        self.ours = OURS["history"]

    def close(self, ours, theirs, rtol=1e-10, atol=0.0):
        np.testing.assert_allclose(ours, theirs, rtol=rtol, atol=atol)

    def test_moments(self):
        self.close(self.ours["moments"], [X.mean(), X.var(ddof=1), stats.skew(X), stats.kurtosis(X), X.min(), X.max()])

    def test_quantiles(self):
        self.close(self.ours["quantiles"], np.quantile(X, LEVELS))

    def test_histogram(self):
        counts, edges = np.histogram(X, 17, HISTOGRAM)
        self.assertEqual(self.ours["histogram"]["counts"], counts.tolist())
        self.assertEqual(self.ours["histogram"]["outside"], len(X) - counts.sum())
        self.close(self.ours["histogram"]["edges"], edges)

    def test_welch_spectrum(self):
        for segment in (256, 105):
            frequency, density = signal.welch(X, 1 / DT, nperseg=segment)
            ours = self.ours[f"spectrum_{segment}"]
            self.close(ours["frequency"], frequency)
            # Line 0 is what is left of the mean under the window; lines far below the peak cancel: compare to the peak.
            self.close(ours["density"], density, rtol=1e-10, atol=1e-12 * density.max())

    def test_spectrum_interval(self):
        segments = 1 + (len(X) - 256) // 128
        nu = 36 * segments**2 / (19 * segments - 1)
        self.close(self.ours["degrees_of_freedom"], nu)
        self.close(self.ours["spectrum_factors"], nu / stats.chi2.ppf([0.975, 0.025], nu), rtol=1e-8)

    def test_autocorrelation(self):
        d = X - X.mean()
        full = signal.correlate(d, d, method="direct")[len(d) - 1 :]
        self.close(self.ours["autocorrelation"], full[:301] / full[0], atol=1e-12)

    def test_peaks_above_a_threshold(self):
        above = np.flatnonzero(X > PEAK_LEVEL)
        clusters = np.split(above, np.flatnonzero(np.diff(above) > SEPARATION) + 1)
        self.assertEqual(self.ours["peaks_above"], [int(c[np.argmax(X[c])]) for c in clusters])

    def test_peaks_between_crossings(self):
        level = X.mean()
        up = np.flatnonzero((X[:-1] <= level) & (X[1:] > level)) + 1
        self.assertGreater(len(up), 20)
        self.assertEqual(self.ours["peaks_between"], [int(a + np.argmax(X[a:b])) for a, b in zip(up, up[1:])])

    def test_low_pass(self):
        b, a = signal.butter(2, 3.0, fs=1 / DT)
        once = signal.lfilter(b, a, X, zi=signal.lfilter_zi(b, a) * X[0])[0]
        self.close(self.ours["low_pass"]["causal"], once)
        higher = np.arctan(np.tan(np.pi * 3.0 * DT) / (np.sqrt(2) - 1)**0.25) / (np.pi * DT)
        self.close(self.ours["low_pass"]["zero"], signal.filtfilt(*signal.butter(2, higher, fs=1 / DT), X))

    def test_block_maxima(self):
        self.close(self.ours["block_maxima"], X[: len(X) // 77 * 77].reshape(-1, 77).max(axis=1))

    def test_intervals_of_the_mean(self):
        self.close(self.ours["mean_interval"], stats.t.interval(0.9, len(X) - 1, X.mean(), stats.sem(X)))
        batches = X[len(X) % 13 :].reshape(13, -1).mean(axis=1)
        self.close(self.ours["batch_means"], stats.t.interval(0.95, 12, batches.mean(), stats.sem(batches)))


class Uneven(unittest.TestCase):
    """A history with gaps and steps that vary: what the room does with it, done again with NumPy and SciPy."""

    def setUp(self):
        self.ours = OURS["uneven"]
        steps = np.diff(TIMES)
        self.at_gap = steps > 5 * np.median(steps)
        self.cuts = np.flatnonzero(self.at_gap) + 1
        self.step = steps[~self.at_gap].mean()
        half = 0.5 * np.where(self.at_gap, self.step, steps)
        self.weights = np.r_[0.5 * self.step, half] + np.r_[half, 0.5 * self.step]

    def pieces(self):
        for t, x in zip(np.split(TIMES, self.cuts), np.split(VALUES, self.cuts)):
            grid = t[0] + self.step * np.arange(int((t[-1] - t[0]) / self.step + 1e-3) + 1)
            yield np.interp(grid, t, x)

    def close(self, ours, theirs, rtol=1e-10, atol=0.0):
        np.testing.assert_allclose(ours, theirs, rtol=rtol, atol=atol)

    def test_sampling(self):
        self.assertFalse(self.ours["even"])
        self.assertEqual(len(self.ours["gaps"]), 2)
        self.close(self.ours["gaps"], [[TIMES[i - 1], TIMES[i]] for i in self.cuts])
        self.close([self.ours["step"], self.ours["duration"]], [self.step, self.weights.sum()])
        self.close(self.ours["weights"], self.weights)

    def test_weighted_moments(self):
        w, x = self.weights / self.weights.sum(), VALUES
        mean = w @ x
        m2, m3, m4 = (w @ (x - mean) ** k for k in (2, 3, 4))
        variance = m2 * len(x) / (len(x) - 1)
        self.close(self.ours["moments"], [mean, variance, m3 / m2**1.5, m4 / m2**2 - 3])
        self.close(self.ours["summary"], [mean, np.sqrt(variance), m3 / m2**1.5])

    def test_weighted_quantiles(self):
        order = np.argsort(VALUES)
        w = self.weights[order]
        reached = np.r_[0.0, np.cumsum(0.5 * (w[1:] + w[:-1]))]
        self.close(self.ours["quantiles"], np.interp(LEVELS, reached / reached[-1], VALUES[order]))

    def test_pieces_are_interpolated(self):
        for ours, theirs in zip(self.ours["pieces"], self.pieces(), strict=True):
            self.close(ours, theirs)

    def test_spectrum_averages_the_segments_of_all_pieces(self):
        segments = []
        for piece in self.pieces():
            for start in range(0, len(piece) - SEGMENT + 1, SEGMENT // 2):
                frequency, density = signal.welch(piece[start : start + SEGMENT], 1 / self.step, nperseg=SEGMENT)
                segments.append(density)
        self.close(self.ours["spectrum"]["frequency"], frequency)
        density = np.mean(segments, axis=0)
        self.close(self.ours["spectrum"]["density"], density, atol=1e-12 * density.max())

    def test_autocorrelation_leaves_out_pairs_across_gaps(self):
        pieces = list(self.pieces())
        everything = np.concatenate(pieces)
        d = [piece - everything.mean() for piece in pieces]
        n = len(everything)
        expected = []
        for lag in range(201):
            products = np.concatenate([p[lag:] * p[: len(p) - lag] for p in d])
            expected.append(products.mean() * (n - lag) / n)
        self.close(self.ours["autocorrelation"], np.array(expected) / expected[0], atol=1e-12)


class Spectra(unittest.TestCase):
    def test_two_spectra(self):
        ours = OURS["spectra"]
        frequency, a = signal.welch(X, 1 / DT, nperseg=250)
        _, b = signal.welch(OTHER, 1 / DT, nperseg=250)
        frequency, a, b = frequency[1:], a[1:], b[1:]
        np.testing.assert_allclose(ours["ratio"], a / b, rtol=1e-9)

        def freedom(n):
            segments = 1 + (n - 250) // 125
            return 36 * segments**2 / (19 * segments - 1)

        band = stats.f.ppf([0.025, 0.975], freedom(len(X)), freedom(len(OTHER)))
        np.testing.assert_allclose(ours["band"], band, rtol=1e-7)  # GSL inverts the distribution to about 1e-8

        def outside(ratio):
            return np.mean((ratio < band[0]) | (ratio > band[1]))

        np.testing.assert_allclose([ours["outside"], ours["shape_outside"]],
                                   [outside(a / b), outside(a / b * b.sum() / a.sum())], rtol=1e-9)
        np.testing.assert_allclose(ours["correlation"], np.corrcoef(np.log(a), np.log(b))[0, 1], rtol=1e-9)
        np.testing.assert_allclose(ours["mean_frequency"], [frequency @ a / a.sum(), frequency @ b / b.sum()], rtol=1e-9)


class Extremes(unittest.TestCase):
    def test_gumbel_fit_has_the_greatest_likelihood(self):
        ours = OURS["extremes"]["gumbel"]
        location, scale = stats.gumbel_r.fit(MAXIMA)
        # SciPy solves the same equation to about 1e-7.
        np.testing.assert_allclose([ours["location"], ours["scale"]], [location, scale], rtol=1e-6)
        self.assertLessEqual(stats.gumbel_r.nnlf((ours["location"], ours["scale"]), MAXIMA),
                             stats.gumbel_r.nnlf((location, scale), MAXIMA) + 1e-9)
        np.testing.assert_allclose(ours["level"]["value"],
                                   stats.gumbel_r.ppf(0.99, ours["location"], ours["scale"]), rtol=1e-10)

    def test_generalised_pareto_fit_has_the_greatest_likelihood(self):
        for name, sample in PEAKS.items():
            ours = OURS["extremes"]["pareto"][name]
            y = sample - THRESHOLD

            def cost(p):
                return min(1e9, stats.genpareto.nnlf((p[0], 0.0, np.exp(p[1])), y))

            start = [ours["shape"], np.log(ours["scale"])]
            best = min((optimize.minimize(cost, [s, np.log(y.mean())], method="Nelder-Mead",
                                          options={"xatol": 1e-10, "fatol": 1e-12, "maxiter": 5000})
                        for s in (-0.2, 0.01, 0.5)), key=lambda r: r.fun)
            self.assertLessEqual(cost(start), best.fun + 1e-8)
            # The minimum is flat: its place is known to about the root of the rounding of the likelihood, 4e3 x 1e-16.
            np.testing.assert_allclose(start, best.x, rtol=0, atol=2e-6)
            level = stats.genpareto.isf(1000.0 / (5000.0 * len(y)), ours["shape"], THRESHOLD, ours["scale"])
            np.testing.assert_allclose(ours["level"]["value"], level, rtol=1e-9)

    def test_return_level_interval_is_that_of_the_profile_likelihood(self):
        for name, sample in PEAKS.items():
            ours = OURS["extremes"]["pareto"][name]
            xi, sigma, y = ours["shape"], ours["scale"], sample - THRESHOLD
            m = len(y) / 1000.0 * 5000.0
            allowed = stats.genpareto.nnlf((xi, 0.0, sigma), y) + 0.5 * stats.chi2.ppf(0.95, 1)

            def excess_cost(x):
                def cost(shape):
                    # Beyond the end of a bounded tail the likelihood vanishes; a finite cost keeps the search going.
                    return min(1e9, stats.genpareto.nnlf((shape, 0.0, x * shape / np.expm1(shape * np.log(m))), y))

                return optimize.minimize_scalar(cost, bounds=(xi - 0.4, xi + 0.6), method="bounded",
                                                options={"xatol": 1e-8}).fun - allowed

            level = ours["level"]["value"] - THRESHOLD
            rate = stats.norm.ppf(0.975) * sigma * m**xi / np.sqrt(len(y))
            lower = optimize.brentq(excess_cost, 0.4 * level, level)
            upper = optimize.brentq(excess_cost, level, 4.0 * level)
            expected = [level - np.hypot(level - lower, rate), level + np.hypot(upper - level, rate)]
            # The ends follow from a flat maximum, found to 1e-7 in the shape.
            np.testing.assert_allclose(np.array(ours["level"]["interval"]) - THRESHOLD, expected, rtol=1e-6)


class Laws(unittest.TestCase):
    """Fits by SciPy's likelihoods, and intervals by a profile that is computed another way."""
    Q = 1e-3
    FROZEN = {
        "Gumbel": lambda p: stats.gumbel_r(p[0], p[1]),
        "GEV": lambda p: stats.genextreme(-p[2], p[0], p[1]),
        "Pareto": lambda p: stats.genpareto(p[2], ORIGIN, p[1]),
        "Weibull": lambda p: stats.weibull_min(p[2], ORIGIN, p[1]),
        "Rayleigh": lambda p: stats.rayleigh(ORIGIN, p[1]),
    }
    # Which of location, scale, shape are fitted.
    FREE = {"Gumbel": (0, 1), "GEV": (0, 1, 2), "Pareto": (1, 2), "Weibull": (1, 2), "Rayleigh": (1,)}

    def sample(self, law):
        return MAXIMA if law in ("Gumbel", "GEV") else LAW_PEAKS

    def cost(self, law, parameters):
        if parameters[1] <= 0 or parameters[2] < -0.98:
            return 1e9
        with np.errstate(all="ignore"):
            total = -np.sum(self.FROZEN[law](parameters).logpdf(self.sample(law)))
        return total if np.isfinite(total) else 1e9

    def fitted(self, law):
        ours = OURS["laws"][law]
        return [ours["location"], ours["scale"], ours["shape"]]

    def test_the_likelihood_is_greatest(self):
        for law, free in self.FREE.items():
            start = self.fitted(law)

            def cost(steps):
                p = list(start)
                for i, step in zip(free, steps):
                    p[i] += step * (start[1] if i < 2 else 1.0)
                return self.cost(law, p)

            best = optimize.minimize(cost, np.full(len(free), 0.05), method="Nelder-Mead",
                                     options={"xatol": 1e-9, "fatol": 1e-10, "maxiter": 5000})
            # A maximum is flat: its place is known to about the root of the rounding.
            np.testing.assert_allclose(best.x, 0.0, atol=2e-5, err_msg=law)

    def test_level_and_exceedance(self):
        for law in self.FREE:
            ours, frozen = OURS["laws"][law], self.FROZEN[law](self.fitted(law))
            np.testing.assert_allclose(ours["level"]["value"], frozen.isf(self.Q), rtol=1e-10, err_msg=law)
            np.testing.assert_allclose(ours["exceedance"], frozen.sf(LAW_AT), rtol=1e-9, err_msg=law)

    def test_anderson_darling(self):
        for law in self.FREE:
            x = np.sort(self.sample(law))
            frozen, n = self.FROZEN[law](self.fitted(law)), len(x)
            i = np.arange(1, n + 1)
            squared = -n - np.mean((2 * i - 1) * (frozen.logcdf(x) + frozen.logsf(x[::-1])))
            np.testing.assert_allclose(OURS["laws"][law]["anderson_darling"], squared, rtol=1e-9, err_msg=law)

    def test_the_ends_of_the_interval_have_the_limit_of_the_likelihood_ratio(self):
        for law, free in self.FREE.items():
            start, sample = self.fitted(law), self.sample(law)
            found = OURS["laws"][law]["level"]
            level, (lower, upper) = found["value"], found["interval"]
            n, freedom = len(sample), len(sample) - len(free)
            allowed = 0.5 * n * np.log1p(stats.t.ppf(0.975, freedom)**2 / freedom)

            def profile(x):
                """Cost of level x at the best other parameters: the one that makes the level follows from them."""
                def cost(others):
                    p = list(start)
                    if law in ("Gumbel", "GEV"):
                        p[1] = start[1] * np.exp(others[0])
                        p[2] = others[1] if law == "GEV" else 0.0
                        p[0] = 0.0
                        p[0] = x - self.FROZEN[law](p).isf(self.Q)
                    else:
                        p[2], p[1] = (others[0] if law != "Rayleigh" else 0.0), 1.0
                        if law == "Weibull" and p[2] <= 0:
                            return 1e9
                        p[1] = (x - ORIGIN) / (self.FROZEN[law](p).isf(self.Q) - ORIGIN)
                    return self.cost(law, p)

                first = {"Gumbel": [0.0], "Rayleigh": [0.0]}.get(law, [start[2]])
                if law == "GEV":  # far levels want heavier tails than the fit has
                    first = min(itertools.product((-0.6, -0.3, 0.0), np.linspace(-0.4, 0.9, 14)), key=cost)
                return optimize.minimize(cost, first, method="Nelder-Mead",
                                         options={"xatol": 1e-7, "fatol": 1e-9, "maxiter": 2000}).fun

            least = self.cost(law, start)
            frozen = self.FROZEN[law](start)
            by_number = 0.0
            if law not in ("Gumbel", "GEV"):
                share = 0.1
                slope = (frozen.isf(self.Q / (1 + share)) - frozen.isf(self.Q)) / np.log1p(share)
                by_number = stats.norm.ppf(0.975) * slope / np.sqrt(n)
            for end in (lower, upper):
                reach = np.sqrt((end - level)**2 - by_number**2) * np.sign(end - level)
                # The search ends at a ten-thousandth of the level.
                np.testing.assert_allclose(profile(level + reach) - least, allowed, rtol=0.02, err_msg=f"{law} {end}")


class Tests(unittest.TestCase):
    def test_kendall(self):
        for name, (x, y) in PAIRS.items():
            ours, theirs = OURS["tests"]["kendall"][name], stats.kendalltau(x, y)
            np.testing.assert_allclose([ours["statistic"], ours["p"]], [theirs.statistic, theirs.pvalue], rtol=1e-9)

    def test_jonckheere_terpstra(self):
        ours = OURS["tests"]["jonckheere"]
        order = np.repeat(np.arange(len(GROUPS)), [len(g) for g in GROUPS])
        values = np.concatenate(GROUPS)
        self.assertLess(len(np.unique(values)), len(values))  # ties are tried
        np.testing.assert_allclose(ours["p"], stats.kendalltau(order, values, method="asymptotic").pvalue, rtol=1e-9)
        # Without ties the p-value is exact: see the unit tests.
        # J is the sum of Mann-Whitney counts; its distribution under shuffling.
        pairs = sum(len(a) * len(b) for i, a in enumerate(GROUPS) for b in GROUPS[i + 1 :])

        def j(v):
            split = np.split(v, np.cumsum([len(g) for g in GROUPS])[:-1])
            return sum((np.subtract.outer(b, a) > 0).sum() + 0.5 * (np.subtract.outer(b, a) == 0).sum()
                       for i, a in enumerate(split) for b in split[i + 1 :])

        shuffled = np.array([j(GENERATOR.permutation(values)) for _ in range(4000)])
        z = (j(values) - 0.5 * pairs) / shuffled.std()
        np.testing.assert_allclose(ours["statistic"], z, rtol=0.05)  # four errors of a deviation from 4000 shuffles

    def test_two_samples(self):
        for name, (a, b) in SAMPLES.items():
            ours = OURS["tests"]["means"][name]
            theirs = stats.ttest_ind(a, b, equal_var=False)
            np.testing.assert_allclose([ours["test"]["statistic"], ours["test"]["p"]],
                                       [theirs.statistic, theirs.pvalue], rtol=1e-9)
            half = ours["difference"] / theirs.statistic * stats.t.ppf(0.975, self.freedom(a, b))
            # GSL inverts Student's distribution to about 1e-8.
            np.testing.assert_allclose(ours["interval"], [ours["difference"] - half, ours["difference"] + half], rtol=3e-8)
            u = stats.mannwhitneyu(a, b, method="asymptotic")
            ours = OURS["tests"]["mann_whitney"][name]
            np.testing.assert_allclose([ours["statistic"], ours["p"]], [u.statistic, u.pvalue], rtol=1e-9)

    def test_kolmogorov_smirnov(self):
        for name, (a, b) in SAMPLES.items():
            ours, theirs = OURS["tests"]["kolmogorov_smirnov"][name], stats.ks_2samp(a, b, method="exact")
            np.testing.assert_allclose([ours["statistic"], ours["p"]], [theirs.statistic, theirs.pvalue], rtol=1e-9)

    @staticmethod
    def freedom(a, b):
        va, vb = a.var(ddof=1) / len(a), b.var(ddof=1) / len(b)
        return (va + vb) ** 2 / (va**2 / (len(a) - 1) + vb**2 / (len(b) - 1))


if __name__ == "__main__":
    OURS = run_driver(sys.argv.pop(1))
    unittest.main(verbosity=1)
