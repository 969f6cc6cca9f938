#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stress intensity of an edge crack in a rectangular plate: an independent solution by finite elements.

Plane stress, nine-node rectangles on a grid that is graded to the crack's tip, half of the plate by symmetry. A pair of
forces P opens the crack at its mouth. A push N at the mouth drives the plate along the crack, and the inertia of the plate
holds against it. K follows from the opening of the crack near its tip and, by another way, from the J integral.
"""
import numpy as np
import scipy.sparse as sparse
import scipy.sparse.linalg

POISSON = 0.3
GAUSS, WEIGHTS = np.polynomial.legendre.leggauss(3)


def shapes(s, t):
    """Shape functions of the nine nodes and their derivatives; node 3 j + i lies at (i - 1, j - 1)."""
    one = lambda x: np.array([0.5 * x * (x - 1), 1 - x * x, 0.5 * x * (x + 1)])
    slope = lambda x: np.array([x - 0.5, -2 * x, x + 0.5])
    return (np.outer(one(t), one(s)).ravel(), np.outer(one(t), slope(s)).ravel(), np.outer(slope(t), one(s)).ravel())


def graded(length, least, ratio=1.6):
    """Distances from 0 to `length`, geometric from `least` on."""
    steps = [least]
    while sum(steps) < length:
        steps.append(steps[-1] * ratio)
    places = np.concatenate([[0.0], np.cumsum(steps)])
    return places * (length / places[-1])


def both_ends(length, least):
    """From 0 to `length`, graded to both."""
    half = graded(0.5 * length, least)
    return np.concatenate([half, length - half[-2::-1]])


class Plate:
    """Length 1 along the crack, breadth `aspect`; E = 1, thickness 1; the crack is `crack` long."""

    def __init__(self, aspect, crack, least=1e-4):
        xs = np.concatenate([both_ends(crack, least), crack + graded(1 - crack, least)[1:]])
        ys = graded(0.5 * aspect, least)
        self.crack, self.area = crack, aspect
        self.x = np.sort(np.concatenate([xs, 0.5 * (xs[1:] + xs[:-1])]))
        self.y = np.sort(np.concatenate([ys, 0.5 * (ys[1:] + ys[:-1])]))
        self.nx, self.ny = len(self.x), len(self.y)
        self.hooke = np.array([[1, POISSON, 0], [POISSON, 1, 0], [0, 0, 0.5 * (1 - POISSON)]]) / (1 - POISSON ** 2)
        self._assemble()

    def node(self, i, j):
        return j * self.nx + i

    def _assemble(self):
        rows, cols, values = [], [], []
        self.body = np.zeros(self.nx * self.ny)  # of a unit force per area
        reference = [(w1 * w2, *shapes(s, t)) for s, w1 in zip(GAUSS, WEIGHTS) for t, w2 in zip(GAUSS, WEIGHTS)]
        for j in range(0, self.ny - 1, 2):
            for i in range(0, self.nx - 1, 2):
                half_x, half_y = 0.5 * (self.x[i + 2] - self.x[i]), 0.5 * (self.y[j + 2] - self.y[j])
                nodes = np.array([self.node(i + b, j + a) for a in range(3) for b in range(3)])
                stiffness = np.zeros((18, 18))
                for weight, value, by_s, by_t in reference:
                    strain = np.zeros((3, 18))
                    strain[0, 0::2] = strain[2, 1::2] = by_s / half_x
                    strain[1, 1::2] = strain[2, 0::2] = by_t / half_y
                    stiffness += weight * half_x * half_y * strain.T @ self.hooke @ strain
                    self.body[nodes] += weight * half_x * half_y * value
                unknowns = np.stack([2 * nodes, 2 * nodes + 1], axis=1).ravel()
                rows.append(np.repeat(unknowns, 18))
                cols.append(np.tile(unknowns, 18))
                values.append(stiffness.ravel())
        n = 2 * self.nx * self.ny
        matrix = sparse.csc_matrix((np.concatenate(values), (np.concatenate(rows), np.concatenate(cols))), shape=(n, n))
        ligament = [2 * self.node(i, 0) + 1 for i in range(self.nx) if self.x[i] >= self.crack - 1e-12]
        held = np.array(ligament + [2 * self.node(self.nx - 1, 0)])
        self.free = np.setdiff1d(np.arange(n), held)
        self.solve_free = sparse.linalg.factorized(matrix[self.free][:, self.free].tocsc())

    def solve(self, opening, push):
        """Displacements, shape=(ny, nx, 2), under the pair `opening` and the whole push `push`."""
        load = np.zeros(2 * self.nx * self.ny)
        load[1] += opening
        load[0] += 0.5 * push
        load[0::2] -= push / self.area * self.body
        u = np.zeros_like(load)
        u[self.free] = self.solve_free(load[self.free])
        return u.reshape(self.ny, self.nx, 2)

    def by_opening(self, u):
        """K from the opening: v = 4 K / E sqrt(r / (2 pi)) (1 + c r), two places with c taken out."""
        distance = self.crack - self.x
        near = [i for i in range(0, self.nx, 2) if 0.01 * min(self.crack, 1 - self.crack) < distance[i] <
                0.06 * min(self.crack, 1 - self.crack)]
        apparent = [0.25 * u[0, i, 1] * np.sqrt(2 * np.pi / distance[i]) for i in near]
        return np.polyfit(distance[near], apparent, 1)[1]

    def by_j_integral(self, u, share, inertia=0.0):
        """K from J along a rectangle about the tip, without the work of a body force `inertia` along x inside it."""
        reach = share * min(self.crack, 1 - self.crack, self.y[-1])
        even = lambda grid, at: 2 * (np.argmin(np.abs(grid[0::2] - at)))
        left, right, top = even(self.x, self.crack - reach), even(self.x, self.crack + reach), even(self.y, reach)

        def at(i, j, s, t):
            _, by_s, by_t = shapes(s, t)
            local = u[j:j + 3, i:i + 3].reshape(9, 2)
            by_x = (by_s @ local) / (0.5 * (self.x[i + 2] - self.x[i]))
            by_y = (by_t @ local) / (0.5 * (self.y[j + 2] - self.y[j]))
            stress = self.hooke @ np.array([by_x[0], by_y[1], by_x[1] + by_y[0]])
            energy = 0.5 * (stress[0] * by_x[0] + stress[1] * by_y[1] + stress[2] * (by_x[1] + by_y[0]))
            return by_x, stress, energy

        total = 0.0
        for i, sign, s in ((right - 2, 1, 1.0), (left, -1, -1.0)):
            for j in range(0, top, 2):
                for t, w in zip(GAUSS, WEIGHTS):
                    by_x, stress, energy = at(i, j, s, t)
                    total += sign * w * 0.5 * (self.y[j + 2] - self.y[j]) * (
                        energy - stress[0] * by_x[0] - stress[2] * by_x[1])
        for i in range(left, right, 2):
            for s, w in zip(GAUSS, WEIGHTS):
                by_x, stress, _ = at(i, top - 2, s, 1.0)
                total -= w * 0.5 * (self.x[i + 2] - self.x[i]) * (stress[2] * by_x[0] + stress[1] * by_x[1])
        if inertia:
            for j in range(0, top, 2):
                for i in range(left, right, 2):
                    for s, w1 in zip(GAUSS, WEIGHTS):
                        for t, w2 in zip(GAUSS, WEIGHTS):
                            by_x, _, _ = at(i, j, s, t)
                            total -= inertia * w1 * w2 * by_x[0] * 0.25 * (self.x[i + 2] - self.x[i]) * (
                                self.y[j + 2] - self.y[j])
        return np.sqrt(max(0.0, 2 * total))


CRACKS = (0.01, 0.02, 0.035, 0.05, 0.07, 0.1, 0.14, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9)
BREADTHS = tuple(2.0 ** (0.5 * i) for i in range(-6, 7))


def entry(aspect, crack, finer=1.0):
    """The plate of a table's entry, and the scale of its K; `finer` divides the least element."""
    return Plate(aspect, crack, least=min(1e-4, crack / 500) / finer), np.sqrt(crack) * (1 - crack) ** 1.5


if __name__ == "__main__":  # prints the arrays of failure/criterion/src/splitting_table.hpp
    print(", ".join(f"{aspect:.8g}" for aspect in BREADTHS))
    for load, sign in (((1, 0), 1), ((0, 1), -1)):
        for aspect in BREADTHS:
            row = [sign * plate.by_opening(plate.solve(*load)) * scale
                   for plate, scale in (entry(aspect, crack) for crack in CRACKS)]
            print("    {" + ", ".join(f"{value:.4f}" for value in row) + "},", flush=True)
