// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "plan.hpp"

namespace brash::simulation {
namespace {

/// Side of a tile [m]: some breaking lengths, so that a cut touches one to four tiles.
constexpr double kTileSide = 4.0;

}  // namespace

SheetTiles::SheetTiles(const geometry::IceSheet& sheet, rigid_body::World& world, double bottom, double top)
    : bottom_(bottom), top_(top) {
  const Box box = bounding_box(sheet.polygons());
  renew(sheet, world, box.lower, box.upper);
}

void SheetTiles::renew(const geometry::IceSheet& sheet, rigid_body::World& world, Vec2 lower, Vec2 upper) {
  if (lower.x > upper.x) return;  // an empty box
  const auto cell = [](double coordinate) { return static_cast<int>(std::floor(coordinate / kTileSide)); };
  for (int i = cell(lower.x); i <= cell(upper.x); ++i) {
    for (int j = cell(lower.y); j <= cell(upper.y); ++j) {
      std::vector<BodyId>& parts = parts_[{i, j}];
      for (const BodyId part : parts) world.remove(part);
      parts.clear();

      const double x = i * kTileSide;
      const double y = j * kTileSide;
      const std::array<Vec2, 4> corners{Vec2{x, y}, Vec2{x + kTileSide, y}, Vec2{x + kTileSide, y + kTileSide},
                                        Vec2{x, y + kTileSide}};
      for (const geometry::Polygon& ice : sheet.within(geometry::ring(corners)))
        for (const geometry::Ring& part : geometry::convex_parts(ice))
          parts.push_back(world.add_sheet_part(to_metres(part), bottom_, top_));
    }
  }
}

}  // namespace brash::simulation
