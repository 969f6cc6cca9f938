#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the splitting law against the finite elements that it comes from, solved anew and checked another way."""
import pathlib
import re
import unittest

import numpy as np

import splitting_fem

TABLE = pathlib.Path(__file__).resolve().parents[3] / "failure" / "criterion" / "src" / "splitting_table.hpp"


def lists_of(name):
    """The rows of numbers of an array in the table."""
    body = re.search(name + r"\{(.*?)\};", TABLE.read_text(), re.S).group(1)
    rows = re.findall(r"\{([^{}]+)\}", body) or [body]
    return [[float(number) for number in row.split(",") if number.strip()] for row in rows]


class SplittingTable(unittest.TestCase):
    def test_entries_are_the_stress_intensities_of_the_plate_by_two_ways(self):
        cracks, breadths = lists_of("kCrackLengths")[0], lists_of("kBreadths")[0]
        self.assertEqual(cracks, list(splitting_fem.CRACKS))
        np.testing.assert_allclose(breadths, splitting_fem.BREADTHS, rtol=1e-7)
        opening, closing = lists_of("kOpening"), lists_of("kClosing")
        for breadth, crack in ((0.125, 0.14), (0.25, 0.2), (0.5, 0.5), (1, 0.05), (1, 0.4), (1, 0.8), (2, 0.3), (4, 0.6), (8, 0.5)):
            with self.subTest(breadth=breadth, crack=crack):
                i, j = breadths.index(breadth), cracks.index(crack)
                plate, scale = splitting_fem.entry(breadth, crack, finer=2)  # another grid than the table's
                pair, push = plate.solve(1, 0), plate.solve(0, 1)
                self.assertAlmostEqual(plate.by_opening(pair) * scale / opening[i][j], 1, delta=0.003)
                self.assertAlmostEqual(-plate.by_opening(push) * scale / closing[i][j], 1, delta=0.005)
                # J is exact for the grid but for its path; the opening is extrapolated to the tip.
                self.assertAlmostEqual(plate.by_j_integral(pair, 0.5) * scale / opening[i][j], 1, delta=0.01)
                inertia = -1 / plate.area
                self.assertAlmostEqual(plate.by_j_integral(push, 0.5, inertia) * scale / closing[i][j], 1, delta=0.03)


if __name__ == "__main__":
    unittest.main()
