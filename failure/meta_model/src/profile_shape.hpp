// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "brash/meta_model/profile_model.hpp"

namespace brash::meta_model {

/// Stations from the tip to the base line and from there to the end.
inline constexpr int kStationsBefore = 50;
inline constexpr int kStationsBehind = 80;
inline constexpr int kProfileStations = kStationsBefore + kStationsBehind;

/// Factors that bring the fields at one place of the centre line to order 1.
struct BeamScale {
  double membrane = 0.0;
  double bending = 0.0;
};

/// The scale of a beam as wide as the load has spread at the distance `x` from the tip over l_c, which carries load
/// and moment.
BeamScale beam_at(const Geometry& geometry, double x);

/// Width of the protrusion at its base line over l_c.
double base_width(const Geometry& geometry);

/// How the fields on the centre line of one geometry are written, so that they change little between geometries.
struct ProfileShape {
  std::vector<double> station;   ///< follow the geometry, the base line x = b among them; n_before, then n_behind
  std::vector<double> bending;   ///< factors of the moments at each station
  std::vector<double> membrane;  ///< the same for membrane stresses
};

/// @param reach  of the stations beyond the base line over l_c.
ProfileShape shape_of(const Geometry& geometry, double reach, int n_before = kStationsBefore,
                      int n_behind = kStationsBehind);

/// The features on which bending depends: the three lengths, the ratios between them, and h through shear.
Eigen::VectorXd bending_features(const Geometry& geometry);
/// The features on which the membrane depends: the ratios alone, and c in so far as it says where the stations lie.
Eigen::VectorXd membrane_features(const Geometry& geometry);

}  // namespace brash::meta_model
