// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/added_mass.hpp"

#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "elliptic.hpp"
#include "plan_rectangle.hpp"
#include "wetted_faces.hpp"

namespace brash::hydrodynamics {
namespace {

/// Integrals over the edges of the plan.
struct EdgeIntegrals {
  explicit EdgeIntegrals(const Prism& prism) {
    for (const auto& ring : prism.rings) {
      Vec2 a = ring.back();
      for (const Vec2 b : ring) {
        const double length = norm(b - a);
        const Vec2 along = length > 0.0 ? (b - a) / length : Vec2{};
        perimeter += length;
        squares += (std::pow(dot(along, b), 3) - std::pow(dot(along, a), 3)) / 3.0;
        a = b;
      }
    }
  }

  double perimeter = 0.0;  ///< [m]
  double squares = 0.0;    ///< of (along . r)^2, with the edge's direction [m3]
};

/// K of (H16): a rectangular plate against a strip of the same breadth. @param slenderness  long side over short, >= 1.
double plate_factor(double slenderness) {
  const double y = 1.0 / slenderness;
  return 1.0 / (1.0 + y * (0.53 + y * (0.26 - 0.063 * y)));
}

/// K' of (H17), of the moment. @param z  side across the axis over the side along it, > 0.
double turning_factor(double z) { return 1.0 / (1.0 + z * (0.375 * z + 0.275) / (z + 2.0)); }

/// Added moment of inertia over the density. @param across, along  the axis of turning, sides of the rectangle [m].
double turning(double across, double along) {
  return kPi / 128.0 * std::pow(across, 4) * along * turning_factor(across / along);
}

/// Two axes that are nearer than this have a round section, which turns without the water [-].
constexpr double kRound = 1e-6;

/// Of a turn about the axis across b and c, over the displaced volume [m2]; squares of the semi-axes and their
/// integrals.
double about(double b2, double c2, double beta, double gamma) {
  const double apart = b2 - c2;
  if (std::abs(apart) <= kRound * (b2 + c2)) return 0.0;
  return 0.2 * apart * apart * (gamma - beta) / (2.0 * apart + (b2 + c2) * (beta - gamma));
}

}  // namespace

AddedMass added_mass_of_plate(const Prism& prism, double density) {
  expect_solid(prism);
  BRASH_EXPECTS(density > 0.0, density);
  const EdgeIntegrals edges(prism);
  const auto [area, x, y] = PlanRectangle(prism);
  const double a = std::min(x, y), b = std::max(x, y), hh = prism.thickness * prism.thickness;
  const double across = density * kPi / 4.0 * a * a * b * plate_factor(b / a);
  const double along = std::min(across, density * kPi / 16.0 * hh * edges.perimeter);
  return {.along = along,
          .across = across,
          .inertia = {density * turning(y, x), density * turning(x, y), density * kPi / 8.0 * hh * edges.squares}};
}

double wetted_share(const Prism& prism, const Pose& pose, double flooded) {
  const Waterplane water = waterplane_in_body_frame(pose);
  const double half = 0.5 * prism.thickness;
  const double lower = wetted_plan_face(prism, water, -half, -1.0).area;
  const double upper = wetted_plan_face(prism, water, half, 1.0).area;
  return std::clamp(0.5 * (lower + flooded * upper) / PlanRectangle(prism).area, 0.0, 1.0);
}

EntrainedWater entrained_by_half(Vec3 a) {
  BRASH_EXPECTS(a.x > 0.0 && a.y > 0.0 && a.z > 0.0, a.x, a.y, a.z);
  const Vec3 s{a.x * a.x, a.y * a.y, a.z * a.z};
  const double product = a.x * a.y * a.z, volume = 2.0 / 3.0 * kPi * product;
  // Shares of the three directions; they add up to 2.
  const double alpha = product * 2.0 / 3.0 * elliptic_rd(s.y, s.z, s.x);
  const double beta = product * 2.0 / 3.0 * elliptic_rd(s.z, s.x, s.y);
  const double gamma = product * 2.0 / 3.0 * elliptic_rd(s.x, s.y, s.z);
  return {volume * Vec3{alpha / (2.0 - alpha), beta / (2.0 - beta), gamma / (2.0 - gamma)},
          volume * Vec3{about(s.y, s.z, beta, gamma), about(s.z, s.x, gamma, alpha), about(s.x, s.y, alpha, beta)}};
}

}  // namespace brash::hydrodynamics
