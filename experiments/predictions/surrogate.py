# SPDX-License-Identifier: GPL-3.0-or-later
"""Sobol indices: a polynomial chaos that stands in for the program, and the estimators that need no surrogate.

Inputs are independent and uniform on the unit cube. y = sum_a c_a psi_a(x) with products psi_a of Legendre polynomials that
are orthonormal there. Then the variance is the sum of c_a^2 over all a but 0, and each index is a part of it
(B. Sudret, Reliab. Eng. Syst. Saf. 93 (2008) 964).
"""
import itertools

import numpy as np
from numpy.polynomial import legendre

MOST_TERMS_SHARE = 0.5  # of the number of points: a fit with more terms than that is no longer checked by them


def exponents(n_inputs, degree, interaction=2):
    """Multi-indices of total degree up to `degree`, at most `interaction` inputs in each; shape=(n_terms, n_inputs)."""
    found = [np.zeros(n_inputs, dtype=int)]
    for size in range(1, min(interaction, n_inputs) + 1):
        for inputs in itertools.combinations(range(n_inputs), size):
            for powers in itertools.product(range(1, degree + 1), repeat=size):
                if sum(powers) <= degree:
                    row = np.zeros(n_inputs, dtype=int)
                    row[list(inputs)] = powers
                    found.append(row)
    return np.array(found)


def basis(points, terms):
    """Values of the orthonormal products at points of the unit cube; shape=(n_points, n_terms)."""
    degree = int(terms.max(initial=0))
    one = legendre.legvander(2.0 * np.asarray(points) - 1.0, degree) * np.sqrt(2.0 * np.arange(degree + 1) + 1.0)
    values = np.ones((len(points), len(terms)))
    for j in range(terms.shape[1]):
        values *= one[:, j, terms[:, j]]
    return values


class Chaos:
    """A sparse polynomial chaos: terms enter one after the other, and their number is chosen by the leave-one-out error."""

    def __init__(self, points, values, degree=4, interaction=2):
        points, values = np.asarray(points, dtype=float), np.asarray(values, dtype=float)
        self.terms = exponents(points.shape[1], degree, interaction)
        matrix = basis(points, self.terms)
        best, self.error = [0], np.inf
        chosen, rest = [0], values - values.mean()
        size = np.linalg.norm(matrix, axis=0)
        for _ in range(max(1, int(MOST_TERMS_SHARE * len(values)))):
            error, fit = self.leave_one_out(matrix[:, chosen], values)
            if error < self.error:
                best, self.error = list(chosen), error
            rest = values - fit
            gain = np.abs(matrix.T @ rest) / size
            gain[chosen] = -1.0
            if len(chosen) == len(self.terms):
                break
            chosen.append(int(np.argmax(gain)))
        self.terms = self.terms[best]
        self.coefficients = np.linalg.lstsq(basis(points, self.terms), values, rcond=None)[0]

    @staticmethod
    def leave_one_out(matrix, values):
        """Error over the variance, corrected for small samples (Blatman and Sudret, J. Comput. Phys. 230 (2011) 2345), and fit."""
        q, r = np.linalg.qr(matrix)
        fit = q @ (q.T @ values)
        leverage = np.minimum(np.sum(q**2, axis=1), 1.0 - 1e-9)
        n, p = matrix.shape
        inverse = np.linalg.pinv(r.T @ r / n)
        correction = n / (n - p) * (1.0 + np.trace(inverse) / n) if n > p else np.inf
        variance = values.var(ddof=1)
        return correction * np.mean(((values - fit) / (1.0 - leverage)) ** 2) / (variance or 1.0), fit

    def __call__(self, points):
        return basis(np.asarray(points), self.terms) @ self.coefficients

    def indices(self):
        """First-order and total Sobol indices, shape=(n_inputs,) each."""
        parts = self.coefficients**2 * self.terms.any(axis=1)
        variance = parts.sum()
        n = self.terms.shape[1]
        if variance == 0.0:
            return np.zeros(n), np.zeros(n)
        alone = (self.terms > 0).sum(axis=1) == 1
        first = np.array([parts[alone & (self.terms[:, j] > 0)].sum() for j in range(n)])
        total = np.array([parts[self.terms[:, j] > 0].sum() for j in range(n)])
        return first / variance, total / variance


def held_back_error(points, values, folds=5, seed=1, **options):
    """Mean square error over the variance on samples that the whole fit, its choice of terms included, has not seen."""
    points, values = np.asarray(points), np.asarray(values)
    order = np.random.default_rng(seed).permutation(len(values))
    missed = np.empty(len(values))
    for part in np.array_split(order, folds):
        kept = np.setdiff1d(order, part)
        missed[part] = values[part] - Chaos(points[kept], values[kept], **options)(points[part])
    return float(np.mean(missed**2) / values.var(ddof=1))


def saltelli_jansen(function, a, b):
    """First-order and total Sobol indices of `function(points)` from two independent samples, shape=(n, n_inputs).

    n (n_inputs + 2) evaluations. First order: Saltelli et al., Comput. Phys. Commun. 181 (2010) 259. Total: Jansen, ibid. 117
    (1999) 35.
    """
    at_a, at_b = function(a), function(b)
    variance = np.var(np.concatenate([at_a, at_b]), ddof=1)
    first, total = np.empty(a.shape[1]), np.empty(a.shape[1])
    for j in range(a.shape[1]):
        mixed = a.copy()
        mixed[:, j] = b[:, j]
        at_mixed = function(mixed)
        first[j] = np.mean(at_b * (at_mixed - at_a)) / variance
        total[j] = 0.5 * np.mean((at_a - at_mixed) ** 2) / variance
    return first, total


def jackknife_indices(points, values, groups=10, seed=1, **options):
    """Standard errors of first and total indices: the fit is repeated without each of `groups` parts; shape=(2, n_inputs).

    A bootstrap would draw points twice, and a leave-one-out error does not see a fit to a point whose twin it keeps.
    """
    points, values = np.asarray(points), np.asarray(values)
    order = np.random.default_rng(seed).permutation(len(values))
    found = []
    for part in np.array_split(order, groups):
        kept = np.setdiff1d(order, part)
        found.append(Chaos(points[kept], values[kept], **options).indices())
    found = np.array(found)
    return np.sqrt((groups - 1) / groups * np.sum((found - found.mean(axis=0)) ** 2, axis=0))


def noise_share(groups):
    """Variance between replicates of a point over the variance of all runs; nan without replicates."""
    within = [np.var(group, ddof=1) for group in groups if len(group) > 1]
    return float(np.mean(within) / np.var(np.concatenate(groups), ddof=1)) if within else float("nan")
