// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "brash/model/case.hpp"
#include "brash/statistics/random.hpp"

namespace brash::ice {

/// Floes that a generator has packed.
struct FloePacking {
  std::vector<geometry::Polygon> floes;  ///< convex; no two overlap, to the last bit
  double concentration = 0.0;            ///< their area over the area of the field outside `keep_out` [-]
  std::size_t n_left_out = 0;            ///< floes of the packing that would have met `keep_out`
};

/// Why no field was made.
struct FloeFieldError {
  std::string key;  ///< of the case: "field.concentration"
  std::string what;
  std::string allowed;
  std::string remedy;
};

/// The size of a floe, L = sqrt(area) [m]; docs/theory/ice.md, (F1).
double size_of(const geometry::Polygon& floe);

/// The distribution function of a law of sizes at `size` [m]: the share of floes that are no larger. (F2), (F3)
double share_up_to(const model::FloeSizes& law, double size);

/// The number of generated floes that a field is expected to have: the area that they cover over their mean area.
/// @param field  with `floes.concentration` and `floes.size`.
double expected_floes(const model::FieldSection& field);

/// Packs floes into the rectangle of `field`, x from 0 to `length`, |y| <= width/2, at its concentration.
///
/// Sizes are drawn until their areas are as near to the concentration as they come: the sum of several is at most half
/// of the last floe too large, or half of the next one drawn too small. The areas of the floes are the drawn ones, to
/// the rounding of their vertices to the grid. Floes of the shapes:
/// - voronoi: cells of a power diagram whose areas are the drawn ones, each over the concentration; a cell shrinks
///   about its centroid to the floe. Aurenhammer, Hoffmann and Aronov 1998; Kitagawa, Merigot and Thibert 2019. (F4),
///   (F5)
/// - squares, discs (24 sides): at random places, the largest first. (F6)
///
/// @param field     with `floes.concentration` and `floes.size`.
/// @param keep_out  rings whose convex hulls no floe may meet: the structure at the start.
/// @param random    of this field alone: the same stream gives the same bytes.
/// @return the floes, or the key that asks for too much and the nearest that is reachable.
tl::expected<FloePacking, FloeFieldError> pack_floes(const model::FieldSection& field,
                                                     std::span<const geometry::Ring> keep_out,
                                                     statistics::RandomStream random);

}  // namespace brash::ice
