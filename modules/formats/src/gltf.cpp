// SPDX-License-Identifier: GPL-3.0-or-later
// A replay as a binary glTF 2.0 file: structure, floes, level ice and water, with one animation. Lengths are in metres.
// Floes appear and vanish, and the sheet changes, at the frames of the run.
// glTF 2.0 specification, Khronos Group, 2021.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "brash/core/write_file.hpp"
#include "brash/formats/exports.hpp"
#include "brash/formats/vtk.hpp"
#include "gltf_file.hpp"

namespace brash::formats {
namespace {

using Json = GltfFile::Json;

constexpr std::array kIce{0.86, 0.93, 0.97, 1.0}, kFloe{0.72, 0.85, 0.93, 1.0}, kSteel{0.85, 0.45, 0.15, 1.0},
    kSea{0.05, 0.22, 0.35, 0.6};

/// A body through the frames that it is in, which follow each other.
struct Track {
  std::size_t first = 0;  ///< frame
  std::vector<Vec3> places;
  std::vector<Quaternion> rotations;

  void add(const Pose& pose) {
    const Quaternion& q = pose.rotation;
    double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
    // Of the two quaternions of an attitude the one near the last: viewers interpolate between them.
    if (!rotations.empty()) {
      const Quaternion& last = rotations.back();
      if (q.w * last.w + q.x * last.x + q.y * last.y + q.z * last.z < 0.0) size = -size;
    }
    places.push_back(pose.position);
    rotations.push_back({q.w / size, q.x / size, q.y / size, q.z / size});
  }
};

/// The scene of a run, built up part by part.
class Scene {
 public:
  explicit Scene(const Replay& run) : run_(run) {
    for (const model::Frame& frame : run.results.frames) times_.push_back(frame.time);
  }

  std::string bytes() {
    add_water();
    add_structure();
    add_sheets();
    add_floes();
    // The run has z upwards, glTF y.
    const double half = std::sqrt(0.5);
    const int root = file_.node({{"name", "run"}, {"rotation", {-half, 0.0, 0.0, half}}, {"children", parts_}});
    return file_.bytes({root});
  }

 private:
  int add(const std::string& name, int mesh) {
    parts_.push_back(file_.node({{"name", name}, {"mesh", mesh}}));
    return parts_.back();
  }

  /// Times of frames, each span once in the file.
  int times(std::size_t first, std::size_t count) {
    const auto [known, is_new] = spans_.try_emplace({first, count}, 0);
    if (is_new) known->second = file_.times(std::span(times_).subspan(first, count));
    return known->second;
  }

  void move(int node, const Track& track) {
    const Vec3& at = track.places.front();
    const Quaternion& q = track.rotations.front();
    file_.node(node)["translation"] = {at.x, at.y, at.z};
    file_.node(node)["rotation"] = {q.x, q.y, q.z, q.w};
    const int over = times(track.first, track.places.size());
    file_.animate(node, "translation", over, file_.vectors(track.places), "LINEAR");
    file_.animate(node, "rotation", over, file_.rotations(track.rotations), "LINEAR");
  }

  /// Shows a node from frame `first` until frame `end`: at scale 0 viewers draw nothing.
  void show(int node, std::size_t first, std::size_t end) {
    std::vector<double> at;
    std::vector<Vec3> scales;
    const auto key = [&](double time, double scale) {
      at.push_back(time);
      scales.push_back({scale, scale, scale});
    };
    if (first > 0) key(times_.front(), 0.0);
    key(times_[first], 1.0);
    if (end < times_.size()) key(times_[end], 0.0);
    if (first > 0) file_.node(node)["scale"] = {0.0, 0.0, 0.0};
    if (at.size() > 1) file_.animate(node, "scale", file_.times(at), file_.vectors(scales), "STEP");
  }

  /// Wider than the field by a part of its size, and as far astern as the structure starts.
  void add_water() {
    const model::FieldSection& field = run_.resolved.field;
    const double margin = 0.2 * std::max(field.length, field.width), side = 0.5 * field.width + margin;
    const double astern = -run_.resolved.structure.start_distance - margin, ahead = field.length + margin;
    PolyData surface;
    surface.points = {{astern, -side, 0.0}, {ahead, -side, 0.0}, {ahead, side, 0.0}, {astern, side, 0.0}};
    surface.faces = {{0, 1, 2, 3}};
    add("water", file_.mesh(surface, file_.material("water", kSea)));
  }

  void add_structure() {
    Track track;
    for (const model::Frame& frame : run_.results.frames) track.add(frame.structure);
    const int steel = file_.material("structure", kSteel);
    move(add("structure", file_.mesh(mesh_surface(run_.hull->mesh()), steel)), track);
  }

  /// Level ice as it is at the first frame, after each crack, and at the end.
  void add_sheets() {
    const int ice = file_.material("level ice", kIce);
    SheetReplay replay(run_);
    int shown = -1;
    std::size_t since = 0;
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const PolyData surface = sheet_surface(run_.resolved, replay.at(run_.results.frames[i]));
      if (i > 0 && i + 1 < times_.size() && !replay.has_cracked()) continue;
      if (shown >= 0) show(shown, since, i);
      shown = -1;
      if (surface.faces.empty()) continue;
      shown = add(fmt::format("level ice {:.2f} s", times_[i]), file_.mesh(surface, ice));
      since = i;
    }
    if (shown >= 0) show(shown, since, times_.size());
  }

  PolyData floe_surface(const model::FloeRecord& floe) const {
    PolyData surface;
    const double half = 0.5 * thickness_of(floe, run_.resolved);
    for (const geometry::Polygon& polygon : polygons_of(floe.rings)) add_prism(surface, polygon, -half, half);
    return surface;
  }

  void add_floes() {
    std::map<std::int64_t, Track> tracks;
    for (std::size_t i = 0; i < times_.size(); ++i)
      for (const model::FloePose& floe : run_.results.frames[i].floes) {
        Track& track = tracks.try_emplace(floe.floe, Track{i, {}, {}}).first->second;
        track.add(floe.pose);
      }
    const int ice = file_.material("floes", kFloe);
    for (const model::FloeRecord& floe : run_.results.floes) {
      const auto track = tracks.find(floe.id);
      if (track == tracks.end()) continue;  // it lived between two frames
      const int node = add(fmt::format("floe {}", floe.id), file_.mesh(floe_surface(floe), ice));
      move(node, track->second);
      show(node, track->second.first, track->second.first + track->second.places.size());
    }
  }

  const Replay& run_;
  GltfFile file_;
  std::vector<double> times_;  ///< of the frames [s]
  std::map<std::pair<std::size_t, std::size_t>, int> spans_;
  std::vector<int> parts_;
};

}  // namespace

Export gltf_export() {
  return {.name = "gltf",
          .meaning = "The replay for any 3-D viewer (glTF 2.0, .glb)",
          .output = "file of the replay",
          .beside = "run.glb",
          .example = "cone.glb",
          .ending = ".glb",
          .kind = "a replay in binary glTF",
          .write = [](const Replay& run, const std::string& file) {
            write_file(file, Scene(run).bytes());
            return file;
          }};
}

}  // namespace brash::formats
