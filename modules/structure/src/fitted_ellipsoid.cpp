// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
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

}  // namespace

HalfEllipsoid fitted_ellipsoid(const Hull& hull) {
  constexpr double kRound = 1e-9;  // a waterline with no longer axis: the round-off must not choose one
  const Displacement wet = hull.displaced({});
  BRASH_EXPECTS(wet.volume > 0.0 && wet.waterplane.area > 0.0, wet.volume, wet.waterplane.area);
  PlanMoments m;
  for (const Outline& outline : hull.footprint({}, 0.0, 0.0).leading) m.add(outline);
  BRASH_EXPECTS(m.area > 0.0, m.area);
  const Vec2 centre = m.first / m.area;
  const double xx = m.xx - m.area * centre.x * centre.x, yy = m.yy - m.area * centre.y * centre.y;
  const double xy = m.xy - m.area * centre.x * centre.y;
  const double mean = 0.5 * (xx + yy), apart = std::hypot(0.5 * (xx - yy), xy);
  const double depth = 1.5 * wet.volume / wet.waterplane.area;
  const double radius = std::sqrt(wet.waterplane.area / kPi);
  if (apart <= kRound * mean) return {{radius, radius, depth}, centre, 0.0};
  const double ratio = std::pow((mean + apart) / (mean - apart), 0.25);
  return {{radius * ratio, radius / ratio, depth}, centre, 0.5 * std::atan2(2.0 * xy, xx - yy)};
}

}  // namespace brash::structure
