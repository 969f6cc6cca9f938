// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>

#include "brash/statistics/laws.hpp"
#include "brash/statistics/random.hpp"
#include "gsl_checked.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kResamples = 199;  // p to about 0.015 at 0.05
/// Numbers of values that are simulated; beyond the last the distribution of the statistic does not change.
constexpr std::array<std::size_t, 6> kSimulated{10, 15, 20, 30, 50, 100};

/// A^2 of values at sorted probabilities of exceedance; docs/theory/statistics.md, (S11).
double anderson_darling(const LawFit& fit) {
  const std::size_t n = fit.values.size();
  const auto logarithm = [](double p) { return std::log(std::max(p, 1e-300)); };
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const double above = fit.distribution.exceedance(fit.values[i]);
    const double opposite = fit.distribution.exceedance(fit.values[n - 1 - i]);
    sum += (2.0 * static_cast<double>(i) + 1.0) * (logarithm(1.0 - above) + logarithm(opposite));
  }
  return -static_cast<double>(n) - sum / static_cast<double>(n);
}

/// The largest simulated number up to n.
std::size_t simulated_number(std::size_t n) {
  const auto above = std::ranges::upper_bound(kSimulated, n);
  return above == kSimulated.begin() ? kSimulated.front() : *(above - 1);
}

}  // namespace

std::vector<double> GoodnessOfFit::simulate(const Key& key) {
  RandomStream stream(1, name_of(key.law), static_cast<std::uint64_t>(key.shape + 100), "goodness of fit", key.n);
  const double shape = key.law == Law::kWeibull ? 1.0 : 0.1 * key.shape;  // a power of a Weibull load is one too
  const Distribution law{key.law, 0.0, 1.0, shape};
  std::vector<double> sample(key.n), found;
  for (std::size_t r = 0; r < kResamples; ++r) {
    for (double& value : sample) value = law.level(stream.uniform() + 0x1p-49);
    if (const auto fit = fit_law(key.law, sample)) found.push_back(anderson_darling(*fit));
  }
  std::ranges::sort(found);
  return found;
}

TestResult GoodnessOfFit::test(const LawFit& fit) {
  quiet_gsl();
  const Distribution& law = fit.distribution;
  const bool has_shape = law.law == Law::kGev || law.law == Law::kPareto;
  const Key key{law.law, has_shape ? static_cast<int>(std::round(10.0 * law.shape)) : 0,
                simulated_number(fit.values.size())};
  auto known = statistics_.find(key);
  if (known == statistics_.end()) known = statistics_.emplace(key, simulate(key)).first;
  const std::vector<double>& simulated = known->second;
  const double observed = anderson_darling(fit);
  const auto worse = simulated.end() - std::ranges::lower_bound(simulated, observed);
  return {observed, (1.0 + static_cast<double>(worse)) / (1.0 + static_cast<double>(simulated.size()))};
}

}  // namespace brash::statistics
