// SPDX-License-Identifier: GPL-3.0-or-later
#include "weak_places.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "brash/core/constants.hpp"
#include "crack_path.hpp"

namespace brash::failure {
namespace {

constexpr double kRadius = 2.5;  ///< of the search, over l_c
/// The search around the best corner of an element starts and ends with these steps, over l_c.
constexpr double kFirstStep = 0.05, kLastStep = 0.01;

/// Says which places are checked.
class Checked {
 public:
  Checked(const plate::LoadedSheet& sheet, const OwnPlaces& own, double l_c)
      : h_(sheet.thickness), split_(sheet.split), own_(own), l_c_(l_c) {
    for (std::size_t i = 0; i + 1 < sheet.outline.size(); ++i) {
      const Side side{sheet.outline[i], sheet.outline[i + 1]};
      if (distance({}, side.from, side.to) < kRadius + h_) edge_.push_back(side);
    }
  }

  bool operator()(Vec2 place) const {
    if (!(norm(place) < kRadius) || (split_ && std::abs(place.y) < h_)) return false;
    const auto is_near = [&](const Side& side) { return side.is_nearer(place, h_); };
    return own_.distance(l_c_ * place) >= h_ * l_c_ && std::ranges::none_of(edge_, is_near) &&
           own_.contain(l_c_ * place);
  }

 private:
  struct Side {
    Side(Vec2 start, Vec2 end) : from(start), to(end), middle(0.5 * (start + end)), reach(0.5 * norm(end - start)) {}

    bool is_nearer(Vec2 place, double limit) const {
      constexpr double kRounding = 1.0 + 1e-9;
      const double most = (limit + reach) * kRounding;
      // Most are so far off that a circle around them shows it.
      return dot(place - middle, place - middle) <= most * most && distance(place, from, to) < limit;
    }

    Vec2 from, to;
    Vec2 middle;
    double reach;  ///< from the middle
  };

  double h_;
  bool split_;
  const OwnPlaces& own_;
  double l_c_;
  std::vector<Side> edge_;
};

}  // namespace

std::optional<WeakPlace> WeakPlaces::weakest() const {
  if (!below || (above && above->stress > below->stress)) return above;
  return below;
}

WeakPlaces weak_places(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution, const IceProperties& ice,
                       const OwnPlaces& own) {
  const double l_c = characteristic_length(ice), unit = ice.water_density * kGravity * l_c / ice.flexural_strength;
  const Checked is_checked(sheet, own, l_c);
  const auto stress = [&](const plate::SheetState& state) {
    return unit * principal(stress_on(1.0, state, sheet.thickness));
  };

  WeakPlaces found;
  for (const plate::SheetPlace& place : solution.at_nodes(is_checked)) {
    std::optional<WeakPlace>& half = place.at.y < 0.0 ? found.below : found.above;
    const double here = stress(place.state);
    if (!half || here > half->stress) half = {place.at, here};
  }
  const auto climb = [&](WeakPlace& weak) {
    for (double step = kFirstStep; step > kLastStep;) {
      const Vec2 from = weak.at;
      for (const Vec2 way : std::array<Vec2, 4>{{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}}) {
        const Vec2 next = from + step * way;
        if (next.y * from.y <= 0.0 || !is_checked(next)) continue;
        const auto state = solution.at(next);
        if (state && stress(*state) > weak.stress) weak = {next, stress(*state)};
      }
      if (weak.at == from) step *= 0.5;
    }
  };
  if (found.below) climb(*found.below);
  if (found.above) climb(*found.above);
  return found;
}

}  // namespace brash::failure
