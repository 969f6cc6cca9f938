// SPDX-License-Identifier: GPL-3.0-or-later
// A ship's resistance over thickness and speed, and the speed that a thrust attains.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "brash/model/case.hpp"

namespace brash::analysis {

inline constexpr double kThreeKnots = 3.0 * 1852.0 / 3600.0;  // [m/s]

/// A grid for the resistance of a ship.
struct ResistanceGrid {
  std::vector<double> thicknesses;  ///< of the ice [m]
  std::vector<double> speeds;       ///< through the ice [m/s]
  int replicates = 2;               ///< of each point
  double lengths = 3.5;             ///< the distance of a run, in lengths of the hull; the last one counts
};

/// The plan of a campaign (TOML) that runs `ship` at each point of a grid. All runs go the same distance; a step is at
/// most 20 mm of it and 0.02 s, and the ice is as long as the distance asks for.
///
/// @param case_file  that `ship` was read from, relative to the plan or absolute.
/// @throws InputError when the ship has no [hull] length, or is not towed along x.
/// @see docs/reference/plan.md.
std::string resistance_plan(const model::Case& ship, const std::string& case_file, const ResistanceGrid& grid);

/// The net thrust of a ship: what its propellers leave for the ice at a speed, after the resistance of open water.
class NetThrust {
 public:
  /// The law of model::thrust_loss, which `structure.motion.open_water_speed` has too, and 0 beyond the speed.
  ///
  /// @param bollard     bollard pull [N], > 0.
  /// @param open_water  speed in open water [m/s], > 0.
  static NetThrust from_bollard_pull(double bollard, double open_water);

  /// A table (CSV) with the columns `speed` [m/s], rising, and `thrust` [N]; straight lines between its rows.
  /// @throws InputError naming file, line and fault.
  static NetThrust from_table(const std::string& path);

  /// At a speed [m/s]; beyond the ends of a table nothing is known.
  std::optional<double> at(double speed) const;

  /// The numbers behind it, for JSON.
  nlohmann::ordered_json json() const;

 private:
  double bollard_ = 0.0, open_water_ = 0.0;
  model::ThrustLoss loss_{};
  std::vector<double> speeds_, thrusts_;  ///< of a table
};

/// The resistance of a ship from the finished cases of a campaign over `ice.thickness` and `structure.speed`, in SI:
///
/// - `points`: mean resistance with its 95 % interval (of the replicates, or within the only run), its parts by cause,
///   coverage of the bottom, the closed forms, and whether the mean is `steady`, with the reason where it is not;
/// - `fit`: R = k h^b v^n over all runs;
/// - with a thrust `attained`, the speed at each thickness, `attained_lines`, that over the thickness, and
///   `thickness_at`, the thickness at `at_speed` [m/s]. Means are joined by straight lines, and nothing is
///   extrapolated.
///
/// @throws InputError when `campaign` is not a campaign of a ship with finished cases, or has two settings of one
///         thickness and speed.
nlohmann::ordered_json resistance_of(const std::string& campaign, const std::optional<NetThrust>& thrust,
                                     double at_speed);

/// The same as text for a reader.
std::string resistance_text(const nlohmann::ordered_json& resistance);

/// The points as a table (CSV), in SI.
std::string resistance_csv(const nlohmann::ordered_json& resistance);

}  // namespace brash::analysis
