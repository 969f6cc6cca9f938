// SPDX-License-Identifier: GPL-3.0-or-later
#include "borders.hpp"

#include <array>

#include "brash/ice/floe_file.hpp"
#include "plan.hpp"

namespace brash::simulation {
namespace {

/// Height of a border above and below the water, in thicknesses of the ice: floes that pile up stay within it.
constexpr double kHeight = 30.0;
/// Thickness of a wall [m]: a floe crosses no such way in a step.
constexpr double kThick = 10.0;

std::vector<Vec2> box(Vec2 lower, Vec2 upper) { return {lower, {upper.x, lower.y}, upper, {lower.x, upper.y}}; }

}  // namespace

void lay_borders(const model::Case& resolved, rigid_body::World& world) {
  if (resolved.field.kind != model::FieldKind::kFloes) return;
  const double length = resolved.field.length, half = 0.5 * resolved.field.width;
  const double height = kHeight * resolved.ice.thickness;
  const model::FloeFieldSection& floes = resolved.field.floes;
  if (floes.border == model::FloeBorder::kWalls) {
    for (const auto& wall :
         {box({0.0, -half - kThick}, {length + kThick, -half}), box({0.0, half}, {length + kThick, half + kThick}),
          box({length, -half}, {length + kThick, half})})
      world.add_sheet_part(wall, -height, height);
  }
  if (floes.shore.empty()) return;
  for (const geometry::Polygon& land : ice::read_outlines(floes.shore))
    for (const geometry::Ring& part : geometry::convex_parts(land))
      world.add_sheet_part(to_metres(part), -height, height);
}

}  // namespace brash::simulation
