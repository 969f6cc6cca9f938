// SPDX-License-Identifier: GPL-3.0-or-later
// Not a test: the superposition against the plate where the ice breaks, with the corrections that go beyond the paper.
// Usage: correction_study N second_order(0|1) radial_first(0|1)
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/failure/criterion.hpp"

namespace {

using namespace brash::failure;

/// The pressure at which `criterion` says that the ice just breaks; the load at it.
LoadCase at_break(const BendingCriterion& criterion, LoadCase load) {
  double low = 0.0, high = 1e8;  // [Pa]
  for (int halving = 0; halving < 50; ++halving) {
    load.pressure = 0.5 * (low + high);
    (criterion.assess(load).fails ? high : low) = load.pressure;
  }
  load.pressure = low;  // the last that does not buckle or split in between
  return load;
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 2;
  const IceProperties ice{
      .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};
  const BendingOptions options{.second_order = std::atoi(argv[2]) == 1, .radial_first = std::atoi(argv[3]) == 1};
  const auto fast = make_criterion(brash::model::FailureModel::kSuperposition, "", ice, options),
             exact = make_criterion(brash::model::FailureModel::kPlate, "", ice, options);
  const double l_c = characteristic_length(ice);
  std::mt19937_64 random(1);
  const auto uniform = [&](double a, double b) { return a + (b - a) * static_cast<double>(random() >> 11) * 0x1p-53; };

  std::vector<double> stress, place;
  for (int i = 0; i < std::atoi(argv[1]); ++i) {
    const double c = 0.05 * std::pow(20.0, uniform(0.0, 1.0));
    LoadCase load{.depth = l_c * (std::exp(uniform(std::log(0.5 * c), std::log(2.0 + 0.5 * c))) - 0.5 * c),
                  .contact_length = l_c * c,
                  .angle = brash::radians(uniform(0.0, 150.0)),
                  .mu1 = 0.511,
                  .mu2 = 0.01};
    load = at_break(*fast, load);
    const Assessment a = fast->assess(load), b = exact->assess(load);
    const double error = b.buckled != a.buckled ? 1.0 : std::abs(a.sigma_max / b.sigma_max - 1.0);
    std::printf("b %.3f c %.3f theta %5.1f p %.3f MPa  %.1f %.1f kPa  %.3f %.3f l_c  %s%s  %.2f %%\n", load.depth / l_c,
                c, load.angle / brash::radians(1.0), load.pressure / 1e6, a.sigma_max / 1e3, b.sigma_max / 1e3,
                a.breaking_length / l_c, b.breaking_length / l_c, a.split ? "split" : "whole", b.split ? "" : "/whole",
                100.0 * error);
    stress.push_back(error);
    place.push_back(std::abs(a.breaking_length - b.breaking_length) / l_c);
  }
  std::printf("stress error: median %.2f %%, 95 %% %.2f %%, largest %.2f %%; place: median %.4f, 95 %% %.3f l_c\n",
              100.0 * quantile(stress, 0.5), 100.0 * quantile(stress, 0.95), 100.0 * quantile(stress, 1.0),
              quantile(place, 0.5), quantile(place, 0.95));
}
