// SPDX-License-Identifier: GPL-3.0-or-later
// Steps per second of floes jammed by a cone in a channel of fixed ice: bench_rigid_body_jam [floes] [seconds] [dt]
// [iterations].

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "brash/core/constants.hpp"
#include "brash/rigid_body/world.hpp"

using namespace brash;
using namespace brash::rigid_body;

namespace {

constexpr double kThickness = 0.33;
constexpr double kSide = 1.5;
constexpr double kGap = 0.01;

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

std::vector<Vec3> cone() {
  std::vector<Vec3> corners;
  for (const double z : {-5.68, 3.4})
    for (int i = 0; i < 64; ++i) {
      const double radius = 6.8 + z / std::tan(radians(61.4));
      corners.push_back({radius * std::cos(kPi * i / 32), radius * std::sin(kPi * i / 32), z});
    }
  return corners;
}

/// Hydrostatic springs at the four corners and linear drag: rough water, cheap against the contacts.
void float_on_water(World& world, BodyId id) {
  const Pose pose = world.pose(id);
  const Twist twist = world.twist(id);
  const double area = kSide * kSide;
  Wrench sum{{0, 0, -900 * kGravity * area * kThickness}, {}};
  for (const double x : {-0.3, 0.3})
    for (const double y : {-0.3, 0.3}) {
      const Vec3 r = rotate(pose.rotation, {x * kSide, y * kSide, 0});
      const double draught = std::clamp(kThickness / 2 - pose.position.z - r.z, 0.0, kThickness);
      const Vec3 v = velocity_at(twist, r);
      const Vec3 f = Vec3{0, 0, 1025 * kGravity * area / 4 * draught} - 300.0 * area / 4 * v;
      sum += {f, cross(r, f)};
    }
  world.apply(id, sum);
}

}  // namespace

int main(int argc, char** argv) {
  const int wanted = argc > 1 ? std::atoi(argv[1]) : 500;
  const double seconds = argc > 2 ? std::atof(argv[2]) : 5.0;
  const double dt = argc > 3 ? std::atof(argv[3]) : 0.01;
  WorldSettings settings;
  settings.ice_structure = {0.027, 0.5e6};
  settings.ice_ice = {0.3, 0.5e6};
  if (argc > 4) settings.iterations = std::atoi(argv[4]);
  World world(settings);

  const int columns = 14;
  const int rows = (wanted + columns - 1) / columns;
  const double pitch = kSide + kGap;
  const double start = 6.8 + 0.2;
  const double half = 0.5 * columns * pitch;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const double x = start + i * pitch;
      const double y = -half + j * pitch;
      const std::vector<std::vector<Vec2>> ring{rectangle(x, y, x + kSide, y + kSide)};
      const PlacedPrism placed = place_prism(ring, ring, kThickness, -0.02);
      world.add_floe(placed.prism, mass_properties(placed.prism, 900, 0.5), placed.pose);
    }
  const double end = start + rows * pitch + 0.05;
  for (const auto& wall :
       {rectangle(start - 3, -half - 5, end, -half - 0.02), rectangle(start - 3, half + 0.02, end, half + 5),
        rectangle(end, -half - 5, end + 5, half + 5)})
    world.add_sheet_part(wall, -0.185, 0.145);
  const std::vector<std::vector<Vec3>> hulls{cone()};
  const BodyId structure = world.add_structure(hulls, {});

  const std::vector<BodyId> floes = world.floes();
  const int steps = static_cast<int>(std::lround(seconds / dt));
  double spent = 0.0;
  double impulse = 0.0;
  std::size_t points = 0;
  for (int i = 0; i < steps; ++i) {
    for (const BodyId id : floes) float_on_water(world, id);
    Pose pose = world.pose(structure);
    pose.position.x += 1.202 * dt;
    world.move_structure(structure, pose, {{1.202, 0, 0}, {}});
    const std::clock_t before = std::clock();  // of this process: the machine may be shared
    world.step(dt);
    spent += static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    points += world.contacts().size();
    for (const ContactLoad& c : world.contacts())
      if (c.other == structure) impulse -= dt * (c.normal_force * c.normal.x + c.friction_force.x);
    if ((i + 1) % std::max(1, steps / 5) == 0)
      std::printf(
          "t %5.2f s  %6.0f steps/s so far, %zu bearing points, kinetic energy %.0f J, mean resistance %.1f kN\n",
          (i + 1) * dt, (i + 1) / spent, world.contacts().size(), world.kinetic_energy(),
          -1e-3 * impulse / ((i + 1) * dt));
  }
  std::printf("%zu floes, dt %g s, %d iterations: %.0f steps/s, %.0f bearing points a step\n", floes.size(), dt,
              settings.iterations, steps / spent, static_cast<double>(points) / steps);
}
