// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "brash/meta_model/edge_responses.hpp"
#include "grid_axis.hpp"

namespace brash::meta_model {

/// Stations of the moments from the tip to the base line and from there to the end.
inline constexpr int kEdgeStationsBefore = 25;
inline constexpr int kEdgeStationsBehind = 50;
inline constexpr int kEdgeStations = kEdgeStationsBefore + kEdgeStationsBehind;
inline constexpr std::size_t kEdgeAxes = 4;

/// Values of every geometry of the grid in their principal modes.
struct GridField {
  Eigen::VectorXd mean;          ///< shape=(n_values,)
  Eigen::MatrixXf modes;         ///< shape=(n_values, n_modes)
  Eigen::MatrixXd coefficients;  ///< shape=(n_modes, n_points)
};

struct EdgeResponseModel::Impl {
  std::array<std::vector<double>, kEdgeAxes> grid;  ///< b / l_c, theta, c / l_c, h / l_c
  bool has_split = false;                           ///< points of the split sheets come after points of whole ones
  std::vector<double> time;                         ///< for plate::kUsualMass
  double reach = 0.0;                               ///< last station beyond the base line / l_c
  std::string data_sha256;
  /// Moments on the axis over their scales are stations * (values of `moments`, shape=(n, m)) * times^T.
  Eigen::MatrixXd stations;  ///< principal shapes along the axis, shape=(kEdgeStations, n)
  Eigen::MatrixXd times;     ///< principal histories for every time, then at rest, shape=(n_times + 1, m)
  GridField moments;
  GridField motion;    ///< deflection over the static one for every time, edge moment for every time and at rest, and
                       ///< the logarithm of the static deflection
  GridField membrane;  ///< on the axis over their scales, and at B along the edge: of every outline
  std::array<EdgeGeometry, 2> range;

  GridAxis depth, width, thickness;
  std::vector<GridAxis> angle;  ///< for every b, then every c

  std::size_t n_outlines() const { return grid[0].size() * grid[1].size() * grid[2].size(); }
  std::size_t n_points() const { return n_outlines() * grid[3].size() * (has_split ? 2 : 1); }
  /// Weights of all outlines for the one of `geometry`: along the angle at every b and c, then along b and c.
  Eigen::VectorXd outline_weights(const EdgeGeometry& geometry) const;
  /// Sets the axes and `range` from the grid.
  void prepare();
};

}  // namespace brash::meta_model
