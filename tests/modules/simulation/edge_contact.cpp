// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/edge_contact.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"
#include "brash/edge/sheet_loads.hpp"
#include "brash/floes/bearing.hpp"
#include "brash/ice/field.hpp"
#include "brash/io/case.hpp"

namespace {

using namespace brash;

/// Keeps the load case that it is asked about.
class Listening final : public failure::BendingCriterion {
 public:
  explicit Listening(bool wants_outline, failure::Assessment answer = {})
      : wants_outline_(wants_outline), answer_(std::move(answer)) {}
  failure::Assessment assess(const failure::LoadCase& load) const override {
    heard = load;
    return answer_;
  }
  bool needs_outline() const override { return wants_outline_; }
  std::unique_ptr<BendingCriterion> for_ice(const failure::IceProperties&) const override {
    return std::make_unique<Listening>(wants_outline_, answer_);
  }
  mutable failure::LoadCase heard;

 private:
  bool wants_outline_;
  failure::Assessment answer_;
};

struct Scene {
  model::Case resolved = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml", {});
  std::unique_ptr<const structure::Hull> hull = structure::make_hull(resolved.structure.shape);
  failure::IceProperties ice = edge::ice_properties(resolved);
  brash::ice::Field field{resolved.field, ice};

  const geometry::IceSheet& sheet() const { return field.level_ice()[0].sheet(); }

  std::vector<edge::EdgeContact> assessed(const Listening& criterion, Vec2 centre = {-6.7, 0.0}) const {
    const structure::State state{{{centre.x, centre.y, 0.0}, {}}, {{1.202, 0.0, 0.0}, {}}};
    const edge::EdgeModel model{*hull, resolved, ice, criterion};
    auto contacts = edge::edge_contacts(model, sheet(), state);
    BOOST_REQUIRE(!contacts.empty());
    edge::assess(model, sheet(), contacts);
    return contacts;
  }

  /// Of the last contact.
  failure::LoadCase load(bool wants_outline, Vec2 centre = {-6.7, 0.0}) const {
    const Listening criterion(wants_outline);
    assessed(criterion, centre);
    return criterion.heard;
  }
};

BOOST_AUTO_TEST_CASE(projected_ice_that_stays_crushes_with_all_the_plan_under_the_structure) {
  Scene scene;
  const auto bound_at = [&](double x) { return scene.assessed(Listening(false), {x, 0.0}).front().bound; };
  scene.resolved.contact.area = model::ContactArea::kProjected;
  const double leaves = bound_at(-5.0);
  scene.resolved.failure.crushed_ice = model::CrushedIce::kStays;
  const double stays = bound_at(-5.0);
  // The cone's section is largest at the top of the ice. Its segment beyond the edge is covered.
  const double top = 6.8 + edge::freeboard(scene.resolved).top / std::tan(radians(61.4));
  const double half_angle = std::acos(5.0 / top);
  const double segment = top * top * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  // The normals spread over 2 x 42.6 degrees in plan, and their sum is sin(a) / a as long as if they did not.
  const double slope = radians(61.4), plan = std::sin(half_angle) / half_angle * std::sin(slope);
  BOOST_TEST(stays == 0.5e6 * segment * std::hypot(plan, std::cos(slope)), boost::test_tools::tolerance(0.02));
  // The ring between the sections at top and bottom is 0.18 m wide.
  BOOST_TEST(leaves < 0.4 * stays);
  const Listening criterion(false);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, criterion};
  BOOST_TEST(edge::middle_outlines(model, {{-5.0, 0.0, 0.0}, {}}).empty());
  BOOST_TEST(edge::trailing_outlines(model, {{-5.0, 0.0, 0.0}, {}}).empty());
}

