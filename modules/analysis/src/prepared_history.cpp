// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "brash/analysis/load_history.hpp"
#include "brash/core/error.hpp"

namespace brash::analysis {
namespace {

constexpr double kMostSamples = 134217728.0;  // 2^27: times and values take 2 GiB
constexpr double kAntiAlias = 0.4;            // of the new sampling frequency; at half of it slower waves would appear

/// Adds samples every `step` between the first and the last one of a piece.
void add_resampled(const std::vector<double>& samples, double start, double old_step, double step,
                   statistics::History& out) {
  // A thousandth absorbs the rounding of a last sample that lies on the grid.
  const double length = old_step * static_cast<double>(samples.size() - 1);
  const auto n = static_cast<std::size_t>(length / step + 1e-3) + 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double at = std::min(step * static_cast<double>(i), length);
    const auto before = std::min(static_cast<std::size_t>(at / old_step), samples.size() - 1);
    const std::size_t after = std::min(before + 1, samples.size() - 1);
    const double share = at / old_step - static_cast<double>(before);
    out.times.push_back(start + at);
    out.values.push_back(samples[before] + share * (samples[after] - samples[before]));
  }
}

/// Refuses a step of so many samples that their memory is a mistake.
void require_few_samples(const LoadHistory& load, double step) {
  double length = 0.0;
  const statistics::Pieces pieces = load.even.pieces(load.history);
  for (const auto piece : pieces) length += load.even.sampling.step * static_cast<double>(piece.size() - 1);
  const auto n_pieces = static_cast<double>(pieces.size());
  if (length / step + n_pieces <= kMostSamples) return;
  // A thousandth absorbs the rounding of the printed step.
  const double shortest = 1.001 * length / (kMostSamples - n_pieces);
  throw InputError(
      Complaint{load.file, fmt::format("--resample {} makes {:.3g} samples", step, length / step),
                fmt::format("at most {:.0f} samples, by a step of {:.4g} s or more", kMostSamples, shortest),
                "give a longer step"});
}

}  // namespace

LoadHistory prepared(const LoadHistory& load, const Preparation& preparation) {
  if (!preparation.any()) return load;
  const double old_step = load.even.sampling.step;
  const double step = preparation.step > 0.0 ? preparation.step : old_step;
  if (preparation.low_pass * old_step >= 0.5)
    throw InputError(Complaint{
        load.file, fmt::format("--low-pass {} Hz of samples every {:.6g} s", preparation.low_pass, old_step),
        fmt::format("below half of the sampling frequency, {:.6g} Hz", 0.5 / old_step), "give a lower frequency"});
  require_few_samples(load, step);
  LoadHistory out{load.column, {}, {}, load.n_missing, load.unit, load.file, load.start, load.is_negated};
  out.warnings = load.warnings;
  out.marker = load.marker;
  out.clipping = statistics::clipping(load.history, load.even);
  const statistics::Pieces pieces = load.even.pieces(load.history);
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    std::vector<double> samples(pieces[p].begin(), pieces[p].end());
    if (step > old_step) samples = statistics::low_pass(samples, old_step, kAntiAlias / step, statistics::Phase::kZero);
    if (preparation.low_pass > 0.0)
      samples = statistics::low_pass(samples, old_step, preparation.low_pass, preparation.phase);
    const double start = load.history.times[load.even.cuts[p]];
    add_resampled(samples, start, old_step, step, out.history);
  }
  if (out.history.values.size() < 2)
    throw InputError(Complaint{load.file, fmt::format("--resample {} leaves fewer than two values", step),
                               "two values at least", "give a shorter step"});
  // Any interval longer than a step is a gap of the history.
  out.even = statistics::make_even(out.history, 1.5 * step);
  return out;
}

nlohmann::ordered_json preparation_json(const Preparation& preparation) {
  if (!preparation.any()) return nullptr;
  nlohmann::ordered_json out{{"low_pass", nullptr}, {"step", nullptr}};
  if (preparation.step > 0.0) out["step"] = preparation.step;
  if (preparation.low_pass > 0.0) {
    out["low_pass"] = preparation.low_pass;
    out["phase"] = preparation.phase == statistics::Phase::kZero ? "zero" : "causal";
    out["delay"] = statistics::low_pass_delay(preparation.low_pass, preparation.phase);
  }
  return out;
}

}  // namespace brash::analysis
