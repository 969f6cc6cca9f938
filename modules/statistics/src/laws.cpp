// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/laws.hpp"

#include <gsl/gsl_cdf.h>

#include <array>
#include <cmath>
#include <limits>

#include "brash/core/contract.hpp"

namespace brash::statistics {
namespace {

constexpr double kNever = -std::numeric_limits<double>::infinity();
constexpr double kNoShape = 1e-9;  // a shape nearer to 0 is 0: its powers are rounding

/// ln(1 + xi z)/xi, z for xi = 0; not a number outside the support.
double log_term(double shape, double z) {
  if (std::abs(shape) < kNoShape) return z;
  return shape * z <= -1.0 ? std::nan("") : std::log1p(shape * z) / shape;
}

/// (e^(xi w) - 1)/xi, w for xi = 0.
double grown(double shape, double w) { return std::abs(shape) < kNoShape ? w : std::expm1(shape * w) / shape; }

double pareto_exceedance(double shape, double z) {
  if (z <= 0.0) return 1.0;
  const double w = log_term(shape, z);
  return std::isnan(w) ? 0.0 : std::exp(-w);
}

double gev_exceedance(double shape, double z) {
  const double w = log_term(shape, z);
  if (std::isnan(w)) return shape > 0.0 ? 1.0 : 0.0;
  return -std::expm1(-std::exp(-w));
}

}  // namespace

const char* name_of(Law law) {
  constexpr std::array<const char*, 5> kNames{"Gumbel", "GEV", "Pareto", "Weibull", "Rayleigh"};
  return kNames[static_cast<std::size_t>(law)];
}

bool is_of_blocks(Law law) { return law == Law::kGumbel || law == Law::kGev; }

double Distribution::exceedance(double x) const {
  const double z = (x - location) / scale;
  switch (law) {
    case Law::kGumbel:
    case Law::kGev:
      return gev_exceedance(shape, z);
    case Law::kPareto:
      return pareto_exceedance(shape, z);
    case Law::kWeibull:
      return z <= 0.0 ? 1.0 : gsl_cdf_weibull_Q(x - location, scale, shape);
    case Law::kRayleigh:
      return z <= 0.0 ? 1.0 : gsl_cdf_rayleigh_Q(x - location, scale);
  }
  return 0.0;
}

double Distribution::level(double exceedance) const {
  BRASH_EXPECTS(exceedance > 0.0 && exceedance < 1.0, exceedance);
  switch (law) {
    case Law::kGumbel:
    case Law::kGev:
      return location + scale * grown(shape, -std::log(-std::log1p(-exceedance)));
    case Law::kPareto:
      return location + scale * grown(shape, -std::log(exceedance));
    case Law::kWeibull:
      return location + gsl_cdf_weibull_Qinv(exceedance, scale, shape);
    case Law::kRayleigh:
      return location + gsl_cdf_rayleigh_Qinv(exceedance, scale);
  }
  return location;
}

double Distribution::log_density(double x) const {
  const double z = (x - location) / scale;
  if (is_of_blocks(law)) {
    const double w = log_term(shape, z);
    return std::isnan(w) ? kNever : -std::log(scale) - (1.0 + shape) * w - std::exp(-w);
  }
  if (z < 0.0) return kNever;
  if (law == Law::kPareto) {
    const double w = log_term(shape, z);
    return std::isnan(w) ? kNever : -std::log(scale) - (1.0 + shape) * w;
  }
  if (law == Law::kWeibull) return std::log(shape / scale) + (shape - 1.0) * std::log(z) - std::pow(z, shape);
  return std::log(z / scale) - 0.5 * z * z;
}

}  // namespace brash::statistics
