// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/model/case.hpp"
#include "brash/structure/cone.hpp"

namespace brash::simulation {

/// The structure of a case.
inline structure::Cone cone_of(const model::Case& resolved) {
  const model::StructureSection& s = resolved.structure;
  return {.angle = s.angle,
          .waterline_width = s.waterline_width,
          .height = s.height,
          .height_under_water = s.height_under_water,
          .downward_breaking = s.breaking == model::Breaking::kDownward,
          .facets = s.facets};
}

}  // namespace brash::simulation
