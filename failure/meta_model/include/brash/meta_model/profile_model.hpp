// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "brash/meta_model/network.hpp"

namespace brash::meta_model {

/// The inputs that linear theory leaves when mu1 and mu2 are superposed exactly.
struct Geometry {
  double b_lc = 0.0;   ///< b / l_c [-]
  double c_lc = 0.0;   ///< c / l_c [-]
  double theta = 0.0;  ///< [rad]
  double h_lc = 0.0;   ///< h / l_c [-]; shear depends on it
};

/// The unit fields on the centre line that symmetry leaves; shape=(n_stations,) each, as in plate::UnitProfiles.
struct Profiles {
  std::vector<double> station;  ///< |AB| / l_c, increasing
  std::vector<double> bending_xx, bending_yy;
  std::vector<double> normal_xx, normal_yy;
  std::vector<double> tangential_xy;
  double buckling_load = 0.0;  ///< plate::InPlaneTerms, like the next two
  std::vector<double> first_xx, first_yy;
  std::vector<double> rest_xx, rest_yy;
};

/// One solved geometry.
struct ProfileSample {
  Geometry geometry;
  Profiles profiles;
};

/// Interpolates unit profiles between solved geometries.
///
/// Profiles are resampled on stations that follow the geometry (the base line x = b is always a station, so its kink
/// stays in place), divided by the values of a beam as wide as the load has spread, and written in their
/// principal modes; the modes' coefficients are interpolated by fifth powers of distances with a quadratic part,
/// bending and membrane each over the features that it depends on. The model passes through the solved geometries up to
/// the modes that are left out.
/// @see docs/theory/fracture-of-the-edge.md
class ProfileModel {
 public:
  /// Builds the model from solved geometries: at least two for each term of the quadratic part over the inputs that
  /// vary, so 42, or 30 of one h / l_c.
  /// @throws InputError when there are too few.
  static ProfileModel fit(std::span<const ProfileSample> samples, const std::string& data_sha256);
  /// @throws InputError naming file, place and error.
  static ProfileModel read(const std::string& path);
  /// Writes the model file (JSON) by rename when whole and returns its content hash.
  std::string write(const std::string& path) const;

  ProfileModel(ProfileModel&&) noexcept;
  ProfileModel& operator=(ProfileModel&&) noexcept;
  ~ProfileModel();

  /// @param geometry             inside the range, see clamp().
  /// @param with_in_plane_terms  whether buckling load, first and rest are wanted; else 0 and empty.
  Profiles predict(const Geometry& geometry, bool with_in_plane_terms = false) const;

  RangeCheck check(const Geometry& geometry) const;
  Geometry clamp(const Geometry& geometry) const;
  /// `{lower, upper}`.
  const std::array<Geometry, 2>& range() const;
  /// Hash of the database that it was fitted to.
  const std::string& data_sha256() const;
  /// Of bending and membrane together.
  int n_modes() const;

 private:
  struct Impl;
  explicit ProfileModel(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace brash::meta_model
