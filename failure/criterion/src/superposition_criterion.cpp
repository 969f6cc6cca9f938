// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "brash/failure/unit_profiles.hpp"
#include "criteria.hpp"

namespace brash::failure {

plate::UnitProfiles to_unit_profiles(const meta_model::Profiles& p) {
  plate::UnitProfiles unit;
  unit.station = p.station;
  for (std::size_t i = 0; i < p.station.size(); ++i) {
    unit.bending.push_back({p.bending_xx[i], p.bending_yy[i], 0.0});
    unit.normal.push_back({p.normal_xx[i], p.normal_yy[i], 0.0});
    unit.tangential.push_back({0.0, 0.0, p.tangential_xy[i]});
    unit.in_plane.first.push_back({p.first_xx[i], p.first_yy[i], 0.0});
    unit.in_plane.rest.push_back({p.rest_xx[i], p.rest_yy[i], 0.0});
  }
  unit.in_plane.buckling_load = p.buckling_load;
  return unit;
}

namespace {

/// Interpolated unit profiles, superposed for the case's mu1, mu2 and h / l_c; then the largest stress.
class SuperpositionCriterion final : public BendingCriterion {
 public:
  SuperpositionCriterion(const std::string& file, const IceProperties& ice, const BendingOptions& options)
      : model_(meta_model::ProfileModel::read(file)),
        ice_(ice),
        options_(options),
        l_c_(characteristic_length(ice)),
        thickness_over_lc_(ice.thickness / l_c_),
        shear_thickness_(std::clamp(thickness_over_lc_, model_.range()[0].h_lc, model_.range()[1].h_lc)) {}

  Assessment assess(const LoadCase& load) const override {
    expect_valid(load);
    const meta_model::Geometry wanted{load.depth / l_c_, load.contact_length / l_c_, load.angle, shear_thickness_};
    const meta_model::RangeCheck range = model_.check(wanted);
    const meta_model::Geometry used = model_.clamp(wanted);
    // A contact that is widened to the smallest c keeps its force p c h: far from the tip only the force counts.
    const double pressure = wanted.c_lc < used.c_lc ? load.pressure * wanted.c_lc / used.c_lc : load.pressure;
    plate::UnitProfiles unit = to_unit_profiles(model_.predict(used));
    const auto bent = plate::compressed(unit, in_plane_load(ice_, l_c_, pressure, options_));
    const plate::Response r = plate::respond(bent ? *bent : unit, thickness_over_lc_, load.mu1, load.mu2);
    const double sigma = r.sigma_over_p * pressure;
    return {.fails = !bent || sigma > ice_.flexural_strength,
            .sigma_max = sigma,
            .breaking_length = r.lbreak_over_lc * l_c_,
            .below_range = range.below || shear_thickness_ != thickness_over_lc_,
            .above_range = range.above,
            .buckled = !bent};
  }

 private:
  meta_model::ProfileModel model_;
  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
  double thickness_over_lc_;
  double shear_thickness_;  ///< the same moved into the model's range: no shorter step brings it there
};

}  // namespace

std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const IceProperties& ice,
                                                               const BendingOptions& options) {
  return std::make_unique<SuperpositionCriterion>(file, ice, options);
}

}  // namespace brash::failure
