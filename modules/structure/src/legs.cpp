// SPDX-License-Identifier: GPL-3.0-or-later
#include "legs.hpp"

#include <cmath>
#include <iterator>
#include <utility>

#include "brash/core/constants.hpp"
#include "mesh_sections.hpp"

namespace brash::structure {
namespace {

Vec3 at_waterplane(Vec2 place) { return {place.x, place.y, 0.0}; }

void append(std::vector<Outline>& all, std::vector<Outline> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The outlines that cover what any of `outlines` covers.
std::vector<Outline> joined(std::vector<Outline> outlines) {
  std::vector<Loops> regions;
  for (Outline& outline : outlines) regions.push_back({std::move(outline)});
  return united(regions, 0.0);
}

TriangleMesh copies_of(const TriangleMesh& leg, const std::vector<Vec2>& places) {
  TriangleMesh mesh;
  for (const Vec2 place : places) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (const Vec3 v : leg.vertices) mesh.vertices.push_back(v + at_waterplane(place));
    for (const auto& [i, j, k] : leg.triangles) mesh.triangles.push_back({first + i, first + j, first + k});
  }
  return mesh;
}

}  // namespace

Legs::Legs(std::unique_ptr<const Hull> leg, std::vector<Vec2> places)
    : leg_(std::move(leg)), places_(std::move(places)), regions_({leg_.get(), places_}) {
  for (const Vec2 place : places_)
    for (ConvexPart part : leg_->parts()) {
      for (Vec3& v : part) v += at_waterplane(place);
      parts_.push_back(std::move(part));
    }
  mesh_ = copies_of(leg_->mesh(), places_);
}

Pose Legs::pose_of(Vec2 place, const Pose& structure) const {
  return {to_world(structure, at_waterplane(place)), structure.rotation};
}

Footprint Legs::footprint(const Pose& pose, double bottom, double top) const {
  Footprint all;
  for (const Vec2 place : places_) {
    Footprint leg = leg_->footprint(pose_of(place, pose), bottom, top);
    append(all.leading, std::move(leg.leading));
    append(all.trailing, std::move(leg.trailing));
  }
  const bool is_upright = pose.rotation.x == 0.0 && pose.rotation.y == 0.0;
  return is_upright ? all : Footprint{joined(std::move(all.leading)), joined(std::move(all.trailing))};
}

std::vector<SidePiece> Legs::sides(const Pose& pose, double bottom, double top, const PlanBox& region) const {
  std::vector<SidePiece> all;
  for (const Vec2 place : places_) {
    std::vector<SidePiece> leg = leg_->sides(pose_of(place, pose), bottom, top, region);
    all.insert(all.end(), std::make_move_iterator(leg.begin()), std::make_move_iterator(leg.end()));
  }
  return all;
}

Surface Legs::surface_at(const Pose& pose, Vec3 point) const {
  const Vec2 nearest = places_[regions_.at(to_body(pose, point))];
  return leg_->surface_at(pose_of(nearest, pose), point);
}

Displacement Legs::displaced(const Pose& pose) const {
  Displacement all;
  for (const Vec2 place : places_) {
    const Displacement leg = leg_->displaced(pose_of(place, pose));
    all.volume += leg.volume;
    all.centre += leg.volume * leg.centre;
    all.waterplane.area += leg.waterplane.area;
    all.waterplane.centre += leg.waterplane.area * leg.waterplane.centre;
  }
  if (all.volume > 0.0) all.centre = all.centre / all.volume;
  if (all.waterplane.area > 0.0) all.waterplane.centre = all.waterplane.centre / all.waterplane.area;
  all.waterplane.radius = std::sqrt(all.waterplane.area / kPi);
  return all;
}

}  // namespace brash::structure
