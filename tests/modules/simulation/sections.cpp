// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/sections.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"
#include "brash/rigid_body/world.hpp"

namespace {

using namespace brash;
using namespace brash::floes;
using boost::test_tools::tolerance;

const double kRound = 1e-12;  // closed forms to rounding

std::vector<Vec2> rectangle(double length, double breadth) {
  return {{-0.5 * length, -0.5 * breadth},
          {0.5 * length, -0.5 * breadth},
          {0.5 * length, 0.5 * breadth},
          {-0.5 * length, 0.5 * breadth}};
}

/// In its principal axes, as a floe has it.
Prism floe(const std::vector<std::vector<Vec2>>& rings, double thickness) {
  return rigid_body::place_prism(rings, rings, thickness, 0.0).prism;
}

/// A line load across a square of side `side`, at `x`, of `force` [N] upwards.
void add_line(std::vector<PointForce>& forces, double x, double side, double force) {
  for (const double share : {-0.375, -0.125, 0.125, 0.375})
    forces.push_back({{x, share * side, force < 0.0 ? 0.165 : -0.165}, {0.0, 0.0, 0.25 * force}});
}

double largest_tension(const Sections& sections, const std::vector<PointForce>& forces) {
  const std::vector<SectionLoad> loads = sections.loads(forces);
  double largest = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i) largest = std::max(largest, sections.tension(i, loads[i]));
  return largest;
}

/// A bay, a hole and no symmetry.
std::vector<std::vector<Vec2>> bay_with_hole() {
  return {{{0, 0}, {4, -1}, {5, 2}, {2.6, 1.1}, {2, 3.5}, {-1, 2}}, {{0.5, 0.8}, {0.7, 1.6}, {1.4, 1.0}}};
}

const std::vector<PointForce> kAnyForces{
    {{1.2, -0.4, 0.1}, {3e3, -1e3, 5e3}}, {{-1.5, 0.3, -0.15}, {-2e3, 4e3, 1e3}}, {{0.2, 1.0, 0.15}, {1e3, 2e3, -7e3}}};

BOOST_AUTO_TEST_SUITE(sections)

// A square of 1.5 m in ice of 0.33 m: W = L h^2 / 6, sigma_f = 539 kPa.
BOOST_AUTO_TEST_CASE(a_square_on_two_supports_breaks_under_a_line_load_of_39_kN) {
  const Sections square(floe({rectangle(1.5, 1.5)}, 0.33));
  const double breaking = 4.0 / 6.0 * 539e3 * 0.33 * 0.33;  // M = P L / 4
  BOOST_TEST(breaking == 39.1e3, tolerance(1e-3));
  std::vector<PointForce> forces;
  add_line(forces, 0.0, 1.5, -breaking);
  add_line(forces, -0.75, 1.5, 0.5 * breaking);
  add_line(forces, 0.75, 1.5, 0.5 * breaking);
  BOOST_TEST(largest_tension(square, forces) == 539e3, tolerance(kRound));
}

BOOST_AUTO_TEST_CASE(a_square_that_only_its_inertia_holds_breaks_under_78_kN) {
  const Sections square(floe({rectangle(1.5, 1.5)}, 0.33));
  const double breaking = 8.0 / 6.0 * 539e3 * 0.33 * 0.33;  // M = P L / 8
  std::vector<PointForce> forces;
  add_line(forces, 0.0, 1.5, -breaking);
  BOOST_TEST(largest_tension(square, forces) == 539e3, tolerance(kRound));
}

