// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/plate.hpp"

#include <boost/test/unit_test.hpp>

#include "level_ice.hpp"

namespace {

using namespace brash;
using namespace brash::ice;
using namespace brash::ice::testing;

BOOST_AUTO_TEST_SUITE(plates)

BOOST_AUTO_TEST_CASE(a_piece_is_afloat_and_of_the_ice_that_it_broke_off) {
  const Plate level(3, Hold::kFast, properties(), {{geometry::disc({0.0, 0.0}, 5.0, 16), {}}});
  const Plate piece = level.piece({geometry::disc({0.0, 0.0}, 1.0, 16), {}});
  BOOST_TEST((piece.hold() == Hold::kAfloat));
  BOOST_TEST(piece.level_ice() == 3);
  BOOST_TEST(piece.ice().thickness == properties().thickness);
  BOOST_TEST(piece.ice().flexural_strength == properties().flexural_strength);
}

BOOST_AUTO_TEST_CASE(outline_and_area_are_the_same_before_and_after_the_sheet_is_laid) {
  Plate plate(0, Hold::kFast, properties(), {{geometry::disc({0.0, 0.0}, 5.0, 16), {}}});
  const geometry::ExactArea area = plate.area();
  BOOST_TEST((plate.outline() == std::vector{geometry::Polygon{geometry::disc({0.0, 0.0}, 5.0, 16), {}}}));
  BOOST_TEST((plate.sheet().area() == area));
  BOOST_TEST((plate.area() == area));
  BOOST_TEST(plate.outline().size() == 1u);
  (void)plate.sheet().cut(geometry::disc({0.0, 0.0}, 1.0, 8));
  BOOST_TEST(plate.outline().at(0).holes.size() == 1u);
  BOOST_TEST((plate.area() < area));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
