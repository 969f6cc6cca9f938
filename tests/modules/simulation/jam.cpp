// SPDX-License-Identifier: GPL-3.0-or-later
// Floes jammed in a basin of fixed walls by a moving wall and a current: nothing flies, nothing crosses a wall.
// BRASH_JAM_COLUMNS, BRASH_JAM_ROWS and BRASH_JAM_SECONDS set its size.
#include <boost/test/unit_test.hpp>

#include "brash/statistics/random.hpp"
#include "floating_floe.hpp"

namespace {

using namespace brash;
using floes::FloePopulation;
using rigid_body::World;

constexpr int kColumns = BRASH_JAM_COLUMNS;  // along x, the moving wall's way
constexpr int kRows = BRASH_JAM_ROWS;
constexpr double kSeconds = BRASH_JAM_SECONDS;
constexpr double kPitch = 1.5;
/// Of the moving wall [m/s]: in the end it has taken a fifth of the basin, and the floes, 81 % of it, fill the rest.
constexpr double kSpeed = 0.2 * kColumns * kPitch / kSeconds;
constexpr double kHeight = 3.0;  // of the walls above and below the water [m]
constexpr double kThick = 5.0;   // of the walls [m]
constexpr double kStep = 0.01;

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

/// A field of quadrilaterals with open water between them in a basin of x in [0, length], y in [0, width].
struct Basin {
  Basin()
      : ice(simulation::testing::ice_and_water({"water.current=[0.3, 0]"})), world(settings()), floes(ice), water(ice) {
    for (const auto& side :
         {rectangle(-kThick, -kThick, length + kThick, 0.0), rectangle(-kThick, width, length + kThick, width + kThick),
          rectangle(length, 0.0, length + kThick, width)})
      world.add_sheet_part(side, -kHeight, kHeight);
    std::vector<Vec3> hull;
    for (const double x : {-kThick, 0.0})
      for (const double y : {0.01, width - 0.01})
        for (const double z : {-kHeight, kHeight}) hull.push_back({x, y, z});
    wall = world.add_structure(std::span(&hull, 1), {});
    lay_floes();
  }

  static rigid_body::WorldSettings settings() { return {.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}}; }

  /// Cells of a lattice whose inner nodes are moved at random by up to a quarter of the pitch, each shrunk by a tenth.
  void lay_floes() {
    statistics::RandomStream random(1, "jam", 0, "field");
    std::vector<std::vector<Vec2>> node(kColumns + 1, std::vector<Vec2>(kRows + 1));
    for (int i = 0; i <= kColumns; ++i)
      for (int j = 0; j <= kRows; ++j) {
        const double dx = 0.5 * (random.uniform() - 0.5), dy = 0.5 * (random.uniform() - 0.5);
        const bool inner = i > 0 && i < kColumns && j > 0 && j < kRows;
        node[i][j] = kPitch * Vec2{i + (inner ? dx : 0.0), j + (inner ? dy : 0.0)};
      }
    for (int i = 0; i < kColumns; ++i)
      for (int j = 0; j < kRows; ++j) {
        const std::vector<Vec2> cell{node[i][j], node[i + 1][j], node[i + 1][j + 1], node[i][j + 1]};
        const Vec2 middle = 0.25 * (cell[0] + cell[1] + cell[2] + cell[3]);
        std::vector<Vec2> ring;
        for (const Vec2 corner : cell) ring.push_back(middle + 0.9 * (corner - middle));
        BOOST_REQUIRE(floes.add(world, simulation::testing::afloat(ice, ring), 0.0).has_value());
      }
  }

  void step() {
    rigid_body::World& w = world;
    Pose next = w.pose(wall);
    next.position.x += kSpeed * kStep;
    w.move_structure(wall, next, {{kSpeed, 0.0, 0.0}, {}});
    water.apply(w, floes, kStep, {});
    w.step(kStep);
  }

  double length = kColumns * kPitch;
  double width = kRows * kPitch;
  model::Case ice;
  World world;
  floes::FloePopulation floes;
  floes::FloeWater water;
  BodyId wall;
};

/// The worst that was seen of the floes so far.
struct Extremes {
  double fastest = 0.0;  ///< [m/s]
  double spin = 0.0;     ///< [rad/s]
  double highest = 0.0;  ///< [m]
  double lowest = 0.0;   ///< [m]
  double nearest = 1e9;  ///< of a centre to a wall's surface, negative behind it [m]
  double most_energy = 0.0;
  std::size_t contacts = 0;

  void look(const Basin& basin) {
    const double front = basin.world.pose(basin.wall).position.x;
    for (const auto& [body, floe] : basin.floes.floes()) {
      const Vec3 p = basin.world.pose(body).position;
      const Twist twist = basin.world.twist(body);
      BOOST_REQUIRE(std::isfinite(p.x + p.y + p.z + norm(twist.linear) + norm(twist.angular)));
      fastest = std::max(fastest, norm(twist.linear));
      spin = std::max(spin, norm(twist.angular));
      highest = std::max(highest, p.z);
      lowest = std::min(lowest, p.z);
      nearest = std::min({nearest, p.x - front, basin.length - p.x, p.y, basin.width - p.y});
    }
    most_energy = std::max(most_energy, basin.world.kinetic_energy());
    contacts = std::max(contacts, basin.world.contacts().size());
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_jam_neither_explodes_nor_passes_through_a_wall) {
  Basin basin;
  Extremes seen;
  const int steps = static_cast<int>(std::lround(kSeconds / kStep));
  for (int i = 1; i <= steps; ++i) {
    basin.step();
    seen.look(basin);
    if (i % std::max(1, steps / 12) == 0)
      BOOST_TEST_MESSAGE("t = " << i * kStep << " s: " << basin.world.contacts().size()
                                << " bearing points, kinetic energy " << basin.world.kinetic_energy()
                                << " J, fastest so far " << seen.fastest << " m/s, heights " << seen.lowest << " to "
                                << seen.highest << " m, nearest to a wall " << seen.nearest << " m");
  }
  BOOST_TEST_MESSAGE(basin.floes.floes().size() << " floes: fastest " << seen.fastest << " m/s, spin " << seen.spin
                                                << " rad/s, most bearing points " << seen.contacts);
  BOOST_TEST(basin.floes.floes().size() == static_cast<std::size_t>(kColumns * kRows));
  BOOST_TEST(seen.contacts > basin.floes.floes().size());  // a jam: more points than floes
  BOOST_TEST(seen.nearest > 0.0);
  // The bound is the wall's speed plus the speed of a floe. A floe that rises or slips off a pile reaches
  // sqrt(2 (1 - rho_i/rho_w) g h) = 0.9 m/s. A floe that falls from its own length reaches sqrt(2 g 1.5) = 5.4 m/s.
  // Contacts that throw ice would exceed the bound at once.
  BOOST_TEST(seen.fastest < kSpeed + std::sqrt(2.0 * kGravity * kPitch));
  BOOST_TEST(seen.highest < kHeight);
  BOOST_TEST(seen.lowest > -kHeight);
}
