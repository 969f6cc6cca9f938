// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/formats/replay.hpp"
#include "brash/geometry/polygon.hpp"

namespace brash::formats {

/// Faces in space with values on them, as VTK's PolyData holds them.
struct PolyData {
  std::vector<Vec3> points;                      ///< [m]
  std::vector<std::vector<std::int64_t>> faces;  ///< indices of points, counter-clockwise seen from outside
  /// Name of each column and its values; shape=(n_faces,) each.
  std::vector<std::pair<std::string, std::vector<double>>> cell_data;
};

/// Adds the closed surface of the prism over `polygon` between two heights [m], placed by `pose`.
///
/// Top and bottom are the polygon's convex parts and share all edges with the sides.
/// @return how many faces were added.
std::size_t add_prism(PolyData& data, const geometry::Polygon& polygon, double bottom, double top,
                      const Pose& pose = {});

/// The surface of level ice with these outlines, afloat.
PolyData sheet_surface(const model::Case& resolved, const std::vector<geometry::Polygon>& polygons);

/// A closed surface of triangles, placed by `pose`.
PolyData mesh_surface(const structure::TriangleMesh& mesh, const Pose& pose = {});

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

}  // namespace brash::formats
