// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_contact.hpp"

#include <boost/test/unit_test.hpp>

#include "brash/core/constants.hpp"
#include "ice_field.hpp"

namespace {

using namespace brash;

/// Keeps the load case that it is asked about.
class Listening final : public failure::BendingCriterion {
 public:
  explicit Listening(bool wants_outline) : wants_outline_(wants_outline) {}
  failure::Assessment assess(const failure::LoadCase& load) const override {
    heard = load;
    return {};
  }
  bool needs_outline() const override { return wants_outline_; }
  mutable failure::LoadCase heard;

 private:
  bool wants_outline_;
};

struct Scene {
  io::Case resolved = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", {});
  structure::Cone cone{.angle = radians(61.4), .waterline_width = 13.6, .height = 9.08, .height_under_water = 5.68};
  failure::IceProperties ice = simulation::ice_properties(resolved);
  simulation::IceField field{50.0, 50.0};

  /// Of the last contact.
  failure::LoadCase load(bool wants_outline, Vec2 centre = {-6.7, 0.0}) {
    const Listening criterion(wants_outline);
    const auto contacts = simulation::edge_contacts({cone, resolved, ice, criterion}, field.sheet(), centre);
    BOOST_REQUIRE(!contacts.empty());
    return criterion.heard;
  }
};

BOOST_AUTO_TEST_CASE(only_a_criterion_that_asks_gets_the_outline) {
  Scene scene;
  BOOST_TEST(scene.load(false).outline.empty());
  BOOST_TEST(!scene.load(true).outline.empty());
}

BOOST_AUTO_TEST_CASE(the_outline_of_a_straight_edge_is_the_edge_with_the_chord_in_it) {
  Scene scene;
  const failure::LoadCase load = scene.load(true);
  const double half = 0.5 * load.contact_length;
  const auto& outline = load.outline;
  BOOST_REQUIRE(outline.size() == 4u);
  BOOST_TEST(outline[1].y == -half);
  BOOST_TEST(outline[2].y == half);
  const double reach = 3.0 * failure::characteristic_length(scene.ice);
  BOOST_TEST(outline.front().y == -reach, boost::test_tools::tolerance(1e-3));  // the circle may be a polygon
  BOOST_TEST(outline.back().y == reach, boost::test_tools::tolerance(1e-3));
  for (const Vec2 point : outline) BOOST_TEST(std::abs(point.x) < 1e-6);  // the grid
}

BOOST_AUTO_TEST_CASE(the_outline_passes_the_contact_once_with_the_ice_on_its_right) {
  Scene scene;
  scene.field.break_free({0.0, 0.0}, 3.0, 4, 16, geometry::disc({-100.0, 0.0}, 1.0, 8), 0.01);
  const failure::LoadCase load = scene.load(true, {-3.9, 0.4});
  const auto& outline = load.outline;
  BOOST_REQUIRE(outline.size() > 4u);
  for (const Vec2 point : outline) {
    BOOST_TEST(point.y >= outline.front().y);
    BOOST_TEST(point.y <= outline.back().y);
  }
  const auto plate = failure::make_criterion("plate-outline", "", scene.ice);
  failure::LoadCase heavy = load;
  heavy.pressure = 1e6;  // enough for the plate to be solved
  BOOST_TEST(!plate->assess(heavy).outline_refused);
}

}  // namespace
