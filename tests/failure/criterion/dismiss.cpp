// SPDX-License-Identifier: GPL-3.0-or-later
// Loads that the superposition dismisses without a look at the profiles, against its full assessment.
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/core/constants.hpp"
#include "brash/failure/criterion.hpp"

namespace {

using namespace brash;
using namespace brash::failure;

IceProperties ice_of(double thickness) {
  return {.thickness = thickness, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};
}

/// Load cases of all kinds, some beyond the model's range.
class Loads {
 public:
  explicit Loads(double l_c) : l_c_(l_c) {}

  LoadCase next() {
    return {.depth = between(0.0, 2.2) * l_c_,
            .contact_length = over_decades(0.01, 2.2) * l_c_,
            .angle = radians(between(0.0, 150.0)),
            .mu1 = over_decades(1e-3, 5.0),
            .mu2 = between(-1.0, 1.0),
            .pressure = over_decades(1e2, 1e6)};
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
  double over_decades(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  double l_c_;
  std::mt19937_64 random_{20261123};
};

/// Dismissed loads against their assessment. @return the largest stress of them over the strength.
double compare(const IceProperties& ice, const BendingOptions& options) {
  const auto criterion = make_criterion(model::FailureModel::kSuperposition, "", ice, options);
  Loads loads(characteristic_length(ice));
  double largest = 0.0;
  int n_weak = 0, n_weak_dismissed = 0, n_wrong = 0;
  for (int i = 0; i < 1500; ++i) {
    const LoadCase load = loads.next();
    const auto dismissed = criterion->dismiss(load);
    const Assessment whole = criterion->assess(load);
    if (whole.sigma_max < 0.05 * ice.flexural_strength) {
      ++n_weak;
      n_weak_dismissed += dismissed ? 1 : 0;
    }
    if (!dismissed) continue;
    largest = std::max(largest, whole.sigma_max / ice.flexural_strength);
    n_wrong += whole.fails || whole.buckled || whole.split || dismissed->fails ||
                       dismissed->below_range != whole.below_range || dismissed->above_range != whole.above_range
                   ? 1
                   : 0;
  }
  BOOST_TEST(n_wrong == 0);
  // Dismissed loads save time: most loads of a run are weak.
  BOOST_TEST(n_weak_dismissed > 0.7 * n_weak);
  BOOST_TEST_MESSAGE("h = " << ice.thickness << " m: " << n_weak_dismissed << " of " << n_weak
                            << " weak loads dismissed, largest stress of a dismissed one " << largest
                            << " of the strength");
  return largest;
}

BOOST_AUTO_TEST_CASE(no_load_is_dismissed_that_comes_near_the_strength) {
  // h / l_c from below the model's range to above it.
  for (const double thickness : {0.02, 0.33, 1.0, 4.0}) {
    for (const bool second_order : {false, true}) {
      for (const bool radial_first : {false, true}) {
        BOOST_TEST_CONTEXT("h = " << thickness << " m, second order " << second_order << ", radial " << radial_first) {
          BOOST_TEST(compare(ice_of(thickness), {second_order, radial_first}) < 0.5);
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(criteria_that_cost_little_dismiss_nothing) {
  for (const auto model : {model::FailureModel::kNetwork, model::FailureModel::kWedge})
    BOOST_TEST(!make_criterion(model, "", ice_of(0.33))
                    ->dismiss({.contact_length = 0.3, .angle = 1.0, .mu1 = 0.5, .pressure = 1.0}));
}

}  // namespace
