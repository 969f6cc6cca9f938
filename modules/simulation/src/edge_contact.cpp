// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/structure/patches.hpp"
#include "plan.hpp"

namespace brash::simulation {
namespace {

/// The free edge is looked at this far from B, in characteristic lengths: the stress has faded there.
constexpr double kFitReach = 2.0;
/// A criterion that solves the outline gets this much of it, in characteristic lengths: as far as it is meshed finely.
constexpr double kOutlineReach = 3.0;
/// The chord's ends lie on the free edge to within this [m]; they are rounded to the geometry's grid, 2^-30 m.
constexpr double kOnTheEdge = 1e-6;
/// A floe that presses without any vertical part; the criteria ask for some.
constexpr double kLeastMu1 = 1e-6;

std::vector<geometry::Ring> on_grid(const std::vector<structure::Outline>& outlines) {
  std::vector<geometry::Ring> rings;
  for (const structure::Outline& outline : outlines) rings.push_back(geometry::ring(outline));
  return rings;
}

structure::Footprint footprint(const EdgeModel& model, const Pose& pose) {
  const Freeboard heights = freeboard(model.resolved);
  return model.hull.footprint(pose, heights.bottom, heights.top);
}

/// A place on a polyline.
struct Foot {
  std::size_t segment = 0;
  double distance = std::numeric_limits<double>::infinity();
};

/// The place of `line` nearest to `point`; the first of several.
Foot nearest(const std::vector<Vec2>& line, Vec2 point) {
  Foot best;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 along = line[i + 1] - line[i];
    const double square = dot(along, along);
    const double s = square > 0.0 ? std::clamp(dot(point - line[i], along) / square, 0.0, 1.0) : 0.0;
    const double distance = norm(line[i] + s * along - point);
    if (distance < best.distance) best = {i, distance};
  }
  return best;
}

/// Drops the part of each arm beyond its outermost point: from there the edge is taken to go on sideways.
void end_sideways(std::vector<Vec2>& outline, std::size_t contact) {
  const auto by_y = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  const auto tip = outline.begin() + static_cast<std::ptrdiff_t>(contact);
  outline.erase(std::max_element(tip + 1, outline.end(), by_y) + 1, outline.end());
  outline.erase(outline.begin(), std::min_element(outline.begin(), tip + 1, by_y));
}

/// The free edge around a contact in the frame of LoadCase::outline, the chord in place of the crushed tip. Empty where
/// the chord's ends are not on one piece of the edge.
std::vector<Vec2> outline_of(const geometry::IceSheet& sheet, const geometry::ContactRegion& region, double reach) {
  const Vec2 at = 0.5 * (region.chord_from + region.chord_to);
  const auto to_frame = [&](Vec2 point) {
    return Vec2{dot(point - at, region.normal), dot(point - at, perpendicular(region.normal))};
  };
  for (const std::vector<Vec2>& chain : sheet.free_edge(at, reach)) {
    // With the ice on its left the chain comes from y > 0, dives into the structure and leaves it towards y < 0.
    const Foot dives = nearest(chain, region.chord_to), leaves = nearest(chain, region.chord_from);
    if (dives.distance > kOnTheEdge || leaves.distance > kOnTheEdge || dives.segment > leaves.segment) continue;
    std::vector<Vec2> outline;
    const auto append = [&](std::size_t from, std::size_t to, Vec2 chord_end) {
      for (std::size_t i = to; i-- > from;) {
        if (norm(chain[i] - chord_end) > kOnTheEdge) outline.push_back(to_frame(chain[i]));
      }
    };
    append(leaves.segment + 1, chain.size(), region.chord_from);
    const std::size_t contact = outline.size();
    outline.push_back({0.0, -0.5 * region.contact_length});
    outline.push_back({0.0, 0.5 * region.contact_length});
    append(0, dives.segment + 1, region.chord_to);
    end_sideways(outline, contact);
    return outline;
  }
  return {};
}

/// The crushing load of a contact on the ice.
struct Crushing {
  Vec3 force{};        ///< with friction [N]
  Vec3 vector_area{};  ///< sum of area times normal over the surface that crushes [m2]
  Vec3 moment{};       ///< sum of area times place [m3]
  double area = 0.0;   ///< of that surface [m2]
};

/// Eq. 15 on each part of the surface inside the ice that moves into it, against its normal and its slip.
Crushing crushing(const EdgeModel& model, const structure::State& state, std::span<const structure::SidePiece> sides,
                  const geometry::Polygon& overlap) {
  const model::Case& c = model.resolved;
  const bool projected = c.contact.area == model::ContactArea::kProjected;
  Crushing sum;
  for (const structure::Patch& patch : structure::patches_within(sides, rings_in_metres(overlap))) {
    const Vec3 velocity = velocity_at(state.twist, patch.centroid - state.pose.position);
    const double into_ice = dot(velocity, patch.normal);
    if (into_ice <= 0.0) continue;  // slides past or leaves
    const double area = projected ? patch.plan_area : patch.area;
    const Vec3 slip = velocity - into_ice * patch.normal;
    const Vec3 friction = norm(slip) > 0.0 ? c.ice.friction_structure * normalized(slip) : Vec3{};
    sum.force += failure::crushing_force(model.ice, area) * (patch.normal + friction);
    sum.vector_area += area * patch.normal;
    sum.moment += area * patch.centroid;
    sum.area += area;
  }
  return sum;
}

/// The load of a contact with the structure, also as the failure model takes it: N along the chord's normal, f along
/// the chord, P vertical.
void load_contact(const EdgeModel& model, const Crushing& crushed, EdgeContact& contact) {
  if (!(crushed.area > 0.0)) return;
  const Vec2 normal = contact.region.normal;
  const double area = norm(crushed.vector_area);
  contact.force = -crushed.force;
  contact.point = crushed.moment / crushed.area;
  contact.normal = crushed.vector_area / area;
  contact.area = area;
  contact.bound = failure::crushing_force(model.ice, area);

  const double in_plane = dot(plan(crushed.force), normal);
  if (!(in_plane > 0.0)) return;
  contact.load = {.depth = contact.wedge.depth,
                  .contact_length = contact.region.contact_length,
                  .angle = contact.wedge.angle,
                  .mu1 = std::max(std::abs(crushed.force.z) / in_plane, kLeastMu1),
                  .mu2 = dot(plan(crushed.force), perpendicular(normal)) / in_plane,
                  .pressure = in_plane / (contact.region.contact_length * model.ice.thickness)};
}

/// The wedge behind the chord, which the crushed tip has become.
void fit(const EdgeModel& model, const geometry::IceSheet& sheet, EdgeContact& contact) {
  const geometry::ContactRegion& region = contact.region;
  contact.wedge = geometry::fit_trapezoid(sheet, {.at = 0.5 * (region.chord_from + region.chord_to),
                                                  .towards = region.normal,
                                                  .contact_length = region.contact_length,
                                                  .reach = kFitReach * failure::characteristic_length(model.ice)});
}

void assess(const EdgeModel& model, const geometry::IceSheet& sheet, EdgeContact& contact) {
  if (!(contact.load.pressure > 0.0)) return;
  if (model.criterion.needs_outline())
    contact.load.outline = outline_of(sheet, contact.region, kOutlineReach * failure::characteristic_length(model.ice));
  const auto harmless = model.criterion.dismiss(contact.load);
  contact.assessment = harmless ? *harmless : model.criterion.assess(contact.load);
}

}  // namespace

