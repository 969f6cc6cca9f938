// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/test/unit_test.hpp>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kPressure = 0.5e6;  // sigma_c R of Table 1's ice
constexpr double kConeAngle = radians(61.4);

WorldSettings bounded() {
  WorldSettings settings;
  settings.ice_structure.crushing_pressure = kPressure;
  settings.ice_ice.crushing_pressure = kPressure;
  return settings;
}

/// Largest force that a cone at 1.2 m/s exerts on a floe of 0.33 m in 0.5 s, and the floe's momentum [kN, N s].
struct Hit {
  double peak = 0.0;
  double momentum = 0.0;
};
Hit hit_by_cone(const WorldSettings& settings, double dt) {
  World world(settings);
  const BodyId structure = add_structure(world, cone(6.8, kConeAngle, 5.68, 3.4));
  // One metre wide and 2 m long, its near edge a centimetre from the cone at the waterline's upper edge.
  const double near = 6.8 + 0.165 / std::tan(kConeAngle) + 0.01;
  const BodyId floe = add_floe(world, rectangle({near, -0.5}, {near + 2, 0.5}), 0.33);
  Hit result;
  const int steps = static_cast<int>(std::lround(0.5 / dt));
  for (int i = 0; i < steps; ++i) {
    push(world, structure, {1.2, 0, 0}, dt);
    world.step(dt);
    result.peak = std::max(result.peak, total_normal_force(world));
  }
  result.momentum = 0.33 * 2 * kDensity * world.twist(floe).linear.x;
  return result;
}

}  // namespace

