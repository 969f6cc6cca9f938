// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's cone presses on ice: vertical over horizontal force is cot(angle + atan(friction)), by the failure room's
// load ratios, by a floe's contact in the World, and by a step against the fixed edge.
#include <fmt/format.h>

#include <boost/test/unit_test.hpp>

#include "brash/failure/criterion.hpp"
#include "brash/simulation/setup.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/structure/hull.hpp"
#include "floating_floe.hpp"

namespace {

using namespace brash;
using rigid_body::ContactLoad;
using rigid_body::World;
using simulation::testing::ice_and_water;

constexpr double kAngle = radians(61.4);
constexpr double kFriction = 0.027;
constexpr double kPressure = 0.5e6;  // sigma_c R of Table 1's ice

/// Vertical over horizontal force of a surface at `slope` on which ice slides down or up.
double ratio(double slope) { return 1.0 / std::tan(slope + std::atan(kFriction)); }

struct Pushed {
  Vec3 force{};        ///< on the floe [N]
  double slope = 0.0;  ///< of the facet ahead [rad]
  std::size_t points = 0;
};

/// The first push of the cone on a floe of 1 m by 2 m at the waterline, one facet square on to the floe's edge.
Pushed push_on_floe(double density_bound, bool downward, int facets) {
  rigid_body::WorldSettings settings;
  settings.ice_structure = {kFriction, density_bound};
  World world(settings);
  const auto breaking = downward ? model::Breaking::kDownward : model::Breaking::kUpward;
  const auto hull = structure::make_hull(model::Cone{kAngle, 13.6, 9.08, 5.68, breaking, facets});
  const double half_facet = kPi / facets;
  const Pose ahead{{}, {std::cos(0.5 * half_facet), 0.0, 0.0, std::sin(0.5 * half_facet)}};
  const BodyId body = world.add_structure(hull->parts(), ahead);

  const double h = 0.33;
  const double top = h * (1.0 - 900.0 / 1025.0);
  const double radius = structure::foremost(*hull, {}, top - h, top, {1.0, 0.0}).reach;
  const double near = radius * std::cos(half_facet) - 0.004;  // 4 mm into the edge
  const std::vector<std::vector<Vec2>> plan{{{near, -0.5}, {near + 2.0, -0.5}, {near + 2.0, 0.5}, {near, 0.5}}};
  const rigid_body::PlacedPrism placed = rigid_body::place_prism(plan, plan, h, top - 0.5 * h);
  world.add_floe(placed.prism, rigid_body::mass_properties(placed.prism, 900.0, 0.5), placed.pose);

  const double dt = 1e-3;
  Pose next = ahead;
  next.position.x += 1.202 * dt;
  world.move_structure(body, next, {{1.202, 0.0, 0.0}, {}});
  world.step(dt);
  Pushed result;
  for (const ContactLoad& c : world.contacts()) result.force += c.normal_force * c.normal + c.friction_force;
  result.points = world.contacts().size();
  // Half a facet from the vertex the cone is as steep as its apothem: tan = tan(angle) / cos(pi / facets).
  result.slope = std::atan(std::tan(kAngle) / std::cos(half_facet));
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_load_ratios_of_the_paper_s_cone_are_0_511) {
  const failure::LoadRatios ratios = failure::load_ratios(kAngle, kFriction, 0.0);
  BOOST_TEST_MESSAGE("load_ratios: P / N = " << ratios.mu1 << ", cot(angle + atan mu) = " << ratio(kAngle));
  BOOST_TEST(ratios.mu1 == ratio(kAngle), boost::test_tools::tolerance(1e-14));
  BOOST_TEST(ratios.mu1 == 0.511, boost::test_tools::tolerance(1e-3));  // three digits
}

BOOST_AUTO_TEST_CASE(a_floe_s_edge_met_head_on_by_the_cone_is_loaded_by_0_511) {
  constexpr double kRigid = std::numeric_limits<double>::infinity();
  for (const bool downward : {true, false}) {
    // Not rigid ice on four points, of which nothing says how they share the push: unequal shares spin the floe.
    for (const auto& [bound, facets] : {std::pair(kPressure, 64), std::pair(kPressure, 128), std::pair(kRigid, 64)}) {
      const Pushed pushed = push_on_floe(bound, downward, facets);
      BOOST_REQUIRE(pushed.points > 0u);
      const double found = (downward ? -1.0 : 1.0) * pushed.force.z / pushed.force.x;
      BOOST_TEST_MESSAGE((downward ? "downward" : "upward")
                         << ", bound " << bound << " Pa, " << facets << " facets: vertical / horizontal = " << found
                         << ", exact for the facet " << ratio(pushed.slope) << ", " << pushed.points << " points");
      BOOST_TEST(pushed.force.x > 0.0);
      // The facet's normal is found to 1e-9 of the hull's size; the floe does not stick, slip stays in its plane.
      BOOST_TEST(found == ratio(pushed.slope), boost::test_tools::tolerance(1e-6));
      BOOST_TEST(std::abs(pushed.force.y) < 1e-6 * pushed.force.x);
      if (facets == 128) BOOST_TEST(found == 0.511, boost::test_tools::tolerance(1e-3));  // three digits
    }
  }
}

BOOST_AUTO_TEST_CASE(the_fixed_edge_met_head_on_is_loaded_by_0_511) {
  // The level ice of the validation without its initial crack and too strong to break, at the first contact, which is
  // a chord of a few centimetres ahead of the cone.
  simulation::Simulation run(ice_and_water({"failure.model=wedge", "field.initial_crack=false",
                                            "ice.flexural_strength=1e8", "time.step=0.001", "time.duration=1"}));
  model::LoadRow row;
  while (norm(row.crushing.force) == 0.0) row = run.step().loads;
  const double found = row.crushing.force.z / row.crushing.force.x;
  BOOST_TEST_MESSAGE("first contact with the sheet: vertical / horizontal = " << found);
  BOOST_TEST(found == 0.511, boost::test_tools::tolerance(1e-3));  // three digits
  BOOST_TEST(std::abs(row.crushing.force.y) < 1e-6 * row.crushing.force.x);
}

BOOST_AUTO_TEST_CASE(unbreakable_ice_resists_a_cone_by_the_pressure_on_its_front_half) {
  // Once the cone has cut its channel its front half is inside the ice over the whole thickness. The pressure on it has
  // the resultant p tan(a) (Rt^2 - Rb^2), with the radii at the top and the bottom of the ice.
  const auto force_in_channel = [](const std::string& friction) {
    simulation::Simulation run(ice_and_water(
        {"failure.model=wedge", "field.initial_crack=false", "ice.flexural_strength=1e8", "structure.waterline_width=2",
         "structure.height=2", "structure.height_under_water=1", "structure.start_distance=1.1", "time.step=0.01",
         "time.duration=5", "ice.friction_structure=" + friction}));
    model::LoadRow row;
    while (run.time() < 3.0) row = run.step().loads;
    return row.crushing.force;
  };
  const double h = 0.33, top = h * (1.0 - 900.0 / 1025.0), bottom = top - h;
  const double outer = 1.0 + top / std::tan(kAngle), inner = 1.0 + bottom / std::tan(kAngle);
  const double exact = kPressure * std::tan(kAngle) * (outer * outer - inner * inner);
  const double found = force_in_channel("0").x;
  BOOST_TEST_MESSAGE("horizontal force " << found << " N, exact " << exact << " N");
  BOOST_TEST(exact == 307.6e3, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(found == exact, boost::test_tools::tolerance(2e-3));

  // Friction acts against the slip: along x it has the share sqrt(1 - sin^2 a cos^2 phi) of the normal force.
  const double friction =
      0.1 * kPressure * (outer * outer - inner * inner) / std::cos(kAngle) * std::comp_ellint_2(std::sin(kAngle));
  BOOST_TEST(force_in_channel("0.1").x == exact + friction, boost::test_tools::tolerance(2e-3));
}

BOOST_AUTO_TEST_CASE(a_compliant_cone_moves_under_its_own_load_as_the_oscillator_does) {
  const std::vector<std::string> keys{
      "structure.motion.kind=compliant", "structure.motion.mass=2e5", "structure.motion.stiffness=5e6",
      "structure.motion.damping=1e5",    "time.duration=3",           "failure.model=wedge"};
  simulation::Simulation run(ice_and_water(keys));
  const double dt = 0.01;
  double stretch = 0.0, velocity = 0.0, load = 0.0, farthest = 0.0;
  for (int step = 1; step <= 300; ++step) {
    // Velocity Verlet in a hundred parts of the step, under the load of the step before.
    const double part = dt / 100.0;
    const auto pull = [&](double q, double v) { return (load - 5e6 * q - 1e5 * v) / 2e5; };
    for (int i = 0; i < 100; ++i) {
      const double half = velocity + 0.5 * part * pull(stretch, velocity);
      stretch += part * half;
      velocity = (half + 0.5 * part * (load - 5e6 * stretch) / 2e5) / (1.0 + 0.5 * part * 1e5 / 2e5);
    }
    const model::LoadRow row = run.step().loads;
    const double offset = row.structure.x - (-7.0 + 1.202 * step * dt);
    farthest = std::min(farthest, offset);
    BOOST_TEST(std::abs(offset - stretch) < 1e-6);
    load = -row.total.force.x;  // Fx is positive against the motion
  }
  BOOST_TEST(farthest < -0.005);
}

BOOST_AUTO_TEST_CASE(unbreakable_ice_resists_a_plane_and_a_wedge_by_the_pressure_on_their_fronts) {
  // In its channel a front of the width w is inside the ice over the whole thickness. Its plan ahead is w h, whatever
  // the slope and the entrance; its plan from above is w h cot(a) / sin(entrance).
  const double h = 0.33, width = 2.0, entrance = radians(30.0), whole = kPressure * width * h;
  const auto force_of = [](const std::vector<std::string>& shape) {
    std::vector<std::string> keys{"failure.model=wedge",
                                  "field.initial_crack=false",
                                  "ice.friction_structure=0",
                                  "ice.flexural_strength=1e8",
                                  "structure.waterline_width=2",
                                  "structure.height=2",
                                  "structure.height_under_water=1",
                                  "structure.start_distance=4.2",
                                  "time.duration=6"};
    keys.insert(keys.end(), shape.begin(), shape.end());
    simulation::Simulation run(ice_and_water(keys));
    model::LoadRow row;
    while (run.time() < 5.5) row = run.step().loads;
    return row.crushing.force;
  };
  const Vec3 plane = force_of({"structure.kind=plane", "structure.length=8"});
  BOOST_TEST(plane.x == whole, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(plane.z == whole / std::tan(kAngle), boost::test_tools::tolerance(1e-6));
  const Vec3 bow = force_of({"structure.kind=wedge-bow", "structure.length=8", "structure.entrance=30 deg"});
  BOOST_TEST(bow.x == whole, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(bow.z == whole / (std::tan(kAngle) * std::sin(entrance)), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(std::abs(bow.y) < 1e-6 * bow.x);
  // A vertical wall leans over the ice by a tenth of a degree: docs/theory/structures.md, (K2).
  const Vec3 wall = force_of({"structure.kind=plane", "structure.length=8", "structure.angle=90 deg"});
  BOOST_TEST(wall.x == whole, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(wall.z == whole * std::tan(radians(0.1)), boost::test_tools::tolerance(1e-5));
  // Ice sticks to a steep rough front: the pressure on its area w h / sin(a) then acts along the motion, as the force
  // on a vertical front does.
  for (const double angle : {85.0, 89.0, 90.0}) {
    const double sine = std::sin(radians(std::min(angle, 89.9)));
    const Vec3 stuck = force_of({"structure.kind=plane", "structure.length=8", "ice.friction_structure=0.3",
                                 fmt::format("structure.angle={} deg", angle)});
    BOOST_TEST(stuck.x == whole / (sine * sine), boost::test_tools::tolerance(1e-6));
    BOOST_TEST(std::abs(stuck.z) < 1e-9 * stuck.x);
  }
}

BOOST_AUTO_TEST_CASE(a_front_that_is_all_but_vertical_has_scales_whatever_its_friction) {
  // Friction turns the vertical force of such a front round, and no failure model takes that.
  const simulation::DerivedScales scales =
      simulation::Setup(
          ice_and_water({"structure.angle=89.7 deg", "ice.friction_structure=0.1", "field.initial_crack=false"}))
          .scales;
  BOOST_TEST(scales.front_slope == radians(89.7), boost::test_tools::tolerance(1e-12));
  BOOST_TEST(scales.mu1 > 0.0);
}
