// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/standards/ralston.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>

#include <cmath>

#include "brash/core/contract.hpp"

namespace brash::standards {
namespace {

struct EllipticIntegrals {
  double first = 0.0;
  double second = 0.0;
};

/// Complete integrals with modulus k = sin a; the contract keeps k inside (0, 1), where GSL cannot fail.
EllipticIntegrals complete_integrals(double slope) {
  gsl_sf_result first{}, second{};
  const int status_first = gsl_sf_ellint_Kcomp_e(std::sin(slope), GSL_PREC_DOUBLE, &first);
  const int status_second = gsl_sf_ellint_Ecomp_e(std::sin(slope), GSL_PREC_DOUBLE, &second);
  BRASH_EXPECTS(status_first == GSL_SUCCESS && status_second == GSL_SUCCESS, slope);
  return {first.val, second.val};
}

void check(const RalstonInput& in) {
  // sin(slope) rounds to 1 closer to the vertical, where the elliptic integral has its pole.
  BRASH_EXPECTS(in.slope > 0.0 && in.slope < 0.5 * kPi - 1e-6, in.slope);
  BRASH_EXPECTS(in.waterline_width > 0.0 && in.end_width >= 0.0 && in.end_width <= in.waterline_width,
                in.waterline_width, in.end_width);
  BRASH_EXPECTS(in.thickness > 0.0 && in.ride_thickness >= 0.0, in.thickness, in.ride_thickness);
  BRASH_EXPECTS(in.flexural_strength > 0.0 && in.friction_structure >= 0.0);
  BRASH_EXPECTS(in.ice_density > 0.0 && in.water_density > in.ice_density, in.ice_density, in.water_density);
}

}  // namespace

tl::expected<RalstonLoad, NotApplicable> ralston(const RalstonInput& in) {
  check(in);
  const double a = in.slope, mu = in.friction_structure, h = in.thickness, w = in.waterline_width;
  const double sine = std::sin(a), cosine = std::cos(a);
  const double rho = in.breaking == Breaking::kDownward ? in.water_density - in.ice_density : in.ice_density;
  const double Y = in.yield == Yield::kTresca ? 2.711 : 3.422;

  const double g_r = (sine + a / cosine) / (0.5 * kPi * sine * sine + 2.0 * mu * a * cosine);
  const double slip = 1.0 - mu * g_r;
  if (slip <= 0.0) return tl::unexpected(NotApplicable{"friction locks the ice on the slope: mu g_r >= 1"});

  RalstonLoad load;
  const double G = rho * in.gravity * w * w / (4.0 * in.flexural_strength * h);
  const double x = 1.0 + 1.0 / std::sqrt(3.0 * G + 0.5 * Y);
  load.radius_ratio = x;
  load.breaking_horizontal = in.flexural_strength * h * h / 3.0 * std::tan(a) / slip *
                             ((1.0 + Y * x * std::log(x)) / (x - 1.0) + G * (x - 1.0) * (x + 2.0));

  const double h_r = in.ride_thickness > 0.0 ? in.ride_thickness : h;
  const double W = rho * in.gravity * h_r * (w * w - in.end_width * in.end_width) / (4.0 * cosine);
  const EllipticIntegrals E = complete_integrals(a);
  const double f = sine + mu * E.first * cosine;
  load.ride_horizontal = W * (std::tan(a) + mu * E.second - mu * f * g_r * cosine) / slip;

  const double h_v = (f * cosine - mu * E.second) / (0.25 * kPi * sine * sine + mu * a * cosine);
  load.breaking_vertical = load.breaking_horizontal * h_v;
  load.ride_vertical = W * cosine * (0.5 * kPi * cosine - mu * a - f * h_v) + load.ride_horizontal * h_v;
  load.horizontal = load.breaking_horizontal + load.ride_horizontal;
  load.vertical = load.breaking_vertical + load.ride_vertical;
  return load;
}

}  // namespace brash::standards
