// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// The radius of the largest ball in a convex part, or of any ball of at least `enough` [m]; right to 1e-7 of the
/// part's extent.
double inner_radius(const ConvexPart& part, double enough = HUGE_VAL);

}  // namespace brash::structure
