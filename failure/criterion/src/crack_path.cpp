// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack_path.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace brash::failure {
namespace {

constexpr double kStep = 0.03;    ///< of a crack, over l_c
constexpr double kLongest = 6.0;  ///< arm of a crack, over l_c

/// Unit vector across the larger principal stress at a place, on the side of `ahead`; nothing outside the ice.
std::optional<Vec2> way_at(const plate::SheetSolution& solution, Vec2 place, Vec2 ahead, Surface side, double h_lc) {
  const auto state = solution.at(place);
  if (!state) return std::nullopt;
  const plate::Tensor2 s = stress_on(side, *state, h_lc);
  const double angle = 0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy);  // of the larger principal stress
  const Vec2 across{-std::sin(angle), std::cos(angle)};
  return dot(across, ahead) < 0.0 ? -1.0 * across : across;
}

/// One arm: from the start to the first place outside the ice, by the midpoint rule.
std::vector<Vec2> arm(const plate::SheetSolution& solution, Vec2 start, Vec2 ahead, Surface side, double h_lc) {
  std::vector<Vec2> path{start};
  const double half = ahead.y;  // the side of the centre line on which the arm stays
  for (double length = 0.0; length < kLongest; length += kStep) {
    const Vec2 here = path.back();
    const auto begin = way_at(solution, here, ahead, side, h_lc);
    if (!begin) return path;
    const auto middle = way_at(solution, here + 0.5 * kStep * *begin, *begin, side, h_lc);
    ahead = middle.value_or(*begin);
    path.push_back(here + kStep * ahead);
    if (path.back().y * half <= 0.0) return {};
    if (!solution.at(path.back())) return path;
  }
  return {};
}

}  // namespace

plate::Tensor2 stress_on(Surface side, const plate::SheetState& state, double thickness_over_lc) {
  return (6.0 * side / (thickness_over_lc * thickness_over_lc)) * state.moment +
         (1.0 / thickness_over_lc) * state.membrane;
}

std::vector<Vec2> crack_path(const plate::SheetSolution& solution, double from, Surface side,
                             double thickness_over_lc) {
  const Vec2 start{from, 0.0};
  // Beside the centre line: a split sheet has its crack there.
  constexpr double kBeside = 1e-3;
  std::vector<Vec2> right = arm(solution, start + Vec2{0.0, -kBeside}, {0.0, -1.0}, side, thickness_over_lc);
  const std::vector<Vec2> left = arm(solution, start + Vec2{0.0, kBeside}, {0.0, 1.0}, side, thickness_over_lc);
  if (right.size() < 2 || left.size() < 2) return {};
  std::ranges::reverse(right);
  right.push_back(start);
  right.insert(right.end(), left.begin(), left.end());
  return right;
}

}  // namespace brash::failure