Freeboard freeboard(const model::Case& resolved) { return freeboard(resolved, resolved.ice.thickness); }

Freeboard freeboard(const model::Case& resolved, double thickness) {
  const double draft = thickness * resolved.ice.density / resolved.water.density;
  return {thickness - draft, -draft};
}

failure::IceProperties ice_properties(const model::Case& resolved) {
  return {.thickness = resolved.ice.thickness,
          .youngs_modulus = resolved.ice.youngs_modulus,
          .poisson_ratio = resolved.ice.poisson_ratio,
          .flexural_strength = resolved.ice.flexural_strength,
          .compressive_strength = resolved.ice.compressive_strength,
          .crushing_factor = resolved.ice.crushing_factor,
          .water_density = resolved.water.density};
}

std::unique_ptr<failure::BendingCriterion> make_criterion(const model::Case& resolved,
                                                          const failure::IceProperties& ice) {
  const model::FailureSection& section = resolved.failure;
  return failure::make_criterion(
      section.model, section.file, ice,
      {.second_order = section.second_order, .radial_first = section.order == model::CrackOrder::kRadialFirst});
}

std::vector<geometry::Ring> leading_outlines(const EdgeModel& model, const Pose& pose) {
  return on_grid(footprint(model, pose).leading);
}

std::vector<geometry::Ring> trailing_outlines(const EdgeModel& model, const Pose& pose) {
  return on_grid(footprint(model, pose).trailing);
}

