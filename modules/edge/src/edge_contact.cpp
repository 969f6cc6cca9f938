// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/edge_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/edge/local_ice.hpp"
#include "brash/edge/sheet_loads.hpp"
#include "brash/floes/plan.hpp"
#include "brash/structure/patches.hpp"

namespace brash::edge {
namespace {

/// The free edge is looked at this far from B, in characteristic lengths: the stress has faded there.
constexpr double kFitReach = 2.0;
/// A load without any vertical part; the criteria ask for some.
constexpr double kLeastMu1 = 1e-6;
/// A load without any part in the plane, over its vertical part.
constexpr double kLeastInPlane = 1e-3;
/// A floe lies flat under the sheet when its normal forces have less than this share in the plane.
constexpr double kFlat = 0.1;

std::vector<geometry::Ring> on_grid(const std::vector<structure::Outline>& outlines) {
  std::vector<geometry::Ring> rings;
  for (const structure::Outline& outline : outlines) rings.push_back(geometry::ring(outline));
  return rings;
}

structure::Footprint footprint(const EdgeModel& model, const Pose& pose, double shift = 0.0) {
  const Freeboard heights = freeboard(model.resolved);
  return model.hull.footprint(pose, heights.bottom + shift, heights.top + shift);
}

/// The sides within ice that lies `shift` higher than at rest, over a part of the plan.
std::vector<structure::SidePiece> sides(const EdgeModel& model, const Pose& pose, const geometry::Polygon& part,
                                        double shift = 0.0) {
  const Freeboard heights = freeboard(model.resolved);
  const geometry::Extent extent = geometry::extent(part);
  return model.hull.sides(pose, heights.bottom + shift, heights.top + shift, {extent.lower, extent.upper});
}

bool ice_leaves(const EdgeModel& model) { return model.resolved.failure.crushed_ice == model::CrushedIce::kLeaves; }

/// The plan of the ice under the structure over the plan of its surface inside the ice. The surface loads ice that it
/// has passed through too, where such ice stays.
double covered_share(const EdgeModel& model, const std::vector<structure::Patch>& patches,
                     const geometry::Polygon& overlap) {
  if (ice_leaves(model)) return 1.0;
  double plan_area = 0.0;
  for (const structure::Patch& patch : patches) plan_area += patch.plan_area;
  return plan_area > 0.0 ? geometry::area(overlap).square_metres() / plan_area : 1.0;
}

/// The crushing load of a contact on the ice.
struct Crushing {
  Vec3 force{};                    ///< with friction [N]
  Vec3 vector_area{};              ///< sum of area times normal over the surface that crushes [m2]
  Vec3 moment{};                   ///< sum of area times place [m3]
  double area = 0.0;               ///< of that surface [m2]
  double left = 0.0, right = 0.0;  ///< its forces across the chord's normal, to either side [N]

