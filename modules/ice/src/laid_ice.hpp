// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/failure/criterion.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/ice/floe_file.hpp"
#include "brash/ice/idle_files.hpp"
#include "brash/ice/variation.hpp"

namespace brash::ice {

/// Level ice at the start, in connected parts.
struct LaidIce {
  std::vector<geometry::Polygon> sheets;  ///< held, or large enough to drift as a sheet: one part each
  std::vector<GivenFloe> floes;           ///< parts that nothing holds, then the floes of the file
  std::vector<geometry::Polygon> land;    ///< of the shore
  std::vector<IdleFile> idle;             ///< files without effect
};

/// Whether land holds a part of level ice with fixed borders: one of its edges lies along a side or the far end of the
/// rectangle, or it touches `land`.
bool is_held(const geometry::Polygon& part, const model::FieldSection& field, std::span<const geometry::Polygon> land);

/// Lays the level ice of `field`: the rectangle with the first edge of `variation` or the outlines of its file, less
/// its openings, parted by its cracks.
///
/// With fixed borders a part is a sheet if land holds it, as is_held() has it. With free borders the largest part is a
/// sheet, and so is each part that is broad enough. Every other part is a floe.
/// @param ice  whose characteristic length, with `smallest_plate`, says which parts are broad enough.
/// @throws InputError naming file and place: a faulty file, ice out of the field, a line that ends inside the ice, or
///         ice that nothing holds.
LaidIce lay_ice(const model::FieldSection& field, const failure::IceProperties& ice, const Variation& variation);

/// `ice` without the inside of `openings`, which may overlap; their holes keep the ice. Exact but for the rounding of
/// crossings to the grid. docs/theory/ice.md, (O1).
std::vector<geometry::Polygon> with_openings(std::span<const geometry::Polygon> ice,
                                             std::span<const geometry::Polygon> openings);

/// The result of parted_by().
struct Parted {
  std::vector<geometry::Polygon> parts;
  std::vector<geometry::Tail> tails;  ///< of 1 mm and more, at most one for each straight piece of a line and part
};

/// Parts `ice` along lines.
Parted parted_by(std::span<const geometry::Crack> lines, std::span<const geometry::Polygon> ice);

}  // namespace brash::ice
