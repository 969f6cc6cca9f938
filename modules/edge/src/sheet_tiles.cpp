// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/sheet_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/edge/edge_contact.hpp"
#include "brash/floes/plan.hpp"

namespace brash::edge {
namespace {

/// Side of a tile [m]: some breaking lengths, so that a cut touches one to four tiles.
constexpr double kTileSide = 4.0;

int index(double coordinate) { return static_cast<int>(std::floor(coordinate / kTileSide)); }

}  // namespace

std::vector<BodyId> SheetTiles::prisms(const ice::Plate& plate, rigid_body::World& world, Cell cell, const Pose& frame,
                                       BodyId sheet) {
  const double x = cell.first * kTileSide;
  const double y = cell.second * kTileSide;
  const std::array<Vec2, 4> corners{Vec2{x, y}, Vec2{x + kTileSide, y}, Vec2{x + kTileSide, y + kTileSide},
                                    Vec2{x, y + kTileSide}};
  const Freeboard heights = freeboard(*case_, plate.ice().thickness);
  std::vector<BodyId> bodies;
  for (const geometry::Polygon& ice : plate.sheet().within(geometry::ring(corners))) {
    for (const geometry::Ring& part : geometry::convex_parts(ice)) {
      bodies.push_back(world.add_sheet_part(floes::to_metres(part), heights.bottom, heights.top, frame, sheet));
      level_ice_of_[bodies.back()] = plate.level_ice();
    }
  }
  return bodies;
}

const geometry::Extent& SheetTiles::extent_of(const ice::Plate& plate) {
  const auto [found, is_new] = extents_.try_emplace(plate.level_ice());
  if (is_new)
    for (const geometry::Polygon& polygon : plate.outline()) found->second.add(geometry::extent(polygon));
  return found->second;
}

void SheetTiles::lay(const ice::Plate& plate, rigid_body::World& world, Vec2 lower, Vec2 upper, const Pose& frame,
                     BodyId sheet) {
  const geometry::Extent& ice = extent_of(plate);
  if (ice.is_empty()) return;
  const Vec2 from{std::max(lower.x, ice.lower.x), std::max(lower.y, ice.lower.y)};
  const Vec2 to{std::min(upper.x, ice.upper.x), std::min(upper.y, ice.upper.y)};
  if (from.x > to.x || from.y > to.y) return;
  auto& parts = parts_[plate.level_ice()];
  for (int i = index(from.x); i <= index(to.x); ++i)
    for (int j = index(from.y); j <= index(to.y); ++j)
      if (const Cell cell{i, j}; !parts.contains(cell)) parts.emplace(cell, prisms(plate, world, cell, frame, sheet));
}

void SheetTiles::lay_edge(const ice::Plate& plate, rigid_body::World& world, const geometry::Extent& box, double reach,
                          const Pose& frame, BodyId sheet) {
  const Vec2 by{reach, reach};
  const Vec2 lower = box.lower - by, upper = box.upper + by;
  const auto lay_along = [&](Vec2 from, Vec2 to) {
    const auto n = std::max(1.0, std::ceil(norm(to - from) / kTileSide));
    for (double i = 0.0; i < n; ++i) {
      const Vec2 a = from + (i / n) * (to - from), b = from + ((i + 1.0) / n) * (to - from);
      const Vec2 least{std::min(a.x, b.x), std::min(a.y, b.y)}, most{std::max(a.x, b.x), std::max(a.y, b.y)};
      if (least.x > upper.x || most.x < lower.x || least.y > upper.y || most.y < lower.y) continue;
      lay(plate, world, least - by, most + by, frame, sheet);
    }
  };
  for (const geometry::Polygon& polygon : plate.outline())
    for (const std::vector<Vec2>& ring : floes::rings_in_metres(polygon))
      for (std::size_t i = 0; i < ring.size(); ++i) lay_along(ring[i], ring[(i + 1) % ring.size()]);
}

void SheetTiles::move(int level_ice, rigid_body::World& world, const Pose& frame, const Twist& twist) {
  for (const auto& [cell, bodies] : parts_[level_ice])
    for (const BodyId body : bodies) world.move_sheet_part(body, frame, twist);
}

void SheetTiles::renew(const ice::Plate& plate, rigid_body::World& world, const geometry::Extent& changed,
                       const Pose& frame, BodyId sheet) {
  if (changed.is_empty()) return;
  auto& parts = parts_[plate.level_ice()];
  for (int i = index(changed.lower.x); i <= index(changed.upper.x); ++i) {
    for (int j = index(changed.lower.y); j <= index(changed.upper.y); ++j) {
      const auto laid = parts.find({i, j});
      if (laid == parts.end() || laid->second.empty()) continue;  // level ice never grows back
      for (const BodyId part : laid->second) {
        world.remove(part);
        level_ice_of_.erase(part);
      }
      laid->second = prisms(plate, world, laid->first, frame, sheet);
    }
  }
}

}  // namespace brash::edge