  Crushing& operator+=(const Crushing& other) {
    left += other.left;
    right += other.right;
    force += other.force;
    vector_area += other.vector_area;
    moment += other.moment;
    area += other.area;
    return *this;
  }
};

/// Eq. 15 on each part of the surface inside the ice that moves into it, against its normal and its slip. The surface
/// is as high as the case's ice is thick; where the ice is thicker, its area is larger.
/// @param ahead  normal of the chord.
Crushing crushing(const EdgeModel& model, const structure::State& state, const geometry::Polygon& overlap, Vec2 ahead,
                  double shift = 0.0) {
  const model::Case& c = model.resolved;
  const bool projected = c.contact.area == model::ContactArea::kProjected;
  const double thicker = model.ice.thickness / c.ice.thickness;
  Crushing sum;
  const auto patches =
      structure::patches_within(sides(model, state.pose, overlap, shift), floes::rings_in_metres(overlap));
  const double covered = projected ? covered_share(model, patches, overlap) : 1.0;
  for (const structure::Patch& patch : patches) {
    const Vec3 velocity = velocity_at(state.twist, patch.centroid - state.pose.position);
    const double into_ice = dot(velocity, patch.normal);
    if (into_ice <= 0.0) continue;  // slides past or leaves
    const double area = thicker * (projected ? covered * patch.plan_area : patch.area);
    const Vec3 slip = velocity - into_ice * patch.normal;
    // At most what holds the ice to the surface: the force then lies along the velocity.
    const double coefficient = std::min(c.ice.friction_structure, norm(slip) / into_ice);
    const Vec3 friction = norm(slip) > 0.0 ? coefficient * normalized(slip) : Vec3{};
    const Vec3 force = failure::crushing_force(model.ice, area) * (patch.normal + friction);
    const double across = cross(ahead, plan(force));
    (across > 0.0 ? sum.left : sum.right) += std::abs(across);
    sum.force += force;
    sum.vector_area += area * patch.normal;
    sum.moment += area * patch.centroid;
    sum.area += area;
  }
  return sum;
}

bool holds(const geometry::Extent& outer, const geometry::Extent& inner) {
  return inner.lower.x >= outer.lower.x && inner.lower.y >= outer.lower.y && inner.upper.x <= outer.upper.x &&
         inner.upper.y <= outer.upper.y;
}

/// The same where the edge lies `shift` higher: it gives way, so the structure covers less of it. `region` becomes the
/// longest region that is still covered; it stays if there is none.
Crushing crushing_shifted(const EdgeModel& model, const geometry::IceSheet& sheet, const structure::State& state,
                          double shift, geometry::ContactRegion& region) {
  const geometry::Extent at_rest = geometry::extent(region.overlap);
  Crushing sum;
  double longest = 0.0;
  for (const geometry::Ring& outline : on_grid(footprint(model, state.pose, shift).leading)) {
    for (geometry::ContactRegion& covered : sheet.contacts(outline)) {
      if (!holds(at_rest, geometry::extent(covered.overlap))) continue;
      sum += crushing(model, state, covered.overlap, region.normal, shift);
      if (covered.contact_length <= longest) continue;
      longest = covered.contact_length;
      region = std::move(covered);
    }
  }
  return sum;
}

/// p of a contact with the structure [Pa], Eqs. 17 and 19.
/// @param in_plane  N [N].
double pressure_on(const EdgeModel& model, const EdgeContact& contact, double in_plane) {
  if (model.resolved.failure.pressure == model::EdgePressure::kContact) return contact.bound / contact.area;
  return in_plane / (contact.region.contact_length * model.ice.thickness);
}

/// The load of a contact with the structure, also as the failure model takes it: N along the chord's normal, f along
/// the chord, P vertical.
void load_contact(const EdgeModel& model, const Crushing& crushed, EdgeContact& contact) {
  if (!(crushed.area > 0.0)) return;
  const Vec2 normal = contact.region.normal;
  const double area = norm(crushed.vector_area);
  contact.on_ice = crushed.force;
  contact.point = crushed.moment / crushed.area;
  contact.normal = crushed.vector_area / area;
  contact.area = area;
  contact.spread = std::min(crushed.left, crushed.right);
  contact.bound = failure::crushing_force(model.ice, area);
  contact.bends = std::abs(contact.normal.z) > std::cos(structure::kSteepestSlope) &&
                  std::abs(crushed.force.z) > kLeastMu1 * norm(plan(crushed.force));
  if (!contact.bends) return;

  const double in_plane = dot(plan(crushed.force), normal);
  if (!(in_plane > 0.0)) return;
  contact.load = {.depth = contact.wedge.depth,
                  .contact_length = contact.region.contact_length,
                  .angle = contact.wedge.angle,
                  .mu1 = std::max(std::abs(crushed.force.z) / in_plane, kLeastMu1),
                  .mu2 = dot(plan(crushed.force), perpendicular(normal)) / in_plane,
                  .pressure = pressure_on(model, contact, in_plane)};
}

/// The wedge behind the chord, which the crushed tip has become.
void fit(const EdgeModel& model, const geometry::IceSheet& sheet, EdgeContact& contact) {
  const geometry::ContactRegion& region = contact.region;
  contact.wedge = geometry::fit_trapezoid(sheet, {.at = 0.5 * (region.chord_from + region.chord_to),
                                                  .towards = region.normal,
                                                  .contact_length = region.contact_length,
                                                  .reach = kFitReach * failure::characteristic_length(model.ice)});
  contact.load.depth = contact.wedge.depth;
  contact.load.angle = contact.wedge.angle;
}

/// The direction in which a floe pushes the sheet; if it lies flat under it, the way from the nearest edge into the
/// ice.
std::optional<Vec2> push_of(const EdgeModel& model, const geometry::IceSheet& sheet, const floes::Bearing& bearing) {
  if (norm(bearing.thrust) > kFlat * bearing.weight) return normalized(bearing.thrust);
  return into_ice_near(sheet, plan(bearing.first / bearing.weight),
                       kFitReach * failure::characteristic_length(model.ice));
}

/// Whether a floe presses inside the ice, where a load on the edge does not represent it.
bool presses_inside(const geometry::IceSheet& sheet, const EdgeContact& contact) {
  return contact.floe != model::kNoFloe &&
         sheet.free_edge(contact.region.midpoint, contact.region.contact_length).empty();
}

/// What bends the ice [N]: the vertical force, and the force in the plane with the arm h/2.
double bending_force(const EdgeModel& model, const EdgeContact& contact) {
  const double arm = 0.5 * model.ice.thickness / failure::characteristic_length(model.ice);
  return std::abs(contact.on_ice.z) + arm * norm(plan(contact.on_ice));
}

/// Whether a load that bends within l_c is more than twice as strong. The ice is then checked there.
bool is_outweighed(const EdgeModel& model, const std::vector<EdgeContact>& contacts, const EdgeContact& own) {
  const double l_c = failure::characteristic_length(model.ice), most = 2.0 * bending_force(model, own);
  return std::ranges::any_of(contacts, [&](const EdgeContact& other) {
    return other.bends && norm(other.region.midpoint - own.region.midpoint) < l_c && bending_force(model, other) > most;
  });
}

/// Plate theory says nothing nearer to a load than the ice is thick; a network may even answer with a negative length.
/// So no disc is smaller: docs/theory/fracture-of-the-edge.md, (7).
void bound_disc(const failure::IceProperties& ice, failure::Assessment& answer) {
  if (answer.fails && answer.crack.empty()) answer.breaking_length = std::max(answer.breaking_length, ice.thickness);
}

/// Puts the crack on the sheet, and the contact of a floe where it was checked.
void move_to(const Frame& frame, EdgeContact& contact) {
  for (Vec2& point : contact.assessment.crack) point = frame.on_sheet(point);
  if (contact.floe == model::kNoFloe) return;
  geometry::ContactRegion& region = contact.region;
  const Vec2 half = 0.5 * region.contact_length * perpendicular(frame.x);
  region.normal = frame.x;
  region.midpoint = frame.origin;
  region.chord_from = frame.origin - half;
  region.chord_to = frame.origin + half;
}

}  // namespace

Freeboard freeboard(const model::Case& resolved) { return freeboard(resolved, resolved.ice.thickness); }

Freeboard freeboard(const model::Case& resolved, double thickness) {
  const double draft = thickness * resolved.ice.density / resolved.water.density;
  return {thickness - draft, -draft};
}

namespace {

std::optional<double> length_density(const model::Case& c) {
  if (c.failure.length_density == model::LengthDensity::kWater) return std::nullopt;
  return c.ice.density;
}

}  // namespace

failure::IceProperties ice_properties(const model::Case& resolved) {
  return {.thickness = resolved.ice.thickness,
          .youngs_modulus = resolved.ice.youngs_modulus,
          .poisson_ratio = resolved.ice.poisson_ratio,
          .flexural_strength = resolved.ice.flexural_strength,
          .compressive_strength = resolved.ice.compressive_strength,
          .crushing_factor = resolved.ice.crushing_factor,
          .water_density = resolved.water.density,
          .length_density = length_density(resolved)};
}

std::unique_ptr<failure::BendingCriterion> make_criterion(const model::Case& resolved,
                                                          const failure::IceProperties& ice) {
  const model::FailureSection& section = resolved.failure;
  return failure::make_criterion(section.model, section.file, ice,
                                 {.second_order = section.second_order,
                                  .radial_first = section.order == model::CrackOrder::kRadialFirst,
                                  .anywhere = section.judged == model::JudgedAt::kAnywhere,
                                  .coarse_first = true,
                                  .trace_crack = section.pattern == model::CrackPattern::kStress,
                                  .keeps_pressure = section.small_contact == model::SmallContact::kKeepsPressure});
}

std::vector<geometry::Ring> middle_outlines(const EdgeModel& model, const Pose& pose) {
  if (!ice_leaves(model)) return {};
  const Freeboard heights = freeboard(model.resolved);
  const double middle = 0.5 * (heights.top + heights.bottom);
  return on_grid(model.hull.footprint(pose, middle, middle).leading);
}

std::vector<geometry::Ring> trailing_outlines(const EdgeModel& model, const Pose& pose, double shift) {
  if (!ice_leaves(model)) return {};
  return on_grid(footprint(model, pose, shift).trailing);
}

std::vector<EdgeContact> edge_contacts(const EdgeModel& model, const geometry::IceSheet& sheet,
                                       const structure::State& state,
                                       const std::function<double(const Touch&)>& shift_of) {
  std::vector<EdgeContact> contacts;
  for (const geometry::Ring& outline : on_grid(footprint(model, state.pose).leading)) {
    for (geometry::ContactRegion& region : sheet.contacts(outline)) {
      if (!(region.contact_length > 0.0)) continue;
      EdgeContact contact;
      contact.touched = {0.5 * (region.chord_from + region.chord_to), region.contact_length};
      contact.region = std::move(region);
      const LocalIce local(model, contact.touched.tip);
      const EdgeModel here = local.model();
      contact.ice = local.ice();
      contact.shift = shift_of ? shift_of(contact.touched) : 0.0;
      const Crushing crushed = contact.shift == 0.0
                                   ? crushing(here, state, contact.region.overlap, contact.region.normal)
                                   : crushing_shifted(here, sheet, state, contact.shift, contact.region);
      fit(here, sheet, contact);
      load_contact(here, crushed, contact);
      contacts.push_back(std::move(contact));
    }
  }
  return contacts;
}

std::optional<EdgeContact> bearing_contact(const EdgeModel& mean, const geometry::IceSheet& sheet, std::int64_t floe,
                                           const floes::Bearing& bearing) {
  if (bearing.weight == 0.0) return std::nullopt;
  const LocalIce local(mean, plan(bearing.first / bearing.weight));
  const EdgeModel model = local.model();
  const double h = model.ice.thickness;
  // A cantilever of the width h and the length l_c does not break under less.
  const double harmless = model.ice.flexural_strength * h * h * h / (6.0 * failure::characteristic_length(model.ice));
  if (bearing.weight < harmless) return std::nullopt;
  const std::optional<Vec2> towards = push_of(model, sheet, bearing);
  if (!towards) return std::nullopt;
  const floes::LineLoad line = floes::line_load(bearing, *towards);

  EdgeContact contact;
  contact.floe = floe;
  contact.ice = local.ice();
  contact.on_ice = bearing.force;
  contact.point = line.middle;
  geometry::ContactRegion& region = contact.region;
  region.contact_length = std::max(line.length, h);
  region.midpoint = plan(line.middle);
  region.normal = line.towards;
  const Vec2 half = 0.5 * region.contact_length * perpendicular(line.towards);
  region.chord_from = region.midpoint - half;
  region.chord_to = region.midpoint + half;
  contact.touched = {region.midpoint, region.contact_length};
  const double in_plane = std::max(line.normal, kLeastInPlane * line.out_of_plane);
  if (!(in_plane > 0.0)) return std::nullopt;
  contact.load = {.contact_length = region.contact_length,
                  .mu1 = std::max(line.out_of_plane / in_plane, kLeastMu1),
                  .mu2 = line.across / in_plane,
                  .pressure = in_plane / (region.contact_length * h)};
  return contact;
}

void weigh_loads(const EdgeModel& model, std::vector<EdgeContact>& contacts) {
  const double l_c = failure::characteristic_length(model.ice);
  for (EdgeContact& contact : contacts) {
    contact.pressing = {};
    for (const EdgeContact& other : contacts) {
      const double off = norm(other.touched.tip - contact.touched.tip) / l_c;
      double& sum = other.floe == model::kNoFloe ? contact.pressing.by_structure : contact.pressing.by_floes;
      const double share = failure::share_at(off);
      sum += bending_force(model, other) * share;
      (other.on_ice.z > 0.0 ? contact.pressing.up : contact.pressing.down) += std::abs(other.on_ice.z) * share;
    }
  }
}

void assess(const EdgeModel& model, const geometry::IceSheet& sheet, std::vector<EdgeContact>& contacts,
            const MotionOf& motion_of, const ShareOut& share_out) {
  struct Question {
    std::size_t contact;
    LocalIce local;
    failure::LoadCase load;
    std::optional<Frame> frame;
  };
  const bool joint = model.resolved.failure.joint_loads;
  for (EdgeContact& contact : contacts)
    contact.has_verdict = contact.load.pressure > 0.0 && !(joint && is_outweighed(model, contacts, contact));
  std::vector<Question> questions;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (!contacts[i].has_verdict || contacts[i].kept == EdgeContact::Verdict::kKept) continue;
    Question asked{i, LocalIce(model, contacts[i]), {}, {}};
    const EdgeModel local = asked.local.model();
    if (contacts[i].floe != model::kNoFloe) fit(local, sheet, contacts[i]);
    asked.load = contacts[i].load;
    const geometry::ContactRegion& region = contacts[i].region;
    const Frame of_trapezoid{0.5 * (region.chord_from + region.chord_to), region.normal};
    if (local.criterion.needs_outline())
      asked.frame = place_loads(local, sheet, contacts, i, joint, asked.load).value_or(of_trapezoid);
    else if (presses_inside(sheet, contacts[i]))
      continue;
    questions.push_back(std::move(asked));
  }
  share_out(questions.size(), [&](std::size_t q) {
    auto& [i, local, load, frame] = questions[q];
    const failure::BendingCriterion& criterion = local.model().criterion;
    const auto harmless = criterion.dismiss(load);
    if (!harmless && motion_of) load.motion = motion_of(contacts[i]);
    failure::Assessment answer = harmless ? *harmless : criterion.assess(load);
    bound_disc(local.model().ice, answer);
    if (contacts[i].kept == EdgeContact::Verdict::kControl) {
      contacts[i].control = std::move(answer);
      return;
    }
    contacts[i].assessment = std::move(answer);
    if (frame) move_to(*frame, contacts[i]);
  });
}

void assess(const EdgeModel& model, const geometry::IceSheet& sheet, std::vector<EdgeContact>& contacts) {
  assess(model, sheet, contacts, {}, [](std::size_t n, const auto& judge) {
    for (std::size_t i = 0; i < n; ++i) judge(i);
  });
}

EdgeContact before_the_notch(EdgeContact contact) {
  geometry::ContactRegion& region = contact.region;
  const Vec2 tip = 0.5 * (region.chord_from + region.chord_to);
  const double depth = dot(region.midpoint - tip, region.normal);
  if (depth <= 0.5 * contact.assessment.breaking_length) return contact;
  const Vec2 forward = depth * region.normal;
  region.chord_from += forward;
  region.chord_to += forward;
  for (Vec2& point : contact.assessment.crack) point += forward;
  return contact;
}

}  // namespace brash::edge
