// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "brash/core/error.hpp"
#include "brash/plate/plate.hpp"
#include "criteria.hpp"

namespace brash::failure {

Assessment assess_trapezoid(const IceProperties& ice, double l_c, const LoadCase& load) {
  const double thickness_over_lc = ice.thickness / l_c;
  const auto profiles = plate::solve({.depth = load.depth / l_c,
                                      .contact_length = load.contact_length / l_c,
                                      .angle = load.angle,
                                      .thickness = thickness_over_lc,
                                      .poisson_ratio = ice.poisson_ratio});
  if (!profiles) {
    throw RunError(fmt::format("the plate with b = {} m, c = {} m, theta = {} rad was not solved: {}", load.depth,
                               load.contact_length, load.angle, profiles.error().what));
  }
  const plate::Response r = plate::respond(*profiles, thickness_over_lc, load.mu1, load.mu2);
  const double sigma = r.sigma_over_p * load.pressure;
  return {.fails = sigma > ice.flexural_strength, .sigma_max = sigma, .breaking_length = r.lbreak_over_lc * l_c};
}

namespace {

/// The floating plate solved for each load case; exact in everything that the plate theory holds.
class PlateCriterion final : public BendingCriterion {
 public:
  explicit PlateCriterion(const IceProperties& ice) : ice_(ice), l_c_(characteristic_length(ice)) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    return assess_trapezoid(ice_, l_c_, load);
  }

 private:
  IceProperties ice_;
  double l_c_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice) {
  return std::make_unique<PlateCriterion>(ice);
}

}  // namespace brash::failure
