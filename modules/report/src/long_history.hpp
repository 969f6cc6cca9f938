// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

#include "blocks.hpp"
#include "brash/model/records.hpp"

namespace brash::report {

/// The names of the six loads, in the order of LoadSamples::loads.
constexpr std::array<const char*, 6> kLoadNames{"Fx", "Fy", "Fz", "Mx", "My", "Mz"};

/// Every sample of the total loads.
struct LoadSamples {
  std::vector<double> times;                 ///< [s]; shape=(n,)
  std::array<std::vector<double>, 6> loads;  ///< [N], [N m]; each shape=(n,)
};

/// The load history of a run as its page has it: every sample of the totals for the statistics, and rows to draw.
///
/// All rows of a short history are drawn. A longer one is divided into spans of equal length, and of each span the rows
/// with the least and the largest value of each drawn load stay: the curve keeps its outline, and each point that it
/// shows is a row of the history.
class LongHistory {
 public:
  /// Takes the next of `n_all` rows.
  void take(std::vector<model::LoadRow>&& rows, std::size_t n_all);
  /// To be called once, when all rows have been taken.
  std::vector<model::LoadRow> drawn();
  const LoadSamples& samples() const { return samples_; }
  /// Rows of a span; 1: every row is drawn.
  std::size_t span() const { return span_; }

 private:
  void choose();

  std::size_t span_ = 1;
  LoadSamples samples_{};
  std::vector<model::LoadRow> waiting_{};  ///< of a span that is not whole yet
  std::vector<model::LoadRow> drawn_{};
  model::LoadRow last_{};  ///< its time says how long the run was
};

/// The statistics of each load as `brash stats --json` has them, for the page's charts. A spectrum of many lines keeps
/// the lowest and the highest line of narrow bands, and `n_lines` says how many there were. `blocks` gets the samples
/// after `from` up to `until` [s] sorted, the largest in size first: `exceedance`.Fx.value, and .rank: how many are as
/// large. Between the largest ones and the last, ranks lie evenly by their logarithm.
///
/// @param statistics  of Fx to Mz, each with `spectrum` and `lower_end`; null stays null.
nlohmann::ordered_json drawn_statistics(nlohmann::ordered_json statistics, const LoadSamples& samples, double from,
                                        double until, Blocks& blocks);

}  // namespace brash::report
