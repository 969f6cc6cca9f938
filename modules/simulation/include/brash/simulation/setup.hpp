// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "brash/failure/criterion.hpp"
#include "brash/model/case.hpp"
#include "brash/simulation/run.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"

namespace brash::simulation {

/// Lengths and times that follow from a case: Setup::scales.
struct DerivedScales {
  double characteristic_length = 0.0;  ///< l_c, Eq. 18 [m]
  double thickness_over_lc = 0.0;      ///< h / l_c [-]
  double front_slope = 0.0;            ///< of the structure straight ahead, from the horizontal [rad]
  double mu1 = 0.0;                    ///< P / N of a contact straight ahead [-]
  double freeboard = 0.0;              ///< [m]
  double draft = 0.0;                  ///< [m]
  double initial_crack_radius = 0.0;   ///< of Fig. 5 [m]
  double correlation_length = 0.0;     ///< of ice that varies; 0: it is even [m]
  double collision_time = 0.0;         ///< T_col of a piece of l_c^2 / 4, Eqs. 11, 12 [s]
};

/// The structure as the field sees it, where nothing resists it.
struct Course {
  double speed = 0.0;   ///< mean over the run [m/s]
  Vec2 velocity{};      ///< mean over the run [m/s]
  double axis = 0.0;    ///< x of its last axis at t = 0 [m]
  double bow = 0.0;     ///< x of its foremost point in the ice at t = 0 [m]
  double end = 0.0;     ///< largest x of its foremost point in the run [m]
  double leaves = 0.0;  ///< when that point passes the far side, if it does [s]
  double beside = 0.0;  ///< farthest that it reaches to a side of the field's middle [m]
  bool meets = false;   ///< whether it comes into the rectangle of the field
};

/// A case and what follows from it before the first step, each made once.
struct Setup {
  /// @throws InputError when the failure model cannot be read.
  explicit Setup(model::Case resolved);
  Setup(const Setup&) = delete;
  Setup& operator=(const Setup&) = delete;

  const model::Case resolved;
  const failure::IceProperties ice;
  const std::unique_ptr<const failure::BendingCriterion> criterion;
  const std::unique_ptr<const structure::Hull> hull;
  const std::unique_ptr<const structure::Motion> motion;  ///< at the start
  const DerivedScales scales;
  const Course course;
  const StatisticsWindow window;
};

/// Whether the structure goes where the case says: a body afloat and one that another program drives may not.
bool goes_as_told(const model::Motion& motion);

/// Whether the program cuts floes out of the level ice before the start.
bool has_initial_crack(const model::Case& c);

/// x that the structure's last axis has to pass before the statistics begin by default [m].
/// @param radius  of the initial crack [m].
double place_of_begin(const model::Case& c, double radius);

/// Radius of Fig. 5's crack [m]: as given, or where the failure model breaks a straight edge under a contact as long
/// as the ice is thick.
double initial_crack_radius(const model::Case& resolved, const failure::IceProperties& ice,
                            const failure::BendingCriterion& criterion);

}  // namespace brash::simulation