std::vector<EdgeContact> edge_contacts(const EdgeModel& model, const geometry::IceSheet& sheet,
                                       const structure::State& state) {
  std::vector<EdgeContact> contacts;
  const Freeboard heights = freeboard(model.resolved);
  const auto sides = model.hull.sides(state.pose, heights.bottom, heights.top);
  for (const geometry::Ring& outline : leading_outlines(model, state.pose)) {
    for (geometry::ContactRegion& region : sheet.contacts(outline)) {
      if (!(region.contact_length > 0.0)) continue;
      EdgeContact contact;
      contact.region = std::move(region);
      fit(model, sheet, contact);
      load_contact(model, crushing(model, state, sides, contact.region.overlap), contact);
      assess(model, sheet, contact);
      contacts.push_back(std::move(contact));
    }
  }
  return contacts;
}

std::vector<rigid_body::GivenContact> given_contacts(std::span<const EdgeContact> contacts, BodyId structure,
                                                     double friction) {
  std::vector<rigid_body::GivenContact> given;
  for (const EdgeContact& contact : contacts)
    if (contact.bound > 0.0)
      given.push_back({.body = structure,
                       .point = contact.point,
                       .normal = -contact.normal,
                       .area = contact.area,
                       .most_normal_force = contact.bound,
                       .friction = friction});
  return given;
}

std::optional<EdgeContact> bearing_contact(const EdgeModel& model, const geometry::IceSheet& sheet, std::int64_t floe,
                                           const Bearing& bearing) {
  const double h = model.ice.thickness;
  // A cantilever of the width h and the length l_c does not break under less.
  const double harmless = model.ice.flexural_strength * h * h * h / (6.0 * failure::characteristic_length(model.ice));
  if (bearing.weight < harmless || norm(bearing.thrust) == 0.0) return std::nullopt;
  const LineLoad line = line_load(bearing);
  if (line.normal <= 0.0) return std::nullopt;

  EdgeContact contact;
  contact.floe = floe;
  geometry::ContactRegion& region = contact.region;
  region.contact_length = std::max(line.length, h);
  region.midpoint = line.middle;
  region.normal = line.towards;
  const Vec2 half = 0.5 * region.contact_length * perpendicular(line.towards);
  region.chord_from = line.middle - half;
  region.chord_to = line.middle + half;
  fit(model, sheet, contact);
  contact.load = {.depth = contact.wedge.depth,
                  .contact_length = region.contact_length,
                  .angle = contact.wedge.angle,
                  .mu1 = std::max(line.out_of_plane / line.normal, kLeastMu1),
                  .mu2 = line.across / line.normal,
                  .pressure = line.normal / (region.contact_length * h)};
  assess(model, sheet, contact);
  return contact;
}

}  // namespace brash::simulation
