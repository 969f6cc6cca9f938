// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/formats/vtk.hpp"

namespace brash::formats {

/// Collects the parts of a binary glTF 2.0 file. Parts name each other by their index.
class GltfFile {
 public:
  using Json = nlohmann::json;

  /// @param colour  red, green, blue, opacity, each from 0 to 1.
  int material(const std::string& name, std::span<const double> colour);

  /// A surface of convex faces. It has no normals, so it is drawn with flat faces.
  int mesh(const PolyData& surface, int material);

  int node(Json node);
  Json& node(int index) { return nodes_.at(static_cast<std::size_t>(index)); }

  /// Times of an animation [s], rising.
  int times(std::span<const double> seconds);
  int vectors(std::span<const Vec3> vectors);
  /// @param rotations  of unit length.
  int rotations(std::span<const Quaternion> rotations);

  /// Moves a property of a node, "translation", "rotation" or "scale", through values at times.
  /// @param between  "LINEAR" or "STEP".
  void animate(int node, const char* property, int times, int values, const char* between);

  /// The file, with `roots` the nodes of its scene.
  std::string bytes(const std::vector<int>& roots) const;

 private:
  int accessor(std::span<const float> numbers, const char* type, std::size_t width, Json more);
  int view(const void* data, std::size_t size, Json more);

  Json materials_ = Json::array(), meshes_ = Json::array(), nodes_ = Json::array();
  Json accessors_ = Json::array(), views_ = Json::array();
  Json channels_ = Json::array(), samplers_ = Json::array();
  std::string buffer_;
};

}  // namespace brash::formats
