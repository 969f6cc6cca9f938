// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "brash/meta_model/network.hpp"
#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Ice whose Eq. 18 has the water's density, as in the training plates.
IceProperties on_water(IceProperties ice) {
  ice.length_density.reset();
  return ice;
}

/// A network with the inputs and outputs of Eq. 17, by Eq. 19: lengths over l_c, stress over p.
class NetworkCriterion final : public BendingCriterion {
 public:
  NetworkCriterion(std::shared_ptr<const meta_model::ResponseNetwork> network, const IceProperties& ice,
                   const BendingOptions& options)
      : network_(std::move(network)),
        options_(options),
        l_c_(characteristic_length(ice)),
        thickness_over_lc_(ice.thickness / characteristic_length(on_water(ice))),
        strength_(ice.flexural_strength) {}

  bool above_range(const LoadCase& load) const override { return network_->check(input(load)).above; }

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    const meta_model::Input wanted = input(load);
    const meta_model::RangeCheck range = network_->check(wanted);
    const meta_model::Input used = network_->clamp(wanted);
    const meta_model::Output y = network_->predict(used);

    const double pressure = widened_pressure(load.pressure, wanted.c_lc, used.c_lc, options_);
    // Eq. 19: sigma / p goes as l_c / h, by E and h alone.
    const double sigma = y.sigma_over_p * pressure * network_->thickness_over_lc() / thickness_over_lc_;
    return {.fails = sigma > strength_,
            .sigma_max = sigma,
            .breaking_length = y.lbreak_over_lc * l_c_,
            .below_range = range.below,
            .above_range = range.above};
  }

  std::optional<double> trained_thickness_over_lc() const override { return network_->thickness_over_lc(); }

  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return std::make_unique<NetworkCriterion>(network_, ice, options_);
  }

 private:
  meta_model::Input input(const LoadCase& load) const {
    return {.b_lc = load.depth / l_c_,
            .c_lc = load.contact_length / l_c_,
            .theta = load.angle,
            .mu1 = load.mu1,
            .mu2 = load.mu2};
  }

  std::shared_ptr<const meta_model::ResponseNetwork> network_;
  BendingOptions options_;
  double l_c_;
  double thickness_over_lc_;  ///< on water
  double strength_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_network_criterion(const std::string& file, const IceProperties& ice,
                                                         const BendingOptions& options) {
  return std::make_unique<NetworkCriterion>(meta_model::read_network(file), ice, options);
}

}  // namespace brash::failure
