// SPDX-License-Identifier: GPL-3.0-or-later
#include "own_places.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::failure {

double share_at(double distance) { return std::exp(-std::pow(distance / 1.75, 1.4)); }

double distance(Vec2 place, Vec2 from, Vec2 to) {
  const Vec2 along = to - from;
  const double square = dot(along, along);
  const double s = square > 0.0 ? std::clamp(dot(place - from, along) / square, 0.0, 1.0) : 0.0;
  return norm(place - (from + s * along));
}

double OwnPlaces::Source::distance(Vec2 place) const {
  return std::max(0.0, failure::distance(place, from, to) - radius);
}

OwnPlaces::OwnPlaces(const std::vector<SheetLoad>& loads, const IceProperties& ice)
    : l_c_(characteristic_length(ice)), thickness_(ice.thickness) {
  BRASH_EXPECTS(!loads.empty(), loads.size());
  for (const SheetLoad& load : loads)
    loads_.push_back({load.from, load.to, load.radius, std::abs(load.out_of_plane) + std::abs(load.moment) / l_c_,
                      load.has_verdict});
}

bool OwnPlaces::contain(Vec2 place) const {
  const double own = loads_.front().weight * share_at(distance(place) / l_c_);
  return std::none_of(loads_.begin() + 1, loads_.end(), [&](const Source& other) {
    const double off = other.distance(place);
    // Plate theory says nothing nearer than h to a load.
    if (off < thickness_) return true;
    return other.checked && other.weight > own && other.weight * share_at(off / l_c_) > own;
  });
}

}  // namespace brash::failure
