// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/criterion.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "criteria.hpp"

namespace brash::failure {

using model::FailureModel;

namespace {

/// A plate is solved where the superposition says more than the strength over this. Where ice bends before it is
/// crushed (sigma/p >= 0.25) it is wrong by less than 5 % on geometries that it has not seen:
/// docs/theory/fracture-of-the-edge.md.
constexpr double kPlateMargin = 1.25;
/// A split sheet has up to 1.3 times the stress of a whole one.
constexpr double kSplitMargin = 1.5;

void expect_valid(const IceProperties& ice) {
  BRASH_EXPECTS(ice.thickness > 0.0 && ice.youngs_modulus > 0.0, ice.thickness, ice.youngs_modulus);
  BRASH_EXPECTS(ice.poisson_ratio >= 0.0 && ice.poisson_ratio < 0.5, ice.poisson_ratio);
  BRASH_EXPECTS(ice.water_density > 0.0 && ice.length_density.value_or(1.0) > 0.0, ice.water_density);
}

std::unique_ptr<BendingCriterion> superposition(const std::string& file, const IceProperties& ice,
                                                const BendingOptions& options) {
  return make_superposition_criterion(model_path(FailureModel::kSuperposition, file), shipped("superposition_split"),
                                      ice, options);
}

/// The stress of the whole sheet screens the stress of a split one.
std::unique_ptr<BendingCriterion> screened(std::unique_ptr<BendingCriterion> exact, const IceProperties& ice,
                                           const BendingOptions& options, double margin) {
  if (options.radial_first) margin *= kSplitMargin;
  return make_screened_criterion(superposition("", ice, {.second_order = options.second_order}), std::move(exact), ice,
                                 margin);
}

void refuse_options(FailureModel model, const std::string& file, const IceProperties& ice,
                    const BendingOptions& options) {
  const model::FailureOptions takes = model::options_of(model, !file.empty());
  if (ice.length_density && !takes.meta_model) {
    throw InputError(
        Complaint{"failure.length_density", fmt::format("= \"ice\" is not for failure.model = \"{}\"", name_of(model)),
                  "failure.model = \"network\" or \"deep-network\"", "take one of these models, or \"water\""});
  }
  if (options.radial_first && !takes.radial_first) {
    throw InputError(
        Complaint{"failure.order",
                  fmt::format("= \"radial-first\" is not for failure.model = \"{}\"{}", name_of(model),
                              file.empty() ? "" : " with a file"),
                  "failure.model = \"plate\", \"plate-outline\", or \"superposition\" without failure.file",
                  "take one of these models, or \"circumferential-first\""});
  }
  if (options.second_order && !takes.second_order) {
    throw InputError(Complaint{
        "failure.second_order", fmt::format("= true is not for failure.model = \"{}\"", name_of(model)),
        "failure.model = \"superposition\", \"plate\" or \"plate-outline\"", "take one of these models, or false"});
  }
}

}  // namespace

void expect_valid(const LoadCase& load) {
  BRASH_EXPECTS(load.depth >= 0.0 && load.contact_length > 0.0, load.depth, load.contact_length);
  BRASH_EXPECTS(load.angle >= 0.0 && load.angle < kPi, load.angle);
  BRASH_EXPECTS(load.mu1 > 0.0 && std::isfinite(load.mu2), load.mu1, load.mu2);
  BRASH_EXPECTS(load.pressure >= 0.0 && std::isfinite(load.pressure), load.pressure);
}

double widened_pressure(double pressure, double wanted, double used, const BendingOptions& options) {
  return wanted < used && !options.keeps_pressure ? pressure * wanted / used : pressure;
}

double characteristic_length(const IceProperties& ice) {
  expect_valid(ice);
  const double E = ice.youngs_modulus, h = ice.thickness, nu = ice.poisson_ratio;
  const double rho = ice.length_density.value_or(ice.water_density);
  return std::pow(E * h * h * h / (12.0 * rho * kGravity * (1.0 - nu * nu)), 0.25);
}

double crushing_force(const IceProperties& ice, double area) {
  BRASH_EXPECTS(area >= 0.0, area);
  return ice.compressive_strength * area * ice.crushing_factor;
}

LoadRatios load_ratios(double slope, double friction, double heading) {
  BRASH_EXPECTS(slope > 0.0 && slope <= kPi / 2, slope);
  BRASH_EXPECTS(friction >= 0.0 && std::isfinite(heading), friction, heading);
  const double sin_a = std::sin(slope), cos_a = std::cos(slope);
  const double along = std::cos(heading), across = std::sin(heading);
  const double slip = std::hypot(along * cos_a, across);
  constexpr double kNoSlip = 1e-12;  // of the structure's speed; below it the direction of slip is round-off
  const double into = along * sin_a;
  double mu = slip > kNoSlip ? friction / slip : 0.0;
  if (into > 0.0) mu = std::min(mu, 1.0 / into);  // the ice sticks
  const double N = sin_a + mu * along * cos_a * cos_a;
  const double P = cos_a - mu * along * sin_a * cos_a;
  return {.horizontal = N, .mu1 = P / N, .mu2 = mu * across / N};
}

std::unique_ptr<BendingCriterion> make_criterion(FailureModel model, const std::string& file, const IceProperties& ice,
                                                 const BendingOptions& options) {
  expect_valid(ice);
  refuse_options(model, file, ice, options);
  switch (model) {
    case FailureModel::kNetwork:
    case FailureModel::kDeepNetwork:
      return make_network_criterion(model_path(model, file), ice, options);
    case FailureModel::kSuperposition:
      return superposition(file, ice, options);
    case FailureModel::kPlate:
      return screened(make_plate_criterion(ice, options), ice, options, kPlateMargin);
    case FailureModel::kPlateOutline:
      return make_outline_criterion(superposition("", ice, {.second_order = options.second_order}), ice, options);
    case FailureModel::kWedge:
      return make_wedge_criterion(ice);
  }
  BRASH_EXPECTS(false, static_cast<int>(model));
  return nullptr;
}

}  // namespace brash::failure
