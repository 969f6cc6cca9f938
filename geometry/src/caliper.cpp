// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/caliper.hpp"

#include <algorithm>

#include "brash/core/constants.hpp"
#include "predicates.hpp"

namespace brash::geometry {
namespace {

/// The corners of the convex hull, counter-clockwise (Andrew's chains); signs are exact.
Ring convex_hull(std::span<const Point> ring) {
  Ring sorted(ring.begin(), ring.end());
  std::ranges::sort(sorted);
  Ring hull;
  const auto add_chain = [&](auto begin, auto end) {
    const std::size_t first = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= first + 2 && side(hull[hull.size() - 2], hull.back(), *p) <= 0) hull.pop_back();
      hull.push_back(*p);
    }
    hull.pop_back();  // the next chain begins with it
  };
  add_chain(sorted.begin(), sorted.end());
  add_chain(sorted.rbegin(), sorted.rend());
  return hull;
}

}  // namespace

double mean_caliper_diameter(std::span<const Point> ring) {
  if (ring.size() < 2) return 0.0;
  const Ring hull = convex_hull(ring);
  double perimeter = 0.0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    perimeter += norm(metres(hull[(i + 1) % hull.size()]) - metres(hull[i]));  // (D1)
  }
  return perimeter / kPi;
}

}  // namespace brash::geometry
