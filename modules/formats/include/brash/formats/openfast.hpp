// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brash/model/records.hpp"

namespace brash::formats {

/// Where a load history acts in OpenFAST, and from when on.
struct OpenFastOptions {
  int version = 5;  ///< of OpenFAST: 4 or 5, which name a line and number the mode differently
  /// Point of application [m]: x as the ice drifts, z upwards, from the structure's origin in the waterplane.
  Vec3 point{};
  /// Height above the still water of the point from which OpenFAST counts the point of application: PtfmRefzt of
  /// ElastoDyn for a control of the substructure, TowerBsHt for one of the tower [m].
  double reference = 0.0;
  double from = 0.0;  ///< time of the run that becomes 0 [s]
  double ramp = 0.0;  ///< the load grows linearly from zero in this time after `from` [s]
  /// When the load jumps from one replicate to the next, after `from` [s]; empty: it is of one run.
  std::vector<double> joints{};
};

/// Replicates of one state of the ice, one after another.
struct JoinedLoads {
  std::vector<model::LoadRow> loads;  ///< times from 0 s on
  std::vector<double> joints;         ///< times of the first row of each replicate but the first [s]
  std::size_t n_used = 0;             ///< replicates
};

/// Adds replicates until they are as long as asked. Each begins one of its steps after the one before ends.
///
/// @param replicates  rows whose times rise, those that shall count alone; two rows at least in each.
/// @param duration    to reach [s]. The last replicate is cut there; if all are shorter, all of them are joined.
JoinedLoads joined(const std::vector<std::vector<model::LoadRow>>& replicates, double duration);

/// The forces and moments of a run as OpenFAST reads them: time, FX, FY, FZ, MX, MY, MZ, about the point. The last row
/// is one step after the run and has no load, since OpenFAST holds the last row for ever.
/// @param loads  about the structure's origin; at least one after options.from.
std::string to_openfast_forces(std::span<const model::LoadRow> loads, const OpenFastOptions& options);

/// The file of OpenFAST's structural control that applies them, in global coordinates.
/// @param forces_file  its name.
std::string to_openfast_structural_control(const std::string& forces_file, const OpenFastOptions& options);

}  // namespace brash::formats
