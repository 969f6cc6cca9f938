// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/plate/sheet.hpp"
#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Beyond that distance from B the edge does not matter, over l_c.
constexpr double kReach = 3.0;
/// The centre line is looked at so far beyond the edge near B, over l_c.
constexpr double kBeyond = 3.0;
/// A sheet is solved where the screen says more than the strength over this. Among the contacts of a run the solution
/// exceeded the screen by 3.3 at most: docs/theory/failure.md.
constexpr double kMargin = 4.0;
/// A split sheet has up to 1.3 times the stress of a whole one.
constexpr double kSplitMargin = 1.5;

/// How much a load on a straight edge, `s` l_c along it from B, bends the ice ahead of B, over the same load at B.
double share_at(double s) { return std::exp(-std::pow(s / 1.75, 1.4)); }

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

/// Stresses over the flexural strength.
struct Stresses {
  double largest = 0.0;  ///< across the centre line's length
  double place = 0.0;    ///< |AB| / l_c
  double radial = 0.0;   ///< along the edge at B, on the surface that P puts in compression
};

/// Stress resultants as stresses on a surface: s 6 m (l_c / h)^2 + n l_c / h, s = 1 on the surface that P puts in
/// tension.
plate::Tensor2 on_surface(const plate::SheetState& state, double thickness, double side) {
  return (6.0 * side / (thickness * thickness)) * state.moment + (1.0 / thickness) * state.membrane;
}

/// The largest stress on the centre line: principal where P puts the surface in tension, along the line on the other
/// one, where the edge's own stress belongs to the radial crack. Plate theory holds from h on.
/// @param unit  k l_c over the strength.
Stresses largest_stresses(const plate::LineProfile& line, double thickness, double unit) {
  Stresses result{.radial = unit * on_surface(line.state.front(), thickness, -1.0).yy};
  std::vector<double> stress;
  for (const plate::SheetState& state : line.state) {
    const plate::Tensor2 top = on_surface(state, thickness, 1.0), bottom = on_surface(state, thickness, -1.0);
    const double principal = 0.5 * (top.xx + top.yy) + std::hypot(0.5 * (top.xx - top.yy), top.xy);
    stress.push_back(std::max(principal, bottom.xx));
  }
  std::size_t first = 0;
  while (first + 2 < stress.size() && line.station[first] < thickness) ++first;
  const auto at = static_cast<std::size_t>(
      std::max_element(stress.begin() + static_cast<std::ptrdiff_t>(first), stress.end()) - stress.begin());
  result.largest = unit * stress[at];
  result.place = line.station[at];
  if (at > first && at + 1 < stress.size()) {  // the top of the parabola through three stations
    const double left = stress[at] - stress[at - 1], right = stress[at] - stress[at + 1];
    if (left + right > 0.0)
      result.place += 0.5 * (line.station[at + 1] - line.station[at]) * (left - right) / (left + right);
  }
  return result;
}

/// The floating sheet with its free edge as it is, under all loads on it, solved for each load case.
class OutlineCriterion final : public BendingCriterion {
 public:
  OutlineCriterion(std::unique_ptr<BendingCriterion> screen, const IceProperties& ice, const BendingOptions& options)
      : screen_(std::move(screen)),
        ice_(ice),
        options_(options),
        l_c_(characteristic_length(ice)),
        foundation_(ice.water_density * kGravity) {}

