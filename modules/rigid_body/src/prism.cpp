// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::rigid_body {
namespace {

/// Area [m2], centroid [m] and second moments about it [m4] of a plan.
struct PlanMoments {
  double area = 0.0;
  Vec2 centroid{};
  double xx = 0.0;  ///< integral of x^2
  double yy = 0.0;
  double xy = 0.0;
};

/// Green's theorem over the rings, about the first vertex so that large coordinates cancel.
PlanMoments plan_moments(std::span<const std::vector<Vec2>> rings) {
  BRASH_EXPECTS(!rings.empty() && rings[0].size() >= 3, rings.size());
  const Vec2 origin = rings[0][0];
  double a = 0.0;
  double mx = 0.0, my = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (const auto& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 p = ring[i] - origin;
      const Vec2 q = ring[(i + 1) % ring.size()] - origin;
      const double c = cross(p, q);
      a += c / 2.0;
      mx += c * (p.x + q.x) / 6.0;
      my += c * (p.y + q.y) / 6.0;
      xx += c * (p.x * p.x + p.x * q.x + q.x * q.x) / 12.0;
      yy += c * (p.y * p.y + p.y * q.y + q.y * q.y) / 12.0;
      xy += c * (p.x * q.y + 2.0 * p.x * p.y + 2.0 * q.x * q.y + q.x * p.y) / 24.0;
    }
  }
  BRASH_EXPECTS(a > 0.0, a);
  const Vec2 r{mx / a, my / a};
  return {a, origin + r, xx - a * r.x * r.x, yy - a * r.y * r.y, xy - a * r.x * r.y};
}

/// Angle in (-90, 90] degrees from x to the axis along which the plan is longest; 0 when no axis is.
double principal_angle(const PlanMoments& m) {
  const double twice_sine = 2.0 * m.xy;
  const double twice_cosine = m.xx - m.yy;
  // Squares and other plans of equal moments: the round-off must not choose the axes.
  if (std::hypot(twice_sine, twice_cosine) <= 1e-12 * (m.xx + m.yy)) return 0.0;
  return 0.5 * std::atan2(twice_sine, twice_cosine);
}

}  // namespace

MassProperties mass_properties(const Prism& prism, double density, double added_mass) {
  BRASH_EXPECTS(prism.thickness > 0.0 && density > 0.0 && added_mass >= 0.0, prism.thickness, density, added_mass);
  const PlanMoments m = plan_moments(prism.rings);
  const double h = prism.thickness;
  const double per_volume = (1.0 + added_mass) * density;
  const double across = m.area * h * h * h / 12.0;
  return {
      .mass = per_volume * m.area * h,
      .inertia = {per_volume * (m.yy * h + across), per_volume * (m.xx * h + across), per_volume * (m.xx + m.yy) * h}};
}

PlacedPrism place_prism(std::span<const std::vector<Vec2>> rings, std::span<const std::vector<Vec2>> parts,
                        double thickness, double mid_height) {
  BRASH_EXPECTS(thickness > 0.0, thickness);
  const PlanMoments m = plan_moments(rings);
  const double angle = principal_angle(m);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const auto in_body = [&](std::span<const std::vector<Vec2>> plan_rings) {
    std::vector<std::vector<Vec2>> result;
    for (const auto& ring : plan_rings) {
      result.emplace_back();
      for (const Vec2& p : ring) {
        const Vec2 r = p - m.centroid;
        result.back().push_back({c * r.x + s * r.y, -s * r.x + c * r.y});
      }
    }
    return result;
  };
  return {.prism = {in_body(rings), in_body(parts), thickness},
          .pose = {{m.centroid.x, m.centroid.y, mid_height}, {std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle)}}};
}

}  // namespace brash::rigid_body
