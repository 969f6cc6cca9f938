// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "brash/meta_model/profile_model.hpp"

namespace brash::meta_model {

inline constexpr int kGeometryInputs = 3;
/// Stations from the tip to the base line and from there to the end.
inline constexpr int kStationsBefore = 70;
inline constexpr int kStationsBehind = 80;
inline constexpr int kProfileStations = kStationsBefore + kStationsBehind;
inline constexpr int kProfileComponents = 5;
inline constexpr int kProfileValues = kProfileStations * kProfileComponents;

struct ProfileModel::Impl {
  std::array<Geometry, 2> range;  ///< lower, upper
  double thickness_over_lc = 0.1;
  std::string data_sha256;
  double reach = 0.0;              ///< last station / l_c
  Eigen::Vector3d offset, factor;  ///< of the features
  Eigen::MatrixXd centres;         ///< normalised features, shape=(3, n_centres)
  Eigen::MatrixXd weights;         ///< of the cubes of the distances, shape=(n_modes, n_centres)
  Eigen::MatrixXd linear;          ///< of 1 and the features, shape=(n_modes, 4)
  Eigen::VectorXd mean;            ///< mean profile, shape=(n_values,)
  Eigen::MatrixXd modes;           ///< shape=(n_values, n_modes)
};

}  // namespace brash::meta_model
