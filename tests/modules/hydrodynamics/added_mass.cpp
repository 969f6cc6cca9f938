// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/hydrodynamics/added_mass.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "shapes.hpp"

namespace {

using namespace brash;
using namespace brash::test;
using hydrodynamics::added_mass_of_plate;
using hydrodynamics::AddedMass;
using hydrodynamics::wetted_share;
namespace tt = boost::test_tools;

constexpr double kWater = 1025.0;

BOOST_AUTO_TEST_CASE(a_rectangular_plate_has_the_tabulated_added_mass_along_its_normal) {
  // K(b/a) of DNV-RP-C205, Table D-2 (three decimals).
  const std::pair<double, double> table[] = {{1.0, 0.579}, {1.25, 0.642}, {1.5, 0.690}, {2.0, 0.757}, {2.5, 0.801},
                                             {3.0, 0.830}, {4.0, 0.872},  {5.0, 0.897}, {8.0, 0.934}, {10.0, 0.947}};
  for (const auto& [slenderness, factor] : table) {
    const AddedMass found = added_mass_of_plate(box(2.0, 2.0 * slenderness, 0.01), kWater);
    BOOST_TEST(found.across == kWater * kPi / 4.0 * 4.0 * 2.0 * slenderness * factor, tt::tolerance(3e-3));
    BOOST_TEST(added_mass_of_plate(box(2.0 * slenderness, 2.0, 0.01), kWater).across == found.across,
               tt::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(a_long_plate_has_the_added_mass_of_a_strip) {
  // Strip of breadth a: pi/4 a^2 and pi/128 a^4 a length (Newman 1977, Table 4.3). A strip that swings end over end has
  // the former at each place. Ends tell: the ratio is 1000.
  const AddedMass found = added_mass_of_plate(box(1000.0, 1.0, 1e-3), kWater);
  BOOST_TEST(found.across == kWater * kPi / 4.0 * 1000.0, tt::tolerance(1e-3));
  BOOST_TEST(found.inertia.x == kWater * kPi / 128.0 * 1000.0, tt::tolerance(1e-3));
  BOOST_TEST(found.inertia.y == kWater * kPi / 48.0 * 1e9, tt::tolerance(6e-3));
}

BOOST_AUTO_TEST_CASE(a_disc_has_nearly_the_added_mass_of_a_disc) {
  std::vector<Vec2> ring;
  for (int i = 0; i < 256; ++i) ring.push_back({2.0 * std::cos(kPi * i / 128.0), 2.0 * std::sin(kPi * i / 128.0)});
  const AddedMass found = added_mass_of_plate({{ring}, {ring}, 0.01}, kWater);
  // Lamb 1932, art. 108: 8/3 r^3 and 16/45 r^5. A square stands for the disc.
  BOOST_TEST(found.across == kWater * 8.0 / 3.0 * 8.0, tt::tolerance(0.06));
  BOOST_TEST(found.inertia.x == kWater * 16.0 / 45.0 * 32.0, tt::tolerance(0.01));
  BOOST_TEST(found.inertia.z < 1e-3 * found.inertia.x);  // a disc turns in its own outline
}

BOOST_AUTO_TEST_CASE(a_square_plate_turns_with_the_added_inertia_of_potential_flow) {
  // Panel solutions of the thin plate, sides p across the axis and q along it: moment over pi/128 p^4 q.
  const std::pair<double, double> solutions[] = {{0.4, 0.5975},  {0.5, 0.6612}, {0.8, 0.7763}, {1.0, 0.8219},
                                                 {1.25, 0.8569}, {1.5, 0.8814}, {2.0, 0.9128}, {2.5, 0.9316}};
  for (const auto& [q, factor] : solutions)
    BOOST_TEST(added_mass_of_plate(box(1.0, q, 0.01), kWater).inertia.y == kWater * kPi / 128.0 * q * factor,
               tt::tolerance(5e-3));
}

BOOST_AUTO_TEST_CASE(along_its_plane_a_plate_moves_the_water_of_its_edges_alone) {
  const AddedMass found = added_mass_of_plate(box(3.0, 2.0, 0.3), kWater);
  // Mean of pi/4 h^2 times the breadths 2 m and 3 m.
  BOOST_TEST(found.along == kWater * kPi / 4.0 * 0.09 * 2.5, tt::tolerance(1e-12));
  BOOST_TEST(found.along < 0.04 * found.across);
  BOOST_TEST(added_mass_of_plate(box(0.3, 0.3, 0.3), kWater).along <=
             added_mass_of_plate(box(0.3, 0.3, 0.3), kWater).across);
}

BOOST_AUTO_TEST_CASE(each_wet_face_counts_half) {
  const Prism floe = box(3.0, 2.0, 0.4);
  BOOST_TEST(wetted_share(floe, {{0.0, 0.0, 1.0}, {}}) == 0.0);
  BOOST_TEST(wetted_share(floe, {{0.0, 0.0, 0.1}, {}}) == 0.5, tt::tolerance(1e-12));
  BOOST_TEST(wetted_share(floe, {{0.0, 0.0, -1.0}, {}}) == 1.0, tt::tolerance(1e-12));
  BOOST_TEST(wetted_share(floe, {{0.0, 0.0, -1.0}, {}}, 0.0) == 0.5, tt::tolerance(1e-12));
  // On its edge, half under water.
  BOOST_TEST(wetted_share(floe, {{0.0, 0.0, 0.0}, turn({1.0, 0.0, 0.0}, 0.5 * kPi)}) == 0.5, tt::tolerance(1e-12));
}

}  // namespace
