// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// A half ellipsoid for each outline of a hull's waterline, as fitted_ellipsoid() makes one for them all: several
/// columns of one mesh. They share the displaced volume by their areas, so all are equally deep.
std::vector<HalfEllipsoid> fitted_ellipsoids(const Hull& hull);

}  // namespace brash::structure
