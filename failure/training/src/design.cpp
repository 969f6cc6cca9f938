// SPDX-License-Identifier: GPL-3.0-or-later
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/training/plan.hpp"

namespace brash::training {
namespace {

/// Sobol's sequence in `N` dimensions.
template <unsigned int N>
class Sobol {
 public:
  Sobol() : generator_(gsl_qrng_alloc(gsl_qrng_sobol, N)) { BRASH_EXPECTS(generator_ != nullptr); }
  ~Sobol() { gsl_qrng_free(generator_); }
  Sobol(const Sobol&) = delete;
  Sobol& operator=(const Sobol&) = delete;
  std::array<double, N> next() {
    std::array<double, N> u{};
    gsl_qrng_get(generator_, u.data());
    return u;
  }

 private:
  gsl_qrng* generator_;
};

/// Stretches [0, 1] by `edge_share` and folds the parts that stick out onto the ends.
double with_ends(double u, double edge_share) { return std::clamp(0.5 + (u - 0.5) / (1.0 - edge_share), 0.0, 1.0); }

/// @param contact_length  c / l_c, of the same point.
double value_at(const Axis& axis, double u, double contact_length) {
  if (u >= 1.0) return axis.to;
  const double shift = 0.5 * contact_length;
  switch (axis.spacing) {
    case Spacing::kByContact:
      return (axis.from + shift) * std::pow((axis.to + shift) / (axis.from + shift), u) - shift;
    case Spacing::kLogarithmic:
      return axis.from * std::pow(axis.to / axis.from, u);
    case Spacing::kQuadratic:
      return axis.from + (axis.to - axis.from) * u * u;
    case Spacing::kLinear:
      break;
  }
  return axis.from + (axis.to - axis.from) * u;
}

}  // namespace

std::vector<DesignPoint> design(const Plan& plan) {
  BRASH_EXPECTS(plan.geometries > 0 && plan.rows_per_geometry > 0, plan.geometries, plan.rows_per_geometry);
  BRASH_EXPECTS(plan.edge_share >= 0.0 && plan.edge_share < 1.0, plan.edge_share);
  Sobol<4> geometries;
  Sobol<2> loads;
  for (int i = 0; i < plan.first; ++i) geometries.next();
  for (int i = 0; i < plan.first * plan.rows_per_geometry; ++i) loads.next();
  const auto at = [&plan](const Axis& axis, double u, double contact_length = 0.0) {
    return value_at(axis, with_ends(u, plan.edge_share), contact_length);
  };

  std::vector<DesignPoint> points;
  for (int g = 0; g < plan.geometries; ++g) {
    const auto u = geometries.next();
    const double contact_length = at(plan.c_lc, u[1]);
    DesignPoint point;
    point.plate = {.depth = std::max(plan.b_lc.from, at(plan.b_lc, u[0], contact_length)),
                   .contact_length = contact_length,
                   .angle = at(plan.theta, u[2]),
                   .thickness = at(plan.thickness_over_lc, u[3]),
                   .poisson_ratio = plan.poisson_ratio,
                   .theory = plan.theory,
                   .with_in_plane_terms = true,
                   .split = plan.split};
    for (int r = 0; r < plan.rows_per_geometry; ++r) {
      const auto v = loads.next();
      point.loads.push_back({at(plan.mu1, v[0]), at(plan.mu2, v[1])});
    }
    points.push_back(std::move(point));
  }
  return points;
}

}  // namespace brash::training
