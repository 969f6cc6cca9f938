// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brash/plate/sheet.hpp"
#include "outline_sheet.hpp"
#include "own_places.hpp"
#include "recorded_sheet.hpp"
#include "weak_places.hpp"

namespace brash::testing {

/// The largest stress of a recorded sheet, as the criterion seeks it, on a mesh of this accuracy. The same functions of
/// the program find it; only the choice of the mesh and the sequence of meshes are left out.
/// @return nothing where the sheet cannot be solved, or buckles.
inline std::optional<SheetReference> solve_recorded(const RecordedSheet& recorded, bool split,
                                                    plate::Accuracy accuracy) {
  const failure::SheetMotion& motion = split ? recorded.load.motion.split : recorded.load.motion.whole;
  failure::IceProperties ice = recorded.ice;
  ice.water_density /= std::pow(motion.length, 4);
  plate::LoadedSheet sheet = failure::loaded_sheet(recorded.load, ice, true, motion.stress);
  sheet.split = split;
  sheet.accuracy = accuracy;
  const auto solution = plate::solve(sheet);
  if (!solution) return std::nullopt;
  const failure::OwnPlaces own(failure::loads_of(recorded.load, ice.thickness), recorded.ice);
  const auto on_line = failure::stresses_ahead(sheet, *solution, ice, own);
  const auto beside = failure::weak_places(sheet, *solution, ice, own).weakest();
  const failure::Stresses line = on_line.value_or(failure::Stresses{});
  const double l_c = failure::characteristic_length(ice);
  SheetReference answer{line.largest, {l_c * line.place, 0.0}, 0.0};
  if (!split) answer.radial = motion.radial / motion.stress * line.radial_bending + line.radial_membrane;
  if (beside && beside->stress > line.largest) {
    answer.ratio = beside->stress;
    answer.place = l_c * beside->at;
  }
  return answer;
}

/// Whether a place lies about as near to a load or the free edge as the criterion looks, h. The stress is steep there.
inline bool is_at_limit(const RecordedSheet& sheet, Vec2 place) {
  const double limit = 1.2 * sheet.ice.thickness;
  const auto& outline = sheet.load.outline;
  for (std::size_t i = 0; i + 1 < outline.size(); ++i)
    if (failure::distance(place, outline[i], outline[i + 1]) < limit) return true;
  return std::ranges::any_of(sheet.load.loads, [&](const failure::SheetLoad& load) {
    return failure::distance(place, load.from, load.radius > 0.0 ? load.from : load.to) - load.radius < limit;
  });
}

/// The value below which this share of the values lies.
inline double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace brash::testing
