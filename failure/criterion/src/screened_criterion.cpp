// SPDX-License-Identifier: GPL-3.0-or-later
#include <utility>

#include "criteria.hpp"

namespace brash::failure {
namespace {

/// Asks a fast criterion first and an exact, slow one only where the fast one does not exclude failure by far.
class ScreenedCriterion final : public BendingCriterion {
 public:
  ScreenedCriterion(std::unique_ptr<BendingCriterion> fast, std::unique_ptr<BendingCriterion> exact,
                    const Screen& screen)
      : fast_(std::move(fast)), exact_(std::move(exact)), screen_(screen) {}

  bool needs_outline() const override { return exact_->needs_outline(); }

  Assessment assess(const LoadCase& load) const override {
    if (load.pressure > 0.0 && load.pressure < screen_.harmless_pressure) {
      const Assessment quick = fast_->assess(load);
      if (!quick.above_range && quick.sigma_max < screen_.harmless_stress) {
        return {.sigma_max = quick.sigma_max, .breaking_length = quick.breaking_length};
      }
    }
    return exact_->assess(load);
  }

 private:
  std::unique_ptr<BendingCriterion> fast_;
  std::unique_ptr<BendingCriterion> exact_;
  Screen screen_;
};

}  // namespace

std::unique_ptr<BendingCriterion> make_screened_criterion(std::unique_ptr<BendingCriterion> fast,
                                                          std::unique_ptr<BendingCriterion> exact,
                                                          const Screen& screen) {
  return std::make_unique<ScreenedCriterion>(std::move(fast), std::move(exact), screen);
}

}  // namespace brash::failure
