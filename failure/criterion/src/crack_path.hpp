// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "brash/plate/sheet.hpp"

namespace brash::failure {

/// A surface of the sheet: 1, the one that the contact's P puts in tension, or -1.
using Surface = double;

/// Stress on a surface over k l_c: s 6 m (l_c / h)^2 + n l_c / h.
plate::Tensor2 stress_on(Surface side, const plate::SheetState& state, double thickness_over_lc);

/// The circumferential crack that starts at (`from`, 0) and follows the stress on a surface: on both sides it runs
/// across the larger principal stress until it leaves the ice. Frame and lengths of LoadedSheet, from y < 0 to y > 0;
/// both ends lie just outside the ice.
///
/// @return nothing where the crack turns back to the centre line or does not reach the free edge within 6 l_c.
/// @see docs/theory/failure.md, (7).
std::vector<Vec2> crack_path(const plate::SheetSolution& solution, double from, Surface side, double thickness_over_lc);

}  // namespace brash::failure
