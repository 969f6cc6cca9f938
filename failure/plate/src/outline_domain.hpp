// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/plate/plate.hpp"
#include "mesh.hpp"

namespace brash::plate {

/// The sheet behind a free edge of any shape.
struct OutlineDomain {
  Domain domain;
  double centre_line = 0.0;  ///< length of the centre line in the ice over l_c, at most as far as the stations go
  double base = 0.0;         ///< x of the innermost point of the edge near B
  std::vector<Vec2> roots;   ///< re-entrant corners near B
};

/// Inserts B, the ends of the contact and the end of the centre line into the edge, closes it far away and says how
/// finely to mesh; or why the edge cannot be used.
tl::expected<OutlineDomain, std::string> sheet_behind(const OutlinePlate& plate, const MeshOptions& options);

}  // namespace brash::plate
