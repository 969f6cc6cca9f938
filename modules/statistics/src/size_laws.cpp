// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "brash/core/contract.hpp"
#include "brash/statistics/laws.hpp"
#include "brash/statistics/sizes.hpp"
#include "gsl_checked.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kFewest = 10;

/// Anderson and Darling's p-value for a normal law with mean and deviation from the sample (Stephens 1986, table 4.9).
double p_of_normal(double a2, double n) {
  const double a = a2 * (1.0 + 0.75 / n + 2.25 / (n * n));
  if (a < 0.2) return 1.0 - std::exp(-13.436 + 101.14 * a - 223.73 * a * a);
  if (a < 0.34) return 1.0 - std::exp(-8.318 + 42.796 * a - 59.938 * a * a);
  if (a < 0.6) return std::exp(0.9177 - 4.279 * a - 1.38 * a * a);
  constexpr double kLast = 13.0;  // the approximation falls up to here; p is below 1e-29
  const double end = std::min(a, kLast);
  return std::exp(1.2937 - 5.709 * end + 0.0186 * end * end);
}

/// Anderson and Darling's A^2 of sorted standardised values against the normal law.
double anderson_darling_normal(const std::vector<double>& sorted) {
  const std::size_t n = sorted.size();
  const auto logarithm = [](double p) { return std::log(std::max(p, 1e-300)); };
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    sum += (2.0 * static_cast<double>(i) + 1.0) *
           (logarithm(gsl_cdf_ugaussian_P(sorted[i])) + logarithm(gsl_cdf_ugaussian_Q(sorted[n - 1 - i])));
  }
  return -static_cast<double>(n) - sum / static_cast<double>(n);
}

std::optional<FitError> fault_of(std::span<const double> sizes) {
  BRASH_EXPECTS(all_finite(sizes) && std::ranges::all_of(sizes, [](double x) { return x > 0.0; }), sizes.size());
  if (sizes.size() < kFewest)
    return FitError{fmt::format("a fit needs at least {} sizes, and has {}", kFewest, sizes.size())};
  if (std::ranges::min(sizes) == std::ranges::max(sizes)) return FitError{"all sizes are equal"};
  return std::nullopt;
}

Estimate on_logarithms(double value, double error) {
  return {value, {value * std::exp(-error), value * std::exp(error)}};
}

}  // namespace

const char* name_of(SizeLaw law) {
  constexpr std::array<const char*, 3> kNames{"log-normal", "Weibull", "power law of the tail"};
  return kNames[static_cast<std::size_t>(law)];
}

double SizeFit::exceedance(double size) const {
  switch (law) {
    case SizeLaw::kLogNormal:
      return size <= 0.0 ? 1.0 : gsl_cdf_ugaussian_Q(std::log(size / scale.value) / shape.value);
    case SizeLaw::kWeibull:
      return size <= 0.0 ? 1.0 : gsl_cdf_weibull_Q(size, scale.value, shape.value);
    case SizeLaw::kPowerTail:
      return size <= scale.value ? 1.0 : std::pow(size / scale.value, 1.0 - shape.value);
  }
  return 0.0;
}

tl::expected<SizeFit, FitError> fit_log_normal_sizes(std::span<const double> sizes, double confidence) {
  if (auto fault = fault_of(sizes)) return tl::unexpected(*std::move(fault));
  quiet_gsl();
  std::vector<double> logarithms;
  for (const double size : sizes) logarithms.push_back(std::log(size));
  std::ranges::sort(logarithms);
  const auto n = static_cast<double>(sizes.size());
  const double mean = gsl_stats_mean(logarithms.data(), 1, sizes.size());
  const double variance = gsl_stats_variance_m(logarithms.data(), 1, sizes.size(), mean);
  const double tail = 0.5 * (1.0 - confidence);
  SizeFit fit{SizeLaw::kLogNormal, {}, {}, sizes.size(), {}};
  // (D2)
  fit.scale = on_logarithms(std::exp(mean), gsl_cdf_tdist_Qinv(tail, n - 1.0) * std::sqrt(variance / n));
  fit.shape.value = std::sqrt(variance * (n - 1.0) / n);
  fit.shape.interval = {std::sqrt((n - 1.0) * variance / gsl_cdf_chisq_Qinv(tail, n - 1.0)),
                        std::sqrt((n - 1.0) * variance / gsl_cdf_chisq_Pinv(tail, n - 1.0))};
  for (double& value : logarithms) value = (value - mean) / std::sqrt(variance);
  fit.goodness.statistic = anderson_darling_normal(logarithms);  // (D3)
  fit.goodness.p_value = p_of_normal(fit.goodness.statistic, n);
  return fit;
}

tl::expected<SizeFit, FitError> fit_weibull_sizes(std::span<const double> sizes, double confidence) {
  if (auto fault = fault_of(sizes)) return tl::unexpected(*std::move(fault));
  quiet_gsl();
  const auto law = fit_law(Law::kWeibull, sizes, 0.0);
  if (!law) return tl::unexpected(law.error());
  const auto n = static_cast<double>(sizes.size());
  const double t = gsl_cdf_tdist_Qinv(0.5 * (1.0 - confidence), n - 2.0);
  // (D4): the inverse of the information matrix
  constexpr double kOfScale = 1.1086, kOfShape = 0.6079;
  SizeFit fit{SizeLaw::kWeibull, {}, {}, sizes.size(), {}};
  const double shape = law->distribution.shape;
  fit.scale = on_logarithms(law->distribution.scale, t * std::sqrt(kOfScale / n) / shape);
  fit.shape = on_logarithms(shape, t * std::sqrt(kOfShape / n));
  GoodnessOfFit goodness;
  fit.goodness = goodness.test(*law);
  return fit;
}

}  // namespace brash::statistics
