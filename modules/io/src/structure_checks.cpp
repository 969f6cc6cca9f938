// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/inner_radius.hpp"
#include "brash/structure/mesh_file.hpp"
#include "brash/structure/motion.hpp"
#include "brash/structure/ship.hpp"
#include "checks.hpp"

namespace brash::io {
namespace {

/// How far from the origin the geometry's grid reaches, geometry::kMaxCoordinate [m].
constexpr double kFarthest = 8192.0;

/// Whether the keys of a shape give a hull. Where their ranges in the schema say it all, they do.
bool check_shape(const auto&, Checks&) { return true; }

/// How far a sloping side draws back from the waterline to the narrow end: the keel when it breaks ice downward, the
/// top when upward [m].
double retreat(const auto& shape) {
  const bool downward = shape.breaking == model::Breaking::kDownward;
  return (downward ? shape.height_under_water : shape.height - shape.height_under_water) / std::tan(shape.angle);
}

bool check_shape(const model::Cone& cone, Checks& checks) {
  const bool downward = cone.breaking == model::Breaking::kDownward;
  const double lost = 2.0 * retreat(cone);
  checks.require(cone.waterline_width > lost, {"structure", "waterline_width"}, {"structure", "angle"},
                 fmt::format("the cone's {} would have the width {:.4g} m", downward ? "keel" : "top",
                             cone.waterline_width - lost),
                 fmt::format("more than {:.6g} m at this angle and height", lost),
                 "widen the waterline, steepen the angle, or shorten that end");
  return cone.waterline_width > lost;
}

/// The plan's least extent of an end of the structure, keel or top, must be positive.
bool check_end(double waterline, double lost, const char* key, bool downward, Checks& checks) {
  checks.require(waterline > lost, {"structure", key}, {"structure", "angle"},
                 fmt::format("the structure ends before its {}", downward ? "keel" : "top"),
                 fmt::format("more than {:.6g} m at this angle and height", lost),
                 "enlarge it, steepen the angle, or shorten that end");
  return waterline > lost;
}

bool check_shape(const model::FacetedCone& cone, Checks& checks) {
  return check_end(cone.waterline_width, 2.0 * retreat(cone), "waterline_width",
                   cone.breaking == model::Breaking::kDownward, checks);
}

bool check_shape(const model::Plane& plane, Checks& checks) {
  return check_end(plane.length, retreat(plane), "length", plane.breaking == model::Breaking::kDownward, checks);
}

/// The wedge ends ahead of the back.
bool check_shape(const model::WedgeBow& bow, Checks& checks) {
  const double wedge = 0.5 * bow.waterline_width / std::tan(bow.entrance);
  return check_end(bow.length, wedge + retreat(bow) / std::sin(bow.entrance), "length",
                   bow.breaking == model::Breaking::kDownward, checks);
}

/// A ship narrows towards its keel from ahead and astern; its parallel part must not run out, and its sides not meet.
bool check_shape(const model::Ship& given, Checks& checks) {
  const model::HullSection& h = given.hull;
  if (!h.length || !h.breadth || !h.draught || !h.stem_angle || !h.waterline_angle) {
    checks.require(false, {"structure", "kind"}, {"structure", "kind"}, "has no particulars in [hull]",
                   "a [hull] with length, breadth, draught, stem_angle and waterline_angle", "write these keys");
    return false;
  }
  const structure::Particulars ship = structure::particulars_of(h);
  const double keel = -ship.draught, deck = ship.depth - ship.draught;
  checks.require(deck > 0.0, {"hull", "depth"}, {"hull", "draught"}, "the deck lies under water",
                 fmt::format("more than hull.draught = {} m", *h.draught), "raise hull.depth");
  checks.require(ship.run > 0.0, {"hull", "midbody"}, {"hull", "length"},
                 "the bow and the parallel part leave no room for the stern",
                 fmt::format("less than hull.length less the bow, {:.4g} m", ship.length - ship.bow),
                 "lengthen the hull, shorten hull.midbody, or raise hull.waterline_angle");
  checks.require(ship.fullness >= 1.0, {"hull", "bow_length"}, {"hull", "waterline_angle"},
                 "the bow is shorter than a wedge of its angle",
                 fmt::format("at least {:.6g} m", ship.bow / ship.fullness),
                 "lengthen it, or raise hull.waterline_angle");
  const bool has_keel = structure::half_breadth_at(ship, keel) > 0.0;
  checks.require(has_keel, {"hull", "flare"}, {"hull", "draught"}, "the sides meet above the keel",
                 "sides that leave the keel a breadth", "lower hull.flare or hull.draught");
  if (!(deck > 0.0 && ship.run > 0.0 && ship.fullness >= 1.0 && has_keel)) return false;
  const double shortest = std::min(structure::midbody_at(ship, keel), structure::midbody_at(ship, deck));
  checks.require(
      shortest > 0.0, {"hull", "midbody"}, {"hull", "stem_angle"},
      fmt::format("bow and stern meet: the parallel part is {:.4g} m long at the keel or the deck", shortest),
      "a parallel part from keel to deck",
      "lengthen hull.midbody, steepen hull.stem_angle or hull.stern_angle, or lower hull.flare");
  return shortest > 0.0;
}

/// A checkpoint names no file; its state has nothing to check here.
bool check_shape(const model::Mesh& mesh, Checks& checks) {
  const Key file{"structure", "file"};
  std::error_code ignored;
  const bool is_there = std::filesystem::is_regular_file(mesh.file, ignored);
  checks.require(is_there || mesh.file.empty(), file, file, fmt::format("there is no file {}", mesh.file),
                 "a mesh in STL, OBJ, PLY or OFF, relative to the case file", "correct the path");
  if (!is_there) return false;
  const auto found = structure::examine(mesh);
  if (!found) checks.require(false, file, file, found.error().what, found.error().allowed, found.error().remedy);
  return found.has_value();
}

/// The keys of a shape for the heights of its ends.
struct HeightKeys {
  Key keel{"structure", "height_under_water"};
  Key top{"structure", "height"};
};

HeightKeys height_keys(const model::Shape& shape) {
  if (std::holds_alternative<model::Ship>(shape)) return {{"hull", "draught"}, {"hull", "depth"}};
  if (std::holds_alternative<model::Mesh>(shape)) return {{"structure", "draught"}, {"structure", "draught"}};
  return {};
}

/// The ice must meet the structure's surface over its whole thickness. @return whether it does.
bool check_heights(const structure::Hull& hull, const HeightKeys& keys, double draught, double freeboard,
                   Checks& checks) {
  const auto [least, most] = hull.bounds();
  const double under_water = -least.z;
  const auto name = [](Key key) { return fmt::format("{}.{}", key.section, key.name); };
  checks.require(most.z > 0.0, keys.keel, keys.top, "the structure does not reach the water's surface",
                 fmt::format("less than {} = {} m", name(keys.top), most.z - least.z),
                 fmt::format("lower {} or raise {}", name(keys.keel), name(keys.top)));
  if (most.z <= 0.0) return false;
  checks.require(draught < under_water, keys.keel, keys.top, "the ice reaches below the keel",
                 fmt::format("more than the ice's draught, {:.6g} m", draught), "deepen the keel or thin the ice");
  checks.require(
      freeboard < most.z, keys.top, {"ice", "thickness"}, "the ice reaches above the structure",
      fmt::format("more than {} plus the ice's freeboard, {:.6g} m", keys.keel.name, under_water + freeboard),
      fmt::format("raise {} or thin the ice", name(keys.top)));
  return draught < under_water && freeboard < most.z;
}

/// A structure afloat keeps clear of the bed. Any other may reach into it.
void check_under_keel(const model::Case& c, const structure::Hull& hull, Checks& checks) {
  const bool floats = std::holds_alternative<model::Free>(c.structure.motion) ||
                      std::holds_alternative<model::Moored>(c.structure.motion);
  if (!floats || !c.water.depth) return;
  const double draught = -hull.bounds().first.z;
  checks.require(draught < *c.water.depth, {"water", "depth"}, height_keys(c.structure.shape).keel,
                 "the structure does not float: it reaches the bed",
                 fmt::format("more than its draught, {:.6g} m", draught),
                 "deepen the water, lower the draught, or take structure.motion.kind = \"towed\"");
}

/// The key that makes a shape of this size in plan thin.
Key thin_key(const model::Shape& shape, Vec3 size) {
  if (std::holds_alternative<model::Mesh>(shape)) return {"structure", "file"};
  if (std::holds_alternative<model::Ship>(shape)) return {"hull", "breadth"};
  const bool has_length = std::holds_alternative<model::Plane>(shape) || std::holds_alternative<model::WedgeBow>(shape);
  return {"structure", has_length && size.x < size.y ? "length" : "waterline_width"};
}

/// Contacts draw every convex part in by the margin, and something must be left of it.
void check_margin(const model::Case& c, const structure::Hull& hull, Checks& checks) {
  constexpr double kRoundOff = 1e-8;  // of the extent
  const double enough = c.contact.margin + kRoundOff * hull.reach();
  double least = HUGE_VAL;
  for (const structure::ConvexPart& part : hull.parts()) least = std::min(least, structure::inner_radius(part, enough));
  const auto [lowest, highest] = hull.bounds();
  const Key thin = thin_key(c.structure.shape, highest - lowest);
  const bool is_mesh = std::holds_alternative<model::Mesh>(c.structure.shape);
  const std::string what = is_mesh ? fmt::format("the thinnest of the mesh's {} convex parts", hull.parts().size())
                                   : std::string("the structure");
  checks.require(least >= enough, {"contact", "margin"}, thin,
                 fmt::format("leaves no body of {}, which is {:.4g} m thick", what, 2.0 * least),
                 fmt::format("less than half of that, {:.6g} m", least),
                 is_mesh ? "lower contact.margin, or thicken the mesh of structure.file"
                         : fmt::format("lower contact.margin, or raise {}.{}", thin.section, thin.name));
}

/// Legs apart from each other: the boxes around them in plan do not touch. @return whether there is a structure.
bool check_legs(const model::StructureSection& s, Checks& checks) {
  if (s.legs.size() < 2) return true;
  const auto [least, most] = structure::make_hull(s.shape)->bounds();
  const Vec2 size = plan(most - least);
  for (std::size_t i = 0; i < s.legs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 apart = s.legs[i] - s.legs[j];
      if (std::abs(apart.x) > size.x || std::abs(apart.y) > size.y) continue;
      checks.require(false, {"structure", "legs"}, {"structure", "waterline_width"},
                     fmt::format("legs {} and {} touch, or may touch", j + 1, i + 1),
                     fmt::format("places more than {:.6g} m apart along x, or {:.6g} m along y: a leg's largest "
                                 "extent",
                                 size.x, size.y),
                     "move the legs apart, or make them thinner");
      return false;
    }
  return true;
}

/// A front that is vertical because the mesh is turned, or one that is so on purpose.
std::string remedy_of_vertical_front(const model::Shape& shape) {
  const std::string whole = "write false: the ice is whole when the structure comes";
  const auto* const mesh = std::get_if<model::Mesh>(&shape);
  const auto report = mesh != nullptr ? structure::examine(*mesh) : structure::MeshReport{};
  if (!report || report->bearing.doubt.empty()) return whole;
  return fmt::format("{}, for {}; or, if it is so, {}", report->bearing.remedy, report->bearing.doubt, whole);
}

/// A front that is vertical, or so steep that the ice sticks to it, crushes ice and breaks none.
void check_front(const model::Case& c, double slope, Checks& checks) {
  const bool is_vertical = slope >= structure::kSteepestSlope;
  if (!is_vertical && std::tan(slope) * c.ice.friction_structure < 1.0) return;
  checks.require(!is_vertical || c.contact.area == model::ContactArea::kSurface, {"contact", "area"},
                 {"structure", "angle"}, "the structure's front is vertical, and its plan has no area", "surface",
                 "write surface, which takes the area of the face itself");
  if (!model::has_level_ice(c.field)) return;
  std::string why = "the structure's front is vertical and bends no ice";
  std::string remedy = remedy_of_vertical_front(c.structure.shape);
  if (!is_vertical) {
    why = fmt::format(
        "the structure's front slopes at {:.4g} degrees and bends no ice, which sticks to it from {:.4g} "
        "degrees on",
        degrees(slope), degrees(std::atan(1.0 / c.ice.friction_structure)));
    remedy += "; or lower ice.friction_structure";
  }
  checks.require(!c.field.initial_crack || c.field.initial_crack_radius > 0.0, {"field", "initial_crack"},
                 {"structure", "kind"}, why, "false, or a field.initial_crack_radius", remedy);
}

/// @param reach   how far the structure reaches ahead of its origin in the ice [m].
/// @param astern  how far it reaches behind it [m].
void check_way(const model::Case& c, double reach, double astern, Checks& checks) {
  const model::StructureSection& s = c.structure;
  checks.require(s.start_distance > reach || c.field.kind == model::FieldKind::kFloes || model::has_ice_files(c.field),
                 {"structure", "start_distance"}, {"structure", "waterline_width"},
                 "the structure starts inside the ice",
                 fmt::format("more than its largest radius in the ice, {:.6g} m", reach),
                 "start the structure further from the ice edge");
  const double farthest = kFarthest - std::max(reach, astern);
  checks.require(std::abs(s.start_distance) <= farthest, {"structure", "start_distance"},
                 {"structure", "waterline_width"}, "the structure starts outside the plane of the ice",
                 fmt::format("at most {} m less its largest radius in the ice, {:.6g} m", kFarthest, farthest),
                 "start the structure nearer to the ice edge");
  const double speed = model::speed(s.motion);
  checks.require(speed * c.time.duration - s.start_distance <= farthest, {"time", "duration"}, {"structure", "speed"},
                 "the structure leaves the plane of the ice before the end",
                 fmt::format("at most {:.6g} s at this speed", (farthest + s.start_distance) / speed),
                 "shorten the run or slow the structure down");
}

/// Rows of a path: ascending times from 0 to the end, in the plane of the ice. @return whether they make a path.
bool check_rows(const model::Case& c, const std::vector<model::Waypoint>& path, double reach, Checks& checks) {
  const Key key{"structure.motion", "path"};
  const double farthest = kFarthest - reach;
  bool ascends = path.size() > 1, is_near = true;
  for (std::size_t i = 0; i < path.size(); ++i) {
    ascends = ascends && (i == 0 || path[i].time > path[i - 1].time);
    is_near = is_near && std::abs(path[i].position.x) <= farthest && std::abs(path[i].position.y) <= farthest;
  }
  checks.require(ascends, key, key, "its times do not ascend", "two rows or more, each later than the last",
                 "sort the rows, and remove doubled ones");
  checks.require(is_near, key, key, "it leaves the plane of the ice",
                 fmt::format("x and y within +-{:.6g} m", farthest), "keep the path near the ice, whose edge is x = 0");
  if (!ascends || !is_near) return false;
  checks.require(path.front().time == 0.0, key, key, fmt::format("it begins at {} s", path.front().time),
                 "a start at 0 s", "count the times from the start of the run");
  checks.require(path.back().time >= c.time.duration, key, {"time", "duration"},
                 fmt::format("it ends at {} s, before the run", path.back().time),
                 fmt::format("rows up to time.duration = {} s", c.time.duration), "add rows, or shorten the run");
  checks.require(c.structure.frame != model::MotionFrame::kIceDriftsThroughStillWater, {"structure.motion", "frame"},
                 key, "a path has no one speed at which the ice could drift",
                 "structure-moves or ice-drifts with a path", "write water.current instead");
  return true;
}

/// The structure begins its path beside the ice.
void check_start(const model::Case& c, const structure::Hull& hull, double draught, double freeboard, Checks& checks) {
  if (c.field.kind == model::FieldKind::kFloes) return;  // a field of floes keeps out of its way
  if (model::has_ice_files(c.field)) return;             // the ice itself reports it when it is laid
  const Pose start = structure::unresisted(c.structure, 0.0);
  const auto reach = [&](Vec2 way) { return structure::foremost(hull, start, -draught, freeboard, way).reach; };
  const bool beside = reach({1.0, 0.0}) < 0.0 || -reach({-1.0, 0.0}) > c.field.length ||
                      -reach({0.0, -1.0}) > 0.5 * c.field.width || reach({0.0, 1.0}) < -0.5 * c.field.width;
  checks.require(beside, {"structure.motion", "path"}, {"field", "length"}, "the structure starts inside the ice",
                 fmt::format("a first row beside the sheet: the structure reaches {:.4g} m ahead of its origin",
                             reach({1.0, 0.0}) - start.position.x),
                 "start the path further from the ice edge");
}

/// A mooring holds, and its springs have an energy.
void check_mooring(const model::Moored& moored, Checks& checks) {
  const Key matrix{"structure.motion", "stiffness_matrix"}, lines{"structure.motion", "lines"};
  checks.require(!moored.stiffness.empty() || !moored.lines.empty(), matrix, {"structure.motion", "kind"},
                 "the structure is moored to nothing", "a stiffness_matrix, lines, or both",
                 "write one, or take kind = \"free\"");
  bool is_symmetric = true;
  for (std::size_t i = 0; i < moored.stiffness.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) is_symmetric = is_symmetric && moored.stiffness[i][j] == moored.stiffness[j][i];
  checks.require(is_symmetric, matrix, matrix, "is not symmetric: springs with it would give energy",
                 "a matrix equal to its transpose", "correct the values across the diagonal");
  for (const model::MooringLine& line : moored.lines) {
    checks.require(line.length > 0.0 && line.weight > 0.0 && line.stiffness > 0.0, lines, lines,
                   "a line has no length, weight or stiffness", "the last three values of each row > 0",
                   "write length, weight in water and axial stiffness");
    checks.require(line.anchor.z < line.fairlead.z, lines, lines, "an anchor lies above its fairlead",
                   "anchors on the sea bed, z < 0", "write the anchor's height from the water's surface");
  }
}

/// A thrust that falls points ahead, and holds the resistance of the water in surge.
void check_thrust(const model::FloatingBody& body, Checks& checks) {
  if (!body.open_water_speed) return;
  const Key top{"structure.motion", "open_water_speed"};
  const Vec3 thrust = body.thrust;
  checks.require(
      thrust.x > 0.0 && thrust.y == 0.0 && thrust.z == 0.0, {"structure.motion", "thrust"}, top,
      fmt::format("open_water_speed makes a thrust ahead fall, not [{:g}, {:g}, {:g}] N", thrust.x, thrust.y, thrust.z),
      "the bollard pull along x, such as [\"1 MN\", 0, 0]", "write the bollard pull, or remove open_water_speed");
  const auto holds_surge = [&](const char* key, double damping) {
    checks.require(
        damping == 0.0, {"structure.motion", key}, top,
        fmt::format("{:g} damps surge, and open_water_speed holds the resistance of the water already", damping),
        "0 in surge", "write 0 as its first value, or remove open_water_speed");
  };
  holds_surge("linear_damping", body.linear_damping.x);
  holds_surge("quadratic_damping", body.quadratic_damping.x);
}

}  // namespace

void check_structure(const model::Case& c, Checks& checks) {
  if (!std::visit([&](const auto& shape) { return check_shape(shape, checks); }, c.structure.shape)) return;
  if (!check_legs(c.structure, checks)) return;
  const auto hull = structure::make_hull(c.structure);
  check_margin(c, *hull, checks);
  const double draught = c.ice.thickness * c.ice.density / c.water.density;
  const double freeboard = c.ice.thickness - draught;
  if (!check_heights(*hull, height_keys(c.structure.shape), draught, freeboard, checks)) return;
  check_under_keel(c, *hull, checks);

  const auto meets = [&](const Pose& pose, Vec2 course) {
    return structure::foremost(*hull, pose, -draught, freeboard, course);
  };
  if (const auto* const moored = std::get_if<model::Moored>(&c.structure.motion)) {
    check_mooring(*moored, checks);
    check_thrust(moored->body, checks);
  }
  if (const auto* const free = std::get_if<model::Free>(&c.structure.motion)) check_thrust(free->body, checks);
  const auto* const towed = std::get_if<model::Towed>(&c.structure.motion);
  if (towed == nullptr || towed->path.empty()) {
    const auto [surface, reach] = meets({}, {1.0, 0.0});
    check_front(c, surface.slope, checks);
    check_way(c, reach, meets({}, {-1.0, 0.0}).reach, checks);
  } else if (check_rows(c, towed->path, hull->reach(), checks)) {
    const auto motion = structure::make_motion(c, *hull);
    check_front(c, meets(motion->now().pose, motion->course()).surface.slope, checks);
    check_start(c, *hull, draught, freeboard, checks);
  }
  const double width = structure::foremost(*hull, {}, 0.0, 0.0, {0.0, 1.0}).reach +
                       structure::foremost(*hull, {}, 0.0, 0.0, {0.0, -1.0}).reach;
  checks.require(c.field.width > width || c.field.kind == model::FieldKind::kFloes, {"field", "width"},
                 {"structure", "waterline_width"}, "the sheet is narrower than the structure",
                 fmt::format("more than the structure's width at the waterline, {:.6g} m", width), "widen the sheet");
}

/// The closed form needs the first five keys; the others say more of the same hull.
void check_hull(const model::Case& c, Checks& checks) {
  const model::HullSection& h = c.hull;
  const std::array<std::pair<const char*, bool>, 5> keys{{{"length", h.length.has_value()},
                                                          {"breadth", h.breadth.has_value()},
                                                          {"draught", h.draught.has_value()},
                                                          {"stem_angle", h.stem_angle.has_value()},
                                                          {"waterline_angle", h.waterline_angle.has_value()}}};
  const std::array<std::pair<const char*, bool>, 5> more{{{"depth", h.depth.has_value()},
                                                          {"bow_length", h.bow_length.has_value()},
                                                          {"flare", h.flare.has_value()},
                                                          {"midbody", h.midbody.has_value()},
                                                          {"stern_angle", h.stern_angle.has_value()}}};
  const auto is_given = [](const auto& key) { return key.second; };
  const char* written = nullptr;
  if (const auto key = std::ranges::find_if(more, is_given); key != more.end()) written = key->first;
  if (const auto key = std::ranges::find_if(keys, is_given); key != keys.end()) written = key->first;
  if (written == nullptr) return;
  for (const auto& [name, given] : keys)
    checks.require(given, {"hull", name}, {"hull", written}, "is missing beside the hull's other keys",
                   "length, breadth, draught, stem_angle and waterline_angle, or none",
                   "write it, or leave [hull] out");
}

}  // namespace brash::io
