// SPDX-License-Identifier: GPL-3.0-or-later
#include "borders.hpp"

#include <array>

#include "brash/ice/floe_file.hpp"
#include "plan.hpp"

namespace brash::simulation {
namespace {

/// Height of a border, in thicknesses of the ice.
constexpr double kHeight = 30.0;
/// Thickness of a wall [m]: a floe crosses no such way in a step.
constexpr double kThick = 10.0;

std::vector<Vec2> box(Vec2 lower, Vec2 upper) { return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}; }

}  // namespace

double border_height(const model::Case& resolved) { return kHeight * resolved.ice.thickness; }

std::vector<geometry::Extent> lay_borders(const model::Case& resolved, rigid_body::World& world) {
  std::vector<geometry::Extent> boxes;
  const auto lay = [&](const std::vector<Vec2>& ring, double height) {
    world.add_sheet_part(ring, -height, height);
    boxes.emplace_back();
    for (const Vec2 corner : ring) boxes.back().add(corner);
  };
  const double length = resolved.field.length, half = 0.5 * resolved.field.width;
  const double height = border_height(resolved);
  const bool has_floes = resolved.field.kind == model::FieldKind::kFloes;
  if (has_floes && resolved.field.floes.border == model::FloeBorder::kWalls) {
    for (const auto& wall :
         {box({0.0, -half - kThick}, {length + kThick, -half}), box({0.0, half}, {length + kThick, half + kThick}),
          box({length, -half}, {length + kThick, half})})
      lay(wall, height);
  }
  if (resolved.field.shore.empty()) return boxes;
  for (const geometry::Polygon& land : ice::read_outlines(resolved.field.shore, resolved.field.origin))
    for (const geometry::Ring& part : geometry::convex_parts(land)) lay(to_metres(part), height);
  return boxes;
}

}  // namespace brash::simulation
