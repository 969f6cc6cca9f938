// SPDX-License-Identifier: GPL-3.0-or-later
#include "mooring.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "brash/core/error.hpp"
#include "catenary.hpp"
#include "rotation.hpp"

namespace {

using namespace brash;
using structure::Line;
using structure::LinePull;
using structure::pull_of;

/// The place of a line's upper end under the pull (h, v), by adding up 200000 pieces from the anchor.
Vec2 end_under(const Line& line, const LinePull& pull) {
  constexpr int kPieces = 200000;
  const double ds = line.length / kPieces;
  Vec2 end{};
  for (int i = 0; i < kPieces; ++i) {
    const double s = (i + 0.5) * ds, v = std::max(0.0, pull.downward - line.weight * (line.length - s));
    const double tension = std::hypot(pull.horizontal, v), stretched = ds * (1.0 + tension / line.stiffness);
    end += tension > 0.0 ? Vec2{stretched * pull.horizontal / tension, stretched * v / tension} : Vec2{ds, 0.0};
  }
  return end;
}

/// 205 m of chain, 1 kN/m in water.
constexpr Line kChain{205.0, 1000.0, 3e8};

BOOST_AUTO_TEST_SUITE(mooring)

BOOST_AUTO_TEST_CASE(a_line_hangs_as_its_pieces_added_up_do) {
  // On the bed for most of its length, hardly on it, off it, and as tight as a string.
  for (const auto& [span, rise] : {std::pair(190.0, 30.0), std::pair(201.0, 30.0), std::pair(202.7, 30.0),
                                   std::pair(204.0, 30.0), std::pair(150.0, 130.0), std::pair(220.0, 60.0)}) {
    const LinePull pull = pull_of(kChain, span, rise);
    const Vec2 end = end_under(kChain, pull);
    BOOST_TEST_MESSAGE(span << " m, " << rise << " m: " << pull.horizontal << " N, " << pull.downward << " N");
    BOOST_TEST(std::abs(end.x - span) < 1e-5);  // the pieces are a midpoint rule
    BOOST_TEST(std::abs(end.y - rise) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_stiff_line_on_the_bed_is_the_textbook_s_catenary) {
  // With a = H / w: rise = a (cosh(x / a) - 1), hanging length a sinh(x / a), span = x + the rest on the bed.
  const Line line{205.0, 1000.0, 1e14};
  const LinePull pull = pull_of(line, 190.0, 30.0);
  const double a = pull.horizontal / line.weight, x = a * std::acosh(1.0 + 30.0 / a);
  BOOST_TEST(x + line.length - a * std::sinh(x / a) == 190.0, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(pull.downward == line.weight * a * std::sinh(x / a), boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(a_shallow_line_pulls_from_the_span_at_which_it_is_slack) {
  // Long chains that rise by a few hundredths of their length. Their pull grows with the span, and hangs together.
  for (const auto& [line, rise] :
       {std::pair(Line{350.0, 1500.0, 5e8}, 15.0), std::pair(Line{500.0, 1000.0, 3e8}, 20.0),
        std::pair(Line{850.0, 1500.0, 5e8}, 50.0), std::pair(Line{850.0, 1500.0, 5e8}, 1.0)}) {
    const double slack = line.length - rise;
    LinePull last = pull_of(line, slack - 0.1, rise);
    BOOST_TEST(last.horizontal == 0.0);
    for (double span = slack + 0.01; span < std::hypot(line.length, rise) - rise * rise / line.length;
         span += rise / 100.0) {
      BOOST_TEST_CONTEXT(line.length << " m, " << span << " m along, " << rise << " m up") {
        const LinePull pull = pull_of(line, span, rise);
        BOOST_TEST(pull.horizontal > last.horizontal);
        BOOST_TEST(pull.downward > last.downward);
        last = pull;
      }
    }
    const Vec2 end = end_under(line, pull_of(line, slack + 0.5 * rise, rise));
    BOOST_TEST(std::abs(end.x - slack - 0.5 * rise) < 1e-5);
    BOOST_TEST(std::abs(end.y - rise) < 1e-5);
  }
}

BOOST_AUTO_TEST_CASE(a_slack_line_hangs_straight_down) {
  const LinePull pull = pull_of(kChain, 100.0, 30.0);
  BOOST_TEST(pull.horizontal == 0.0);
  BOOST_TEST(pull.downward == 30e3, boost::test_tools::tolerance(1e-3));  // less its stretch
  const LinePull longer = pull_of(kChain, 100.0, 30.001);
  BOOST_TEST((longer.energy - pull.energy) / 0.001 == pull.downward, boost::test_tools::tolerance(1e-4));
}

/// 90 m of tendon, 1 kN/m in water, which its own weight stretches by 13.5 mm.
constexpr Line kTendon{90.0, 1000.0, 3e8};

BOOST_AUTO_TEST_CASE(a_taut_tendon_is_a_spring_with_a_weight) {
  // Rise = L + (V - w L / 2) L / (E A).
  model::Moored moored;
  moored.lines = {{{0, 0, -100}, {0, 0, -5}, 90, 1000, 3e8}};
  const structure::Mooring mooring(moored, {});
  const auto lift = [&](double heave) { return mooring.at({{0.0, 0.0, heave}, {}}, {}).load.force.z; };
  BOOST_TEST(lift(0.0) == -(3e8 * (95.0 / 90.0 - 1.0) + 45e3), boost::test_tools::tolerance(1e-12));
  BOOST_TEST((lift(-0.5) - lift(0.5)) == 3e8 / 90.0, boost::test_tools::tolerance(1e-9));
  const auto energy = [&](double heave) { return mooring.at({{0.0, 0.0, heave}, {}}, {}).energy; };
  BOOST_TEST((energy(-0.5) - energy(0.5)) == lift(0.0), boost::test_tools::tolerance(1e-12));  // quadratic
}

BOOST_AUTO_TEST_CASE(an_upright_line_pulls_as_its_neighbours_do) {
  // Part of it on the bed, hung and hardly loaded at its foot, taut. Beside upright it swings as a pendulum does:
  // span = H (ln(V / V_bottom) / w + L / (E A)).
  for (const double rise : {60.0, 89.9, 90.0, 90.0134, 90.0135, 90.0136, 90.1, 95.0}) {
    const LinePull upright = pull_of(kTendon, 0.0, rise);
    BOOST_TEST(upright.horizontal == 0.0);
    for (const double span : {1e-300, 1e-100, 1e-15, 8e-12, 1e-11, 1e-9, 1e-7, 1e-5, 1e-4, 1e-3}) {
      BOOST_TEST_CONTEXT(rise << " m up, " << span << " m aside") {
        const LinePull pull = pull_of(kTendon, span, rise);
        const double foot = upright.downward - 90e3;
        // A millimetre aside lifts the foot of a line that hardly leaves the bed by as much as 4 N.
        BOOST_TEST(std::abs(pull.downward - upright.downward) < 5e-5 * upright.downward);
        BOOST_TEST(std::abs(pull.energy - upright.energy) < 0.1);  // H span / 2
        if (foot > 1.0)
          BOOST_TEST(pull.horizontal / span == 1.0 / (std::log(upright.downward / foot) / 1e3 + 90.0 / 3e8),
                     boost::test_tools::tolerance(1e-4));
        else
          BOOST_TEST(std::abs(pull.horizontal) < 1e3 * span);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(an_upright_line_is_taut_where_it_leaves_the_bed) {
  const double least = 90.0 + 1000.0 * 90.0 * 90.0 / (2.0 * 3e8);  // its rise under its own weight
  const LinePull slack = pull_of(kTendon, 0.0, least - 1e-6), taut = pull_of(kTendon, 0.0, least + 1e-6);
  BOOST_TEST(slack.downward == 90e3, boost::test_tools::tolerance(1e-7));
  BOOST_TEST(taut.downward == 90e3, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(taut.energy - slack.energy == 2e-6 * 90e3, boost::test_tools::tolerance(1e-4));
  BOOST_TEST(pull_of(kTendon, 0.0, 60.0).downward == 60e3, boost::test_tools::tolerance(1e-3));  // less its stretch
}

BOOST_AUTO_TEST_CASE(the_pull_of_a_line_is_the_slope_of_its_energy) {
  for (const auto& [span, rise] : {std::pair(190.0, 30.0), std::pair(202.7, 30.0), std::pair(204.5, 30.0)}) {
    const double d = 1e-4;
    const LinePull pull = pull_of(kChain, span, rise);
    const double along = (pull_of(kChain, span + d, rise).energy - pull_of(kChain, span - d, rise).energy) / (2.0 * d);
    const double up = (pull_of(kChain, span, rise + d).energy - pull_of(kChain, span, rise - d).energy) / (2.0 * d);
    BOOST_TEST(along == pull.horizontal, boost::test_tools::tolerance(1e-6));
    BOOST_TEST(up == pull.downward, boost::test_tools::tolerance(1e-6));
  }
}

BOOST_AUTO_TEST_CASE(a_fairlead_that_comes_down_to_its_anchor_ends_the_run_with_the_line_s_name) {
  model::Moored moored;
  moored.lines = {{{190, 0, -30}, {5, 0, 0}, 205, 1000, 3e8}, {{-190, 0, -6}, {-5, 0, -4}, 205, 1000, 3e8}};
  const structure::Mooring mooring(moored, {});
  const auto sunk_to = [&](double z) { return mooring.at({{0.0, 0.0, z}, {}}, {}); };
  BOOST_TEST(sunk_to(-1.999).load.force.z < 0.0);
  for (const double z : {-2.0, -2.5})
    BOOST_CHECK_EXCEPTION(sunk_to(z), RunError, [](const RunError& error) {
      const std::string said = error.what();
      BOOST_TEST_MESSAGE(said);
      return said.find("line 2 of structure.motion.lines") == 0 && said.find("lies at -6 m") != std::string::npos;
    });
}

BOOST_AUTO_TEST_CASE(the_load_of_springs_and_lines_is_the_slope_of_their_energy_at_any_pose) {
  model::Moored moored;
  moored.stiffness = {{{2e5, 1e4, 0, 0, 0, 5e4},
                       {1e4, 3e5, 0, 2e4, 0, 0},
                       {0, 0, 1e4, 0, 0, 0},
                       {0, 2e4, 0, 4e6, 0, 0},
                       {0, 0, 0, 0, 5e6, 1e5},
                       {5e4, 0, 0, 0, 1e5, 7e6}}};
  moored.pretension = {1e4, -2e4, 3e4, 5e4, -6e4, 7e4};
  moored.lines = {{{190, 0, -30}, {5, 0, 0}, 205, 1000, 3e8}, {{-150, 110, -30}, {-5, 3, 1}, 205, 1000, 3e8}};
  const Pose start{{-7.0, 0.0, 0.0}, {}};
  const structure::Mooring mooring(moored, start);
  const Vec3 shift{0.3, 0.0, 0.0};
  const Pose pose{{-5.5, 0.7, -0.2}, structure::rotation_by({0.3, -0.4, 0.9})};
  const Wrench load = mooring.at(pose, shift).load;
  const double d = 1e-5;
  const std::array<double, 6> found{load.force.x,  load.force.y,  load.force.z,
                                    load.moment.x, load.moment.y, load.moment.z};
  for (std::size_t i = 0; i < 6; ++i) {
    std::array<double, 6> step{};
    step[i] = d;
    const auto energy = [&](double sign) {
      const Vec3 way = sign * Vec3{step[0], step[1], step[2]}, turn = sign * Vec3{step[3], step[4], step[5]};
      return mooring.at({pose.position + way, structure::turned(pose.rotation, turn)}, shift).energy;
    };
    BOOST_TEST(-(energy(1.0) - energy(-1.0)) / (2.0 * d) == found[i], boost::test_tools::tolerance(1e-5));
  }
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
