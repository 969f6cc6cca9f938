// SPDX-License-Identifier: GPL-3.0-or-later
// Cracks that end on an edge or on another crack, to the last unit of the grid or within its rounding.
#include "brash/geometry/lines.hpp"

#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>

#include "brash/core/constants.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/text.hpp"

namespace {

using namespace brash;
using namespace brash::geometry;

Ring box(double half) {
  const std::array corners{Vec2{-half, -half}, Vec2{half, -half}, Vec2{half, half}, Vec2{-half, half}};
  return ring(corners);
}

std::size_t n_pieces(const Ring& outline, const Ring& region, const std::vector<Crack>& cracks) {
  const Polygon polygon{outline, {}};
  return IceSheet::from_polygons(std::span(&polygon, 1)).value().cut(region, cracks).pieces.size();
}

class Draw {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(next_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 next_{11};
};

BOOST_AUTO_TEST_SUITE(lines)

BOOST_AUTO_TEST_CASE(a_crack_ends_on_a_crack_that_the_region_cuts_off) {
  const auto cracks = read_lines("LINESTRING (-300 -3, 300 -73)\nLINESTRING (48 -43.6, 48 300)").value().cracks;
  for (const double half : {100.0, 110.0, 600.0}) BOOST_TEST(n_pieces(box(100), box(half), cracks) == 3u);
}

BOOST_AUTO_TEST_CASE(cracks_end_on_cracks_wherever_the_region_cuts_them_off) {
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    const double angle = draw(0.0, 2.0 * kPi), share = draw(0.45, 0.55);
    const Vec2 along{std::cos(angle), std::sin(angle)}, middle{draw(-20.0, 20.0), draw(-20.0, 20.0)};
    const Point from = snap(middle - 300.0 * along), to = snap(middle + 300.0 * along);
    const Vec2 a = metres(from), end = a + share * (metres(to) - a);
    const Point foot = snap(end), head = snap(end + 300.0 * Vec2{-along.y, along.x});
    const std::vector<Crack> cracks{{from, to}, {foot, head}};
    for (const double half : {100.0, 110.0, 600.0}) BOOST_TEST(n_pieces(box(100), box(half), cracks) == 3u);
  }
}

BOOST_AUTO_TEST_CASE(a_line_drawn_from_side_to_side_parts_a_floe_whose_corners_are_rounded) {
  Draw draw;
  int n_missed = 0;
  for (int i = 0; i < 1000; ++i) {
    std::array<double, 7> angles{};
    for (double& angle : angles) angle = draw(0.0, 2.0 * kPi);
    std::sort(angles.begin(), angles.end());
    std::array<Vec2, 7> corners{};
    for (std::size_t k = 0; k < 7; ++k) corners[k] = {std::cos(angles[k]), std::sin(angles[k])};
    const std::vector<Crack> line{{snap(0.5 * (corners[0] + corners[1])), snap(0.5 * (corners[3] + corners[4]))}};
    n_missed += n_pieces(ring(corners), box(9), line) == 1u;
    BOOST_TEST(n_pieces(ring(corners), box(9), beyond_free_ends(line)) == 2u);
  }
  BOOST_TEST(n_missed > 0);  // else the test is of nothing
}

BOOST_AUTO_TEST_CASE(lines_reach_beyond_their_free_ends_alone) {
  const auto point = [](double x, double y) { return snap({x, y}); };
  const Point a = point(0, 0), b = point(3, 4), c = point(6, 4), d = point(8192, 4);
  const std::vector<Crack> cracks = beyond_free_ends({{a, b}, {b, c}, {c, d}});
  BOOST_TEST(norm(metres(cracks[0].from) - Vec2{-0.6e-7, -0.8e-7}) < kGridUnit);
  BOOST_TEST((cracks[0].to == b && cracks[1].from == b && cracks[1].to == c && cracks[2].from == c));
  BOOST_TEST((cracks[2].to == d));  // the rim of the grid
  const std::vector<Crack> ring = beyond_free_ends({{a, b}, {b, c}, {c, a}});
  BOOST_TEST((ring[0].from == a && ring[2].to == a));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
