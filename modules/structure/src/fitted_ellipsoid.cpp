// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/structure/floating_body.hpp"
#include "brash/structure/hull.hpp"

namespace brash::structure {
namespace {

/// Area [m2], first [m3] and second moments [m4] of outlines about the origin.
struct PlanMoments {
  double area = 0.0;
  Vec2 first{};
  double xx = 0.0, yy = 0.0, xy = 0.0;

  void add(const Outline& outline) {
    Vec2 a = outline.back();
    for (const Vec2 b : outline) {
      const double twice = cross(a, b);
      const Vec2 sum = a + b;
      area += twice / 2.0;
      first += twice / 6.0 * sum;
      xx += twice / 24.0 * (a.x * a.x + b.x * b.x + sum.x * sum.x);
      yy += twice / 24.0 * (a.y * a.y + b.y * b.y + sum.y * sum.y);
      xy += twice / 24.0 * (a.x * a.y + b.x * b.y + sum.x * sum.y);
      a = b;
    }
  }
};

/// @param area  of the waterplane [m2]. The area of its outlines is a little less where they are inscribed in it.
HalfEllipsoid half_ellipsoid(const PlanMoments& m, double area, double depth) {
  constexpr double kRound = 1e-9;  // a waterline with no longer axis: the round-off must not choose one
  BRASH_EXPECTS(m.area > 0.0, m.area);
  const Vec2 centre = m.first / m.area;
  const double xx = m.xx - m.area * centre.x * centre.x, yy = m.yy - m.area * centre.y * centre.y;
  const double xy = m.xy - m.area * centre.x * centre.y;
  const double mean = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy);
  const double radius = std::sqrt(area / kPi);
  if (apart <= kRound * mean) return {{radius, radius, depth}, centre, 0.0};
  const double ratio = std::pow((mean + apart) / (mean - apart), 0.25);
  return {{radius * ratio, radius / ratio, depth}, centre, 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

double depth_of(const Displacement& wet) {
  BRASH_EXPECTS(wet.volume > 0.0 && wet.waterplane.area > 0.0, wet.volume, wet.waterplane.area);
  return 1.5 * wet.volume / wet.waterplane.area;
}

}  // namespace

HalfEllipsoid fitted_ellipsoid(const Hull& hull) {
  const Displacement wet = hull.displaced({});
  const double depth = depth_of(wet);
  PlanMoments m;
  for (const Outline& outline : hull.footprint({}, 0.0, 0.0).leading) m.add(outline);
  return half_ellipsoid(m, wet.waterplane.area, depth);
}

std::vector<HalfEllipsoid> fitted_ellipsoids(const Hull& hull) {
  const Displacement wet = hull.displaced({});
  const double depth = depth_of(wet);
  std::vector<PlanMoments> outlines;
  double area = 0.0;
  for (const Outline& outline : hull.footprint({}, 0.0, 0.0).leading) {
    outlines.emplace_back().add(outline);
    area += outlines.back().area;
  }
  std::vector<HalfEllipsoid> result;
  result.reserve(outlines.size());
  for (const PlanMoments& m : outlines)
    result.push_back(half_ellipsoid(m, wet.waterplane.area * (m.area / area), depth));
  return result;
}

}  // namespace brash::structure
