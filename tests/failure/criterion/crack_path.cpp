// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack_path.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "outline_sheet.hpp"

namespace {

using namespace brash;

const failure::IceProperties kIce{
    .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};

/// A load on 0.05 l_c of a straight edge.
failure::LoadCase narrow_load() {
  const double l_c = failure::characteristic_length(kIce);
  return {.contact_length = 0.05 * l_c, .mu1 = 0.511, .pressure = 5e6};
}

struct Broken {
  double length = 0.0;  ///< over l_c
  std::vector<Vec2> crack;
};

Broken broken_by(const failure::LoadCase& load, plate::Accuracy accuracy) {
  plate::LoadedSheet sheet = failure::loaded_sheet(load, kIce, false);
  sheet.accuracy = accuracy;
  const auto solution = plate::solve(sheet);
  BOOST_REQUIRE(solution.has_value());
  const auto stresses =
      failure::stresses_ahead(sheet, *solution, kIce, {failure::loads_of(load, kIce.thickness), kIce});
  BOOST_REQUIRE(stresses.has_value());
  return {stresses->place, failure::crack_from_line(sheet, *solution, stresses->place, stresses->side)};
}

/// How far into the ice a crack runs `y` beside the centre line.
double depth_at(const std::vector<Vec2>& crack, double y) {
  const auto after = std::ranges::find_if(crack, [&](Vec2 point) { return point.y >= y; });
  BOOST_REQUIRE((after != crack.begin() && after != crack.end()));
  const Vec2 b = *after, a = *(after - 1);
  return a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y);
}

BOOST_AUTO_TEST_CASE(under_a_narrow_load_on_a_straight_edge_the_crack_is_symmetric) {
  // 2 % is the goal for runs; the meshes of both sides differ.
  for (const auto accuracy : {plate::Accuracy::kFast, plate::Accuracy::kFine}) {
    const Broken broken = broken_by(narrow_load(), accuracy);
    BOOST_REQUIRE(broken.crack.size() > 10u);
    const double right = -broken.crack.front().y, left = broken.crack.back().y;
    BOOST_TEST(right == left, boost::test_tools::tolerance(0.02));
    for (double share = 0.1; share < 0.95; share += 0.1) {
      const double y = share * std::min(left, right);
      BOOST_TEST(std::abs(depth_at(broken.crack, -y) - depth_at(broken.crack, y)) < 0.02 * broken.length,
                 "y = " << y << ": " << depth_at(broken.crack, -y) << " and " << depth_at(broken.crack, y));
    }
  }
}

BOOST_AUTO_TEST_CASE(the_crack_crosses_the_centre_line_at_the_breaking_length) {
  const Broken broken = broken_by(narrow_load(), plate::Accuracy::kFast);
  BOOST_REQUIRE(!broken.crack.empty());
  BOOST_TEST(std::ranges::count(broken.crack, Vec2{broken.length, 0.0}) == 1);
  // The table of docs/theory/fracture-of-the-edge.md: b = 0, c = 0.05.
  BOOST_TEST(broken.length == 0.946, boost::test_tools::tolerance(0.02));
}

/// A wall loads the edge evenly, so the ice cracks along it, and at its ends towards the free edge.
BOOST_AUTO_TEST_CASE(the_crack_along_a_long_load_runs_past_its_ends) {
  const double l_c = failure::characteristic_length(kIce);
  const Broken broken =
      broken_by({.contact_length = 17.0 * l_c, .mu1 = 0.511, .pressure = 5e6}, plate::Accuracy::kFast);
  BOOST_REQUIRE(broken.crack.size() > 10u);
  BOOST_TEST(broken.crack.front().y < -8.5);
  BOOST_TEST(broken.crack.back().y > 8.5);
  // Under an even line load the moment of a half-infinite plate is largest at pi/4 l of the beam, l = sqrt(2) l_c.
  BOOST_TEST(broken.length == 0.25 * kPi * std::sqrt(2.0), boost::test_tools::tolerance(0.03));
  for (const double y : {-5.0, 5.0}) BOOST_TEST(std::abs(depth_at(broken.crack, y) - broken.length) < 0.15);
}

BOOST_AUTO_TEST_CASE(the_crack_ends_just_outside_the_edge) {
  const Broken broken = broken_by(narrow_load(), plate::Accuracy::kFast);
  BOOST_REQUIRE(broken.crack.size() > 10u);
  for (const Vec2 end : {broken.crack.front(), broken.crack.back()}) {
    BOOST_TEST(end.x < 0.0);
    BOOST_TEST(end.x > -0.03);  // one step of the crack
  }
  for (std::size_t i = 1; i + 1 < broken.crack.size(); ++i) BOOST_TEST(broken.crack[i].x > 0.0);
}

BOOST_AUTO_TEST_CASE(the_criterion_gives_this_crack_in_metres) {
  const auto criterion = failure::make_criterion(model::FailureModel::kPlateOutline, "", kIce, {.trace_crack = true});
  const failure::Assessment assessment = criterion->assess(narrow_load());
  BOOST_TEST(assessment.fails);
  const Broken broken = broken_by(narrow_load(), plate::Accuracy::kFast);
  BOOST_REQUIRE(assessment.crack.size() == broken.crack.size());
  const double l_c = failure::characteristic_length(kIce);
  for (std::size_t i = 0; i < broken.crack.size(); ++i)
    BOOST_TEST(norm(assessment.crack[i] - l_c * broken.crack[i]) == 0.0);
}

}  // namespace