/// The end is pushed up by P. The beam's inertia is even and linear along it: P / L (1 + 6 g x / L), g = 1/(1 +
/// h^2/L^2) with its rotary part.
BOOST_AUTO_TEST_CASE(a_beam_pushed_at_its_end_bends_as_its_inertia_says) {
  const double l = 10.0, h = 0.4, force = 2e4;
  const Sections beam(floe({rectangle(l, 1.0)}, h));
  const std::vector<SectionLoad> loads = beam.loads(std::vector<PointForce>{{{0.5 * l, 0.0, 0.0}, {0.0, 0.0, force}}});
  const double rotary = 1.0 / (1.0 + h * h / (l * l)), slope = 12.0 * rotary * force * 0.5 * l / (l * l * l);
  int n_across = 0;
  double largest = 0.0;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Section& s = beam.all()[i];
    if (s.normal.x < 1.0 - 1e-9) continue;
    ++n_across;
    const double arm = 0.5 * l - s.offset;
    const double moment = force * arm - 0.5 * force / l * arm * arm -
                          slope * (arm * arm * s.offset / 2.0 + arm * arm * arm / 3.0) - slope * arm * h * h / 12.0;
    BOOST_TEST(loads[i].moment == moment, tolerance(1e-10));
    largest = std::max(largest, loads[i].moment);
  }
  BOOST_TEST(n_across == 17);
  // The largest moment of a thin beam is 4/27 P L, a third of its length from the end. The nearest section is 0.2 m
  // off.
  BOOST_TEST(largest < 4.0 / 27.0 * force * l);
  BOOST_TEST(largest > 0.9 * 4.0 / 27.0 * force * l);
}

BOOST_AUTO_TEST_CASE(between_two_sections_a_point_load_on_a_free_beam_loses_a_sixth_of_its_moment_at_most) {
  const double l = 10.0, force = 2e4;
  for (const double h : {0.2, 0.5, 1.0, 2.0}) {
    const Sections beam(floe({rectangle(l, 2.5)}, h));
    for (double x = -0.25 * l; x <= 0.25 * l; x += 0.01 * l) {
      const std::vector<SectionLoad> loads = beam.loads(std::vector<PointForce>{{{x, 0.0, 0.0}, {0.0, 0.0, force}}});
      double largest = 0.0;
      for (std::size_t i = 0; i < loads.size(); ++i)
        if (beam.all()[i].normal.x > 1.0 - 1e-9) largest = std::max(largest, std::abs(loads[i].moment));
      // Under the load: the inertia of the ice beyond, even and linear along the beam, with its rotary part.
      const double arm = 0.5 * l - x, slope = 12.0 * force * x / (l * l * l * (1.0 + h * h / (l * l)));
      const double exact = force / l * arm * arm / 2.0 + slope * (arm * arm * x / 2.0 + arm * arm * arm / 3.0) +
                           slope * arm * h * h / 12.0;
      BOOST_TEST(largest > 5.0 / 6.0 * exact);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_thrust_presses_less_the_more_ice_it_has_moved) {
  const Sections beam(floe({rectangle(6.0, 2.0)}, 0.3));
  const std::vector<SectionLoad> loads = beam.loads(std::vector<PointForce>{{{3.0, 0.0, 0.1}, {-9e3, 0.0, 0.0}}});
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const Section& s = beam.all()[i];
    if (s.normal.x < 1.0 - 1e-9) continue;
    const double left_behind = 0.5 + s.offset / 6.0;  // share of the ice that the section pushes
    BOOST_TEST(loads[i].thrust == -9e3 * left_behind, tolerance(kRound));
  }
}

/// Weight, and buoyancy of faces that are wholly wet or dry, are forces that vary linearly over the plan.
BOOST_AUTO_TEST_CASE(forces_that_vary_as_inertia_does_bend_nothing) {
  const double side = 2.0;
  const Sections square(floe({rectangle(side, side)}, 0.25));
  const int n = 200;
  const double cell = side / n;
  std::vector<PointForce> forces;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double x = -0.5 * side + (i + 0.5) * cell, y = -0.5 * side + (j + 0.5) * cell;
      forces.push_back({{x, y, 0.0}, {0.0, 0.0, cell * cell * (1e4 + 3e3 * x - 2e3 * y)}});
    }
  // All together weigh 40 kN. A strip of cells at the section is counted whole or not at all, and the rotary inertia
  // bends: both stay below a thousandth of the bending under the same forces in one point.
  const std::vector<PointForce> in_one_point{{{}, {0.0, 0.0, 4e4}}};
  BOOST_TEST(largest_tension(square, forces) < 1e-3 * largest_tension(square, in_one_point));
}

