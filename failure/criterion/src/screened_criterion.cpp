// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Asks a fast criterion first and an exact, slow one only where the fast one does not exclude failure by far.
class ScreenedCriterion final : public BendingCriterion {
 public:
  ScreenedCriterion(std::unique_ptr<BendingCriterion> screen, std::unique_ptr<BendingCriterion> exact,
                    double flexural_strength, double margin)
      : screen_(std::move(screen)), exact_(std::move(exact)), harmless_(flexural_strength / margin) {}

  bool needs_outline() const override { return exact_->needs_outline(); }

  Assessment assess(const LoadCase& load) const override {
    if (load.pressure > 0.0) {
      const Assessment quick = screen_->assess(load);
      if (!quick.above_range && quick.sigma_max < harmless_) {
        return {.sigma_max = quick.sigma_max, .breaking_length = quick.breaking_length};
      }
    }
    return exact_->assess(load);
  }

 private:
  std::unique_ptr<BendingCriterion> screen_;
  std::unique_ptr<BendingCriterion> exact_;
  double harmless_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_screened_criterion(std::unique_ptr<BendingCriterion> screen,
                                                          std::unique_ptr<BendingCriterion> exact,
                                                          double flexural_strength, double margin) {
  return std::make_unique<ScreenedCriterion>(std::move(screen), std::move(exact), flexural_strength, margin);
}

}  // namespace brash::failure