  bool needs_outline() const override { return true; }

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    if (load.pressure == 0.0) return unloaded(load);
    if (const auto harmless = screened(load)) return *harmless;
    std::optional<Assessment> answer;
    if (!load.outline.empty()) answer = solve(sheet(load));
    if (answer) return *answer;
    LoadCase alone = load;
    alone.outline.clear();
    alone.loads.clear();
    answer = solve(sheet(alone));
    if (!answer) answer = screen_->assess(load);
    answer->outline_refused = true;
    return *answer;
  }

 private:
  /// Where the ice would break under a load of this kind, however small.
  Assessment unloaded(LoadCase load) const {
    load.pressure = 1.0;
    load.loads.clear();
    Assessment answer = solve(sheet(load)).value_or(screen_->assess(load));
    return {.breaking_length = answer.breaking_length};
  }

  /// The answer of the trapezoid alone, if even with every load near B it stays far below the strength.
  std::optional<Assessment> screened(const LoadCase& load) const {
    const Assessment quick = screen_->assess(load);
    const double own = load.mu1 * load.pressure * load.contact_length * ice_.thickness;
    double all = load.loads.empty() ? own : 0.0;
    for (const SheetLoad& other : load.loads) {
      all += (std::abs(other.out_of_plane) + std::abs(other.moment) / l_c_) *
             share_at(norm(0.5 * (other.from + other.to)) / l_c_);
    }
    if (quick.buckled || quick.sigma_max * std::max(1.0, all / own) > ice_.flexural_strength / kMargin)
      return std::nullopt;
    return Assessment{.sigma_max = quick.sigma_max, .breaking_length = quick.breaking_length};
  }

  plate::LoadedSheet sheet(const LoadCase& load) const {
    plate::LoadedSheet result{.outline = load.outline.empty() ? trapezoid(load, l_c_) : load.outline,
                              .edge_loads = {},
                              .patch_loads = {},
                              .thickness = ice_.thickness / l_c_,
                              .poisson_ratio = ice_.poisson_ratio,
                              .second_order = options_.second_order};
    for (Vec2& point : result.outline) point = point / l_c_;
    const double force = foundation_ * l_c_ * l_c_ * l_c_;
    const auto add = [&](const SheetLoad& one) {
      if (one.radius > 0.0)
        result.patch_loads.push_back({one.from / l_c_, one.radius / l_c_, one.out_of_plane / force});
      else
        result.edge_loads.push_back({.from = one.from / l_c_,
                                     .to = one.to / l_c_,
                                     .in_plane = one.in_plane / force,
                                     .out_of_plane = one.out_of_plane / force,
                                     .moment = options_.second_order ? one.moment / (force * l_c_) : 0.0});
    };
    if (load.loads.empty()) add(own_load(load, ice_.thickness));
    for (const SheetLoad& one : load.loads) add(one);
    return result;
  }

  /// Nothing where the sheet cannot be meshed.
  std::optional<Assessment> solve(plate::LoadedSheet sheet) const {
    Assessment answer;
    auto stress = stresses(sheet, answer);
    if (!stress) return std::nullopt;
    const bool may_fail = kSplitMargin * stress->largest > 1.0;
    if (options_.radial_first && may_fail && stress->radial > 1.0) {
      sheet.split = true;
      if (auto split = stresses(sheet, answer)) {
        answer.split = true;
        stress = split;
      }
    }
    answer.sigma_max = stress->largest * ice_.flexural_strength;
    answer.breaking_length = stress->place * l_c_;
    answer.fails = answer.buckled || answer.sigma_max > ice_.flexural_strength;
    return answer;
  }

  /// Stresses on the centre line over the flexural strength; to first order if the plate buckles.
  std::optional<Stresses> stresses(plate::LoadedSheet sheet, Assessment& answer) const {
    auto solution = plate::solve(sheet);
    if (!solution && solution.error().buckled) {
      answer.buckled = true;
      sheet.second_order = false;
      solution = plate::solve(sheet);
    }
    if (!solution) return std::nullopt;
    double base = 0.0;
    for (const Vec2 point : sheet.outline)
      if (norm(point) < kReach) base = std::max(base, point.x);
    const plate::LineProfile line = solution->along({}, {1.0, 0.0}, base + kBeyond);
    if (line.station.size() < 3) return std::nullopt;
    return largest_stresses(line, sheet.thickness, foundation_ * l_c_ / ice_.flexural_strength);
  }

  std::unique_ptr<BendingCriterion> screen_;
  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
  double foundation_;  ///< k = rho_w g [N/m3]
};

}  // namespace

std::unique_ptr<BendingCriterion> make_outline_criterion(std::unique_ptr<BendingCriterion> screen,
                                                         const IceProperties& ice, const BendingOptions& options) {
  return std::make_unique<OutlineCriterion>(std::move(screen), ice, options);
}

}  // namespace brash::failure
