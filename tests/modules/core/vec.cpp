// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/vec.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"

namespace {

using namespace brash;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(a_quarter_turn_about_z_takes_x_to_y) {
  const Quaternion quarter{std::cos(kPi / 4), 0.0, 0.0, std::sin(kPi / 4)};
  const Vec3 turned = rotate(quarter, {1.0, 0.0, 0.0});
  BOOST_TEST(std::abs(turned.x) < 1e-15);  // round-off of cos(pi/4)
  BOOST_TEST(turned.y == 1.0, tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(body_and_world_frames_are_inverse) {
  const double half = 0.35;
  const Pose pose{{1.0, -2.0, 0.5}, {std::cos(half), 0.0, std::sin(half), 0.0}};
  const Vec3 point{0.3, 0.7, -0.2};
  BOOST_TEST(norm(to_body(pose, to_world(pose, point)) - point) < 1e-15);  // a few roundings of unit-size numbers
}

BOOST_AUTO_TEST_CASE(a_spinning_body_moves_across_its_arm) {
  const Twist twist{{1.0, 0.0, 0.0}, {0.0, 0.0, 2.0}};
  BOOST_TEST((velocity_at(twist, {0.0, 1.0, 0.0}) == Vec3{-1.0, 0.0, 0.0}));
}

BOOST_AUTO_TEST_CASE(a_broken_contract_names_condition_and_values) {
  const double depth = -0.5;
  BOOST_CHECK_EXCEPTION(BRASH_EXPECTS(depth > 0.0, depth), ContractViolation, [](const ContractViolation& violation) {
    const std::string text = violation.what();
    return text.find("depth > 0.0") != std::string::npos && text.find("-0.5") != std::string::npos;
  });
}

}  // namespace
