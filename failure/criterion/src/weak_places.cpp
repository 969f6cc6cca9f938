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

double distance(Vec2 place, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double square = dot(along, along);
  const double s = square > 0.0 ? std::clamp(dot(place - from, along) / square, 0.0, 1.0) : 0.0;
  return norm(place - (from + s * along));
}

/// Says which places are judged.
class Judged {
 public:
  explicit Judged(const plate::LoadedSheet& sheet) : h_(sheet.thickness), split_(sheet.split) {
    for (const plate::EdgeLoad& load : sheet.edge_loads) loads_.push_back({load.from, load.to, 0.0});
    for (const plate::PatchLoad& load : sheet.patch_loads) loads_.push_back({load.at, load.at, load.radius});
    const auto from_b = [](const Stretch& load) { return load.distance({}); };
    std::ranges::iter_swap(loads_.begin(), std::ranges::min_element(loads_, {}, from_b));
    for (std::size_t i = 0; i + 1 < sheet.outline.size(); ++i) {
      const Stretch side{sheet.outline[i], sheet.outline[i + 1], 0.0};
      if (side.distance({}) < kRadius + h_) edge_.push_back(side);
    }
  }

  bool operator()(Vec2 place) const {
    if (!(norm(place) < kRadius)) return false;
    const double own = loads_.front().distance(place);
    const auto nearer = [&](double limit) {
      return [limit, place](const Stretch& s) { return s.is_nearer(place, limit); };
    };
    return own >= h_ && (!split_ || std::abs(place.y) >= h_) && std::ranges::none_of(loads_, nearer(own)) &&
           std::ranges::none_of(edge_, nearer(h_));
  }

 private:
  struct Stretch {
    Stretch(Vec2 start, Vec2 end, double r)
        : from(start), to(end), radius(r), middle(0.5 * (start + end)), reach(0.5 * norm(end - start) + r) {}

    double distance(Vec2 place) const { return std::max(0.0, failure::distance(place, from, to) - radius); }
    bool is_nearer(Vec2 place, double limit) const {
      constexpr double kRounding = 1.0 + 1e-9;
      const double most = (limit + reach) * kRounding;
      // Most are so far off that their circle tells it.
      return dot(place - middle, place - middle) <= most * most && distance(place) < limit;
    }

    Vec2 from, to;
    double radius;
    Vec2 middle;
    double reach;  ///< from the middle
  };

  double h_;
  bool split_;
  std::vector<Stretch> loads_;  ///< the one at B first
  std::vector<Stretch> edge_;
};

}  // namespace

std::optional<WeakPlace> WeakPlaces::weakest() const {
  if (!below || (above && above->stress > below->stress)) return above;
  return below;
}

WeakPlaces weak_places(const plate::LoadedSheet& sheet, const plate::SheetSolution& solution,
                       const IceProperties& ice) {
  const Judged is_judged(sheet);
  const double unit = ice.water_density * kGravity * characteristic_length(ice) / ice.flexural_strength;
  const auto stress = [&](const plate::SheetState& state) {
    return unit * principal(stress_on(1.0, state, sheet.thickness));
  };

  WeakPlaces found;
  for (const plate::SheetPlace& place : solution.at_nodes(is_judged)) {
    std::optional<WeakPlace>& half = place.at.y < 0.0 ? found.below : found.above;
    const double here = stress(place.state);
    if (!half || here > half->stress) half = {place.at, here};
  }
  const auto climb = [&](WeakPlace& weak) {
    for (double step = kFirstStep; step > kLastStep;) {
      const Vec2 from = weak.at;
      for (const Vec2 way : std::array<Vec2, 4>{{{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}}) {
        const Vec2 next = from + step * way;
        if (next.y * from.y <= 0.0 || !is_judged(next)) continue;
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