BOOST_AUTO_TEST_CASE(A_floe_pressed_beyond_its_strength_accelerates_at_pressure_times_area_over_mass) {
  World world(bounded());
  // A block of 0.1 x 0.2 m in the middle of the edge of a 3 m floe, 5 cm deep: the force passes the centre of mass.
  const BodyId wall = add_structure(world, box({-1, -0.1, -0.1}, {0.05, 0.1, 0.1}));
  const BodyId floe = add_floe(world, rectangle({0, -1.5}, {3, 1.5}), 0.4, {}, 0.5);
  const double dt = 0.001;
  push(world, wall, {2.0, 0, 0}, dt);
  world.step(dt);
  const double mass = 1.5 * kDensity * 9 * 0.4;
  const double area = 0.2 * 0.2;
  BOOST_TEST(world.twist(floe).linear.x == kPressure * area * dt / mass, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(norm(world.twist(floe).angular) < 1e-12);
  double sum = 0.0;
  double shares = 0.0;
  for (const ContactLoad& c : world.contacts()) {
    BOOST_TEST(c.at_bound);
    BOOST_TEST(c.depth == 0.05, boost::test_tools::tolerance(1e-9));
    BOOST_TEST(norm(c.normal - Vec3{1, 0, 0}) < 1e-12);
    sum += c.normal_force;
    shares += c.area;
  }
  BOOST_TEST(sum == kPressure * area, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(shares == area, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(A_kinematic_structure_pushes_with_the_velocity_it_was_given) {
  WorldSettings settings;  // no bound: one step brings the floe to the structure's velocity
  World world(settings);
  const BodyId wall = add_structure(world, box({-1, -2, -1}, {0.001, 2, 1}));
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.3);
  push(world, wall, {0.7, 0, 0}, 0.01);
  world.step(0.01);
  // 50 sequential impulses on four coplanar points leave 1e-8 m/s.
  BOOST_TEST(world.twist(floe).linear.x == 0.7, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(world.twist(wall).linear.x == 0.7);
  BOOST_TEST(world.pose(wall).position.x == 0.01 * 0.7);
  BOOST_TEST(total_normal_force(world) * 0.01 == 0.7 * kDensity * 4 * 0.3, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(A_sheet_that_drifts_into_a_floe_at_rest_loads_it_as_a_floe_that_drifts_into_a_sheet_at_rest) {
  // The same in two frames, whose velocities differ by that of the sheet.
  const double speed = 0.5, dt = 0.01;
  const WorldSettings settings{.ice_ice = {0.3, 0.5e6}};
  World drifts(settings), rests(settings);
  const std::vector<Vec2> tile = rectangle({0, -5}, {4, 5}), ice = rectangle({-2.003, -1}, {-0.003, 1});
  const BodyId sheet = drifts.add_sheet_part(tile, -0.2, 0.2);
  rests.add_sheet_part(tile, -0.2, 0.2);
  const BodyId still = add_floe(drifts, ice, 0.4);
  const BodyId moving = add_floe(rests, ice, 0.4, {{speed, 0.0, 0.0}, {}});
  for (int i = 1; i <= 20; ++i) {
    drifts.move_sheet_part(sheet, {{-speed * dt * i, 0, 0}, {}}, {{-speed, 0, 0}, {}});
    drifts.step(dt);
    rests.step(dt);
    BOOST_TEST(drifts.twist(still).linear.x == rests.twist(moving).linear.x - speed,
               boost::test_tools::tolerance(1e-9));
    BOOST_TEST(drifts.contacts().size() == rests.contacts().size());
  }
  BOOST_TEST(drifts.twist(still).linear.x < -0.1);
  // Without a call it stands still.
  drifts.step(dt);
  const double place = drifts.bounds(sheet).first.x;
  drifts.step(dt);
  BOOST_TEST(drifts.bounds(sheet).first.x == place);
}

BOOST_AUTO_TEST_CASE(No_force_acts_at_first_touch) {
  World world(bounded());
  const BodyId wall = add_structure(world, box({-1, -2, -1}, {0, 2, 1}));
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.3);
  push(world, wall, {1.0, 0, 0}, 0.01);
  world.step(0.01);
  BOOST_TEST(world.contacts().empty());
  BOOST_TEST(world.twist(floe).linear.x == 0.0);
}

BOOST_AUTO_TEST_CASE(Overlap_of_breakable_ice_is_not_pushed_apart) {
  World world(bounded());
  add_structure(world, box({-1, -2, -1}, {0.05, 2, 1}));
  const BodyId floe = add_floe(world, rectangle({0, -1}, {2, 1}), 0.3);
  for (int i = 0; i < 100; ++i) world.step(0.01);
  BOOST_TEST(world.pose(floe).position.x == 1.0);
  BOOST_TEST(world.kinetic_energy() == 0.0);
}

BOOST_AUTO_TEST_CASE(The_faces_between_parts_of_one_sheet_or_floe_are_no_surfaces) {
  // A floe of two parts pressed 3 cm into a free edge of three parts; the joints of both lie within the overlap or a
  // centimetre from its end. There the separating axis of a part alone would run along the edge.
  using Rings = std::vector<std::vector<Vec2>>;
  const Rings ring{rectangle({-2, -1}, {0.03, 1})};
  const auto press = [&](const Rings& parts, const Rings& sheet, double& area) {
    World world(bounded());
    for (const auto& part : sheet) world.add_sheet_part(part, -0.165, 0.165);
    const PlacedPrism placed = place_prism(ring, parts, 0.33, 0.0);
    const BodyId floe =
        world.add_floe(placed.prism, mass_properties(placed.prism, kDensity, 0.0), placed.pose, {{5, 0, 0}, {}});
    world.step(0.001);
    area = 0.0;
    for (const ContactLoad& c : world.contacts()) {
      BOOST_TEST(norm(c.normal - Vec3{-1, 0, 0}) < 1e-12);
      area += c.area;
    }
    return world.twist(floe);
  };
  double area = 0.0;
  const Twist whole = press(ring, {rectangle({0, -3}, {4, 3})}, area);
  BOOST_TEST(area == 2 * 0.33, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(whole.linear.x == 5 - kPressure * 0.66 * 0.001 / (kDensity * 2.03 * 2 * 0.33),
             boost::test_tools::tolerance(1e-9));

  const Rings halves{rectangle({-2, -1}, {0.03, 0.2}), rectangle({-2, 0.2}, {0.03, 1})};
  const Twist in_parts = press(
      halves, {rectangle({0, -3}, {4, 0.19}), rectangle({0, 0.19}, {4, 0.99}), rectangle({0, 0.99}, {4, 3})}, area);
  BOOST_TEST(area == 2 * 0.33, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(norm(whole.linear - in_parts.linear) < 1e-9);
  BOOST_TEST(norm(whole.angular - in_parts.angular) < 1e-9);

  // Behind a slanting joint the same area is seen twice: here 3 cm deep with a slope of 1 in 5.
  press(halves,
        {rectangle({0, -3}, {4, 0.19}),
         {{0, 0.19}, {4, 0.99}, {0, 0.99}},
         {{0, 0.19}, {4, 0.19}, {4, 0.99}},
         rectangle({0, 0.99}, {4, 3})},
        area);
  BOOST_TEST(area == (2 + 0.03 / 5) * 0.33, boost::test_tools::tolerance(1e-9));
}

BOOST_AUTO_TEST_CASE(A_corner_that_is_crushed_stops_the_floe_as_a_spring_would) {
  // A square floe runs with its right-angled corner into a wall: at depth d the section is 2 d wide, h high, so the
  // force p 2 h d is a spring's, and the peak is v sqrt(m p 2 h) after a quarter period. Second order in dt.
  const double h = 0.33;
  const double v = 0.5;
  const double r = std::sqrt(2.0) / 2;
  const double exact = v * std::sqrt(kDensity * h * kPressure * 2 * h);
  std::vector<double> errors;
  for (const double dt : {0.008, 0.004, 0.002, 0.001, 0.0005}) {
    World world(bounded());
    add_structure(world, box({-1, -3, -1}, {0, 3, 1}));
    const BodyId floe = add_floe(world, {{0, 0}, {r, -r}, {2 * r, 0}, {r, r}}, h, {{-v, 0, 0}, {}});
    double peak = 0.0;
    for (double t = 0.0; t < 0.2; t += dt) {
      world.step(dt);
      peak = std::max(peak, total_normal_force(world));
    }
    BOOST_TEST(std::abs(world.twist(floe).linear.x) < 1e-4 * v);  // the iterations leave a little of the last approach
    errors.push_back(std::abs(peak - exact) / exact);
  }
  BOOST_TEST_MESSAGE("relative errors of the peak: " << errors[0] << ' ' << errors[1] << ' ' << errors[2] << ' '
                                                     << errors[3] << ' ' << errors[4]);
  // The last step's impulse only stops the floe, so the largest force is found up to a step before the peak:
  // (w dt)^2 / 2 low. Semi-implicit Euler's amplitude is (w dt)^2 / 8 off; the rest is left to the solver.
  const double w = std::sqrt(2 * kPressure / kDensity);  // k = 2 h p, m = kDensity h of 1 m2: a quarter period of 47 ms
  double dt = 0.008;
  for (const double error : errors) {
    BOOST_TEST(error < std::pow(w * dt, 2));
    dt /= 2;
  }
}

BOOST_AUTO_TEST_CASE(The_peak_force_of_a_cone_on_a_floe_converges_with_the_time_step) {
  std::vector<double> peaks;
  for (const double dt : {0.02, 0.01, 0.005, 0.002, 0.001, 0.0005}) peaks.push_back(hit_by_cone(bounded(), dt).peak);
  BOOST_TEST_MESSAGE("bounded peaks [N]: " << peaks[0] << ' ' << peaks[1] << ' ' << peaks[2] << ' ' << peaks[3] << ' '
                                           << peaks[4] << ' ' << peaks[5]);
  // First order in dt: at 1 ms within 5 % of 0.5 ms, and the change falls.
  BOOST_TEST(std::abs(peaks[4] - peaks[5]) < 0.05 * peaks[5]);
  BOOST_TEST(std::abs(peaks[4] - peaks[5]) < std::abs(peaks[1] - peaks[2]));
}

BOOST_AUTO_TEST_CASE(Without_the_bound_the_peak_grows_as_one_over_the_time_step) {
  const double coarse = hit_by_cone({}, 0.01).peak;
  const double fine = hit_by_cone({}, 0.001).peak;
  // The same impulse in a tenth of the time; the floe's attitude at the first blow differs by centimetres of travel.
  BOOST_TEST(fine / coarse > 7.0);
}
