// SPDX-License-Identifier: GPL-3.0-or-later
// Structures of several legs: docs/theory/structures.md, (K8).
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/structure/floating_body.hpp"
#include "brash/structure/regions.hpp"
#include "meshes.hpp"

namespace {

using namespace brash;
using namespace brash::structure;

const model::Cone kCone{
    .angle = radians(60.0), .waterline_width = 6.0, .height = 6.0, .height_under_water = 4.0, .facets = 32};
/// 4 m wide and 4 m long, with its slope ahead.
const model::Plane kPlane{
    .angle = radians(60.0), .waterline_width = 4.0, .length = 6.0, .height = 4.0, .height_under_water = 2.0};
const std::vector<Vec2> kPlaces{{8.0, 10.0}, {8.0, -10.0}, {-8.0, 10.0}, {-8.0, -10.0}};
const auto kExact = boost::test_tools::tolerance(1e-12);

std::unique_ptr<const Hull> with_legs(const model::Shape& shape, const std::vector<Vec2>& places) {
  return make_hull(model::StructureSection{.shape = shape, .legs = places, .motion = {}});
}

/// A turn about y that lifts the bow.
Pose pitched(double angle) { return {{}, {std::cos(0.5 * angle), 0.0, -std::sin(0.5 * angle), 0.0}}; }

BOOST_AUTO_TEST_SUITE(legs)

BOOST_AUTO_TEST_CASE(one_leg_at_the_origin_is_the_shape_itself) {
  const auto one = with_legs(kCone, {{0.0, 0.0}}), alone = make_hull(kCone);
  const Pose pose{{3.0, -1.0, 0.1}, {std::cos(0.2), 0.0, 0.0, std::sin(0.2)}};
  BOOST_TEST((one->footprint(pose, -0.3, 0.05).leading == alone->footprint(pose, -0.3, 0.05).leading));
  BOOST_TEST((one->footprint(pose, -0.3, 0.05).trailing == alone->footprint(pose, -0.3, 0.05).trailing));
  BOOST_TEST(one->sides(pose, -0.3, 0.05, {}).size() == alone->sides(pose, -0.3, 0.05, {}).size());
  BOOST_TEST((one->surface_at(pose, {6.0, 2.0, 0.0}).normal == alone->surface_at(pose, {6.0, 2.0, 0.0}).normal));
  BOOST_TEST(one->displaced(pose).volume == alone->displaced(pose).volume, kExact);
  BOOST_TEST(one->displaced(pose).waterplane.radius == alone->displaced(pose).waterplane.radius, kExact);
  BOOST_TEST((one->mesh().vertices == alone->mesh().vertices));
}

BOOST_AUTO_TEST_CASE(each_leg_is_a_copy_at_its_place_and_turns_with_the_structure) {
  const auto four = with_legs(kCone, kPlaces), leg = make_hull(kCone);
  const double turn = radians(30.0);
  const Pose pose{{100.0, 50.0, 0.0}, {std::cos(0.5 * turn), 0.0, 0.0, std::sin(0.5 * turn)}};
  const Footprint plans = four->footprint(pose, -0.3, 0.05);
  BOOST_REQUIRE(plans.leading.size() == 4u);
  BOOST_REQUIRE(plans.trailing.size() == 4u);
  // A leg 8 m ahead and 10 m to port.
  const Vec2 place{100.0 + 8.0 * std::cos(turn) - 10.0 * std::sin(turn),
                   50.0 + 8.0 * std::sin(turn) + 10.0 * std::cos(turn)};
  const Pose there{{place.x, place.y, 0.0}, pose.rotation};
  const Outline alone = leg->footprint(there, -0.3, 0.05).leading.front();
  for (std::size_t i = 0; i < alone.size(); ++i) BOOST_TEST(norm(plans.leading.front()[i] - alone[i]) < 1e-12);
  const Vec3 beside{place.x + 3.0, place.y + 1.0, 0.0};
  BOOST_TEST(norm(four->surface_at(pose, beside).normal - leg->surface_at(there, beside).normal) < 1e-12);
  BOOST_TEST(four->parts().size() == 4u);
  BOOST_TEST(four->sides(pose, -0.3, 0.05, {}).size() == 4u * leg->sides(pose, -0.3, 0.05, {}).size());

  const Displacement wet = four->displaced(pose), of_leg = leg->displaced({});
  BOOST_TEST(wet.volume == 4.0 * of_leg.volume, kExact);
  BOOST_TEST(wet.centre.x == 100.0, kExact);
  BOOST_TEST(wet.centre.z == of_leg.centre.z, kExact);
  BOOST_TEST(wet.waterplane.area == 4.0 * of_leg.waterplane.area, kExact);
  BOOST_TEST(displaced_by_mesh(*four, {}).volume == 4.0 * displaced_by_mesh(*leg, {}).volume, kExact);
  const auto [least, most] = four->bounds();
  BOOST_TEST(most.x - least.x == 16.0 + leg->bounds().second.x - leg->bounds().first.x, kExact);
}

BOOST_AUTO_TEST_CASE(heeled_legs_whose_plans_cover_each_other_have_one_outline) {
  // Two columns 12 m high, 5 m apart: pitched by 40 degrees, each passes over 9 m of the plan between their ends.
  const model::Plane column{
      .angle = 0.5 * kPi, .waterline_width = 4.0, .length = 4.0, .height = 12.0, .height_under_water = 6.0};
  const auto two = with_legs(column, {{-2.5, 0.0}, {2.5, 0.0}});
  BOOST_TEST(two->footprint({}, -5.0, 5.0).leading.size() == 2u);
  BOOST_TEST(two->footprint(pitched(radians(40.0)), -4.0, 4.0).leading.size() == 1u);
}

BOOST_AUTO_TEST_CASE(what_is_ahead_of_two_legs_abreast_is_one_of_them) {
  const auto two = with_legs(kPlane, {{0.0, 6.0}, {0.0, -6.0}});
  const Foremost ahead = foremost(*two, {}, 0.0, 0.0, {1.0, 0.0});
  BOOST_TEST(ahead.reach == 3.0, kExact);
  BOOST_TEST(ahead.surface.slope == radians(60.0), kExact);
  BOOST_TEST(std::abs(ahead.surface.normal.y) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_place_belongs_to_the_leg_whose_box_is_nearest) {
  const model::StructureSection structure{
      .shape = kPlane, .legs = {{0.0, 6.0}, {0.0, -6.0}, {-20.0, 1.0}}, .motion = {}};
  const auto regions = regions_of(structure, *make_hull(structure));
  BOOST_REQUIRE(regions);
  const auto leg_at = [&](Vec3 point) { return regions->at(point, {1.0, 0.0, 0.0}) - model::kHullRegions + 1; };
  BOOST_TEST(leg_at({3.0, 7.0, 0.0}) == 1u);
  BOOST_TEST(leg_at({0.0, 3.9, -1.0}) == 1u);
  BOOST_TEST(leg_at({2.0, -0.5, 0.0}) == 2u);
  // Nearer to the middle of the first leg, yet on the side of the third.
  BOOST_TEST(leg_at({-12.0, 3.0, 0.0}) == 3u);
  // A cone alone has no regions, a cone with a leg has.
  BOOST_TEST(!regions_of({.shape = kCone, .motion = {}}, *make_hull(kCone)));
}

BOOST_AUTO_TEST_CASE(legs_afloat_add_up_and_turn_about_their_middle) {
  const Inertia one = inertia_of({}, *make_hull(kCone), 1025.0);
  const Inertia four = inertia_of({}, *with_legs(kCone, kPlaces), 1025.0);
  BOOST_TEST(four.mass == 4.0 * one.mass, kExact);
  BOOST_TEST(four.added_mass.x == 4.0 * one.added_mass.x, kExact);
  BOOST_TEST(four.added_mass.z == 4.0 * one.added_mass.z, kExact);
  // Parallel axes: 10 m from the x axis, 8 m from the y axis.
  BOOST_TEST(four.moments.x == 4.0 * (one.moments.x + one.mass * 100.0), kExact);
  BOOST_TEST(four.moments.z == 4.0 * (one.moments.z + one.mass * 164.0), kExact);
  BOOST_TEST(four.added_inertia.x == 4.0 * (one.added_inertia.x + one.added_mass.z * 100.0), kExact);
  BOOST_TEST(four.added_inertia.y == 4.0 * (one.added_inertia.y + one.added_mass.z * 64.0), kExact);
  BOOST_TEST(four.added_inertia.z == 4.0 * (one.added_inertia.z + one.added_mass.x * 100.0 + one.added_mass.y * 64.0),
             kExact);
}

BOOST_AUTO_TEST_CASE(columns_of_one_mesh_have_the_inertia_of_as_many_legs) {
  const model::Plane column{
      .angle = 0.5 * kPi, .waterline_width = 6.0, .length = 4.0, .height = 12.0, .height_under_water = 8.0};
  const auto legs = with_legs(column, kPlaces);
  TriangleMesh mesh;
  const auto [least, most] = make_hull(column)->bounds();
  for (const Vec2 place : kPlaces) {
    const Vec3 to{place.x, place.y, 0.0};
    mesh = mesh.vertices.empty() ? test::box(least + to, most + to)
                                 : test::joined(std::move(mesh), test::box(least + to, most + to));
  }
  const MeshHull columns = test::hull(mesh);
  const Inertia of_legs = inertia_of({}, *legs, 1025.0), of_columns = inertia_of({}, columns, 1025.0);
  const auto close = [](Vec3 a, Vec3 b) { return norm(a - b) < 1e-9 * norm(b); };
  BOOST_TEST(of_columns.mass == of_legs.mass, kExact);
  BOOST_TEST(close(of_columns.moments, of_legs.moments));
  BOOST_TEST(close(of_columns.added_mass, of_legs.added_mass));
  BOOST_TEST(close(of_columns.added_inertia, of_legs.added_inertia));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
