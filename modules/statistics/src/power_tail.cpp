// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/statistics/quantile.hpp"
#include "brash/statistics/random.hpp"
#include "brash/statistics/sizes.hpp"
#include "samples.hpp"

namespace brash::statistics {
namespace {

constexpr std::size_t kFewest = 50;  // sizes; Clauset, Shalizi and Newman find that fewer show nothing
constexpr std::size_t kFewestInTail = 10;
constexpr double kSteepest = 1e6;  // exponent of a tail of equal sizes

/// A tail of sorted logarithms: those from `first` on.
struct Tail {
  std::size_t first = 0;
  double exponent = 0.0;
  double distance = 2.0;  ///< Kolmogorov and Smirnov's, at most 1
};

/// The exponent of the tail and its distance from the law, (D5); gives up where it exceeds `enough`.
Tail tail_from(const std::vector<double>& logarithms, const std::vector<double>& sums, std::size_t first,
               double enough) {
  const auto n = static_cast<double>(logarithms.size() - first);
  const double excess = sums[first] - n * logarithms[first];
  Tail tail{first, excess > 0.0 ? std::min(kSteepest, 1.0 + n / excess) : kSteepest, 0.0};
  for (std::size_t i = first; i < logarithms.size() && tail.distance <= enough; ++i) {
    const double law = -std::expm1((1.0 - tail.exponent) * (logarithms[i] - logarithms[first]));
    const auto below = static_cast<double>(i - first);
    tail.distance = std::max({tail.distance, std::abs(law - below / n), std::abs(law - (below + 1.0) / n)});
  }
  return tail;
}

/// The tail that lies nearest to its law.
Tail best_tail(const std::vector<double>& logarithms, std::size_t most_candidates) {
  std::vector<double> sums(logarithms.size() + 1, 0.0);
  for (std::size_t i = logarithms.size(); i-- > 0;) sums[i] = sums[i + 1] + logarithms[i];
  const std::size_t n_starts = logarithms.size() - kFewestInTail + 1;
  const std::size_t n_candidates = std::min(most_candidates, n_starts);
  Tail best;
  for (std::size_t c = 0; c < n_candidates; ++c) {
    std::size_t first = c * n_starts / n_candidates;
    while (first > 0 && logarithms[first - 1] == logarithms[first]) --first;  // a tail holds all equal sizes
    const Tail tail = tail_from(logarithms, sums, first, best.distance);
    if (tail.distance < best.distance) best = tail;
  }
  return best;
}

std::size_t index_below(RandomStream& stream, std::size_t n) {
  return std::min(n - 1, static_cast<std::size_t>(stream.uniform() * static_cast<double>(n)));
}

/// A sample like the sizes: those below the tail drawn again, the tail from its law, (D6).
std::vector<double> simulated(const std::vector<double>& logarithms, const Tail& tail, RandomStream& stream) {
  std::vector<double> sample(logarithms.size());
  for (double& value : sample) {
    const std::size_t i = index_below(stream, logarithms.size());
    value =
        i < tail.first ? logarithms[i] : logarithms[tail.first] - std::log1p(-stream.uniform()) / (tail.exponent - 1.0);
  }
  std::ranges::sort(sample);
  return sample;
}

std::vector<double> resampled(const std::vector<double>& logarithms, RandomStream& stream) {
  std::vector<double> sample(logarithms.size());
  for (double& value : sample) value = logarithms[index_below(stream, logarithms.size())];
  std::ranges::sort(sample);
  return sample;
}

Interval percentiles(const std::vector<double>& values, double confidence) {
  const double levels[] = {0.5 * (1.0 - confidence), 0.5 * (1.0 + confidence)};
  const std::vector<double> ends = quantiles(values, levels);
  return {ends[0], ends[1]};
}

}  // namespace

tl::expected<SizeFit, FitError> fit_power_tail(std::span<const double> sizes, const TailSettings& settings) {
  BRASH_EXPECTS(all_finite(sizes) && std::ranges::all_of(sizes, [](double x) { return x > 0.0; }), sizes.size());
  BRASH_EXPECTS(settings.n_resamples > 0 && settings.most_candidates > 0);
  if (sizes.size() < kFewest)
    return tl::unexpected(FitError{fmt::format("a tail needs at least {} sizes, and has {}", kFewest, sizes.size())});
  if (std::ranges::min(sizes) == std::ranges::max(sizes)) return tl::unexpected(FitError{"all sizes are equal"});
  std::vector<double> logarithms;
  for (const double size : sizes) logarithms.push_back(std::log(size));
  std::ranges::sort(logarithms);

  const Tail tail = best_tail(logarithms, settings.most_candidates);
  RandomStream stream(1, "sizes", sizes.size(), "power tail");
  std::vector<double> starts, exponents;
  std::size_t n_farther = 0;
  for (std::size_t r = 0; r < settings.n_resamples; ++r) {
    const std::vector<double> drawn = resampled(logarithms, stream);
    const Tail again = best_tail(drawn, settings.most_candidates);
    starts.push_back(std::exp(drawn[again.first]));
    exponents.push_back(again.exponent);
    const Tail of_law = best_tail(simulated(logarithms, tail, stream), settings.most_candidates);
    if (of_law.distance >= tail.distance) ++n_farther;
  }
  SizeFit fit{SizeLaw::kPowerTail, {}, {}, sizes.size() - tail.first, {}};
  fit.scale = {std::exp(logarithms[tail.first]), percentiles(starts, settings.confidence)};
  fit.shape = {tail.exponent, percentiles(exponents, settings.confidence)};
  fit.goodness = {tail.distance,
                  (1.0 + static_cast<double>(n_farther)) / (1.0 + static_cast<double>(settings.n_resamples))};
  return fit;
}

}  // namespace brash::statistics
