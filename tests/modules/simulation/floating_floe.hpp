// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "afloat.hpp"
#include "brash/core/constants.hpp"
#include "brash/floes/floe_water.hpp"
#include "brash/io/case.hpp"
#include "brash/rigid_body/world.hpp"

namespace brash::simulation::testing {

/// The ice and the water of the validation case: 0.33 m of 900 kg/m3 on 1025 kg/m3.
inline model::Case ice_and_water(std::vector<std::string> overrides = {}) {
  overrides.insert(overrides.begin(), "output.statistics_from=0");
  return io::read_case(BRASH_SOURCE_DIR "/experiments/validation/second_reading.toml", overrides);
}

inline std::vector<std::string> without_drag() {
  return {"hydrodynamics.form_drag=0", "hydrodynamics.rotational_drag=0", "hydrodynamics.skin_friction=0"};
}

/// World, water and one rectangular floe, coupled as Simulation::step couples them.
struct FloatingFloe {
  FloatingFloe(double length, double breadth, model::Case resolved)
      : ice(std::move(resolved)), world({}), floes(ice), water(ice), l(length), b(breadth) {
    const std::vector<Vec2> ring{{-0.5 * l, -0.5 * b}, {0.5 * l, -0.5 * b}, {0.5 * l, 0.5 * b}, {-0.5 * l, 0.5 * b}};
    floes.add(world, afloat(ice, ring), 0.0);
    body = world.floes().front();
    rest = h() * (0.5 - ice.ice.density / ice.water.density);
  }
  FloatingFloe(const FloatingFloe&) = delete;
  FloatingFloe& operator=(const FloatingFloe&) = delete;

  void step(double dt) {
    water.apply(world, floes, dt, {});
    world.step(dt);
  }
  double h() const { return ice.ice.thickness; }
  double draft() const { return h() * ice.ice.density / ice.water.density; }
  const rigid_body::MassProperties& inertia() const { return floes.floes().at(body).inertia; }
  /// Height of the centre of mass above floating at rest [m].
  double heave() const { return world.pose(body).position.z - rest; }
  /// Angle about x [rad], for turns about x alone.
  double roll() const {
    const Quaternion q = world.pose(body).rotation;
    return 2.0 * std::atan2(q.x, q.w);
  }
  void place(double heave, double roll, const Twist& twist = {}) {
    world.set_state(body, {{0.0, 0.0, rest + heave}, {std::cos(0.5 * roll), std::sin(0.5 * roll), 0.0, 0.0}}, twist);
  }

  model::Case ice;
  rigid_body::World world;
  floes::FloePopulation floes;
  floes::FloeWater water;
  double l;
  double b;
  double rest = 0.0;  ///< height of the centre of mass at rest, Archimedes [m]
  BodyId body;
};

/// The mean period [s] of an oscillation and its turning points, the start first.
struct Oscillation {
  double period = 0.0;
  std::vector<double> turns;
};

/// Steps `floe` until `value` has crossed zero `crossings` times; crossings are found by linear interpolation, turning
/// points by the parabola through three samples.
template <typename Value>
Oscillation oscillate(FloatingFloe& floe, Value value, double dt, int crossings) {
  Oscillation result;
  double first = 0.0, last = 0.0, before = value(), now = before, time = 0.0;
  result.turns.push_back(now);
  for (int n = 0; n < crossings;) {
    floe.step(dt);
    const double next = value();
    if ((now - before) * (next - now) < 0.0) {
      const double slope = 0.5 * (next - before), bend = next - 2.0 * now + before;
      result.turns.push_back(now - 0.5 * slope * slope / bend);
    }
    if (now * next < 0.0) {
      last = time + dt * now / (now - next);
      if (++n == 1) first = last;
    }
    before = now;
    now = next;
    time += dt;
  }
  result.period = 2.0 * (last - first) / (crossings - 1);
  return result;
}

}  // namespace brash::simulation::testing
