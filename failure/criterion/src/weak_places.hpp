// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "brash/failure/criterion.hpp"
#include "brash/plate/sheet.hpp"
#include "own_places.hpp"

namespace brash::failure {

/// A place where the surface that the contact's P puts in tension has its largest principal stress.
struct WeakPlace {
  Vec2 at{};            ///< [l_c]
  double stress = 0.0;  ///< over the flexural strength
};

/// The weakest place of each half around B; nothing where no place of it is checked.
struct WeakPlaces {
  std::optional<WeakPlace> below, above;  ///< y < 0 and y > 0

  /// The weaker one.
  std::optional<WeakPlace> weakest() const;
};

/// Looks within 2.5 l_c of B, at places of the contact's own load. Plate theory says nothing nearer than h to a load,
/// the free edge or the radial crack.
/// @param ice  of `sheet`: its l_c is the unit of the sheet's lengths.
/// @see docs/theory/fracture-of-the-edge.md, (6).
WeakPlaces weak_places(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, const IceProperties& ice,
                       const OwnPlaces& own);

}  // namespace brash::failure
