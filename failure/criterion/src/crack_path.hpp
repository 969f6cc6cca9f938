// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "brash/plate/sheet.hpp"

namespace brash::failure {

/// A surface of the sheet: 1, the one that the contact's P puts in tension, or -1.
using Surface = double;

/// Stress on a surface over k l_c: s 6 m (l_c / h)^2 + n l_c / h.
plate::Tensor2 stress_on(Surface side, const plate::SheetState& state, double thickness_over_lc);

/// The larger principal value.
double principal(const plate::Tensor2& stress);

// Cracks follow the stress on a surface: they run across the larger principal stress, either way from their start,
// until they leave the ice. Frame and lengths of LoadedSheet, from y < 0 to y > 0; both ends lie just outside the ice.
// Nothing where a crack does not reach the free edge within 6 l_c and half the longest load, whose stress it follows.
// See docs/theory/fracture-of-the-edge.md, (7).

/// The crack that starts at (`from`, 0). Nothing where it turns back to the centre line.
std::vector<Vec2> crack_from_line(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, double from,
                                  Surface side);

/// The crack through a place of a whole sheet.
std::vector<Vec2> crack_through(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, Vec2 place,
                                Surface side);

/// The cracks of both halves of a split sheet, each through a place of its half. They run to the radial crack, which
/// joins them. Where one half has no place, or no crack from there, it cracks from the end of the other half's crack.
/// @param below, above  places with y < 0 and y > 0.
std::vector<Vec2> crack_through_halves(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution,
                                       const std::optional<Vec2>& below, const std::optional<Vec2>& above,
                                       Surface side);

/// Where a crack first crosses the centre line, x > 0; nothing where it does not.
std::optional<double> distance_ahead(const std::vector<Vec2>& crack);

}  // namespace brash::failure
