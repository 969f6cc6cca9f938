// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/vec.hpp"

namespace brash::io {

/// Faces in space with values on them, as VTK's PolyData holds them.
struct PolyData {
  std::vector<Vec3> points;                      ///< [m]
  std::vector<std::vector<std::int64_t>> faces;  ///< indices of points, counter-clockwise seen from outside
  /// Name of each column and its values; shape=(n_faces,) each.
  std::vector<std::pair<std::string, std::vector<double>>> cell_data;
};

/// The file (.vtp) of one dataset: XML with the arrays as raw bytes behind it, little endian, headers of 64 bits.
/// @see VTK file formats, XML formats, appended data.
std::string to_vtp(const PolyData& data);

/// One file of a time series.
struct VtkStep {
  double time = 0.0;  ///< [s]
  int part = 0;       ///< number of the block that the file belongs to
  std::string file;   ///< relative to the folder of the collection
};

/// The collection (.pvd) that gives each file its time.
std::string to_pvd(const std::vector<VtkStep>& steps);

}  // namespace brash::io
