// SPDX-License-Identifier: GPL-3.0-or-later
// Drag that is kept for a way, docs/theory/water.md, (H13) and (H14), against drag of every step; decision 5.
#include "brash/floes/kept_drag.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "brash/core/constants.hpp"
#include "floating_floe.hpp"

namespace {

using namespace brash;
using simulation::testing::FloatingFloe;
using simulation::testing::ice_and_water;

constexpr double kLength = 4.0;
constexpr double kBreadth = 3.0;

/// Error of the kept drag in a closing pack, and how often drag is recomputed.
struct PackDrag {
  double difference = 0.0;  ///< of the force from drag recomputed in the same state, rms over rms [-]
  double energy = 0.0;      ///< lost to the kept drag, over the loss to recomputed drag [-]
  double renewed = 0.0;     ///< share of the floes whose drag is recomputed in a step [-]
};

/// 6 x 6 floes of 1.4 m that run into the middle from gaps of 0.3 m, 1.5 s; `speed` [m/s]: of the corner floes.
PackDrag drag_of_closing_pack(double speed, const char* travel) {
  const model::Case ice = ice_and_water({std::string("hydrodynamics.drag_travel=") + travel});
  const double dt = 0.01, way = ice.hydrodynamics.drag_travel * ice.ice.thickness;
  rigid_body::World world({});
  floes::FloePopulation floes(ice);
  floes::FloeWater water_on_floes(ice);
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) {
      const Vec2 low{1.7 * i, 1.7 * j};
      const std::vector<Vec2> ring{low, low + Vec2{1.4, 0.0}, low + Vec2{1.4, 1.4}, low + Vec2{0.0, 1.4}};
      floes.add(world, simulation::testing::afloat(ice, ring), 0.0);
      const BodyId body = world.floes().back();
      world.set_state(body, world.pose(body), {std::sqrt(0.5) * speed / 2.5 * Vec3{2.5 - i, 2.5 - j, 0.0}, {}});
    }
  const hydrodynamics::Water water{.density = ice.water.density,
                                   .form_drag = ice.hydrodynamics.form_drag,
                                   .skin_friction = ice.hydrodynamics.skin_friction,
                                   .shading_gap = ice.hydrodynamics.shading_gap * ice.ice.thickness};
  double off = 0.0, all = 0.0, taken = 0.0, due = 0.0;
  int n_renewed = 0, n = 0;
  for (int step = 0; step < 150; ++step) {
    water_on_floes.apply(world, floes, dt, {});
    world.visit_neighbours(world.moving(), water_on_floes.reach(), [&](BodyId body, std::span<const Solid> neighbours) {
      const floes::Floe& floe = floes.floes().at(body);
      const Twist twist = world.twist(body);
      const hydrodynamics::StepInertia inertia{
          .dt = dt, .mass = floe.inertia.mass, .inertia = floe.inertia.inertia, .weight = floe.weight};
      const Wrench anew = water_load(floe.prism, world.pose(body), twist, water, inertia, neighbours).drag;
      off += dot(floe.drag.force - anew.force, floe.drag.force - anew.force);
      all += dot(anew.force, anew.force);
      taken += power(floe.drag, twist);
      due += power(anew, twist);
      n_renewed += floe.kept_drag.left == way ? 1 : 0;
      ++n;
    });
    world.step(dt);
  }
  return {std::sqrt(off / all), taken / due, static_cast<double>(n_renewed) / n};
}

}  // namespace

BOOST_AUTO_TEST_CASE(drag_that_is_kept_leads_a_floe_where_drag_of_every_step_does) {
  // On edge and out of the water by a third, adrift in a current and turning: it falls, dives and rights itself.
  const auto path = [&](const char* travel, double dt) {
    FloatingFloe floe(kLength, kBreadth,
                      ice_and_water({std::string("hydrodynamics.drag_travel=") + travel, "water.current=[0.5, 0]"}));
    floe.place(0.5, radians(70.0), {{0.5, -0.3, 0.0}, {0.2, 0.3, 0.1}});
    std::vector<Vec3> corners;  // every 10 ms for 5 s
    for (int i = 0; i < 500; ++i) {
      for (double t = 0.0; t < 0.01 - 0.5 * dt; t += dt) floe.step(dt);
      for (const Vec3 corner : {Vec3{2.0, 1.5, 0.0}, {-2.0, 1.5, 0.0}, {2.0, -1.5, 0.0}})
        corners.push_back(to_world(floe.world.pose(floe.body), corner));
    }
    return corners;
  };
  const auto farthest = [](const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, norm(a[i] - b[i]));
    return largest;
  };
  const std::vector<Vec3> each = path("0", 0.01);
  const double by_step = farthest(each, path("0", 0.001));
  const double kept = farthest(each, path("0.1", 0.01));
  BOOST_TEST_MESSAGE("corners within " << kept << " m; the step has an error of " << by_step << " m");
  BOOST_TEST(kept > 0.0);
  BOOST_TEST(kept < by_step);
}

