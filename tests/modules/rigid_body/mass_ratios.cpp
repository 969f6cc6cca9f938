// SPDX-License-Identifier: GPL-3.0-or-later
// Large floes that press small ones against a wall.
#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr double kThickness = 0.33;
/// Wind of 20 m/s on ice: density and drag coefficient of the air as in a case [Pa].
constexpr double kWindStress = 1.3 * 0.0015 * 20.0 * 20.0;
constexpr double kStrength = 0.5e6;  // sigma_c R [Pa]
/// Rounding of the energy that the contacts of a step take: impulses of 400 N s, velocities of 1e-3 m/s [J].
constexpr double kRounding = 1e-12;

WorldSettings settings(int sweeps) {
  return {.ice_structure = {0.027, kStrength}, .ice_ice = {0.3, kStrength}, .iterations = sweeps};
}

/// Floes of 1 m in a row before a wall, and behind them a floe of many times their mass. The wind drives all.
class Jam {
 public:
  /// @param y  of the row [m].
  Jam(World& world, double ratio, int n_small, double y) {
    for (int i = 0; i < n_small; ++i)
      small_.push_back(add_floe(world, rectangle({-i - 1.0, y - 0.5}, {-i * 1.0, y + 0.5}), kThickness));
    const double side = std::sqrt(ratio);
    large_ =
        add_floe(world, rectangle({-n_small - side, y - 0.5 * side}, {-n_small * 1.0, y + 0.5 * side}), kThickness);
    // No more than a quarter of what crushes a small floe.
    on_large_ = std::min(kWindStress * ratio, 0.25 * kStrength * kThickness);
    start_ = world.pose(large_).position.x;
  }
  void drive(World& world) const {
    for (const BodyId floe : small_) world.apply(floe, {{kWindStress, 0, 0}, {}});
    world.apply(large_, {{on_large_, 0, 0}, {}});
  }
  /// How far the large floe has come since the first touch [m].
  double sunk(const World& world) const { return world.pose(large_).position.x - start_; }
  /// Force on the wall, as a share of the drive [-].
  double on_wall(const World& world) const {
    double force = 0.0;
    for (const ContactLoad& contact : world.contacts())
      if (contact.body == small_.front() && contact.other_kind == BodyKind::kSheet) force += contact.normal_force;
    return force / (on_large_ + kWindStress * static_cast<double>(small_.size()));
  }

 private:
  std::vector<BodyId> small_;
  BodyId large_;
  double on_large_ = 0.0, start_ = 0.0;
};

World world_with_walls(int sweeps, const std::vector<double>& at) {
  World world(settings(sweeps));
  for (const double y : at) world.add_sheet_part(rectangle({0, y - 2}, {2, y + 2}), -0.2, 0.2);
  return world;
}

/// Energy that the contacts of the last step gave, 0 if they took some [J].
double given_by_contacts(const World& world) {
  double loss = 0.0;
  for (const ContactLoad& contact : world.contacts()) loss += contact.loss;
  return std::max(0.0, -loss);
}

/// Presses a jam for a minute at the default settings and checks it.
void check_a_minute(World& world, const std::vector<Jam>& jams) {
  constexpr double kStep = 0.01;
  constexpr int kSteps = 6000, kLast = 1000;
  double given = 0.0, last_change = 0.0;
  std::vector<double> on_wall(jams.size());
  for (int i = 0; i < kSteps; ++i) {
    for (const Jam& jam : jams) jam.drive(world);
    world.step(kStep);
    given = std::max(given, given_by_contacts(world));
    last_change += world.last_change() / kSteps;
    if (i < kSteps - kLast) continue;
    for (std::size_t k = 0; k < jams.size(); ++k) on_wall[k] += jams[k].on_wall(world) / kLast;
  }
  BOOST_TEST(given <= kRounding);
  for (std::size_t k = 0; k < jams.size(); ++k) {
    BOOST_TEST_MESSAGE("sunk by " << 1e3 * jams[k].sunk(world) << " mm, wall " << on_wall[k]
                                  << " of the drive, last change " << last_change << " m/s");
    BOOST_TEST(jams[k].sunk(world) < 5e-3);  // 1 m for 4e4 without long strides
    BOOST_TEST(std::abs(on_wall[k] - 1.0) < 0.01);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(A_large_floe_hardly_sinks_into_a_small_one_before_a_wall) {
  for (const double ratio : {1e2, 2.4e2, 2.6e2, 1e3, 1e4, 4e4, 1e6}) {
    BOOST_TEST_CONTEXT("mass ratio " << ratio) {
      World world = world_with_walls(30, {0.0});
      check_a_minute(world, {Jam(world, ratio, 1, 0.0)});
    }
  }
}

/// Each jam finds its own stride.
BOOST_AUTO_TEST_CASE(Jams_beside_each_other_do_not_disturb_each_other) {
  World world = world_with_walls(30, {0.0, 3000.0, 6000.0});
  check_a_minute(world, {Jam(world, 1e4, 2, 0.0), Jam(world, 1e6, 1, 3000.0), Jam(world, 4e4, 1, 6000.0)});
}
