// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_sheet.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "brash/core/constants.hpp"

namespace brash::failure {
namespace {

/// Beyond that distance from B the edge does not matter, over l_c.
constexpr double kReach = 3.0;
/// The centre line is looked at so far beyond the edge near B, over l_c.
constexpr double kBeyond = 3.0;
/// The trapezoid of a load case as an outline.
std::vector<Vec2> trapezoid(const LoadCase& load, double l_c) {
  const double tip = 0.5 * load.contact_length, root = tip + load.depth * std::tan(0.5 * load.angle);
  const double far = root + kReach * l_c;
  if (load.depth <= 0.0) return {{0.0, -far}, {0.0, -tip}, {0.0, tip}, {0.0, far}};
  return {{load.depth, -far}, {load.depth, -root}, {0.0, -tip}, {0.0, tip}, {load.depth, root}, {load.depth, far}};
}

/// The contact's own load, even on its chord.
SheetLoad own_load(const LoadCase& load, double thickness) {
  const double normal = load.pressure * load.contact_length * thickness;
  return {.from = {0.0, -0.5 * load.contact_length},
          .to = {0.0, 0.5 * load.contact_length},
          .in_plane = {normal, load.mu2 * normal},
          .out_of_plane = load.mu1 * normal};
}

/// @param unit  k l_c over the strength.
Stresses largest_stresses(const plate::LineProfile& line, double thickness, double unit, double l_c,
                          const OwnPlaces& own) {
  const plate::SheetState& at_b = line.state.front();
  Stresses result{.radial_bending = unit * stress_on(-1.0, {.moment = at_b.moment, .membrane = {}}, thickness).yy,
                  .radial_membrane = unit * stress_on(-1.0, {.moment = {}, .membrane = at_b.membrane}, thickness).yy};
  std::vector<double> stress;
  std::vector<bool> on_bottom;
  for (std::size_t i = 0; i < line.state.size(); ++i) {
    const plate::SheetState& state = line.state[i];
    const plate::Tensor2 top = stress_on(1.0, state, thickness), bottom = stress_on(-1.0, state, thickness);
    const double principal = 0.5 * (top.xx + top.yy) + std::hypot(0.5 * (top.xx - top.yy), top.xy);
    const bool is_own = own.contain({l_c * line.station[i], 0.0});
    stress.push_back(is_own ? std::max(principal, bottom.xx) : 0.0);
    on_bottom.push_back(bottom.xx > principal);
  }
  std::size_t first = 0;
  while (first + 2 < stress.size() && line.station[first] < thickness) ++first;
  const auto at = static_cast<std::size_t>(
      std::max_element(stress.begin() + static_cast<std::ptrdiff_t>(first), stress.end()) - stress.begin());
  result.largest = unit * std::max(0.0, stress[at]);
  result.place = line.station[at];
  if (on_bottom[at]) result.side = -1.0;
  const bool has_sides = at > first && at + 1 < stress.size() && stress[at - 1] > 0.0 && stress[at + 1] > 0.0;
  if (has_sides) {  // the top of the parabola through three stations
    const double left = stress[at] - stress[at - 1], right = stress[at] - stress[at + 1];
    if (left + right > 0.0)
      result.place += 0.5 * (line.station[at + 1] - line.station[at]) * (left - right) / (left + right);
  }
  return result;
}

}  // namespace

plate::LoadedSheet loaded_sheet(const LoadCase& load, const IceProperties& ice, bool second_order, double moments) {
  const double l_c = characteristic_length(ice);
  plate::LoadedSheet result{.outline = load.outline.empty() ? trapezoid(load, l_c) : load.outline,
                            .edge_loads = {},
                            .patch_loads = {},
                            .thickness = ice.thickness / l_c,
                            .poisson_ratio = ice.poisson_ratio,
                            .second_order = second_order};
  for (Vec2& point : result.outline) point = point / l_c;
  const double force = ice.water_density * kGravity * l_c * l_c * l_c;
  const auto add = [&](const SheetLoad& one) {
    if (one.radius > 0.0)
      result.patch_loads.push_back({one.from / l_c, one.radius / l_c, moments * one.out_of_plane / force});
    else
      result.edge_loads.push_back({.from = one.from / l_c,
                                   .to = one.to / l_c,
                                   .in_plane = one.in_plane / force,
                                   .out_of_plane = moments * one.out_of_plane / force,
                                   .moment = second_order ? moments * one.moment / (force * l_c) : 0.0});
  };
  for (const SheetLoad& one : loads_of(load, ice.thickness)) add(one);
  return result;
}

std::vector<SheetLoad> loads_of(const LoadCase& load, double thickness) {
  return load.loads.empty() ? std::vector{own_load(load, thickness)} : load.loads;
}

std::optional<Stresses> stresses_ahead(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution,
                                       const IceProperties& ice, const OwnPlaces& own) {
  double base = 0.0;
  for (const Vec2 point : sheet.outline)
    if (norm(point) < kReach) base = std::max(base, point.x);
  const plate::LineProfile line = solution.along({}, {1.0, 0.0}, base + kBeyond);
  if (line.station.size() < 3) return std::nullopt;
  const double l_c = characteristic_length(ice), unit = ice.water_density * kGravity * l_c / ice.flexural_strength;
  return largest_stresses(line, sheet.thickness, unit, l_c, own);
}

}  // namespace brash::failure
