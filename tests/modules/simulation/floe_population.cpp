// SPDX-License-Identifier: GPL-3.0-or-later
#include "floe_population.hpp"

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
  failure::IceProperties thick = ice_properties(pool.resolved);
  thick.thickness = 0.5;
  const auto record =
      pool.floes.add(pool.world, ice::Plate(0, ice::Hold::kAfloat, thick, {{geometry::ring(kSquare), {}}}), 1.5);
  BOOST_REQUIRE(record.has_value());
  BOOST_TEST(record->birth == 1.5);
  const Floe& floe = pool.floes.floes().begin()->second;
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

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
