# SPDX-License-Identifier: GPL-3.0-or-later
"""The surrogate of experiments/predictions and its Sobol indices against closed forms."""
import math
import os
import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(os.environ["BRASH_SOURCE_DIR"]) / "experiments" / "predictions"))

import brash
import surrogate


def ishigami(points):
    """a = 7, b = 0.1; exact indices below (T. Ishigami, T. Homma 1990)."""
    z = math.pi * (2.0 * points - 1.0)
    return np.sin(z[:, 0]) + 7.0 * np.sin(z[:, 1]) ** 2 + 0.1 * z[:, 2] ** 4 * np.sin(z[:, 0])


ISHIGAMI_FIRST, ISHIGAMI_TOTAL = [0.3139, 0.4424, 0.0], [0.5576, 0.4424, 0.2437]


class Indices(unittest.TestCase):
    # experiments/sensitivity/README.md, (U6), (U7), (U8)

    def test_saltelli_and_jansen_find_the_indices_of_ishigami(self):
        sample = brash.sobol(4096, 6, seed=1)
        first, total = surrogate.saltelli_jansen(ishigami, sample[:, :3], sample[:, 3:])
        np.testing.assert_allclose(first, ISHIGAMI_FIRST, atol=0.02)
        np.testing.assert_allclose(total, ISHIGAMI_TOTAL, atol=0.02)

    def test_a_polynomial_chaos_of_128_runs_finds_them_too(self):
        points = brash.sobol(128, 3, seed=1)
        chaos = surrogate.Chaos(points, ishigami(points), degree=9)
        first, total = chaos.indices()
        np.testing.assert_allclose(first, ISHIGAMI_FIRST, atol=0.01)
        np.testing.assert_allclose(total, ISHIGAMI_TOTAL, atol=0.01)
        # Its estimators agree with its own coefficients.
        sample = brash.sobol(2048, 6, seed=2)
        np.testing.assert_allclose(surrogate.saltelli_jansen(chaos, sample[:, :3], sample[:, 3:])[1], total, atol=0.02)

    def test_a_choice_has_polynomials_on_its_values_alone(self):
        middle = (np.arange(3) + 0.5) / 3
        values = surrogate.orthonormal(middle, 4, 3)
        np.testing.assert_allclose(values.T @ values / 3, np.diag([1, 1, 1, 0, 0]), atol=1e-12)
        # A choice of three values and an input of variance 1/12 with a factor of 6: shares of 14/9 and 3 of the variance.
        points = brash.sobol(32, 2, seed=1)
        y = np.array([0.0, 3.0, 1.0])[(3 * points[:, 0]).astype(int)] + 6.0 * points[:, 1]
        chaos = surrogate.Chaos(points, y, degree=3, choices=[3, 0])
        np.testing.assert_allclose(chaos.indices(), [[14 / 41, 27 / 41]] * 2, atol=1e-6)
        self.assertLess(surrogate.held_back_error(points, y, degree=3, choices=[3, 0]), 1e-9)
        self.assertGreater(surrogate.held_back_error(points, y, degree=3), 0.02)

    def test_the_error_on_held_back_samples_is_the_error_on_fresh_ones(self):
        points, fresh = brash.sobol(128, 3, seed=1), np.random.default_rng(3).random((2000, 3))
        chaos = surrogate.Chaos(points, ishigami(points), degree=4)
        true = np.mean((chaos(fresh) - ishigami(fresh)) ** 2) / np.var(ishigami(fresh))
        held = surrogate.held_back_error(points, ishigami(points), degree=4)
        self.assertLess(abs(math.log(held / true)), math.log(2.0))  # four fifths of the points, and another sample

    def test_noise_is_no_index(self):
        random = np.random.default_rng(4)
        points = brash.sobol(64, 10, seed=5)
        noise = random.normal(size=64)
        self.assertGreater(surrogate.held_back_error(points, noise, degree=2), 0.8)
        # A linear input of variance 1/12 under noise of a hundredth of it.
        values = points[:, 3] + 0.029 * noise
        self.assertGreater(surrogate.Chaos(points, values, degree=2).indices()[0][3], 0.95)
        errors = surrogate.jackknife_indices(points, values, degree=2)
        self.assertLess(errors[0][3], 0.05)

    def test_the_share_of_noise_comes_from_replicates(self):
        random = np.random.default_rng(6)
        groups = [[mean + random.normal(), mean + random.normal()] for mean in random.normal(0, 3, 4000)]
        self.assertAlmostEqual(surrogate.noise_share(groups), 1 / 10, delta=0.01)
        self.assertTrue(math.isnan(surrogate.noise_share([[1.0], [2.0]])))


if __name__ == "__main__":
    unittest.main()
