// SPDX-License-Identifier: GPL-3.0-or-later
// Names and numbers of the format: glTF 2.0 specification, Khronos Group, 2021; the container is its Sec. 4.4.
#include "gltf_file.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

#include "brash/core/contract.hpp"
#include "brash/core/version.hpp"

namespace brash::formats {
namespace {

static_assert(std::endian::native == std::endian::little, "the format is little endian");

constexpr int kFloat = 5126, kUnsignedInt = 5125;
constexpr int kVertices = 34962, kIndices = 34963;  ///< targets of a view
constexpr std::size_t kAlignment = 4;

int last_of(const nlohmann::json& items) { return static_cast<int>(items.size()) - 1; }

std::vector<float> numbers_of(std::span<const Vec3> vectors) {
  std::vector<float> numbers;
  for (const Vec3& v : vectors)
    for (const double x : {v.x, v.y, v.z}) numbers.push_back(static_cast<float>(x));
  return numbers;
}

/// Least and largest of each component, as the file has them.
void bound(nlohmann::json& accessor, std::span<const float> numbers, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) {
    float least = numbers[i], most = numbers[i];
    for (std::size_t at = i; at < numbers.size(); at += width) {
      least = std::min(least, numbers[at]);
      most = std::max(most, numbers[at]);
    }
    accessor["min"].push_back(double{least});
    accessor["max"].push_back(double{most});
  }
}

void append(std::string& bytes, std::uint32_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// A chunk of the container, filled up to whole words.
void append_chunk(std::string& bytes, const char* kind, std::string content, char filler) {
  while (content.size() % kAlignment != 0) content += filler;
  append(bytes, static_cast<std::uint32_t>(content.size()));
  bytes.append(kind, 4);
  bytes += content;
}

}  // namespace

int GltfFile::material(const std::string& name, std::span<const double> colour) {
  Json material{{"name", name},
                {"doubleSided", true},
                {"pbrMetallicRoughness",
                 {{"baseColorFactor", std::vector<double>(colour.begin(), colour.end())},
                  {"metallicFactor", 0.0},
                  {"roughnessFactor", 0.9}}}};
  if (colour.back() < 1.0) material["alphaMode"] = "BLEND";
  materials_.push_back(std::move(material));
  return last_of(materials_);
}

int GltfFile::view(const void* data, std::size_t size, Json more) {
  more["buffer"] = 0;
  more["byteOffset"] = buffer_.size();
  more["byteLength"] = size;
  buffer_.append(static_cast<const char*>(data), size);
  BRASH_EXPECTS(buffer_.size() % kAlignment == 0, size);
  views_.push_back(std::move(more));
  return last_of(views_);
}

int GltfFile::accessor(std::span<const float> numbers, const char* type, std::size_t width, Json more) {
  more["bufferView"] = last_of(views_);
  more["componentType"] = kFloat;
  more["count"] = numbers.size() / width;
  more["type"] = type;
  accessors_.push_back(std::move(more));
  return last_of(accessors_);
}

int GltfFile::mesh(const PolyData& surface, int material) {
  BRASH_EXPECTS(!surface.faces.empty(), surface.points.size());
  const std::vector<float> numbers = numbers_of(surface.points);
  view(numbers.data(), numbers.size() * sizeof(float), {{"target", kVertices}});
  Json bounds;
  bound(bounds, numbers, 3);
  const int positions = accessor(numbers, "VEC3", 3, bounds);

  std::vector<std::uint32_t> corners;
  for (const std::vector<std::int64_t>& face : surface.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      for (const std::int64_t corner : {face[0], face[i], face[i + 1]})
        corners.push_back(static_cast<std::uint32_t>(corner));
  const int indices = view(corners.data(), corners.size() * sizeof(std::uint32_t), {{"target", kIndices}});
  accessors_.push_back(
      {{"bufferView", indices}, {"componentType", kUnsignedInt}, {"count", corners.size()}, {"type", "SCALAR"}});
  const Json primitive{
      {"attributes", {{"POSITION", positions}}}, {"indices", last_of(accessors_)}, {"material", material}};
  meshes_.push_back({{"primitives", Json::array({primitive})}});
  return last_of(meshes_);
}

int GltfFile::node(Json node) {
  nodes_.push_back(std::move(node));
  return last_of(nodes_);
}

int GltfFile::times(std::span<const double> seconds) {
  const std::vector<float> numbers(seconds.begin(), seconds.end());
  view(numbers.data(), numbers.size() * sizeof(float), Json::object());
  Json bounds;
  bound(bounds, numbers, 1);
  return accessor(numbers, "SCALAR", 1, bounds);
}

int GltfFile::vectors(std::span<const Vec3> vectors) {
  const std::vector<float> numbers = numbers_of(vectors);
  view(numbers.data(), numbers.size() * sizeof(float), Json::object());
  return accessor(numbers, "VEC3", 3, Json::object());
}

int GltfFile::rotations(std::span<const Quaternion> rotations) {
  std::vector<float> numbers;
  for (const Quaternion& q : rotations)
    for (const double x : {q.x, q.y, q.z, q.w}) numbers.push_back(static_cast<float>(x));
  view(numbers.data(), numbers.size() * sizeof(float), Json::object());
  return accessor(numbers, "VEC4", 4, Json::object());
}

void GltfFile::animate(int node, const char* property, int times, int values, const char* between) {
  samplers_.push_back({{"input", times}, {"output", values}, {"interpolation", between}});
  channels_.push_back({{"sampler", last_of(samplers_)}, {"target", {{"node", node}, {"path", property}}}});
}

std::string GltfFile::bytes(const std::vector<int>& roots) const {
  Json file{{"asset", {{"version", "2.0"}, {"generator", std::string("brash ") + kVersion}}},
            {"scene", 0},
            {"scenes", Json::array({{{"nodes", roots}}})},
            {"materials", materials_},
            {"meshes", meshes_},
            {"nodes", nodes_},
            {"accessors", accessors_},
            {"bufferViews", views_},
            {"buffers", Json::array({{{"byteLength", buffer_.size()}}})}};
  if (!channels_.empty())
    file["animations"] = Json::array({{{"name", "run"}, {"channels", channels_}, {"samplers", samplers_}}});
  std::string chunks;
  append_chunk(chunks, "JSON", file.dump(), ' ');
  append_chunk(chunks, "BIN", buffer_, '\0');
  constexpr std::uint32_t kVersionOfContainer = 2;
  std::string glb = "glTF";
  append(glb, kVersionOfContainer);
  append(glb, static_cast<std::uint32_t>(12 + chunks.size()));
  return glb + chunks;
}

}  // namespace brash::formats
