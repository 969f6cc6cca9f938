// SPDX-License-Identifier: GPL-3.0-or-later
// The fit on sheets. `--log_level=message` prints the numbers of docs/theory/fracture-of-the-edge.md.
#include <boost/test/unit_test.hpp>

#include "brash/geometry/trapezoid.hpp"
#include "fit_cases.hpp"

namespace brash::geometry {
namespace {

constexpr double kReach = 3.3;

/// A sheet whose left edge has the protrusion, turned by `angle` about B at `at`.
IceSheet sheet_with_protrusion(double b, double c, double theta, Vec2 at, double angle) {
  std::vector<Vec2> outline;
  const Vec2 x{std::cos(angle), std::sin(angle)};
  for (const Vec2 p : fit_cases::trapezoid_edge(b, c, theta, 20.0)) outline.push_back(p);
  outline.push_back({40.0, -20.0});
  outline.push_back({40.0, 20.0});
  for (Vec2& p : outline) p = at + p.x * x + p.y * perpendicular(x);
  const Polygon ice{ring(outline), {}};
  return IceSheet::from_polygons(std::span(&ice, 1)).value();
}

/// The passage of a cylinder that breaks its way into a sheet: one fit at each contact, in order.
struct Passage {
  std::vector<Trapezoid> at_edge;
  std::vector<Trapezoid> at_chord;
};

Passage break_through_a_sheet() {
  const Polygon ice{shapes::box(0, -20, 30, 20), {}};
  IceSheet sheet = IceSheet::from_polygons(std::span(&ice, 1)).value();
  std::mt19937_64 generator(3);
  Passage passage;
  for (double x = -6.9; x < 12.0; x += 0.02) {
    for (const ContactRegion& contact : sheet.contacts(disc({x, 0}, 6.8, 64))) {
      if (!(contact.contact_length > 0.0)) continue;
      FitRequest request{contact.midpoint, contact.normal, contact.contact_length, kReach};
      passage.at_edge.push_back(fit_trapezoid(sheet, request));
      request.at = 0.5 * (contact.chord_from + contact.chord_to);
      passage.at_chord.push_back(fit_trapezoid(sheet, request));
      const double radius = 0.5 + shapes::uniform(generator);
      const int wedges = 3 + static_cast<int>(3 * shapes::uniform(generator));
      if (contact.contact_length > 0.25) cut_circumferential(sheet, contact.midpoint, radius, wedges);
    }
    sheet.cut(disc({x - 0.15, 0}, 6.8, 64));
    sheet.release_detached();
  }
  return passage;
}

void report(const char* where, const std::vector<Trapezoid>& fits) {
  double flat = 0, reidentified = 0, depth = 0, angle = 0, error = 0;
  for (const Trapezoid& fit : fits) {
    BOOST_TEST((fit.depth >= 0.0 && fit.depth <= kReach));
    BOOST_TEST((fit.angle >= 0.0 && degrees(fit.angle) <= 150.0 + 1e-12));
    BOOST_TEST((fit.error >= 0.0 && fit.error <= 1.0));
    flat += fit.depth == 0.0;
    reidentified += fit.reidentified;
    depth += fit.depth;
    angle += degrees(fit.angle);
    error += fit.error;
  }
  const double n = static_cast<double>(fits.size());
  BOOST_TEST_MESSAGE(where << ": " << n << " contacts, flat " << flat / n << ", reidentified " << reidentified / n
                           << ", mean b " << depth / n << " m, theta " << angle / n << " deg, error " << error / n);
  // An error of 0.1 is called distorted; if that were the rule, the trapezoid would be the wrong shape.
  BOOST_TEST(error / n < 0.1);
  BOOST_TEST(reidentified / n < 0.5);
}

BOOST_AUTO_TEST_SUITE(trapezoid_fit_of_sheets)

BOOST_AUTO_TEST_CASE(a_protrusion_of_a_sheet_is_found_wherever_it_points) {
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.3 + kPi * i / 6;
    const Vec2 at{-3.0 * i, 17.5}, towards{std::cos(angle), std::sin(angle)};
    const IceSheet sheet = sheet_with_protrusion(1.1, 0.4, radians(75), at, angle);
    const Trapezoid fit = fit_trapezoid(sheet, {at, towards, 0.4, kReach});
    // As in the tests of the fit alone.
    BOOST_TEST(std::abs(fit.depth - 1.1) < 0.003);
    BOOST_TEST(std::abs(degrees(fit.angle) - 75.0) < 0.5);
    BOOST_TEST(!fit.reidentified);
  }
}

BOOST_AUTO_TEST_CASE(the_fit_to_an_island_does_not_depend_on_where_its_outline_starts) {
  // The outline of a sheet starts at its smallest vertex: here it is B, a corner beside the window, or one behind B.
  for (int i = 0; i < 12; ++i) {
    const double angle = kPi * i / 6;
    const Vec2 x{std::cos(angle), std::sin(angle)}, at{20.0, -7.0};
    std::vector<Vec2> outline{{0, 0}, {0.6, -3.6}, {3, -2}, {3, 2}, {0.6, 3.6}};
    for (Vec2& p : outline) p = at + p.x * x + p.y * perpendicular(x);
    const Polygon ice{ring(outline), {}};
    const IceSheet island = IceSheet::from_polygons(std::span(&ice, 1)).value();
    const Trapezoid fit = fit_trapezoid(island, {at, x, {}, 3.0});
    const std::vector<Vec2> edge{{0.6, 3.6}, {0, 0}, {0.6, -3.6}};
    const Trapezoid open = fit_trapezoid(std::span(&edge, 1), {{0, 0}, {1, 0}, {}, 3.0});
    // The least descends to 1e-4 of the ranges.
    BOOST_TEST(std::abs(fit.depth - open.depth) < 0.001);
    BOOST_TEST(std::abs(fit.contact_length - open.contact_length) < 0.001);
    BOOST_TEST(std::abs(degrees(fit.angle) - degrees(open.angle)) < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(every_contact_of_a_passage_has_a_trapezoid_and_a_second_passage_has_the_same) {
  const Passage first = break_through_a_sheet(), second = break_through_a_sheet();
  BOOST_REQUIRE(first.at_edge.size() > 500u);
  report("B on the edge", first.at_edge);
  report("B on the chord", first.at_chord);
  BOOST_REQUIRE(first.at_edge.size() == second.at_edge.size());
  for (std::size_t i = 0; i < first.at_edge.size(); ++i) {
    BOOST_TEST(first.at_edge[i].depth == second.at_edge[i].depth);
    BOOST_TEST(first.at_chord[i].angle == second.at_chord[i].angle);
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
}  // namespace brash::geometry