BOOST_AUTO_TEST_CASE(drag_is_kept_for_a_way_on_which_a_turn_of_the_motion_counts_more) {
  const rigid_body::MassProperties mass{.mass = 4.0, .inertia = {1.0, 2.0, 9.0}};
  const double dt = 0.25;
  const auto way = [&](const Twist& taken_at, const Twist& now) {  // (H14) of a step
    floes::KeptDrag kept{{}, taken_at, 100.0};
    BOOST_REQUIRE(kept.follow(mass, now, dt).has_value());
    return 100.0 - kept.left;
  };
  const Twist surge{{2.0, 0.0, 0.0}, {}}, slow{{0.5, 0.0, 0.0}, {}}, back{{-2.0, 0.0, 0.0}, {}};
  const Twist sway{{0.0, 2.0, 0.0}, {}}, yaw{{}, {0.0, 0.0, 2.0}};
  const auto close = boost::test_tools::tolerance(1e-12);
  BOOST_TEST(way(surge, surge) == 2.0 * dt, close);
  BOOST_TEST(way(surge, slow) == 0.5 * dt, close);  // alike: the drag of another speed is known
  BOOST_TEST(way(slow, surge) == 2.0 * dt, close);
  BOOST_TEST(way(surge, back) == (1.0 + 20.0) * 2.0 * dt, close);
  BOOST_TEST(way(surge, sway) == (1.0 + 10.0 * std::sqrt(2.0)) * 2.0 * dt, close);
  BOOST_TEST(way(surge, yaw) == (1.0 + 10.0 * std::sqrt(2.0)) * 3.0 * dt, close);  // sqrt(36 / 4) m/s
  BOOST_TEST(way(surge, {}) == 0.0);
  BOOST_TEST(way({}, {}) == 0.0);

  floes::KeptDrag kept{{}, surge, 1.2};
  BOOST_TEST(kept.follow(mass, surge, dt).has_value());
  BOOST_TEST(kept.follow(mass, surge, dt).has_value());
  BOOST_TEST(!kept.follow(mass, surge, dt).has_value());
  BOOST_TEST(!floes::KeptDrag{}.follow(mass, {}, dt).has_value());  // there is none yet
  floes::KeptDrag at_rest{{}, {}, 1.2};
  BOOST_TEST(!at_rest.follow(mass, slow, dt).has_value());
}

BOOST_AUTO_TEST_CASE(a_floe_that_comes_into_the_water_has_drag_at_once) {
  double with_drag_of_every_step = 0.0;
  for (const char* travel : {"0", "0.1", "10"}) {
    FloatingFloe floe(kLength, kBreadth, ice_and_water({std::string("hydrodynamics.drag_travel=") + travel}));
    floe.place(1.0, 0.0);  // dropped flat
    double lowest = 0.0;
    for (int i = 0; i < 2000; ++i) {
      floe.step(0.001);
      lowest = std::min(lowest, floe.heave());
    }
    BOOST_TEST_MESSAGE("dropped from 1 m with drag kept for " << travel << " h: down to " << lowest << " m");
    if (with_drag_of_every_step == 0.0) with_drag_of_every_step = lowest;
    BOOST_TEST(lowest < -0.5);  // without drag it would go down about as far as it came from
    BOOST_TEST(lowest == with_drag_of_every_step, boost::test_tools::tolerance(0.01));
  }
}

BOOST_AUTO_TEST_CASE(a_floe_that_moves_on_takes_its_drag_anew_and_one_at_rest_does_not) {
  FloatingFloe drifts(kLength, kBreadth, ice_and_water({"water.current=[0.5, 0]"})),
      rests(kLength, kBreadth, ice_and_water());
  const double travel = 0.1 * drifts.h();
  int n_taken = 0;
  rests.place(0.0, 0.0, {{1.0, 0.0, 0.0}, {}});
  for (int i = 0; i < 2; ++i) rests.step(0.001);
  const double left = rests.floes.floes().at(rests.body).kept_drag.left;
  rests.place(0.0, 0.0);
  for (int i = 0; i < 100; ++i) {
    drifts.step(0.001);
    rests.step(0.001);
    if (drifts.floes.floes().at(drifts.body).kept_drag.left == travel) ++n_taken;
  }
  // Against the water it makes 0.05 m, a little less for the drag.
  BOOST_TEST(n_taken == 1 + static_cast<int>(0.049 / travel));
  BOOST_TEST(left == travel - 0.001, boost::test_tools::tolerance(0.01));  // left after its last step in motion
  BOOST_TEST(rests.floes.floes().at(rests.body).kept_drag.left == left);
}

BOOST_AUTO_TEST_CASE(kept_drag_of_a_closing_pack_is_near_that_of_every_step) {
  const PackDrag each = drag_of_closing_pack(1.7, "0");
  BOOST_TEST(each.difference < 1e-12);
  BOOST_TEST(each.renewed == 1.0);
  for (const double speed : {0.2, 0.6, 1.7}) {
    const PackDrag kept = drag_of_closing_pack(speed, "0.1");
    BOOST_TEST_MESSAGE("pack closing at " << speed << " m/s: drag off by " << kept.difference << ", energy "
                                          << kept.energy << ", taken anew by " << kept.renewed << " of the floes");
    BOOST_TEST(kept.difference < 0.05);
    BOOST_TEST(kept.energy == 1.0, boost::test_tools::tolerance(0.05));
    BOOST_TEST(kept.renewed < 0.2);
  }
}
