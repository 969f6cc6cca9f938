// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/plate/plate.hpp"
#include "criteria.hpp"

namespace brash::failure {

namespace {

plate::UnitProfiles solve(const plate::WedgePlate& wedge, bool& buckled) {
  auto profiles = plate::solve(wedge);
  if (!profiles && profiles.error().buckled) {
    buckled = true;
    plate::WedgePlate unloaded = wedge;
    unloaded.in_plane_load = 0.0;
    profiles = plate::solve(unloaded);
  }
  if (!profiles) {
    throw RunError(fmt::format("the plate with b = {} l_c, c = {} l_c, theta = {} rad was not solved: {}", wedge.depth,
                               wedge.contact_length, wedge.angle, profiles.error().what));
  }
  return std::move(*profiles);
}

}  // namespace

double in_plane_load(const IceProperties& ice, double l_c, double pressure, const BendingOptions& options) {
  if (!options.second_order) return 0.0;
  const double k = ice.water_density * kGravity;  // sqrt(k D) = k l_c^2
  return pressure * ice.thickness / (k * l_c * l_c);
}

Assessment assess_trapezoid(const IceProperties& ice, double l_c, const LoadCase& load, const BendingOptions& options) {
  plate::WedgePlate wedge{.depth = load.depth / l_c,
                          .contact_length = load.contact_length / l_c,
                          .angle = load.angle,
                          .thickness = ice.thickness / l_c,
                          .poisson_ratio = ice.poisson_ratio,
                          .in_plane_load = in_plane_load(ice, l_c, load.pressure, options)};
  Assessment answer;
  plate::Response r = plate::respond(solve(wedge, answer.buckled), wedge.thickness, load.mu1, load.mu2);
  if (options.radial_first && r.sigma_radial_over_p * load.pressure > ice.flexural_strength) {
    wedge.split = answer.split = true;
    r = plate::respond(solve(wedge, answer.buckled), wedge.thickness, load.mu1, load.mu2);
  }
  answer.sigma_max = r.sigma_over_p * load.pressure;
  answer.breaking_length = r.lbreak_over_lc * l_c;
  answer.fails = answer.buckled || answer.sigma_max > ice.flexural_strength;
  return answer;
}

namespace {

/// The floating plate solved for each load case; exact in everything that the plate theory holds.
class PlateCriterion final : public BendingCriterion {
 public:
  PlateCriterion(const IceProperties& ice, const BendingOptions& options)
      : ice_(ice), options_(options), l_c_(characteristic_length(ice)) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    return assess_trapezoid(ice_, l_c_, load, options_);
  }

 private:
  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice, const BendingOptions& options) {
  return std::make_unique<PlateCriterion>(ice, options);
}

}  // namespace brash::failure
