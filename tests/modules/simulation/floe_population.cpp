// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/floe_population.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

const std::vector<Vec2> kSquare{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

BOOST_AUTO_TEST_SUITE(floe_population)

BOOST_AUTO_TEST_CASE(a_floe_is_as_thick_and_heavy_as_the_plate_that_it_is) {
  Pool pool;
  failure::IceProperties thick = edge::ice_properties(pool.resolved);
  thick.thickness = 0.5;
  const auto record =
      pool.floes.add(pool.world, ice::Plate(0, ice::Hold::kAfloat, thick, {{geometry::ring(kSquare), {}}}), 1.5);
  BOOST_REQUIRE(record.has_value());
  BOOST_TEST(record->birth == 1.5);
  const floes::Floe& floe = pool.floes.floes().begin()->second;
  BOOST_TEST(floe.prism.thickness == 0.5);
  BOOST_TEST(floe.weight == 900.0 * 0.5 * kGravity, boost::test_tools::tolerance(1e-12));
  BOOST_TEST(record->birth_pose.position.z == 0.5 * (0.5 - 900.0 / 1025.0), boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_plate_too_thin_for_a_body_is_left_as_it_is) {
  Pool pool;
  const std::vector<Vec2> sliver{{0, 0}, {1, 0}, {1, 0.001}, {0, 0.001}};
  ice::Plate plate = afloat(pool.resolved, sliver);
  const geometry::ExactArea area = plate.area();
  BOOST_TEST(!pool.floes.add(pool.world, std::move(plate), 0.0).has_value());
  BOOST_TEST((plate.area() == area));
  BOOST_TEST(pool.floes.next_id() == 0);
  BOOST_TEST(pool.floes.floes().empty());
  failure::IceProperties thin = edge::ice_properties(pool.resolved);
  for (const double thickness : {0.5, 1.0, 2.0}) {
    thin.thickness = thickness * pool.resolved.contact.margin;
    ice::Plate film(0, ice::Hold::kAfloat, thin, {{geometry::ring(kSquare), {}}});
    BOOST_TEST(!pool.floes.add(pool.world, std::move(film), 0.0).has_value());
  }
}

BOOST_AUTO_TEST_CASE(the_sums_follow_births_and_deaths) {
  Pool pool;
  const BodyId first = pool.add({0, 0}, {1, 1}, {});
  const BodyId second = pool.add({5, 0}, {7, 1}, {});
  BOOST_TEST(pool.floes.area().square_metres() == 3.0);
  BOOST_TEST(pool.floes.contains(first));
  BOOST_TEST((pool.floes.bodies_by_id() == std::map<std::int64_t, BodyId>{{0, first}, {1, second}}));
  const double weight = pool.floes.at(second).weight;
  pool.remove(first);
  BOOST_TEST(!pool.floes.contains(first));
  BOOST_TEST(pool.floes.area().square_metres() == 2.0);
  BOOST_TEST(pool.floes.weight() == weight);
  BOOST_TEST(pool.floes.next_id() == 2);
}

struct Motion {
  double mass = 0.0;
  Vec3 momentum{};
  Vec3 angular_momentum{};  ///< about the origin
  double kinetic = 0.0;
  double potential = 0.0;
};

Motion motion_of(const Pool& pool) {
  Motion sum{.potential = pool.floes.potential_energy(pool.world)};
  for (const auto& [body, floe] : pool.floes.floes()) {
    const double mass = floe.inertia.mass;
    const Vec3 inertia = floe.inertia.inertia;
    const Pose pose = pool.world.pose(body);
    const Twist twist = pool.world.twist(body);
    const Vec3 spin = rotate(conjugate(pose.rotation), twist.angular);
    sum.mass += mass;
    sum.momentum += mass * twist.linear;
    sum.angular_momentum += cross(pose.position, mass * twist.linear) +
                            rotate(pose.rotation, {inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z});
    sum.kinetic += pool.world.kinetic_energy(body);
  }
  return sum;
}

BOOST_AUTO_TEST_CASE(pieces_of_a_floe_move_on_as_it_did) {
  Pool pool;
  const std::vector<Vec2> outline{{3, 1}, {5.5, 0.5}, {6, 2.5}, {4.2, 3.4}, {2.8, 2}};
  (void)pool.floes.add(pool.world, afloat(pool.resolved, outline), 0.0);
  const BodyId body = pool.world.floes().front();
  const Pose tilted{{7.0, -2.0, 0.15}, {0.8, 0.36, -0.48, 0.0}};
  pool.world.set_state(body, tilted, {{0.4, -0.2, 0.3}, {0.5, 0.7, -0.6}});
  (void)pool.step(0.01);  // it takes the added mass of its wet part
  BOOST_TEST(pool.floes.at(body).wet_share < 1.0);
  const Motion before = motion_of(pool);
  const Pose pose = pool.world.pose(body);
  const Twist twist = pool.world.twist(body);

  const floes::Floe parent = pool.floes.remove(pool.world, body);
  const auto halves = geometry::split(parent.plate.outline().front(), geometry::snap({3.5, 0}), geometry::snap({5, 3}));
  BOOST_REQUIRE(halves.pieces.size() == 2u);
  for (const geometry::Polygon& half : halves.pieces) {
    const auto record = pool.floes.add_piece(pool.world, parent.plate.piece(half), parent, pose, twist, 2.5);
    BOOST_REQUIRE(record.has_value());
    BOOST_TEST(record->parent == parent.id);
    BOOST_TEST(record->birth == 2.5);
    BOOST_TEST((record->birth_pose == pool.world.pose(pool.world.floes().back())));
  }
  // Outlines are rounded to 1e-9 m.
  const Motion after = motion_of(pool);
  const double close = 1e-8;
  BOOST_TEST(after.mass == before.mass, boost::test_tools::tolerance(close));
  BOOST_TEST(norm(after.momentum - before.momentum) < close * norm(before.momentum));
  BOOST_TEST(norm(after.angular_momentum - before.angular_momentum) < close * norm(before.angular_momentum));
  BOOST_TEST(after.kinetic == before.kinetic, boost::test_tools::tolerance(close));
  BOOST_TEST(after.potential == before.potential, boost::test_tools::tolerance(close));
  // They part along the crack, and do not press on each other.
  (void)pool.step(0.01);
  BOOST_TEST(pool.world.contacts().empty());
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
