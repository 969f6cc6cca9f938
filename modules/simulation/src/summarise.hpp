// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "brash/simulation/run.hpp"
#include "brash/simulation/warnings.hpp"

namespace brash::simulation {

/// Sum of numbers, and their mean.
struct Mean {
  double sum = 0.0;
  std::size_t n = 0;

  void add(double value) {
    sum += value;
    ++n;
  }
  double value() const;  ///< NaN without numbers
};

/// Statistics of loads and frames, which come part after part: a long run has too many for the memory.
class RowSummary {
 public:
  RowSummary(const model::Case& resolved, const StatisticsWindow& window);

  /// Adds the loads and frames of `part`, which follow those before.
  void add(const model::RunResults& part);
  const LoadsSeen& loads_seen() const { return seen_; }
  /// Completes `summary` with the statistics of the rows.
  void write_to(const model::Case& resolved, RunSummary& summary) const;

 private:
  /// Of all steps in the window.
  struct Window {
    std::vector<double> horizontal, vertical;   ///< loads of the steps [N]
    Vec3 crushing, floe_normal, floe_friction;  ///< sums of forces [N]
    model::RegionLoads regions;                 ///< sums
    bool is_touched = false;
  };
  /// Of all steps.
  struct Whole {
    Mean mean;
    std::optional<double> most, most_backwards;  ///< of the load, and of it with the other sign [N]

    void add(double load);
  };

  void add(const model::LoadRow& row);
  void add_to_window(const model::LoadRow& row);
  void add(const model::Frame& frame);
  LoadSplit split(double Vec3::*axis) const;
  std::vector<RegionMean> mean_by_region(const model::StructureSection& structure) const;
  std::optional<double> fastest() const;
  EnergyBalance energy_balance() const;

  double from_, until_;  ///< the window [s]
  LoadsSeen seen_;
  Window window_{};
  Whole horizontal_{}, vertical_{};
  model::LoadRow last_{};
  double largest_step_error_ = 0.0;  ///< of the energy [J]
  std::size_t n_frames_ = 0;
  double frame_time_ = 0.0;                   ///< of the newest frame [s]
  std::map<std::int64_t, Vec3> positions_{};  ///< of the floes in it [m]
  double fastest_ = 0.0;                      ///< floe between two frames [m/s]
};

/// Completes `counts` (the counters and the ledger of the run) with the statistics of its results.
/// @param rows        loads and frames of the whole run; `results` may lack earlier ones.
/// @param open_water  area of the field without its land [m2].
RunSummary summarise(const model::Case& resolved, const model::RunResults& results, const RowSummary& rows,
                     double open_water, RunSummary counts);

}  // namespace brash::simulation
