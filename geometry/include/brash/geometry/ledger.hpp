// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "brash/geometry/area.hpp"

namespace brash::geometry {

/// Where every square metre of ice is. Exact.
///
/// `initial = sheet + floes + crushed + deleted + brash + snap`: `snap` is the area that rounding moved.
struct Ledger {
  ExactArea initial;
  ExactArea sheet;
  ExactArea floes;
  /// Crushed by the structure before it could break off.
  ExactArea crushed;
  /// Floes deleted because their stress exceeded the compressive strength.
  ExactArea deleted;
  /// Pieces too small or too thin for a body.
  ExactArea brash;
  ExactArea snap;
  /// How many vertices rounding to the grid made, or led an edge to.
  std::int64_t n_rounded = 0;

  ExactArea missing() const { return initial - (sheet + floes + crushed + deleted + brash + snap); }
  bool closes() const { return missing() == ExactArea{}; }
};

}  // namespace brash::geometry
