// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh from a file, as it lies in the water.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <optional>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/structure/inner_radius.hpp"
#include "mesh_hull.hpp"
#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

/// Size of the largest file.
constexpr std::size_t kMostMebibytes = 512;
/// Length of the longest structure [m]; ships end at 458 m.
constexpr double kLongest = 1000.0;
/// Thickness of the thinnest structure [m]. Outlines have a grid of a micrometre, and a thinner one would have none.
constexpr double kThinnest = 1e-3;

using Placed = tl::expected<std::shared_ptr<const MeshBody>, MeshError>;

Quaternion about(Vec3 axis, double angle) {
  const double s = std::sin(0.5 * angle);
  return {std::cos(0.5 * angle), s * axis.x, s * axis.y, s * axis.z};
}

/// The unit that a length was probably given in, when metres are no unit for it.
std::string probable_unit(double length) {
  for (const auto& [unit, metres] : {std::pair{"millimetres", 1e-3}, std::pair{"centimetres", 1e-2}})
    if (length * metres <= kLongest && length * metres >= 1.0)
      return fmt::format("in {} it would be {:.4g} m long: write structure.scale = {:g}", unit, length * metres,
                         metres);
  return "correct structure.scale";
}

/// Not finite where the mesh has no section at the waterline.
Vec2 middle_of_waterline(const TriangleMesh& mesh) {
  const MeshSections sections(mesh);
  Vec2 least{HUGE_VAL, HUGE_VAL}, most{-HUGE_VAL, -HUGE_VAL};
  for (const Outline& loop : sections.at({}, 0.0, sections.near({}, 0.0, 0.0)))
    for (const Vec2 v : loop) {
      least = {std::min(least.x, v.x), std::min(least.y, v.y)};
      most = {std::max(most.x, v.x), std::max(most.y, v.y)};
    }
  return 0.5 * (least + most);
}

/// Turned by heading, trim and heel in this order, and lowered to its draught; the middle of its waterline becomes the
/// origin.
tl::expected<void, MeshError> place(const model::Mesh& how, TriangleMesh& mesh) {
  const Quaternion heading = about({0.0, 0.0, 1.0}, how.heading), trim = about({0.0, 1.0, 0.0}, -how.trim),
                   heel = about({1.0, 0.0, 0.0}, how.heel);
  double keel = HUGE_VAL, top = -HUGE_VAL;
  for (Vec3& v : mesh.vertices) {
    v = how.scale * v;
    if (how.heading != 0.0) v = rotate(heading, v);
    if (how.trim != 0.0) v = rotate(trim, v);
    if (how.heel != 0.0) v = rotate(heel, v);
    keel = std::min(keel, v.z);
    top = std::max(top, v.z);
  }
  if (how.draught >= top - keel)
    return tl::unexpected(MeshError{fmt::format("is {:.4g} m high, and its draught {:.4g} m", top - keel, how.draught),
                                    "a structure that reaches above the water",
                                    "lower structure.draught, or correct structure.scale"});
  for (Vec3& v : mesh.vertices) v.z -= keel + how.draught;
  const Vec2 middle = middle_of_waterline(mesh);
  if (!std::isfinite(middle.x))
    return tl::unexpected(
        MeshError{fmt::format("has nothing {:.4g} m above its lowest point, where the water's surface is", how.draught),
                  "a structure that crosses the water's surface", "correct structure.draught"});
  for (Vec3& v : mesh.vertices) v = {v.x - middle.x, v.y - middle.y, v.z};
  return {};
}

/// Refuses a structure that is thinner everywhere than its outlines are exact.
tl::expected<void, MeshError> expect_thick(const MeshBody& body) {
  const double least = std::max(kThinnest, 2.0 * body.tolerance);
  double thickness = 0.0;
  for (const ConvexPart& part : body.parts)
    if (thickness < least) thickness = std::max(thickness, 2.0 * inner_radius(part, 0.5 * least));
  if (thickness >= least) return {};
  const Vec3 size = body.report.size;
  return tl::unexpected(MeshError{fmt::format("is {:.3g} m x {:.3g} m x {:.3g} m large and at most {:.2g} m thick",
                                              size.x, size.y, size.z, thickness),
                                  fmt::format("at least {:.2g} m somewhere", least),
                                  "give the structure its thickness, or correct structure.scale"});
}

Placed placed(const std::string& bytes, const model::Mesh& how) {
  std::string kind = std::filesystem::path(how.file).extension().string();
  std::ranges::transform(kind, kind.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind != ".stl" && kind != ".obj" && kind != ".ply" && kind != ".off")
    return tl::unexpected(MeshError{"has an unknown ending", ".stl, .obj, .ply or .off", "export it in such a format"});
  auto read = read_mesh(bytes, kind.substr(1));
  if (!read) return tl::unexpected(read.error());
  const Box box = box_around(read->mesh.vertices);
  const Vec3 size = how.scale * box.size();
  const double length = std::max({size.x, size.y, size.z});
  if (!(length <= kLongest))
    return tl::unexpected(MeshError{fmt::format("is {:.4g} km long", length / 1e3),
                                    fmt::format("at most {:g} m", kLongest), probable_unit(length)});
  if (auto lies = place(how, read->mesh); !lies) return tl::unexpected(lies.error());
  auto body = std::make_shared<const MeshBody>(std::move(read->mesh), read->report);
  if (auto thick = expect_thick(*body); !thick) return tl::unexpected(thick.error());
  return body;
}

/// A case makes its hull several times, and repairing a large mesh takes seconds: the newest one is kept.
Placed kept_or_placed(const model::Mesh& how) {
  static std::mutex mutex;
  static std::string kept_key;
  static std::shared_ptr<const MeshBody> kept;
  const std::string bytes = read_text_file(how.file, "a mesh", kMostMebibytes);
  const std::string key = fmt::format("{} {} {} {} {} {} {}", sha256(bytes), how.scale, how.draught, how.heading,
                                      how.heel, how.trim, std::filesystem::path(how.file).extension().string());
  const std::lock_guard lock(mutex);
  if (kept && key == kept_key) return kept;
  Placed made = placed(bytes, how);
  if (made) kept = *made, kept_key = key;
  return made;
}

}  // namespace

tl::expected<MeshReport, MeshError> examine(const model::Mesh& mesh) {
  return kept_or_placed(mesh).map([](const auto& body) { return body->report; });
}

std::unique_ptr<const Hull> hull_of(const model::Mesh& mesh) {
  const Placed body = kept_or_placed(mesh);
  if (!body) throw InputError(Complaint{mesh.file, body.error().what, body.error().allowed, body.error().remedy});
  return std::make_unique<MeshHull>(*body);
}

}  // namespace brash::structure
