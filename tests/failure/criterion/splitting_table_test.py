#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of the splitting law against the finite elements that it comes from, solved anew and checked another way."""
import pathlib
import re
import unittest

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
        opening, closing = lists_of("kOpening"), lists_of("kClosing")
        for i, j in ((0, 3), (1, 6), (2, 1), (2, 5), (2, 9), (3, 4), (4, 7)):
            with self.subTest(breadth=breadths[i], crack=cracks[j]):
                # Another grid than the table's, twice as fine at the tip.
                plate = splitting_fem.Plate(breadths[i], cracks[j], least=5e-5)
                scale = cracks[j] ** 0.5 * (1 - cracks[j]) ** 1.5
                pair, push = plate.solve(1, 0), plate.solve(0, 1)
                self.assertAlmostEqual(plate.by_opening(pair) * scale / opening[i][j], 1, delta=0.003)
                self.assertAlmostEqual(-plate.by_opening(push) * scale / closing[i][j], 1, delta=0.005)
                # J is exact for the grid but for its path; the opening is extrapolated to the tip.
                self.assertAlmostEqual(plate.by_j_integral(pair, 0.5) * scale / opening[i][j], 1, delta=0.01)
                inertia = -1 / plate.area
                self.assertAlmostEqual(plate.by_j_integral(push, 0.5, inertia) * scale / closing[i][j], 1, delta=0.03)


if __name__ == "__main__":
    unittest.main()
