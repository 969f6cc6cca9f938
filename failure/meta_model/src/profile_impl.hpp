// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "brash/meta_model/profile_model.hpp"
#include "interpolant.hpp"
#include "profile_shape.hpp"

namespace brash::meta_model {

inline constexpr std::size_t kGeometryInputs = 4;
/// xx and yy of bending and of each of its in-plane terms; xx and yy under N and xy under f of the membrane.
inline constexpr int kBendingComponents = 2;
inline constexpr int kInPlaneComponents = 4;
inline constexpr int kMembraneComponents = 3;

/// Some components of the profile in their principal modes, whose coefficients are interpolated.
struct FieldModel {
  Interpolant coefficients;
  Eigen::VectorXd mean;   ///< shape=(n_values,), component by component
  Eigen::MatrixXd modes;  ///< shape=(n_values, n_modes)
};

struct ProfileModel::Impl {
  std::array<Geometry, 2> range;  ///< lower, upper
  std::string data_sha256;
  double reach = 0.0;  ///< last station beyond the base line / l_c
  FieldModel bending, in_plane, membrane;
  Interpolant buckling;  ///< ln(buckling load), one value
};

}  // namespace brash::meta_model
