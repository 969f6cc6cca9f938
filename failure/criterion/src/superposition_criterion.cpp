// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/failure/response_model.hpp"
#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Interpolated unit profiles, superposed for the case's mu1, mu2 and h / l_c; then the largest stress.
class SuperpositionCriterion final : public BendingCriterion {
 public:
  SuperpositionCriterion(const std::string& file, const IceProperties& ice)
      : model_(meta_model::ProfileModel::read(file)),
        l_c_(characteristic_length(ice)),
        thickness_over_lc_(ice.thickness / l_c_),
        strength_(ice.flexural_strength) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    const meta_model::Geometry wanted{load.depth / l_c_, load.contact_length / l_c_, load.angle};
    const meta_model::RangeCheck range = model_.check(wanted);
    const meta_model::Geometry used = model_.clamp(wanted);
    const plate::Response r =
        plate::respond(to_unit_profiles(model_.predict(used)), thickness_over_lc_, load.mu1, load.mu2);
    // A contact that is widened to the smallest c keeps its force p c h: far from the tip only the force counts.
    const double pressure = wanted.c_lc < used.c_lc ? load.pressure * wanted.c_lc / used.c_lc : load.pressure;
    const double sigma = r.sigma_over_p * pressure;
    return {.fails = sigma > strength_,
            .sigma_max = sigma,
            .breaking_length = r.lbreak_over_lc * l_c_,
            .below_range = range.below,
            .above_range = range.above};
  }

 private:
  meta_model::ProfileModel model_;
  double l_c_;
  double thickness_over_lc_;
  double strength_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const IceProperties& ice) {
  return std::make_unique<SuperpositionCriterion>(file, ice);
}

}  // namespace brash::failure
