// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet at rest that stands for the moving one, against the moving trapezoid itself.
#include "brash/failure/edge_motion.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <iostream>

#include "brash/core/constants.hpp"
#include "brash/failure/edge_break.hpp"
#include "brash/failure/edge_responses.hpp"

namespace {

using namespace brash;
namespace tt = boost::test_tools;

const failure::IceProperties kIce{
    .thickness = 0.33, .youngs_modulus = 0.35e9, .flexural_strength = 539e3, .compressive_strength = 1e6};
constexpr double kDensity = 900.0, kMu1 = 0.511, kFriction = 0.027;
const double kSlope = radians(61.4);

/// The state of an edge that a surface has pushed for some time: N linear in the depth, the contact length fixed.
struct Pushed {
  failure::EdgeHistory history{0.0};
  double load = 0.0;  ///< N
};

Pushed push(const failure::EdgeDynamics& edge, const failure::LoadCase& shape, double speed, double until) {
  const double stiffness =
      kIce.compressive_strength * kIce.crushing_factor * shape.contact_length * (std::tan(kSlope) + kFriction);
  constexpr int kSteps = 60;
  Pushed result;
  for (int i = 1; i <= kSteps; ++i) {
    const double t = until * i / kSteps;
    const double away = i > 1 ? edge.deflection(shape, result.history, t) / std::tan(kSlope) : 0.0;
    result.load = stiffness * std::max(0.0, speed * t - away);
    result.history.extend(t, kMu1 * result.load, edge.memory());
  }
  return result;
}

BOOST_AUTO_TEST_CASE(a_sheet_that_stands_for_the_moving_one_breaks_as_the_moving_trapezoid_does) {
  const double l_c = failure::characteristic_length(kIce);
  const failure::EdgeSource model("");
  const failure::EdgeDynamics edge = failure::make_edge_dynamics(kIce, kDensity);
  const auto sheet = failure::make_criterion(model::FailureModel::kPlateOutline, "", kIce);
  struct Case {
    double depth, contact_length, angle, speed;
  };
  for (const auto& [b, c, theta, speed] :
       {Case{0.0, 0.3, 0.0, 1.202}, Case{0.0, 0.3, 0.0, 0.3}, Case{0.0, 1.5, 0.0, 1.202}, Case{0.0, 1.5, 0.0, 3.0},
        Case{0.4, 0.3, 60.0, 1.202}, Case{0.2, 0.3, 120.0, 1.202}, Case{0.2, 0.3, 120.0, 3.0},
        Case{0.1, 0.8, 90.0, 1.202}, Case{0.0, 6.0, 0.0, 1.202}, Case{0.0, 0.03, 0.0, 1.202},
        Case{0.1, 0.06, 60.0, 1.202}, Case{0.1, 0.06, 80.0, 1.202}, Case{0.2, 0.15, 80.0, 1.202},
        Case{0.4, 0.06, 80.0, 1.202}}) {
    const plate::EdgeGeometry geometry{.depth = b,
                                       .contact_length = c,
                                       .angle = radians(theta),
                                       .mass_ratio = failure::mass_ratio(kIce, kDensity),
                                       .thickness = kIce.thickness / l_c};
    const failure::EdgeBreak known = failure::break_edge(
        model.at(geometry).responses, kIce,
        {.speed = speed, .slope = kSlope, .friction = kFriction, .mu1 = kMu1, .contact_length = c * l_c});
    failure::LoadCase load{.depth = b * l_c, .contact_length = c * l_c, .angle = radians(theta), .mu1 = kMu1};
    const Pushed pushed = push(edge, load, speed, known.time);
    const double deflection = edge.deflection(load, pushed.history, known.time);
    load.pressure = pushed.load / (load.contact_length * kIce.thickness);
    load.motion = edge.motion(load, pushed.history);
    const failure::Assessment here = sheet->assess(load);
    const double stress = here.sigma_max / kIce.flexural_strength;
    std::cout << "b " << b << " c " << c << " theta " << theta << " V " << speed << ": N " << 1e-3 * pushed.load << " ("
              << 1e-3 * known.load << "), w " << deflection << " (" << known.deflection << "), stress " << stress
              << ", l " << here.breaking_length / l_c << " (" << known.breaking_length / l_c << "), scales "
              << load.motion.whole.length << " " << load.motion.whole.stress << " " << load.motion.whole.radial << "\n";
    BOOST_TEST(pushed.load == known.load, tt::tolerance(0.01));
    BOOST_TEST(deflection == known.deflection, tt::tolerance(0.03));
    BOOST_TEST(stress == 1.0, tt::tolerance(0.05));
    BOOST_TEST(std::abs(here.breaking_length - known.breaking_length) < 0.1 * l_c);
  }
}

/// How a run judges a bay: the true outline at rest stands for the moving one, by the motion of the straight edge that
/// its trapezoid is.
failure::EdgeBreak break_as_in_a_run(double deep, double angle, failure::LoadCase load, double speed, double longest) {
  const double l_c = failure::characteristic_length(kIce), tip = 0.5 * load.contact_length;
  const double root = tip + deep * std::tan(0.5 * angle), far = root + 3.0 * l_c;
  load.outline = {{-deep, -far}, {-deep, -root}, {0.0, -tip}, {0.0, tip}, {-deep, root}, {-deep, far}};
  const failure::EdgeDynamics edge = failure::make_edge_dynamics(kIce, kDensity);
  const auto sheet = failure::make_criterion(model::FailureModel::kPlateOutline, "", kIce);
  double holds = 0.0, breaks = longest;
  failure::EdgeBreak result;
  for (int halving = 0; halving < 9; ++halving) {
    result.time = 0.5 * (holds + breaks);
    const Pushed pushed = push(edge, load, speed, result.time);
    load.pressure = pushed.load / (load.contact_length * kIce.thickness);
    load.motion = edge.motion(load, pushed.history);
    const failure::Assessment here = sheet->assess(load);
    result.load = pushed.load;
    result.deflection = edge.deflection(load, pushed.history, result.time);
    result.breaking_length = here.breaking_length;
    (here.fails ? breaks : holds) = result.time;
  }
  return result;
}

// The limits are the errors that docs/theory/simulation.md states.
BOOST_AUTO_TEST_CASE(a_bay_of_a_run_breaks_nearly_as_the_moving_bay_does) {
  const double l_c = failure::characteristic_length(kIce);
  const failure::EdgeSource plate("fem");
  struct Case {
    double deep, contact_length, angle, speed;
  };
  for (const auto& [deep, c, theta, speed] : {Case{0.1, 0.3, 60.0, 1.202}, Case{0.4, 0.3, 60.0, 1.202},
                                              Case{0.4, 0.3, 120.0, 0.3}, Case{0.2, 1.0, 90.0, 1.202}}) {
    const plate::EdgeResponses responses = plate
                                               .at({.depth = -deep,
                                                    .contact_length = c,
                                                    .angle = radians(theta),
                                                    .mass_ratio = failure::mass_ratio(kIce, kDensity),
                                                    .thickness = kIce.thickness / l_c})
                                               .responses;
    const failure::EdgeBreak known = failure::break_edge(
        responses, kIce,
        {.speed = speed, .slope = kSlope, .friction = kFriction, .mu1 = kMu1, .contact_length = c * l_c});
    const failure::EdgeBreak here = break_as_in_a_run(
        deep * l_c, radians(theta), {.contact_length = c * l_c, .mu1 = kMu1}, speed, 2.0 * known.time);
    std::cout << "bay " << deep << " c " << c << " theta " << theta << " V " << speed << ": N " << 1e-3 * here.load
              << " (" << 1e-3 * known.load << "), w " << here.deflection << " (" << known.deflection << "), l "
              << here.breaking_length / l_c << " (" << known.breaking_length / l_c << ")\n";
    BOOST_TEST(here.load == known.load, tt::tolerance(0.06));
    BOOST_TEST(std::abs(here.breaking_length - known.breaking_length) < 0.25 * l_c);
  }
}

BOOST_AUTO_TEST_CASE(the_factor_of_the_edge_s_own_moment_is_bounded_where_that_moment_passes_through_zero) {
  // At rest it does so under contacts of some 11 l_c, and under the tips of narrow protrusions.
  const double l_c = failure::characteristic_length(kIce);
  const failure::EdgeDynamics edge = failure::make_edge_dynamics(kIce, kDensity);
  for (const auto& [depth, angle] : {std::pair(0.0, 0.0), std::pair(0.05, 40.0), std::pair(0.4, 40.0)})
    for (const double c : {0.05, 0.06, 0.07, 0.1, 0.3, 1.0, 4.0, 8.0, 9.0, 10.0, 11.0, 12.0}) {
      BOOST_TEST_CONTEXT("b " << depth << " c " << c) {
        const failure::LoadCase load{
            .depth = depth * l_c, .contact_length = c * l_c, .angle = radians(angle), .mu1 = kMu1};
        const failure::SheetMotion sheet = edge.motion(load, push(edge, load, 1.202, 0.3).history).whole;
        std::cout << "b " << depth << " c " << c << ": " << sheet.stress << " " << sheet.radial << "\n";
        BOOST_TEST(std::abs(sheet.radial) < 5.0);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_sheet_that_stands_for_a_moving_protrusion_is_no_longer_than_the_ice_s) {
  // Its outline holds the static hump where it is, and no length brings it as far in as the moving one.
  const double l_c = failure::characteristic_length(kIce), period = std::sqrt(l_c / kGravity);
  const failure::EdgeDynamics edge = failure::make_edge_dynamics(kIce, kDensity);
  for (const double b : {0.1, 0.2, 0.4})
    for (const double c : {0.06, 0.15})
      for (const double age : {0.2, 0.4, 0.8}) {
        const failure::LoadCase load{.depth = b * l_c, .contact_length = c * l_c, .angle = radians(70.0), .mu1 = kMu1};
        failure::EdgeHistory history(0.0);
        for (int i = 1; i <= 40; ++i) history.extend(age * period * i / 40.0, 1e3 * i, edge.memory());
        const failure::EdgeMotion motion = edge.motion(load, history);
        for (const failure::SheetMotion& sheet : {motion.whole, motion.split}) {
          BOOST_TEST(sheet.length <= 1.0);
          BOOST_TEST(sheet.length > 0.15);
        }
      }
}

BOOST_AUTO_TEST_CASE(a_contact_shorter_than_the_model_knows_keeps_its_force) {
  // The model begins at 0.05 l_c. On a straight edge a force is a force there. A tip is blunter in the model.
  struct Case {
    double depth, angle, close;
  };
  const failure::EdgeSource model(""), plate("fem");
  for (const auto& [depth, angle, close] : {Case{0.0, 0.0, 0.01}, Case{0.5, 60.0, 0.12}}) {
    const plate::EdgeGeometry edge{.depth = depth, .contact_length = 0.02, .angle = radians(angle)};
    const plate::EdgeResponses found = model.at(edge).responses, known = plate.at(edge).responses;
    const auto largest = [](const plate::EdgeResponses& r) {
      double most = 0.0;
      for (std::size_t i = 0; i < r.station.size(); ++i)
        if (r.station[i] > 0.3) most = std::max(most, r.static_axis_moment[i]);
      return most;
    };
    std::cout << "b " << depth << ": w " << found.static_deflection << " (" << known.static_deflection << "), m "
              << largest(found) << " (" << largest(known) << ")\n";
    BOOST_TEST(found.static_deflection == known.static_deflection, tt::tolerance(close));
    BOOST_TEST(largest(found) == largest(known), tt::tolerance(close));
  }
}

BOOST_AUTO_TEST_CASE(ice_thicker_than_the_model_s_is_the_plate_along_a_straight_line) {
  // The model ends at 0.14 l_c. The twin at rest of a sheet that moves is thicker over its l_c than the sheet.
  struct Case {
    double depth, contact_length, angle;
  };
  const failure::EdgeSource model(""), plate("fem");
  for (const auto& [b, c, theta] :
       {Case{0.0, 0.24, 0.0}, Case{0.0, 1.5, 0.0}, Case{0.12, 0.2, 115.0}, Case{0.4, 0.3, 60.0}}) {
    const double thickness = 0.2;
    const plate::EdgeGeometry edge{.depth = b,
                                   .contact_length = c,
                                   .angle = radians(theta),
                                   .mass_ratio = 0.88 * thickness,
                                   .thickness = thickness};
    BOOST_TEST(!model.at(edge).in_range);
    const plate::EdgeResponses found = model.at(edge).responses, known = plate.at(edge).responses;
    const auto largest = [&](const plate::EdgeResponses& r) {
      double most = 0.0;
      for (std::size_t i = 0; i < r.station.size(); ++i)
        if (r.station[i] > thickness) most = std::max(most, r.static_axis_moment[i]);
      return most;
    };
    std::cout << "b " << b << " c " << c << ": m " << largest(found) << " (" << largest(known) << "), edge "
              << found.static_edge_moment << " (" << known.static_edge_moment << ")\n";
    BOOST_TEST(largest(found) == largest(known), tt::tolerance(0.02));
    BOOST_TEST(found.static_edge_moment == known.static_edge_moment, tt::tolerance(0.04));
    double off = 0.0;
    for (std::size_t i = 0; i < found.time.size(); ++i)
      off = std::max(off, std::abs(found.deflection[i] - known.deflection[i]) / known.static_deflection);
    std::cout << "  deflection off by " << off << "\n";
    BOOST_TEST(off < 0.02);
  }
}

BOOST_AUTO_TEST_CASE(an_edge_of_another_thickness_moves_as_one_made_for_it) {
  failure::IceProperties thick = kIce;
  thick.thickness *= 1.2;
  const failure::EdgeDynamics made = failure::make_edge_dynamics(thick, kDensity);
  const failure::EdgeDynamics shared = failure::make_edge_dynamics(kIce, kDensity).of_thickness(thick.thickness);
  const failure::LoadCase shape{.depth = 0.5, .contact_length = 1.0, .angle = 1.0};
  const Pushed edge = push(made, shape, 1.202, 0.3);
  BOOST_TEST(made.memory() == shared.memory());
  BOOST_TEST(made.deflection(shape, edge.history, 0.3) == shared.deflection(shape, edge.history, 0.3));
  BOOST_TEST(made.deflection(shape, edge.history, 0.3) !=
             failure::make_edge_dynamics(kIce, kDensity).deflection(shape, edge.history, 0.3));
}

BOOST_AUTO_TEST_CASE(an_edge_that_is_pushed_slowly_is_at_rest) {
  const double l_c = failure::characteristic_length(kIce);
  const failure::EdgeDynamics edge = failure::make_edge_dynamics(kIce, kDensity);
  const failure::LoadCase load{.depth = 0.1 * l_c, .contact_length = 0.3 * l_c, .angle = 1.0, .mu1 = kMu1};
  failure::EdgeHistory history(0.0);
  for (int i = 1; i <= 400; ++i) history.extend(0.1 * i, 100.0 * i, edge.memory());
  const failure::EdgeMotion motion = edge.motion(load, history);
  for (const failure::SheetMotion& sheet : {motion.whole, motion.split}) {
    BOOST_TEST(sheet.length == 1.0, tt::tolerance(0.02));
    BOOST_TEST(sheet.stress == 1.0, tt::tolerance(0.02));
    BOOST_TEST(sheet.radial == 1.0, tt::tolerance(0.02));
  }
}

}  // namespace
