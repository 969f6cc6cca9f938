// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace brash::failure {
namespace {

constexpr double kStep = 0.03;       ///< of a crack, over l_c
constexpr double kLongestArm = 6.0;  ///< beyond the load, over l_c

enum class End { kOutside, kCentreLine, kNowhere };

/// One way of a crack from its start, which it holds.
struct Arm {
  std::vector<Vec2> points;
  End end = End::kNowhere;
};

/// Follows the stress on one surface of a sheet.
class Tracer {
 public:
  Tracer(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, Surface side)
      : solution_(&solution), side_(side), h_lc_(sheet.thickness) {
    double longest = 0.0;
    for (const plate::EdgeLoad& load : sheet.edge_loads) longest = std::max(longest, norm(load.to - load.from));
    most_steps_ = std::lround((kLongestArm + 0.5 * longest) / kStep);
  }

  /// Unit vector across the larger principal stress at a place, on the side of `ahead`; nothing outside the ice.
  std::optional<Vec2> way_at(Vec2 place, Vec2 ahead) const {
    const auto state = solution_->at(place);
    if (!state) return std::nullopt;
    const plate::Tensor2 s = stress_on(side_, *state, h_lc_);
    const double angle = 0.5 * std::atan2(2.0 * s.xy, s.xx - s.yy);  // of the larger principal stress
    const Vec2 across{-std::sin(angle), std::cos(angle)};
    return dot(across, ahead) < 0.0 ? -1.0 * across : across;
  }

  /// By the midpoint rule, from the start to the first place outside the ice.
  /// @param crosses  whether it may cross the centre line; else it ends on it.
  Arm arm(Vec2 start, Vec2 ahead, bool crosses) const {
    Arm arm{{start}, End::kNowhere};
    for (long step = 0; step < most_steps_; ++step) {
      const Vec2 here = arm.points.back();
      const auto begin = way_at(here, ahead);
      if (!begin) return arm.end = End::kOutside, arm;
      ahead = way_at(here + 0.5 * kStep * *begin, *begin).value_or(*begin);
      const Vec2 next = here + kStep * ahead;
      if (!crosses && next.y * start.y <= 0.0) {
        arm.points.push_back({here.x + (next.x - here.x) * here.y / (here.y - next.y), 0.0});
        return arm.end = End::kCentreLine, arm;
      }
      arm.points.push_back(next);
      if (!solution_->at(next)) return arm.end = End::kOutside, arm;
    }
    return arm;
  }

  /// From the centre line into the half y < 0 (`half` is -1) or y > 0 (1).
  Arm arm_from_line(double from, double half) const {
    constexpr double kBeside = 1e-3;  // a split sheet has its crack on the line
    return arm({from, half * kBeside}, {0.0, half}, false);
  }

  /// Both arms from a place.
  std::array<Arm, 2> arms(Vec2 start, bool crosses) const {
    const Vec2 way = way_at(start, {0.0, 1.0}).value_or(Vec2{0.0, 1.0});
    return {arm(start, -1.0 * way, crosses), arm(start, way, crosses)};
  }

 private:
  const plate::SheetSolution* solution_;
  Surface side_;
  double h_lc_;
  long most_steps_;
};

/// Backwards along one arm, then along the other.
std::vector<Vec2> joined(const Arm& one, const Arm& other) {
  std::vector<Vec2> line(one.points.rbegin(), one.points.rend());
  line.insert(line.end(), other.points.begin() + 1, other.points.end());
  return line;
}

/// The crack of one half, from outside to the centre line; empty where there is no place, or it does not come so far.
std::vector<Vec2> half_crack(const Tracer& tracer, const std::optional<Vec2>& place) {
  if (!place) return {};
  auto [one, other] = tracer.arms(*place, false);
  if (one.end == End::kCentreLine) std::swap(one, other);
  if (one.end != End::kOutside || other.end != End::kCentreLine) return {};
  return joined(one, other);
}

}  // namespace

plate::Tensor2 stress_on(Surface side, const plate::SheetState& state, double thickness_over_lc) {
  return (6.0 * side / (thickness_over_lc * thickness_over_lc)) * state.moment +
         (1.0 / thickness_over_lc) * state.membrane;
}

double principal(const plate::Tensor2& s) { return 0.5 * (s.xx + s.yy) + std::hypot(0.5 * (s.xx - s.yy), s.xy); }

std::vector<Vec2> crack_from_line(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, double from,
                                  Surface side) {
  const Tracer tracer(sheet, solution, side);
  const Arm right = tracer.arm_from_line(from, -1.0), left = tracer.arm_from_line(from, 1.0);
  if (right.end != End::kOutside || left.end != End::kOutside) return {};
  if (right.points.size() < 2 || left.points.size() < 2) return {};
  std::vector<Vec2> crack(right.points.rbegin(), right.points.rend() - 1);
  crack.push_back({from, 0.0});
  crack.insert(crack.end(), left.points.begin() + 1, left.points.end());
  return crack;
}

std::vector<Vec2> crack_through(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, Vec2 place,
                                Surface side) {
  const auto [one, other] = Tracer(sheet, solution, side).arms(place, true);
  if (one.end != End::kOutside || other.end != End::kOutside) return {};
  std::vector<Vec2> crack = joined(one, other);
  if (crack.front().y > crack.back().y) std::ranges::reverse(crack);
  return crack;
}

std::vector<Vec2> crack_through_halves(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution,
                                       const std::optional<Vec2>& below, const std::optional<Vec2>& above,
                                       Surface side) {
  const Tracer tracer(sheet, solution, side);
  std::vector<Vec2> crack = half_crack(tracer, below), rest = half_crack(tracer, above);
  if (crack.empty() && rest.empty()) return {};
  if (crack.empty() || rest.empty()) {
    const std::vector<Vec2>& found = crack.empty() ? rest : crack;
    const Arm other = tracer.arm_from_line(found.back().x, crack.empty() ? -1.0 : 1.0);
    if (other.end != End::kOutside || other.points.size() < 2) return {};
    (crack.empty() ? crack : rest).assign(other.points.rbegin(), other.points.rend());
  }
  crack.insert(crack.end(), rest.rbegin(), rest.rend());
  return crack;
}

std::optional<double> distance_ahead(const std::vector<Vec2>& crack) {
  std::optional<double> least;
  for (std::size_t i = 0; i + 1 < crack.size(); ++i) {
    const Vec2 a = crack[i], b = crack[i + 1];
    if (a.y * b.y > 0.0) continue;
    const double x = a.y == b.y ? std::min(a.x, b.x) : a.x + (b.x - a.x) * a.y / (a.y - b.y);
    if (x > 0.0 && (!least || x < *least)) least = x;
  }
  return least;
}

}  // namespace brash::failure
