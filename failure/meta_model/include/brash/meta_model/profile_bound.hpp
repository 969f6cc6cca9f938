// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "brash/meta_model/profile_model.hpp"

namespace brash::meta_model {

/// Values that the profiles of a geometry hardly exceed anywhere on the centre line; units as in Profiles.
struct ProfileExtremes {
  double bending = 0.0;        ///< of either component, as all of these
  double normal = 0.0;         ///< the same for normal_xx and normal_yy
  double tangential = 0.0;     ///< the same for tangential_xy
  double first = 0.0;          ///< the same for first_xx and first_yy
  double rest = 0.0;           ///< the same for rest_xx and rest_yy
  double buckling_load = 0.0;  ///< hardly less
};

/// Reports how large a model's profiles get without a look at them, at a hundredth of the price.
///
/// Profiles are of order 1 when they are divided by the values of a beam as wide as the load has spread. Tangential
/// stresses are divided by 1 + b / base width instead. The largest quotients come from a lattice of geometries; between
/// its points they may be somewhat larger.
/// @see docs/theory/fracture-of-the-edge.md, (N2)
class ProfileBound {
 public:
  /// For geometries of the model's range with one h / l_c [-], which is inside it.
  ProfileBound(const ProfileModel& model, double h_lc);

  ProfileExtremes at(const Geometry& geometry) const;

 private:
  ProfileExtremes most_;  ///< over those scales
};

}  // namespace brash::meta_model
