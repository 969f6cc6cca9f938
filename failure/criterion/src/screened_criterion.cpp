// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Whether `criterion` knows the h / l_c of `ice`. Outside its range it answers for another thickness.
bool knows_thickness(const BendingCriterion& criterion, const IceProperties& ice) {
  const auto range = criterion.thickness_over_lc_range();
  const double wanted = ice.thickness / characteristic_length(ice);
  return !range || (range->first <= wanted && wanted <= range->second);
}

/// Asks a fast criterion first and an exact, slow one only where the fast one does not exclude failure by far.
class ScreenedCriterion final : public BendingCriterion {
 public:
  ScreenedCriterion(std::unique_ptr<BendingCriterion> fast, std::unique_ptr<BendingCriterion> exact,
                    const IceProperties& ice, double margin)
      : fast_(std::move(fast)),
        exact_(std::move(exact)),
        knows_thickness_(failure::knows_thickness(*fast_, ice)),
        harmless_stress_(ice.flexural_strength / margin),
        margin_(margin) {}

  bool needs_outline() const override { return exact_->needs_outline(); }

  Assessment assess(const LoadCase& load) const override {
    if (knows_thickness_ && load.pressure > 0.0) {
      const Assessment quick = fast_->assess(load);
      if (!quick.above_range && !quick.buckled && quick.sigma_max < harmless_stress_)
        return {.sigma_max = quick.sigma_max, .breaking_length = quick.breaking_length};
    }
    return exact_->assess(load);
  }

  std::unique_ptr<BendingCriterion> for_ice(const IceProperties& ice) const override {
    return make_screened_criterion(fast_->for_ice(ice), exact_->for_ice(ice), ice, margin_);
  }

 private:
  std::unique_ptr<BendingCriterion> fast_;
  std::unique_ptr<BendingCriterion> exact_;
  bool knows_thickness_;    ///< of `fast_`
  double harmless_stress_;  ///< [Pa]
  double margin_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_screened_criterion(std::unique_ptr<BendingCriterion> fast,
                                                          std::unique_ptr<BendingCriterion> exact,
                                                          const IceProperties& ice, double margin) {
  return std::make_unique<ScreenedCriterion>(std::move(fast), std::move(exact), ice, margin);
}

}  // namespace brash::failure
