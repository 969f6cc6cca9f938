// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/plate/sheet.hpp"
#include "crack_path.hpp"
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
  Surface side = 1.0;    ///< on which it is
  double radial = 0.0;   ///< along the edge at B, on the surface that P puts in compression
};

/// The largest stress on the centre line: principal where P puts the surface in tension, along the line on the other
/// one, where the edge's own stress belongs to the radial crack. Plate theory holds from h on.
/// @param unit  k l_c over the strength.
Stresses largest_stresses(const plate::LineProfile& line, double thickness, double unit) {
  Stresses result{.radial = unit * stress_on(-1.0, line.state.front(), thickness).yy};
  std::vector<double> stress;
  std::vector<bool> on_bottom;
  for (const plate::SheetState& state : line.state) {
    const plate::Tensor2 top = stress_on(1.0, state, thickness), bottom = stress_on(-1.0, state, thickness);
    const double principal = 0.5 * (top.xx + top.yy) + std::hypot(0.5 * (top.xx - top.yy), top.xy);
    stress.push_back(std::max(principal, bottom.xx));
    on_bottom.push_back(bottom.xx > principal);
  }
  std::size_t first = 0;
  while (first + 2 < stress.size() && line.station[first] < thickness) ++first;
  const auto at = static_cast<std::size_t>(
      std::max_element(stress.begin() + static_cast<std::ptrdiff_t>(first), stress.end()) - stress.begin());
  result.largest = unit * stress[at];
  result.place = line.station[at];
  if (on_bottom[at]) result.side = -1.0;
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
    if (!load.outline.empty()) answer = judge(sheet(load));
    if (answer) return *answer;
    LoadCase alone = load;
    alone.outline.clear();
    alone.loads.clear();
    answer = judge(sheet(alone));
    if (!answer) answer = screen_->assess(load);
    answer->outline_refused = true;
    return *answer;
  }

 private:
  /// Where the ice would break under a load of this kind, however small.
  Assessment unloaded(LoadCase load) const {
    load.pressure = 1.0;
    load.loads.clear();
    Assessment answer = judge(sheet(load)).value_or(screen_->assess(load));
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

  /// A solved sheet and its stresses on the centre line.
  struct Solved {
    plate::SheetSolution solution;
    Stresses stresses;
  };

  /// Nothing where the sheet cannot be meshed.
  std::optional<Assessment> judge(plate::LoadedSheet sheet) const {
    Assessment answer;
    std::optional<Solved> solved = solve(sheet, answer);
    if (!solved) return std::nullopt;
    const bool may_fail = kSplitMargin * solved->stresses.largest > 1.0;
    if (options_.radial_first && may_fail && solved->stresses.radial > 1.0) {
      sheet.split = true;
      if (auto split = solve(sheet, answer)) {
        answer.split = true;
        solved = std::move(split);
      }
    }
    const Stresses& stresses = solved->stresses;
    answer.sigma_max = stresses.largest * ice_.flexural_strength;
    answer.breaking_length = stresses.place * l_c_;
    answer.fails = answer.buckled || answer.sigma_max > ice_.flexural_strength;
    if (answer.fails && options_.trace_crack) {
      answer.crack = crack_path(solved->solution, stresses.place, stresses.side, sheet.thickness);
      for (Vec2& point : answer.crack) point = l_c_ * point;
    }
    return answer;
  }

  /// To first order if the plate buckles.
  std::optional<Solved> solve(plate::LoadedSheet sheet, Assessment& answer) const {
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
    const Stresses stresses = largest_stresses(line, sheet.thickness, foundation_ * l_c_ / ice_.flexural_strength);
    return Solved{std::move(*solution), stresses};
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
