# SPDX-License-Identifier: GPL-3.0-or-later
"""Statistics on arrays, against NumPy where it has them too."""
import unittest

import numpy as np

import brash

X = np.random.default_rng(1).normal(3, 2, 4000)


class Statistics(unittest.TestCase):
    def test_moments_and_quantiles_are_numpy_s(self):
        m = brash.moments(X)
        np.testing.assert_allclose([m.mean, m.variance, m.maximum], [X.mean(), X.var(ddof=1), X.max()])
        np.testing.assert_allclose(brash.quantiles(X, [0.1, 0.5, 0.9]), np.quantile(X, [0.1, 0.5, 0.9]))
        counts, edges, outside = brash.histogram(X, 10, 0, 5)
        np.testing.assert_array_equal(counts, np.histogram(X, 10, (0, 5))[0])
        np.testing.assert_allclose(edges, np.linspace(0, 5, 11))
        self.assertEqual(counts.sum() + outside, len(X))

    def test_a_summary_of_white_noise(self):
        s = brash.summarise(X, dt=0.1)
        self.assertLess(s.mean_95.lower, 3)
        self.assertGreater(s.mean_95.upper, 3)
        # Half a step for white noise; the estimate's own deviation is some 5 % of it for 4000 samples.
        self.assertAlmostEqual(s.autocorrelation_time, 0.05, delta=0.015)
        self.assertEqual(brash.autocorrelation(X, 3)[0], 1)
        self.assertEqual(brash.autocorrelation_time(X, 0.1).tau, s.autocorrelation_time)

    def test_the_spectrum_integrates_to_the_variance(self):
        frequency, density, dof = brash.welch_spectrum(X, 0.1, 400)
        # 20 segments: the integral's deviation is some 3 %.
        integral = np.sum((density[1:] + density[:-1]) / 2 * np.diff(frequency))
        self.assertAlmostEqual(integral / X.var(), 1, delta=0.1)
        self.assertGreater(dof, 10)

    def test_peaks_and_extremes(self):
        index, value = brash.peaks_above([0, 2, 3, 0, 0, 5, 0], 1)
        self.assertEqual((index.tolist(), value.tolist()), ([2, 5], [3, 5]))
        self.assertEqual(brash.peaks_above([0, 2, 3, 0, 0, 5, 0], 1, separation=3)[0].tolist(), [5])
        self.assertEqual(brash.peaks_between_crossings([0, 2, 0, 3, 0, 1], 1)[1].tolist(), [2])
        maxima = brash.block_maxima(X, 40)
        np.testing.assert_array_equal(maxima, X.reshape(100, 40).max(1))
        with self.assertWarnsRegex(UserWarning, "fixed shape"):
            level = brash.return_level(brash.fit_gumbel(maxima), 50)
        self.assertLess(level.interval.lower, level.value)
        self.assertAlmostEqual(level.value, np.quantile(maxima, 0.98), delta=1)
        excess = brash.fit_generalised_pareto(X[X > 5], 5)
        self.assertGreater(brash.return_level(excess, duration=400, return_period=4000).value, X.max() - 1)
        with self.assertRaises(brash.NotApplicable):
            brash.fit_gumbel([1, 1, 1])

    def test_sobol_points_fill_the_cube_and_continue(self):
        points = brash.sobol(64, 3, seed=38)
        self.assertEqual(points.shape, (64, 3))
        np.testing.assert_array_equal(np.sort((points * 64).astype(int), axis=0), np.tile(np.arange(64)[:, None], 3))
        np.testing.assert_array_equal(brash.sobol(8, 3, seed=38), points[:8])
        for n, dimension in ((0, 3), (8, 41)):
            with self.assertRaisesRegex(brash.InputError, "is not allowed"):
                brash.sobol(n, dimension)

    def test_intervals_and_tests(self):
        interval = brash.bootstrap_interval(X[:200], np.median, n_resamples=300)
        self.assertTrue(interval.lower < np.median(X[:200]) < interval.upper)
        again = brash.bootstrap_interval(X[:200], np.median, n_resamples=300)
        self.assertEqual((interval.lower, interval.upper), (again.lower, again.upper))
        self.assertTrue(brash.mean_interval(X).lower < X.mean() < brash.batch_means_interval(X, 20).upper)
        self.assertAlmostEqual(brash.kendall([1, 2, 3, 4], [1, 3, 2, 4]).statistic, 2 / 3)
        self.assertLess(brash.jonckheere_terpstra([X[:50], X[50:100] + 2, X[100:150] + 4]).p_value, 1e-6)
        self.assertLess(brash.mann_whitney(X[:50], X[50:100] + 3).p_value, 1e-3)
        np.testing.assert_allclose(brash.holm([0.01, 0.04]), [0.02, 0.04])
        self.assertAlmostEqual(brash.compare_means(X[:50], X[:50] - 1).difference, 1)
        self.assertEqual(brash.compare_means(brash.summarise(X, 1), brash.summarise(X, 1)).difference, 0)

    def test_ranks_are_compared_in_n_log_n(self):
        whole = np.random.default_rng(1).integers(0, 40, (2, 300)).astype(float)  # with ties
        score = sum(np.sign(whole[0] - x) @ np.sign(whole[1] - y) for x, y in whole.T) / 2
        pairs = [(n * (n - 1) - sum(t * (t - 1) for t in np.unique(side, return_counts=True)[1])) for side in whole for n in (300,)]
        self.assertAlmostEqual(brash.kendall(*whole).statistic, 2 * score / np.sqrt(pairs[0] * pairs[1]), 12)
        many = np.random.default_rng(2).normal(size=1_000_000)  # all pairs would take an hour
        self.assertTrue(abs(brash.kendall(many[:500_000], many[500_000:]).statistic) < 0.01)
        self.assertLess(brash.mann_whitney(many[:500_000], many[500_000:] + 0.1).p_value, 1e-9)

    def test_an_exception_in_the_statistic_comes_through(self):
        with self.assertRaises(ZeroDivisionError):
            brash.bootstrap_interval([1, 2, 3], lambda x: 1 / 0)
        with self.assertRaises((TypeError, RuntimeError)):
            brash.bootstrap_interval([1, 2, 3], lambda x: "text")

    def test_complex_numbers_dates_durations_and_texts_are_refused_with_the_remedy(self):
        dates = np.array(["2026-01-01", "2026-01-02"], dtype="datetime64[s]")
        for values, said in ((np.array([1 + 2j, 2]), "complex numbers; take their real"), (dates, "dates; subtract"),
                             (dates - dates[0], "durations; divide"), (np.array(["1", "2"]), "texts; convert"),
                             (np.array([b"1", b"2"]), "texts; convert"), (["1", "2"], "texts; convert")):
            with self.subTest(said), self.assertRaisesRegex(brash.InputError, f"samples: .*{said}"):
                brash.moments(values)
        self.assertEqual(brash.moments([True, False]).mean, 0.5)
        self.assertEqual(brash.moments(np.array([1, 2], dtype=np.int8)).mean, 1.5)

    def test_masked_values_are_refused_with_the_remedy(self):
        masked = np.ma.masked_array([1.0, 2.0, 1e30, 3.0], mask=[False, False, True, False])
        with self.assertRaisesRegex(brash.InputError, r"without masked values.*samples\.compressed\(\)"):
            brash.moments(masked)
        self.assertEqual(brash.moments(masked.compressed()).mean, 2.0)
        self.assertEqual(brash.moments(np.ma.masked_array([1.0, 2.0, 3.0], mask=False)).mean, 2.0)

    def test_bad_arguments_are_refused(self):
        calls = {
            "empty": lambda: brash.summarise([], 1), "one": lambda: brash.moments([1]),
            "nan": lambda: brash.summarise([1, np.nan, 2], 1), "inf": lambda: brash.moments([np.inf, 1]),
            "2-d": lambda: brash.moments(np.zeros((2, 2))), "0-d": lambda: brash.moments(3.0),
            "text": lambda: brash.moments("abc"), "none": lambda: brash.moments(None),
            "dt": lambda: brash.summarise(X, 0), "dt nan": lambda: brash.summarise(X, np.nan),
            "levels": lambda: brash.quantiles(X, [2]), "lag": lambda: brash.autocorrelation(X, 10**9),
            "segment": lambda: brash.welch_spectrum(X, 1, 3), "long": lambda: brash.welch_spectrum(X, 1, 10**9),
            "bins": lambda: brash.histogram(X, 0, 0, 1), "many": lambda: brash.histogram(X, 10**12, 0, 1),
            "order": lambda: brash.histogram(X, 3, 1, 0), "separation": lambda: brash.peaks_above(X, 0, 0),
            "block": lambda: brash.block_maxima(X, 0), "period": lambda: brash.return_level(brash.fit_gumbel(X), 0.5),
            "confidence": lambda: brash.mean_interval(X, 1.5), "batches": lambda: brash.batch_means_interval(X, 1),
            "pairs": lambda: brash.kendall([1, 2], [1, 2, 3]), "groups": lambda: brash.jonckheere_terpstra([[1]]),
            "p": lambda: brash.holm([2]), "resamples": lambda: brash.bootstrap_interval([1, 2], np.mean, n_resamples=1)}
        for name, call in calls.items():
            with self.subTest(name), self.assertRaises(brash.InputError):
                call()


if __name__ == "__main__":
    unittest.main()
