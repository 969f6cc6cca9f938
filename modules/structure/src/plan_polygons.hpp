// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Loops that bound a region of the plan: outlines counter-clockwise, holes clockwise.
using Loops = std::vector<Outline>;

/// The outlines of the union of regions, holes left out. Simple, counter-clockwise, vertices on a grid of 2^-20 m.
/// @param tolerance  how far a vertex may lie from the outlines that leave it out [m].
std::vector<Outline> united(const std::vector<Loops>& regions, double tolerance);

/// The outlines of the part that all regions have in common, moved in by `inset` [m] on every side; otherwise alike.
std::vector<Outline> common(const std::vector<Loops>& regions, double tolerance, double inset);

}  // namespace brash::structure
