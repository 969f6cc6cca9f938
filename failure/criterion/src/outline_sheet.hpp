// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/failure/criterion.hpp"
#include "brash/plate/sheet.hpp"
#include "crack_path.hpp"
#include "own_places.hpp"

namespace brash::failure {

/// The sheet of a load case, to be solved: its outline with its loads. Without an outline the trapezoid takes its
/// place, and without loads the contact's own load acts alone.
/// @param moments  the loads out of the plane and the moments are this many times as large.
plate::LoadedSheet loaded_sheet(const LoadCase& load, const IceProperties& ice, bool second_order,
                                double moments = 1.0);

/// The loads of a load case: without any, the contact's own load, even on its chord.
std::vector<SheetLoad> loads_of(const LoadCase& load, double thickness);

/// Stresses over the flexural strength.
struct Stresses {
  double largest = 0.0;  ///< across the centre line's length
  double place = 0.0;    ///< |AB| / l_c
  Surface side = 1.0;    ///< on which it is
  /// Along the edge at B, on the surface that P puts in compression.
  double radial_bending = 0.0;
  double radial_membrane = 0.0;
};

/// The stresses on the line from B into the ice.
///
/// The largest one is principal where P puts the surface in tension, and along the line on the other surface: the
/// edge's own stress there belongs to the radial crack. Plate theory holds from h on. Places of other loads are left
/// out: `largest` is 0 if none is left.
///
/// @return nothing where the line meets no ice.
std::optional<Stresses> stresses_ahead(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution,
                                       const IceProperties& ice, const OwnPlaces& own);

}  // namespace brash::failure
