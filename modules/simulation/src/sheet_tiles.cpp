// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_tiles.hpp"

#include <array>
#include <cmath>

#include "edge_contact.hpp"
#include "plan.hpp"

namespace brash::simulation {
namespace {

/// Side of a tile [m]: some breaking lengths, so that a cut touches one to four tiles.
constexpr double kTileSide = 4.0;

int index(double coordinate) { return static_cast<int>(std::floor(coordinate / kTileSide)); }

}  // namespace

std::vector<BodyId> SheetTiles::prisms(const ice::Plate& plate, rigid_body::World& world, Cell cell,
                                       const Pose& frame) {
  const double x = cell.first * kTileSide;
  const double y = cell.second * kTileSide;
  const std::array<Vec2, 4> corners{Vec2{x, y}, Vec2{x + kTileSide, y}, Vec2{x + kTileSide, y + kTileSide},
                                    Vec2{x, y + kTileSide}};
  const Freeboard heights = freeboard(*case_, plate.ice().thickness);
  std::vector<BodyId> bodies;
  for (const geometry::Polygon& ice : plate.sheet().within(geometry::ring(corners))) {
    for (const geometry::Ring& part : geometry::convex_parts(ice)) {
      bodies.push_back(world.add_sheet_part(to_metres(part), heights.bottom, heights.top, frame));
      level_ice_of_[bodies.back()] = plate.level_ice();
    }
  }
  return bodies;
}

void SheetTiles::lay(const ice::Plate& plate, rigid_body::World& world, Vec2 lower, Vec2 upper, const Pose& frame) {
  auto& parts = parts_[plate.level_ice()];
  for (int i = index(lower.x); i <= index(upper.x); ++i)
    for (int j = index(lower.y); j <= index(upper.y); ++j)
      if (const Cell cell{i, j}; !parts.contains(cell)) parts.emplace(cell, prisms(plate, world, cell, frame));
}

void SheetTiles::move(int level_ice, rigid_body::World& world, const Pose& frame, const Twist& twist) {
  for (const auto& [cell, bodies] : parts_[level_ice])
    for (const BodyId body : bodies) world.move_sheet_part(body, frame, twist);
}

void SheetTiles::renew(const ice::Plate& plate, rigid_body::World& world, const geometry::Extent& changed,
                       const Pose& frame) {
  if (changed.is_empty()) return;
  auto& parts = parts_[plate.level_ice()];
  for (int i = index(changed.lower.x); i <= index(changed.upper.x); ++i) {
    for (int j = index(changed.lower.y); j <= index(changed.upper.y); ++j) {
      const auto laid = parts.find({i, j});
      if (laid == parts.end()) continue;
      for (const BodyId part : laid->second) {
        world.remove(part);
        level_ice_of_.erase(part);
      }
      laid->second = prisms(plate, world, laid->first, frame);
    }
  }
}

}  // namespace brash::simulation