/// Buoyancy that sets in across the beam at x0, of 1 Pa: the farthest from linear that a face awash can be.
BOOST_AUTO_TEST_CASE(a_face_awash_bends_no_more_than_the_page_says) {
  const double l = 8.0, h = 0.25;
  const Sections beam(floe({rectangle(l, 1.0)}, h));
  const int n = 400;
  double largest = 0.0;
  for (int from = 0; from < n; from += 4) {
    std::vector<PointForce> forces;
    for (int i = from; i < n; ++i) forces.push_back({{-0.5 * l + (i + 0.5) * l / n, 0.0, 0.0}, {0.0, 0.0, l / n}});
    largest = std::max(largest, largest_tension(beam, forces));
  }
  BOOST_TEST(largest < 0.097 * l * l / (h * h));
  BOOST_TEST(largest > 0.094 * l * l / (h * h));  // the sections are a sixteenth of the beam apart
}

BOOST_AUTO_TEST_CASE(both_sides_of_a_section_give_the_same_load) {
  const Prism prism = floe(bay_with_hole(), 0.33);
  Prism turned = prism;
  const auto half_turn = [](Vec2 p) { return -p; };
  for (auto& ring : turned.rings) std::ranges::transform(ring, ring.begin(), half_turn);
  std::vector<PointForce> turned_forces;
  for (const auto& [p, f] : kAnyForces) turned_forces.push_back({{-p.x, -p.y, p.z}, {-f.x, -f.y, f.z}});
  const Sections one(prism), other(turned);
  const std::vector<SectionLoad> loads = one.loads(kAnyForces), turned_loads = other.loads(turned_forces);
  BOOST_REQUIRE(loads.size() == 204u);
  BOOST_REQUIRE(turned_loads.size() == 204u);
  for (std::size_t i = 0; i < 204; ++i) {
    const std::size_t mirrored = i / 17 * 17 + 16 - i % 17;  // the same section, seen from its other side
    BOOST_TEST(one.all()[i].offset == -other.all()[mirrored].offset, tolerance(1e-9));
    BOOST_TEST(one.all()[i].width == other.all()[mirrored].width, tolerance(1e-9));
    BOOST_TEST(std::abs(loads[i].moment - turned_loads[mirrored].moment) < 1e-8);  // of some 1e4 N m
    BOOST_TEST(std::abs(loads[i].thrust - turned_loads[mirrored].thrust) < 1e-8);
  }
}

BOOST_AUTO_TEST_CASE(a_section_knows_its_ice_with_bays_and_holes) {
  // A frame: 4 m by 3 m around a hole of 2 m by 1 m.
  std::vector<Vec2> hole = rectangle(2.0, 1.0);
  std::ranges::reverse(hole);
  const Sections frame(floe({rectangle(4.0, 3.0), hole}, 0.3));
  for (const Section& s : frame.all()) {
    if (s.normal.x < 1.0 - 1e-9) continue;
    const bool in_hole = std::abs(s.offset) < 1.0;
    BOOST_TEST(s.width == (in_hole ? 2.0 : 3.0), tolerance(kRound));
    const double of_hole = std::clamp(1.0 - s.offset, 0.0, 2.0);
    BOOST_TEST(s.area == (2.0 - s.offset) * 3.0 - of_hole, tolerance(kRound));
  }
}

BOOST_AUTO_TEST_CASE(a_tip_narrower_than_it_is_thick_does_not_break_off) {
  // A triangle, 6 m long and 2 m wide at its base, bent at its tip.
  const Sections wedge(floe({{{0, -1}, {6, 0}, {0, 1}}}, 0.5));
  const std::vector<SectionLoad> loads = wedge.loads(std::vector<PointForce>{{{4.0, 0.0, 0.0}, {0.0, 0.0, 1e4}}});
  int n_narrow = 0, n_wide = 0;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double tension = wedge.tension(i, loads[i]);
    if (wedge.all()[i].width < 0.5) {
      ++n_narrow;
      BOOST_TEST(tension == 0.0);
    } else {
      ++n_wide;
      BOOST_TEST(tension > 0.0);
    }
  }
  BOOST_TEST(n_narrow > 0);
  BOOST_TEST(n_wide > 50);
}

BOOST_AUTO_TEST_CASE(nothing_shorter_than_two_thicknesses_has_a_section) {
  BOOST_TEST(Sections(floe({rectangle(0.65, 0.65)}, 0.5)).all().empty());
  // Long enough along one axis, and too short across it.
  const Sections beam(floe({rectangle(2.0, 0.5)}, 0.4));
  BOOST_TEST(!beam.all().empty());
  for (const Section& s : beam.all()) BOOST_TEST(std::abs(s.normal.y) < 0.99);
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
