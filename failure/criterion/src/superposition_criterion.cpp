// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "brash/failure/unit_profiles.hpp"
#include "brash/meta_model/profile_bound.hpp"
#include "criteria.hpp"

namespace brash::failure {

plate::UnitProfiles to_unit_profiles(const meta_model::Profiles& p) {
  plate::UnitProfiles unit;
  unit.station = p.station;
  for (std::size_t i = 0; i < p.station.size(); ++i) {
    unit.bending.push_back({p.bending_xx[i], p.bending_yy[i], 0.0});
    unit.normal.push_back({p.normal_xx[i], p.normal_yy[i], 0.0});
    unit.tangential.push_back({0.0, 0.0, p.tangential_xy[i]});
  }
  for (std::size_t i = 0; i < p.first_xx.size(); ++i) {
    unit.in_plane.first.push_back({p.first_xx[i], p.first_yy[i], 0.0});
    unit.in_plane.rest.push_back({p.rest_xx[i], p.rest_yy[i], 0.0});
  }
  unit.in_plane.buckling_load = p.buckling_load;
  return unit;
}

namespace {

/// A load is dismissed that is so many times below the strength, as far as the bound shows. Where it was tried, the
/// bound was never exceeded (`failure_dismiss`).
constexpr double kDismissed = 2.0;
/// Share of the buckling load up to which the bound holds.
constexpr double kFarFromBuckling = 0.5;

/// Interpolated unit profiles, superposed for the case's mu1, mu2 and h / l_c; then the largest stress.
class SuperpositionCriterion final : public BendingCriterion {
 public:
  using Model = std::shared_ptr<const meta_model::ProfileModel>;

  /// @param split  nothing where the options do not ask for it.
  SuperpositionCriterion(Model whole, Model split, const IceProperties& ice, const BendingOptions& options)
      : SuperpositionCriterion(whole, std::move(split), meta_model::ProfileBound(*whole, shear_thickness(*whole, ice)),
                               ice, options) {}
  SuperpositionCriterion(Model whole, Model split, const meta_model::ProfileBound& bound, const IceProperties& ice,
                         const BendingOptions& options)
      : whole_(std::move(whole)),
        split_(std::move(split)),
        ice_(ice),
        options_(options),
        l_c_(characteristic_length(ice)),
        thickness_over_lc_(ice.thickness / l_c_),
        shear_thickness_(shear_thickness(*whole_, ice)),
        bound_(bound) {}

  Assessment assess(const LoadCase& load) const override {
    const auto [used, pressure, answer_so_far] = place(load);
    Assessment answer = answer_so_far;
    plate::Response r = respond(*whole_, used, pressure, load, answer.buckled);
    if (split_ && r.sigma_radial_over_p * pressure > ice_.flexural_strength) {
      answer.split = true;
      r = respond(*split_, used, pressure, load, answer.buckled);
    }
    answer.sigma_max = r.sigma_over_p * pressure;
    answer.breaking_length = r.lbreak_over_lc * l_c_;
    answer.fails = answer.buckled || answer.sigma_max > ice_.flexural_strength;
    return answer;
  }

  bool above_range(const LoadCase& load) const override { return place(load).answer.above_range; }

  /// Largest principal and edge stress by docs/theory/fracture-of-the-edge.md, (N2).
  std::optional<Assessment> dismiss(const LoadCase& load) const override {
    const auto [used, pressure, answer] = place(load);
    const meta_model::ProfileExtremes most = bound_.at(used);
    const double r = kDismissed * in_plane_load(ice_, l_c_, pressure, options_) / most.buckling_load;
    if (r > kFarFromBuckling) return std::nullopt;
    const double bending = most.bending + r * most.first + r * r / (1.0 - r) * most.rest;
    const double stress =
        pressure * (6.0 * load.mu1 / thickness_over_lc_ * bending + most.normal + std::abs(load.mu2) * most.tangential);
    if (kDismissed * stress > ice_.flexural_strength) return std::nullopt;
    return answer;
  }

  std::optional<std::pair<double, double>> thickness_over_lc_range() const override {
    return std::pair(whole_->range()[0].h_lc, whole_->range()[1].h_lc);
  }

  /// The bound stays: it depends on h / l_c by shear alone.
  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return std::make_unique<SuperpositionCriterion>(whole_, split_, bound_, ice, options_);
  }

 private:
  static double shear_thickness(const meta_model::ProfileModel& model, const IceProperties& ice) {
    return std::clamp(ice.thickness / characteristic_length(ice), model.range()[0].h_lc, model.range()[1].h_lc);
  }

  /// A load case as the model can answer it.
  struct Placed {
    meta_model::Geometry geometry;  ///< inside the range
    double pressure = 0.0;          ///< [Pa]
    Assessment answer;              ///< with its range flags set
  };

  Placed place(const LoadCase& load) const {
    expect_valid(load);
    const meta_model::Geometry wanted{load.depth / l_c_, load.contact_length / l_c_, load.angle, shear_thickness_};
    const meta_model::RangeCheck range = whole_->check(wanted);
    const meta_model::Geometry used = whole_->clamp(wanted);
    const double pressure = widened_pressure(load.pressure, wanted.c_lc, used.c_lc, options_);
    return {used,
            pressure,
            {.below_range = range.below || shear_thickness_ != thickness_over_lc_, .above_range = range.above}};
  }

  plate::Response respond(const meta_model::ProfileModel& model, const meta_model::Geometry& geometry, double pressure,
                          const LoadCase& load, bool& buckled) const {
    plate::UnitProfiles unit = to_unit_profiles(model.predict(model.clamp(geometry), options_.second_order));
    if (options_.second_order) {
      auto bent = plate::compressed(unit, in_plane_load(ice_, l_c_, pressure, options_));
      if (bent)
        unit = std::move(*bent);
      else
        buckled = true;
    }
    return plate::respond(unit, thickness_over_lc_, load.mu1, load.mu2);
  }

  Model whole_;
  Model split_;  ///< by a radial crack
  IceProperties ice_;
  BendingOptions options_;
  double l_c_;
  double thickness_over_lc_;
  double shear_thickness_;  ///< the same moved into the model's range: no shorter step brings it there
  meta_model::ProfileBound bound_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_superposition_criterion(const std::string& file, const std::string& split_file,
                                                               const IceProperties& ice,
                                                               const BendingOptions& options) {
  using Model = meta_model::ProfileModel;
  auto split = options.radial_first ? std::make_shared<const Model>(Model::read(split_file)) : nullptr;
  return std::make_unique<SuperpositionCriterion>(std::make_shared<const Model>(Model::read(file)), std::move(split),
                                                  ice, options);
}

}  // namespace brash::failure
