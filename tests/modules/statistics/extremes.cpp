// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/statistics/extremes.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "brash/statistics/random.hpp"

namespace {

using namespace brash::statistics;
using Samples = std::vector<double>;
using boost::test_tools::tolerance;

Samples gumbel_sample(double location, double scale, int n, std::uint64_t replicate) {
  RandomStream stream(4, "gumbel", replicate, "maxima");
  Samples x;
  for (int i = 0; i < n; ++i) x.push_back(location - scale * std::log(-std::log(stream.uniform() + 0x1p-50)));
  return x;
}

Samples pareto_sample(double threshold, double scale, double shape, int n, std::uint64_t replicate) {
  RandomStream stream(4, "pareto", replicate, "peaks");
  Samples x;
  for (int i = 0; i < n; ++i) {
    const double e = -std::log1p(-stream.uniform());
    x.push_back(threshold + scale * (shape == 0.0 ? e : std::expm1(shape * e) / shape) + 1e-12);
  }
  return x;
}

double pareto_level(double threshold, double scale, double shape, double expected) {
  return threshold + scale * (shape == 0.0 ? std::log(expected) : std::expm1(shape * std::log(expected)) / shape);
}

bool holds(const Interval& interval, double value) { return interval.lower <= value && value <= interval.upper; }

}  // namespace

BOOST_AUTO_TEST_SUITE(extremes)

BOOST_AUTO_TEST_CASE(gumbel_parameters_are_found_in_a_large_sample) {
  const Gumbel fit = fit_gumbel(gumbel_sample(200.0, 30.0, 20000, 0)).value();
  // Four asymptotic errors: 1.053 beta / sqrt(n) and 0.780 beta / sqrt(n).
  BOOST_CHECK_SMALL(fit.location - 200.0, 4.0 * 1.053 * 30.0 / std::sqrt(20000.0));
  BOOST_CHECK_SMALL(fit.scale - 30.0, 4.0 * 0.780 * 30.0 / std::sqrt(20000.0));
}