BOOST_AUTO_TEST_CASE(the_pressure_on_the_edge_is_of_the_contact_or_of_the_edge) {
  Scene scene;
  for (const double x : {-6.7, -6.2}) {
    scene.resolved.failure.pressure = model::EdgePressure::kContact;
    BOOST_TEST(scene.load(false, {x, 0.0}).pressure == 0.5e6, boost::test_tools::tolerance(1e-12));
    scene.resolved.failure.pressure = model::EdgePressure::kEdge;
    const Listening criterion(false);
    const edge::EdgeContact contact = scene.assessed(criterion, {x, 0.0}).back();
    const double in_plane = dot(plan(contact.on_ice), contact.region.normal);
    BOOST_TEST(criterion.heard.pressure == in_plane / (contact.region.contact_length * 0.33),
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(only_a_criterion_that_asks_gets_the_outline) {
  Scene scene;
  BOOST_TEST(scene.load(false).outline.empty());
  BOOST_TEST(!scene.load(true).outline.empty());
}

/// A wall of 10 m meets ice of 0.6 m characteristic length.
BOOST_AUTO_TEST_CASE(the_edge_along_a_wide_wall_is_known_past_its_ends) {
  const model::Case resolved = io::read_case(BRASH_SOURCE_DIR "/experiments/predictions/m5/wall.toml", {});
  const auto hull = structure::make_hull(resolved.structure.shape);
  const failure::IceProperties ice = edge::ice_properties(resolved);
  const brash::ice::Field field{resolved.field, ice};
  const geometry::IceSheet& sheet = field.level_ice()[0].sheet();
  const Listening criterion(true);
  const edge::EdgeModel model{*hull, resolved, ice, criterion};
  const auto contacts = edge::edge_contacts(model, sheet, {{{-1.49, 0.0, 0.0}, {}}, {{0.05, 0.0, 0.0}, {}}});
  BOOST_REQUIRE_EQUAL(contacts.size(), 1u);
  BOOST_TEST(contacts[0].region.contact_length == 10.0, boost::test_tools::tolerance(0.01));
  failure::LoadCase load = contacts[0].load;
  BOOST_REQUIRE(edge::place_loads(model, sheet, contacts, 0, true, load).has_value());
  const auto [least, most] = std::ranges::minmax(load.outline, {}, &Vec2::y);
  BOOST_TEST(least.y < -5.5);
  BOOST_TEST(most.y > 5.5);
}

BOOST_AUTO_TEST_CASE(a_disc_is_no_smaller_than_the_ice_is_thick) {
  const Scene scene;
  const double h = scene.ice.thickness;
  const auto length = [&](const failure::Assessment& answer) {
    return scene.assessed(Listening(false, answer)).front().assessment.breaking_length;
  };
  BOOST_TEST(length({.fails = true, .breaking_length = -0.01}) == h);
  BOOST_TEST(length({.fails = true, .breaking_length = 0.5 * h}) == h);
  BOOST_TEST(length({.fails = true, .breaking_length = 3.0 * h}) == 3.0 * h);
  BOOST_TEST(length({.breaking_length = 0.5 * h}) == 0.5 * h);  // the ice holds
}

BOOST_AUTO_TEST_CASE(the_outline_of_a_straight_edge_is_the_edge_with_the_chord_in_it) {
  Scene scene;
  const failure::LoadCase load = scene.load(true);
  const double half = 0.5 * load.contact_length;
  const auto& outline = load.outline;
  BOOST_REQUIRE(outline.size() == 4u);
  BOOST_TEST(outline[1].y == -half);
  BOOST_TEST(outline[2].y == half);
  const double reach = 5.0 * failure::characteristic_length(scene.ice);
  BOOST_TEST(outline.front().y == -reach, boost::test_tools::tolerance(1e-3));  // the circle may be a polygon
  BOOST_TEST(outline.back().y == reach, boost::test_tools::tolerance(1e-3));
  for (const Vec2 point : outline) BOOST_TEST(std::abs(point.x) < 1e-6);  // the grid
}

BOOST_AUTO_TEST_CASE(the_outline_passes_the_contact_once_with_the_ice_on_its_right) {
  Scene scene;
  ice::Plate& level_ice = scene.field.level_ice(0);
  const ice::CrackPlan circle{geometry::circumferential(level_ice.sheet(), {}, 3.0, 4), {}, 3.0, 4};
  (void)scene.field.break_off(level_ice, circle, {}, 0.01);
  const failure::LoadCase load = scene.load(true, {-3.9, 0.4});
  const auto& outline = load.outline;
  BOOST_REQUIRE(outline.size() > 4u);
  for (const Vec2 point : outline) {
    BOOST_TEST(point.y >= outline.front().y);
    BOOST_TEST(point.y <= outline.back().y);
  }
  const auto plate = failure::make_criterion(model::FailureModel::kPlateOutline, "", scene.ice);
  failure::LoadCase heavy = load;
  heavy.pressure = 1e6;  // enough for the plate to be solved
  BOOST_TEST(!plate->assess(heavy).outline_refused);
}

/// A floe that presses evenly on 2 m of the straight edge around y = 1, over a thousand points.
floes::Bearing even_bearing(double normal, double downward) {
  constexpr int kPoints = 1000;
  floes::Bearing bearing;
  for (int i = 0; i < kPoints; ++i) {
    rigid_body::ContactLoad contact;
    contact.point = {0.0, 2.0 * (i + 0.5) / kPoints, 0.0};
    contact.normal = {-1.0, 0.0, 0.0};
    contact.normal_force = normal / kPoints;
    contact.friction_force = {0.0, 0.0, downward / kPoints};
    floes::add_contact(bearing, contact);
  }
  return bearing;
}

BOOST_AUTO_TEST_CASE(an_even_bearing_is_the_line_load_that_it_is) {
  const floes::LineLoad load = floes::line_load(even_bearing(8e4, 3e4), {1.0, 0.0});
  BOOST_TEST(load.length == 2.0, boost::test_tools::tolerance(1e-6));  // of the sum in place of the integral
  BOOST_TEST(load.middle.y == 1.0, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(load.towards.x == 1.0);
  BOOST_TEST(load.normal == 8e4, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(load.out_of_plane == 3e4, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_edge_under_a_floe_breaks_by_the_same_criterion_as_under_the_structure) {
  Scene scene;
  const auto criterion = failure::make_criterion(model::FailureModel::kSuperposition, "", scene.ice);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, *criterion};
  const auto fails = [&](double normal, double downward) {
    std::vector contacts{edge::bearing_contact(model, scene.sheet(), 7, even_bearing(normal, downward)).value()};
    edge::assess(model, scene.sheet(), contacts);
    return contacts[0].assessment.fails;
  };
  // A straight edge of this ice breaks at 85 kN out of the plane, with 160 kN in it
  // (docs/theory/fracture-of-the-edge.md).
  BOOST_TEST(!fails(1.2e5, 6e4));
  BOOST_TEST(fails(2e5, 1.1e5));
  BOOST_TEST(!fails(2e5, 0.0));

  const auto contact = edge::bearing_contact(model, scene.sheet(), 7, even_bearing(8e4, 3e4)).value();
  BOOST_TEST(contact.floe == 7);
  BOOST_TEST(contact.load.mu1 == 0.375, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(contact.load.pressure == 8e4 / (2.0 * 0.33), boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_floe_that_hardly_presses_is_not_looked_at) {
  Scene scene;
  const Listening criterion(false);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, criterion};
  BOOST_TEST(!edge::bearing_contact(model, scene.sheet(), 0, even_bearing(500.0, 0.0)).has_value());
  BOOST_TEST(!edge::bearing_contact(model, scene.sheet(), 0, {}).has_value());
}

BOOST_AUTO_TEST_CASE(a_mean_bearing_approaches_what_stays) {
  floes::Bearing mean;
  const floes::Bearing now = even_bearing(8e4, 3e4);
  for (int i = 0; i < 3; ++i) floes::approach(mean, now, 0.5);
  BOOST_TEST(mean.weight == 0.875 * now.weight, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(floes::line_load(mean, {1.0, 0.0}).length == 2.0, boost::test_tools::tolerance(1e-6));
}

/// A floe of 1 m by 1 m that lies flat under the sheet, `depth` from its edge, and pushes it up by `force`.
floes::Bearing flat_bearing(double depth, double force) {
  floes::Bearing bearing;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      rigid_body::ContactLoad contact;
      contact.point = {depth + x, y, -0.29};
      contact.normal = {0.0, 0.0, -1.0};
      contact.normal_force = 0.25 * force;
      floes::add_contact(bearing, contact);
    }
  return bearing;
}

BOOST_AUTO_TEST_CASE(a_floe_flat_under_the_sheet_loads_it_where_it_lies) {
  Scene scene;
  const auto criterion = failure::make_criterion(model::FailureModel::kPlateOutline, "", scene.ice);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, *criterion};
  const auto load_of = [&](double depth) {
    const std::vector contacts{edge::bearing_contact(model, scene.sheet(), 7, flat_bearing(depth, 9e4)).value()};
    failure::LoadCase load = contacts[0].load;
    BOOST_TEST(edge::place_loads(model, scene.sheet(), contacts, 0, true, load).has_value());
    return load;
  };
  const failure::LoadCase inside = load_of(2.0);
  BOOST_REQUIRE_EQUAL(inside.loads.size(), 1u);
  BOOST_TEST(inside.loads[0].radius > 0.4);
  BOOST_TEST(inside.loads[0].from.x == 2.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(inside.loads[0].out_of_plane == 9e4, boost::test_tools::tolerance(1e-9));
  // A thrust past the disc is not judged: the line of the judgement still passes under it.
  floes::Bearing askew = flat_bearing(2.0, 9e4);
  askew.thrust = {0.2 * askew.weight, 0.2 * askew.weight};
  std::vector contacts{edge::bearing_contact(model, scene.sheet(), 7, askew).value()};
  failure::LoadCase load = contacts[0].load;
  const auto frame = edge::place_loads(model, scene.sheet(), contacts, 0, true, load);
  BOOST_REQUIRE(frame.has_value());
  BOOST_TEST(std::abs(frame->x.y) < 1e-9);
  BOOST_TEST(std::abs(load.loads[0].from.y) < 1e-9);
  BOOST_TEST(criterion->assess(load).sigma_max == criterion->assess(inside).sigma_max,
             boost::test_tools::tolerance(1e-3));
  // The farther inside it pushes, the less it bends the edge, and the farther off the ice breaks.
  const failure::Assessment near = criterion->assess(load_of(1.0)), far = criterion->assess(load_of(3.0));
  BOOST_TEST(near.sigma_max > 0.0);
  BOOST_TEST(far.breaking_length > near.breaking_length);
}

BOOST_AUTO_TEST_CASE(a_model_of_the_trapezoid_leaves_a_floe_under_the_sheet_out) {
  Scene scene;
  const auto criterion = failure::make_criterion(model::FailureModel::kSuperposition, "", scene.ice);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, *criterion};
  const auto stress = [&](double depth) {
    std::vector contacts{edge::bearing_contact(model, scene.sheet(), 7, flat_bearing(depth, 9e4)).value()};
    edge::assess(model, scene.sheet(), contacts);
    return contacts[0].assessment.sigma_max;
  };
  BOOST_TEST(stress(0.5) > 0.0);
  BOOST_TEST(stress(4.0) == 0.0);
}

BOOST_AUTO_TEST_CASE(a_weak_load_that_is_judged_stays_beside_strong_ones) {
  const Scene scene;
  const Listening criterion(true);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, criterion};
  const structure::State state{{{-6.7, 0.0, 0.0}, {}}, {{1.202, 0.0, 0.0}, {}}};
  auto contacts = edge::edge_contacts(model, scene.sheet(), state);
  BOOST_REQUIRE_EQUAL(contacts.size(), 1u);
  contacts.push_back(contacts[0]);
  for (Vec2* point : {&contacts[1].region.chord_from, &contacts[1].region.chord_to, &contacts[1].region.midpoint})
    point->y += 1.3 * failure::characteristic_length(scene.ice);
  contacts[1].on_ice = 200.0 * contacts[1].on_ice;
  failure::LoadCase load = contacts[0].load;
  BOOST_REQUIRE(edge::place_loads(model, scene.sheet(), contacts, 0, true, load).has_value());
  BOOST_REQUIRE_EQUAL(load.loads.size(), 2u);
  BOOST_TEST(load.loads[0].out_of_plane == -contacts[0].on_ice.z, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(the_moment_of_a_force_is_about_the_middle_of_an_edge_that_has_given_way) {
  const Scene scene;
  const Listening criterion(true);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, criterion};
  // Cone and edge lie lower by the same way, so they touch alike.
  const auto moment = [&](double lower) {
    const structure::State state{{{-6.7, 0.0, -lower}, {}}, {{1.202, 0.0, 0.0}, {}}};
    const auto contacts = edge::edge_contacts(model, scene.sheet(), state, [&](const edge::Touch&) { return -lower; });
    BOOST_REQUIRE_EQUAL(contacts.size(), 1u);
    failure::LoadCase load = contacts[0].load;
    BOOST_REQUIRE(edge::place_loads(model, scene.sheet(), contacts, 0, true, load).has_value());
    return load.loads.front().moment;
  };
  BOOST_TEST(moment(0.0) < 0.0);
  for (const double lower : {0.05, 0.1, 0.3})
    BOOST_TEST(moment(lower) == moment(0.0), boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_force_above_mid_thickness_has_a_moment_that_lifts_the_edge) {
  Scene scene;
  const Listening criterion(true);
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, criterion};
  const structure::State state{{{-6.7, 0.0, 0.0}, {}}, {{1.202, 0.0, 0.0}, {}}};
  const auto contacts = edge::edge_contacts(model, scene.sheet(), state);
  BOOST_REQUIRE_EQUAL(contacts.size(), 1u);
  failure::LoadCase load = contacts[0].load;
  BOOST_REQUIRE(edge::place_loads(model, scene.sheet(), contacts, 0, true, load).has_value());
  BOOST_REQUIRE_EQUAL(load.loads.size(), 1u);
  // The cone crushes the upper part of the ice; its force acts there.
  const double top = scene.ice.thickness * (1.0 - 900.0 / 1025.0), middle = top - 0.5 * scene.ice.thickness;
  BOOST_TEST(contacts[0].point.z > middle);
  BOOST_TEST(contacts[0].point.z < top);
  const failure::SheetLoad& one = load.loads[0];
  BOOST_TEST(one.out_of_plane == -contacts[0].on_ice.z, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(one.moment == -(contacts[0].point.z - middle) * one.in_plane.x, boost::test_tools::tolerance(1e-9));
}

/// A scene whose sheet has a round bay, and floes that press on it.
struct Bay : Scene {
  Bay(Vec2 centre, double radius) {
    brash::ice::Plate& level_ice = field.level_ice(0);
    const brash::ice::CrackPlan plan{geometry::circumferential(level_ice.sheet(), centre, radius, 3, 64), centre,
                                     radius};
    (void)field.break_off(level_ice, plan, {}, 0.01);
  }

  /// A floe that pushes up at a place with 90 kN.
  edge::EdgeContact floe(Vec2 at) const {
    floes::Bearing bearing;
    for (const Vec2 corner : {Vec2{-0.1, -0.1}, Vec2{0.1, -0.1}, Vec2{0.1, 0.1}, Vec2{-0.1, 0.1}}) {
      rigid_body::ContactLoad contact;
      contact.point = {at.x + corner.x, at.y + corner.y, -0.29};
      contact.normal = {0.0, 0.0, -1.0};
      contact.normal_force = 0.25 * 9e4;
      floes::add_contact(bearing, contact);
    }
    return edge::bearing_contact(model, sheet(), 7, bearing).value();
  }

  /// The loads around the first of `floes`.
  failure::LoadCase load_around(const std::vector<edge::EdgeContact>& floes) const {
    failure::LoadCase load = floes[0].load;
    BOOST_REQUIRE(edge::place_loads(model, sheet(), floes, 0, true, load).has_value());
    return load;
  }

  std::unique_ptr<failure::BendingCriterion> criterion =
      failure::make_criterion(model::FailureModel::kPlateOutline, "", ice);
  edge::EdgeModel model{*hull, resolved, ice, *criterion};
};

BOOST_AUTO_TEST_CASE(a_floe_before_a_sharp_corner_of_the_ice_presses_on_its_edge) {
  const Bay bay({2.0, 0.0}, 3.0);  // meets the edge x = 0 at y = 2.236 under 48 degrees
  const failure::LoadCase load = bay.load_around({bay.floe({0.1, 3.5}), bay.floe({-0.4, 2.036})});
  BOOST_REQUIRE_EQUAL(load.loads.size(), 2u);
  BOOST_TEST(load.loads[1].radius == 0.0);
  BOOST_TEST(!bay.criterion->assess(load).outline_refused);
}

BOOST_AUTO_TEST_CASE(a_floe_on_an_edge_that_the_outline_leaves_out_is_left_out) {
  const Bay bay({2.9, 0.0}, 3.0);  // seen from its side, the outline ends at its bottom and at its mouth
  const auto near = bay.floe({2.9, 3.0}), opposite = bay.floe({2.9, -3.0});
  BOOST_TEST(bay.load_around({near}).loads.size() == 1u);
  BOOST_TEST(bay.load_around({near, opposite}).loads.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_load_on_the_lip_of_a_narrow_mouth_runs_along_the_edge) {
  const Bay bay({2.9, 0.0}, 3.0);  // its mouth is 1.5 m wide
  for (const double side : {-1.0, 1.0}) {
    auto on_lip = bay.floe({0.1, 1.0 * side});
    on_lip.region.contact_length = 2.6;
    const failure::LoadCase load = bay.load_around({bay.floe({0.1, 4.0}), on_lip});
    BOOST_REQUIRE_EQUAL(load.loads.size(), 2u);
    BOOST_TEST(load.loads[1].radius == 0.0);
    BOOST_TEST(!bay.criterion->assess(load).outline_refused);
  }
}

/// A floe that pushes the ice, mostly along the unit vector `push`, over 0.8 m of its edge.
floes::Bearing pushing_bearing(Vec2 at, Vec2 push, double force) {
  floes::Bearing bearing;
  for (const double side : {-0.3, -0.1, 0.1, 0.3}) {
    rigid_body::ContactLoad contact;
    const Vec2 place = at + side * perpendicular(push);
    contact.point = {place.x, place.y, -0.29};
    contact.normal = normalized(Vec3{-push.x, -push.y, -0.3});
    contact.normal_force = 0.25 * force;
    floes::add_contact(bearing, contact);
  }
  return bearing;
}

/// A channel whose ends lie farther than 5 l_c from its middle, with a floe on either side there.
struct Channel : Scene {
  static constexpr double kHalf = 5.0, kAt = 18.0;

  Channel() {
    const std::vector<Vec2> corners{{-1.0, -kHalf}, {40.0, -kHalf}, {40.0, kHalf}, {-1.0, kHalf}};
    const geometry::Ring ring = geometry::ring(corners);
    field.crush(field.level_ice(0), ring);
    for (const double side : {-1.0, 1.0})
      floes.push_back(
          edge::bearing_contact(model, sheet(), 7, pushing_bearing({kAt, side * kHalf}, {0.0, side}, 9e4)).value());
  }

  Listening criterion{true};
  edge::EdgeModel model{*hull, resolved, ice, criterion};
  std::vector<edge::EdgeContact> floes;
};

BOOST_AUTO_TEST_CASE(a_load_acts_on_the_edge_that_it_presses_and_not_on_the_other_side_of_a_channel) {
  const Channel channel;
  for (const std::size_t own : {0u, 1u}) {
    failure::LoadCase load = channel.floes[own].load;
    BOOST_REQUIRE(edge::place_loads(channel.model, channel.sheet(), channel.floes, own, true, load).has_value());
    BOOST_REQUIRE_EQUAL(load.loads.size(), 1u);
    BOOST_TEST(load.loads[0].in_plane.x > 8e4);
  }
}

BOOST_AUTO_TEST_CASE(weak_floes_with_long_stretches_on_a_cusped_edge_leave_the_stress_of_a_strong_one) {
  Scene scene;
  ice::Plate& level_ice = scene.field.level_ice(0);
  for (const double y : {-9.0, -4.5, 0.0, 4.5, 9.0}) {  // five bays with cusps between them
    const Vec2 centre{-1.0, y};
    const ice::CrackPlan bay{geometry::circumferential(level_ice.sheet(), centre, 2.5, 3), centre, 2.5};
    (void)scene.field.break_off(level_ice, bay, {}, 0.01);
  }
  const auto criterion =
      failure::make_criterion(model::FailureModel::kPlateOutline, "", scene.ice,
                              {.second_order = true, .radial_first = true, .anywhere = true, .trace_crack = true});
  scene.resolved.failure.joint_loads = true;
  const edge::EdgeModel model{*scene.hull, scene.resolved, scene.ice, *criterion};
  const auto floe = [&](Vec2 at, double reach, double force) {
    floes::Bearing bearing;
    for (const double side : {-1.0, 1.0}) {
      rigid_body::ContactLoad contact;
      contact.point = {at.x, at.y + side * reach, -0.29};
      contact.normal = normalized(Vec3{-1.0, 0.0, -0.5});
      contact.normal_force = 0.5 * force;
      floes::add_contact(bearing, contact);
    }
    return edge::bearing_contact(model, scene.sheet(), 7, bearing).value();
  };
  const auto largest = [&](std::vector<edge::EdgeContact> contacts) {
    edge::assess(model, scene.sheet(), contacts);
    double most = 0.0;
    for (const edge::EdgeContact& contact : contacts) {
      BOOST_TEST(!contact.assessment.outline_refused);
      most = std::max(most, contact.assessment.sigma_max);
    }
    return most;
  };
  constexpr double kStrong = 6e4;
  const edge::EdgeContact strong = floe({1.5, 0.0}, 0.5, kStrong);
  std::vector<edge::EdgeContact> all{strong};
  for (const double y : {-5.0, -2.5, 2.5, 5.0}) all.push_back(floe({0.5, y}, 2.3, 0.03 * kStrong));  // 8 m
  BOOST_TEST(all[1].region.contact_length > 7.9);
  BOOST_TEST(largest(all) == largest({strong}), boost::test_tools::tolerance(0.05));
}

BOOST_AUTO_TEST_CASE(no_load_points_out_of_the_ice) {
  const Channel channel;
  // A floe on the far side of a slot that is narrower than the floe's contact is long.
  edge::EdgeContact near = channel.floes[1], far = channel.floes[1];
  far.region.normal = {0.0, -1.0};
  failure::LoadCase load = near.load;
  BOOST_REQUIRE(edge::place_loads(channel.model, channel.sheet(), {near, far}, 0, true, load).has_value());
  BOOST_TEST(load.loads.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_crack_inside_the_notch_that_was_cut_moves_to_the_ice_ahead) {
  edge::EdgeContact contact;
  contact.region.chord_from = {2.0, -6.0};
  contact.region.chord_to = {2.0, 6.0};
  contact.region.normal = {1.0, 0.0};
  contact.region.midpoint = {6.0, 0.0};
  contact.assessment.breaking_length = 3.0;
  contact.assessment.crack = {{2.0, -4.0}, {5.0, 0.0}, {2.0, 4.0}};
  const edge::EdgeContact moved = edge::before_the_notch(contact);
  BOOST_TEST((moved.region.chord_from == Vec2{6.0, -6.0}));
  BOOST_TEST((moved.region.chord_to == Vec2{6.0, 6.0}));
  BOOST_TEST((moved.assessment.crack[1] == Vec2{9.0, 0.0}));
  // A shallow notch, and an edge that stands out into the structure, stay.
  for (const double x : {3.4, 1.0}) {
    contact.region.midpoint = {x, 0.0};
    BOOST_TEST((edge::before_the_notch(contact).region.chord_from == contact.region.chord_from));
  }
}

}  // namespace
