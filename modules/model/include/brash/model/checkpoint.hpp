// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "brash/core/ids.hpp"
#include "brash/core/vec.hpp"
#include "brash/model/records.hpp"

namespace brash::model {

/// Point of the plan in grid units of 2^-30 m, sheet frame: exact.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// One polygon: its outline, then its holes.
using GridRings = std::vector<std::vector<GridPoint>>;

/// What a floe presses on the edge of the sheet: sums over its contacts there, averaged over its collision time. All
/// moments are of the in-plane sizes of the normal forces.
struct Bearing {
  Vec3 force{};                    ///< on the sheet, friction included [N]
  Vec2 thrust{};                   ///< in-plane part of its normal forces [N]
  double weight = 0.0;             ///< sum of the sizes of these parts [N]
  Vec2 first{};                    ///< first moments about the origin [N m]
  std::array<double, 3> second{};  ///< second moments xx, xy, yy about the origin [N m2]

  friend bool operator==(const Bearing&, const Bearing&) = default;
};

/// How near a floe is to rest, and what would end it.
struct Rest {
  double slow_for = 0.0;     ///< it has been slower than time.settle_speed for so long [s]
  std::int64_t settled = 0;  ///< 1: it is fixed where it is
  Vec3 push{};               ///< by how much the mean force of other floes on it has changed since it was settled [N]

  friend bool operator==(const Rest&, const Rest&) = default;
};

/// What the water does against a floe's motion, kept for a way: hydrodynamics::Drag, body frame.
struct KeptDrag {
  double left = 0.0;         ///< how far the floe may go on with it [m]; at 0 it is taken anew
  double sum = 0.0;          ///< of the dampers [kg/s]
  Vec3 first{};              ///< moments [kg m/s]
  Vec3 squares{};            ///< [kg m2/s]
  Vec3 products{};           ///< [kg m2/s]
  double rotation = 0.0;     ///< [kg m2/s]
  Vec3 skin_force{};         ///< [N]
  Vec3 skin_moment{};        ///< [N m]
  double skin_power = -1.0;  ///< of these at the velocity at which they were taken [W]
  Twist velocity{};          ///< that velocity, against the water

  friend bool operator==(const KeptDrag&, const KeptDrag&) = default;
};

/// A floe that is in the world when a checkpoint is taken.
struct CheckpointFloe {
  std::int64_t id = 0;  ///< FloeRecord::id
  BodyId body;
  GridRings rings;  ///< where it broke off, sheet frame
  double thickness = 0.0;
  Pose pose;
  Twist twist;
  std::array<double, 6> stress{};  ///< mean stress xx, yy, zz, xy, yz, zx [Pa]
  double peak_stress = 0.0;        ///< [Pa]
  Bearing bearing{};
  Rest rest{};
  KeptDrag kept_drag{};

  friend bool operator==(const CheckpointFloe&, const CheckpointFloe&) = default;
};

/// The mean force of the floe `other` on the floe `floe`, both by FloeRecord::id [N].
struct FloePush {
  std::int64_t floe = 0;
  std::int64_t other = 0;
  Vec3 force{};

  friend bool operator==(const FloePush&, const FloePush&) = default;
};

/// Everything that a run needs to go on as if it had not been interrupted. Nothing in it is rounded.
struct Checkpoint {
  std::string case_name;
  std::string case_toml;  ///< the resolved case as to_toml wrote it: a run resumes its own case only
  std::vector<GridRings> sheet;
  std::vector<CheckpointFloe> floes;
  std::vector<FloePush> pushes;               ///< where floes settle (time.settle_speed)
  std::map<std::string, std::string> ledger;  ///< whole numbers of any size as decimal text, e.g. twice an exact area
  std::map<std::string, std::int64_t> counters;  ///< steps done, random streams used, next id, ...
  std::map<std::string, double> numbers;         ///< finite: place of the structure, work done, ...
  RunResults results;                            ///< so far

  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

}  // namespace brash::model