BOOST_AUTO_TEST_CASE(a_gumbel_fit_moves_and_stretches_with_the_unit) {
  const Samples x = gumbel_sample(0.0, 1.0, 50, 1);
  Samples y;
  for (const double v : x) y.push_back(1e6 + 1e3 * v);
  const Gumbel a = fit_gumbel(x).value(), b = fit_gumbel(y).value();
  BOOST_TEST(b.scale == 1e3 * a.scale, tolerance(1e-9));  // an offset of 1000 scales costs three digits
  BOOST_TEST(b.location == 1e6 + 1e3 * a.location, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(gumbel_intervals_cover_the_return_level) {
  const double exact = -std::log(-std::log1p(-1.0 / 100.0));
  int covered = 0;
  for (std::uint64_t r = 0; r < 1000; ++r) {
    covered += holds(return_level(fit_gumbel(gumbel_sample(0.0, 1.0, 50, r)).value(), 100.0).interval, exact) ? 1 : 0;
  }
  BOOST_TEST_MESSAGE("coverage " << covered << " of 1000");
  // Asymptotic at n = 50: a per cent or two low; three standard errors of 1000 trials are 2.1 %.
  BOOST_TEST(covered > 1000 * (0.95 - 0.02 - 0.021));
  BOOST_TEST(covered < 1000 * (0.95 + 0.021));
}

BOOST_AUTO_TEST_CASE(pareto_parameters_are_found_for_bounded_exponential_and_heavy_tails) {
  for (const double shape : {-0.3, 0.0, 0.4}) {
    const int n = 20000;
    const GeneralisedPareto fit = fit_generalised_pareto(pareto_sample(100.0, 20.0, shape, n, 0), 100.0).value();
    // Four asymptotic errors: (1 + xi) / sqrt(n) and sigma sqrt(2 (1 + xi) / n).
    BOOST_CHECK_SMALL(fit.shape - shape, 4.0 * (1.0 + shape) / std::sqrt(n));
    BOOST_CHECK_SMALL(fit.scale - 20.0, 4.0 * 20.0 * std::sqrt(2.0 * (1.0 + shape) / n));
    BOOST_TEST(fit.excesses.size() == static_cast<std::size_t>(n));
  }
}

BOOST_AUTO_TEST_CASE(pareto_intervals_cover_the_return_level_inside_twice_the_record) {
  for (const double shape : {-0.2, 0.0, 0.2}) {
    // 200 peaks in 1000 s; the level of 2000 s is exceeded 400 times as rarely as a peak comes.
    const double exact = pareto_level(100.0, 20.0, shape, 400.0);
    int covered = 0;
    for (std::uint64_t r = 0; r < 500; ++r) {
      const auto fit = fit_generalised_pareto(pareto_sample(100.0, 20.0, shape, 200, r), 100.0);
      if (fit) covered += holds(return_level(*fit, 1000.0, 2000.0).interval, exact) ? 1 : 0;
    }
    BOOST_TEST_MESSAGE("shape " << shape << ": coverage " << covered << " of 500");
    // Asymptotic at n = 200: a per cent or two low; three standard errors of 500 trials are 3 %.
    BOOST_TEST(covered > 500 * (0.95 - 0.02 - 0.03));
    BOOST_TEST(covered < 500 * (0.95 + 0.03));
  }
}

BOOST_AUTO_TEST_CASE(return_levels_are_continuous_through_the_exponential_tail) {
  const Samples excesses = pareto_sample(0.0, 20.0, 0.0, 200, 0);
  const Estimate at_zero = return_level({100.0, 20.0, 0.0, excesses}, 1000.0, 5000.0);
  BOOST_TEST(at_zero.value == 100.0 + 20.0 * std::log(1000.0), tolerance(1e-14));
  for (const double shape : {-1e-12, 1e-12, -1e-6, 1e-6}) {
    const Estimate near = return_level({100.0, 20.0, shape, excesses}, 1000.0, 5000.0);
    // First order in the shape: sigma ln^2 / 2 = 477 per unit of shape.
    BOOST_CHECK_SMALL(near.value - at_zero.value - 0.5 * 20.0 * std::pow(std::log(1000.0), 2) * shape, 1e-8);
  }
}

// A rarer level is higher under every law that the likelihood allows. So both ends of its interval are higher too.
BOOST_AUTO_TEST_CASE(ends_of_an_interval_rise_with_the_return_period) {
  for (const int n : {10, 12, 20})
    for (std::uint64_t replicate = 0; replicate < 12; ++replicate) {
      const auto fit = fit_law(Law::kGev, gumbel_sample(100.0, 40.0, n, replicate));
      if (!fit) continue;  // a shape of 1 or more
      Interval last{-1e300, -1e300};
      for (double exceedance = 0.5; exceedance > 1e-4; exceedance /= 1.4) {
        const Interval found = level_with_interval(*fit, exceedance).interval;
        // The search for an end stops within 1e-4 of its distance from the estimate.
        BOOST_TEST(found.lower >= last.lower - 1e-3 * 40.0, n << " maxima, replicate " << replicate);
        BOOST_TEST(found.upper >= 0.999 * last.upper, n << " maxima, replicate " << replicate);
        last = found;
      }
    }
}

BOOST_AUTO_TEST_CASE(samples_that_cannot_be_fitted_say_why) {
  BOOST_TEST(!fit_gumbel(Samples{1.0, 2.0}).has_value());
  BOOST_TEST(fit_gumbel(Samples{2.0, 2.0, 2.0, 2.0}).error().reason == "all maxima are equal");
  BOOST_TEST(!fit_generalised_pareto(Samples{1.0, 2.0, 3.0}, 0.0).has_value());
  // Values that end in a wall have xi near -1, where the likelihood has no maximum.
  Samples wall;
  for (int i = 1; i <= 200; ++i) wall.push_back(1.0 - std::pow(i / 201.0, 4.0));
  BOOST_TEST(!fit_generalised_pareto(wall, 0.0).has_value());
  BOOST_CHECK_THROW(return_level(Gumbel{0.0, 1.0, 10}, 1.0), brash::ContractViolation);
  BOOST_CHECK_THROW(return_level(GeneralisedPareto{0.0, 1.0, 0.1, Samples(10, 1.0)}, 100.0, 5.0),
                    brash::ContractViolation);
}

BOOST_AUTO_TEST_SUITE_END()
