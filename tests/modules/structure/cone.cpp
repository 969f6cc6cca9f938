// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/structure/cone.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace {

using namespace brash;

const structure::Cone kPaperCone{radians(61.4), 13.6, 9.08, 5.68, true, 64};

BOOST_AUTO_TEST_CASE(the_papers_cone_has_the_keel_and_top_widths_of_its_slope) {
  // Table 1: 5.68 m below and 3.40 m above the waterplane at 61.4 deg; both widths rounded to the centimetre.
  BOOST_TEST(2.0 * structure::radius_at(kPaperCone, -5.68) == 7.41, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(2.0 * structure::radius_at(kPaperCone, 3.40) == 17.31, boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(an_upward_breaking_cone_narrows_upwards) {
  structure::Cone cone = kPaperCone;
  cone.downward_breaking = false;
  BOOST_TEST(structure::radius_at(cone, 1.0) < structure::radius_at(cone, 0.0));
}

BOOST_AUTO_TEST_CASE(a_section_runs_counter_clockwise_with_its_vertices_on_the_circle) {
  const auto ring = structure::section(kPaperCone, 0.2);
  BOOST_REQUIRE_EQUAL(ring.size(), 64u);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    BOOST_TEST(norm(ring[i]) == structure::radius_at(kPaperCone, 0.2), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(cross(ring[i], ring[(i + 1) % ring.size()]) > 0.0);
  }
}

BOOST_AUTO_TEST_CASE(the_hull_spans_the_height_of_the_cone) {
  const auto vertices = structure::hull(kPaperCone);
  BOOST_REQUIRE_EQUAL(vertices.size(), 128u);
  BOOST_TEST(vertices.front().z == -5.68);
  BOOST_TEST(vertices.back().z == 3.40, boost::test_tools::tolerance(1e-14));
}

BOOST_AUTO_TEST_CASE(a_section_beyond_the_apex_breaks_the_contract) {
  BOOST_CHECK_THROW(structure::section(kPaperCone, -20.0), ContractViolation);
}

}  // namespace
