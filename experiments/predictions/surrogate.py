# SPDX-License-Identifier: GPL-3.0-or-later
"""Sobol indices: a polynomial chaos that stands in for the program, and the estimators that need no surrogate.

Inputs are independent and uniform on the unit cube. y = sum_a c_a psi_a(x) with products psi_a of polynomials that are
orthonormal there: Legendre's over a range, Gram's over equally likely choices. Then the variance is the sum of c_a^2 over all a but
0, and each index is a part of it (B. Sudret, Reliab. Eng. Syst. Saf. 93 (2008) 964).
"""
import itertools

import numpy as np
from numpy.polynomial import legendre

MOST_TERMS_SHARE = 0.5  # of the number of points: a fit with more terms than that is no longer checked by them
FOLDS = 10


def exponents(choices, degree, interaction=2):
    """Multi-indices of total degree up to `degree`, at most `interaction` inputs in each; shape=(n_terms, n_inputs).

    choices: for each input the number of its choices, or 0 for a range. m choices bear polynomials up to the degree m - 1.
    """
    most = [min(degree, m - 1) if m else degree for m in choices]
    found = [np.zeros(len(choices), dtype=int)]
    for size in range(1, min(interaction, len(choices)) + 1):
        for inputs in itertools.combinations(range(len(choices)), size):
            for powers in itertools.product(*(range(1, most[j] + 1) for j in inputs)):
                if sum(powers) <= degree:
                    row = np.zeros(len(choices), dtype=int)
                    row[list(inputs)] = powers
                    found.append(row)
    return np.array(found)


def orthonormal(places, degree, n_choices):
    """Polynomials of one input at its places in the unit interval; shape=(n_points, degree + 1), zero beyond what choices bear."""
    if n_choices == 0:
        return legendre.legvander(2.0 * places - 1.0, degree) * np.sqrt(2.0 * np.arange(degree + 1) + 1.0)
    q, r = np.linalg.qr(np.vander(np.linspace(-1.0, 1.0, n_choices), increasing=True))
    values = np.zeros((n_choices, max(degree + 1, n_choices)))
    values[:, :n_choices] = q * np.sign(np.diag(r)) * np.sqrt(n_choices)
    return values[(places * n_choices).astype(int), :degree + 1]


def basis(points, terms, choices):
    """Values of the orthonormal products at points of the unit cube; shape=(n_points, n_terms)."""
    degree, points = int(terms.max(initial=0)), np.asarray(points)
    values = np.ones((len(points), len(terms)))
    for j, n_choices in enumerate(choices):
        values *= orthonormal(points[:, j], degree, n_choices)[:, terms[:, j]]
    return values


def fits(matrix, values):
    """(terms, coefficients) of fits that grow by a term each, the one that the rest of the last fit asks for most."""
    chosen, size = [0], np.linalg.norm(matrix, axis=0)
    for _ in range(max(1, min(int(MOST_TERMS_SHARE * len(values)), matrix.shape[1]))):
        coefficients = np.linalg.lstsq(matrix[:, chosen], values, rcond=None)[0]
        yield list(chosen), coefficients
        gain = np.abs(matrix.T @ (values - matrix[:, chosen] @ coefficients)) / np.maximum(size, 1e-12)
        gain[chosen] = -1.0
        chosen.append(int(np.argmax(gain)))


def left_out_errors(matrix, values):
    """Mean square error of fits of 1, 2, ... terms on parts of the samples that they leave out, their choice of terms included."""
    parts = np.array_split(np.random.default_rng(1).permutation(len(values)), FOLDS)
    errors = []
    for part in parts:
        kept = np.setdiff1d(np.arange(len(values)), part)
        errors.append([np.sum((matrix[np.ix_(part, chosen)] @ coefficients - values[part]) ** 2)
                       for chosen, coefficients in fits(matrix[kept], values[kept])])
    shortest = min(len(error) for error in errors)
    return np.sum([error[:shortest] for error in errors], axis=0) / len(values)


class Chaos:
    """A sparse polynomial chaos. Cross-validation chooses its degree and the number of its terms."""

    def __init__(self, points, values, degree=4, interaction=2, choices=None):
        points, values = np.asarray(points, dtype=float), np.asarray(values, dtype=float)
        self.choices = [0] * points.shape[1] if choices is None else list(choices)
        least = np.inf
        for most in range(1, degree + 1):
            terms = exponents(self.choices, most, interaction)
            matrix = basis(points, terms, self.choices)
            errors = left_out_errors(matrix, values)
            if errors.min() < least:
                least = errors.min()
                chosen, self.coefficients = next(itertools.islice(fits(matrix, values), int(errors.argmin()), None))
                self.terms = terms[chosen]

    def __call__(self, points):
        return basis(points, self.terms, self.choices) @ self.coefficients

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

    A bootstrap would draw points twice, and an error on samples left out does not see a fit to a point whose twin it keeps.
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
