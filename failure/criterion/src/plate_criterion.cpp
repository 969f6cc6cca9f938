// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/plate/plate.hpp"
#include "criteria.hpp"
#include "last_solved.hpp"

namespace brash::failure {

namespace {

/// The fields of first order where the plate buckles.
struct Solved {
  plate::UnitProfiles profiles;
  bool buckled = false;
};

Solved solve(const plate::WedgePlate& wedge) {
  auto profiles = plate::solve(wedge);
  const bool buckled = !profiles && profiles.error().buckled;
  if (buckled) {
    plate::WedgePlate unloaded = wedge;
    unloaded.in_plane_load = 0.0;
    profiles = plate::solve(unloaded);
  }
  if (!profiles) {
    throw RunError(fmt::format("the plate with b = {} l_c, c = {} l_c, theta = {} rad was not solved: {}", wedge.depth,
                               wedge.contact_length, wedge.angle, profiles.error().what));
  }
  return {std::move(*profiles), buckled};
}

}  // namespace

double in_plane_load(const IceProperties& ice, double l_c, double pressure, const BendingOptions& options) {
  if (!options.second_order) return 0.0;
  const double k = ice.water_density * kGravity;  // sqrt(k D) = k l_c^2
  return pressure * ice.thickness / (k * l_c * l_c);
}

namespace {

/// The floating plate solved for each load case; exact in everything that the plate theory holds.
class PlateCriterion final : public BendingCriterion {
 public:
  PlateCriterion(const IceProperties& ice, const BendingOptions& options)
      : ice_(ice), options_(options), l_c_(characteristic_length(ice)) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    plate::WedgePlate wedge{.depth = load.depth / l_c_,
                            .contact_length = load.contact_length / l_c_,
                            .angle = load.angle,
                            .thickness = ice_.thickness / l_c_,
                            .poisson_ratio = ice_.poisson_ratio,
                            .in_plane_load = in_plane_load(ice_, l_c_, load.pressure, options_)};
    Assessment answer;
    plate::Response r = respond(wedge, load, answer.buckled);
    if (options_.radial_first && r.sigma_radial_over_p * load.pressure > ice_.flexural_strength) {
      wedge.split = answer.split = true;
      r = respond(wedge, load, answer.buckled);
    }
    answer.sigma_max = r.sigma_over_p * load.pressure;
    answer.breaking_length = r.lbreak_over_lc * l_c_;
    answer.fails = answer.buckled || answer.sigma_max > ice_.flexural_strength;
    return answer;
  }

  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return std::make_unique<PlateCriterion>(ice, options_);
  }

 private:
  plate::Response respond(const plate::WedgePlate& wedge, const LoadCase& load, bool& buckled) const {
    const Solved solved = last_.get(wedge, solve);
    buckled = buckled || solved.buckled;
    return plate::respond(solved.profiles, wedge.thickness, load.mu1, load.mu2);
  }

  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
  mutable LastSolved<plate::WedgePlate, Solved> last_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_plate_criterion(const IceProperties& ice, const BendingOptions& options) {
  return std::make_unique<PlateCriterion>(ice, options);
}

}  // namespace brash::failure
