// SPDX-License-Identifier: GPL-3.0-or-later
// Floes under the flat bottom of a hull: how much of it they cover, and how fast they slip along it.
#include <boost/test/unit_test.hpp>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/floes/coverage.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/regions.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

constexpr double kDraught = 3.0;
constexpr double kFriction = 0.1;
constexpr double kLength = 2.0;  ///< of the floe that slips [m]

/// A floe whose top lies `gap` below the keel.
BodyId add_below_keel(Pool& pool, Vec2 lower, Vec2 upper, double gap = 1e-4) {
  const BodyId floe = pool.add(lower, upper, {});
  Pose pose = pool.world.pose(floe);
  pose.position.z = -kDraught - gap - 0.5 * pool.resolved.ice.thickness;
  pool.world.set_state(floe, pose, {});
  return floe;
}

BOOST_AUTO_TEST_SUITE(under_hull)

/// A barge of 20 m by 8 m with vertical sides.
struct Barge : Pool {
  model::Case c = io::read_case(BRASH_SOURCE_DIR "/tests/modules/simulation/askew_barge.toml",
                                std::vector<std::string>{"structure.heading=0"});
  std::unique_ptr<const structure::Hull> hull = structure::make_hull(c.structure);
  floes::Coverage coverage{*hull, *structure::regions_of(c.structure, *hull), c.ice.thickness};

  double covered(model::HullRegion region, Pose at = {}) const {
    return coverage.by(world, floes, at)[static_cast<std::size_t>(region)];
  }
};

BOOST_FIXTURE_TEST_CASE(floes_below_the_keel_cover_their_share_of_the_bottom, Barge) {
  BOOST_TEST(covered(model::HullRegion::kBottom) == 0.0);
  add_below_keel(*this, {-4.0, -4.0}, {4.0, 2.0});
  // 48 of 160 m2, seen at some 300 places.
  BOOST_TEST(covered(model::HullRegion::kBottom) == 48.0 / 160.0, boost::test_tools::tolerance(0.05));
  BOOST_TEST(covered(model::HullRegion::kBow) == 0.0);
  // A second layer below it covers nothing more, and a floe at the surface covers a side.
  add_below_keel(*this, {-4.0, -4.0}, {4.0, 2.0}, 0.4);
  BOOST_TEST(covered(model::HullRegion::kBottom) == 48.0 / 160.0, boost::test_tools::tolerance(0.05));
  add({-10.0, 4.0}, {10.0, 6.0}, {});
  // 0.3 of 3 m of one side of two: less than the places can tell apart, but seen.
  BOOST_TEST(covered(model::HullRegion::kSides) > 0.0);
  BOOST_TEST(covered(model::HullRegion::kSides) < 0.1);
}

BOOST_FIXTURE_TEST_CASE(the_share_moves_with_the_hull, Barge) {
  add_below_keel(*this, {-4.0, -4.0}, {4.0, 4.0});
  const double before = covered(model::HullRegion::kBottom);
  BOOST_TEST(before == 0.4, boost::test_tools::tolerance(0.05));
  Pose moved;
  moved.position.x = 10.0;  // half of the floe is astern
  BOOST_TEST(covered(model::HullRegion::kBottom, moved) == 0.2, boost::test_tools::tolerance(0.05));
  moved.position.x = 15.0;
  BOOST_TEST(covered(model::HullRegion::kBottom, moved) == 0.0);
}

/// How fast a row of floes without gaps gets under the flat bottom of a hull that runs over it [m/s].
double speed_under_hull(double hull_speed, const std::string& shading, int n_floes = 1) {
  constexpr double kStep = 0.01;
  Pool pool({"ice.thickness=0.8", "hydrodynamics.structure_flow=false", "hydrodynamics.skin_friction=0", shading});
  pool.world = rigid_body::World({.ice_structure = {kFriction, 0.5e6}, .ice_ice = {0.3, 0.5e6}});
  std::vector<std::vector<Vec3>> box(1);
  for (const double x : {-100.0, 100.0})
    for (const double y : {-5.0, 5.0})
      for (const double z : {-kDraught, 3.0}) box.front().push_back({x, y, z});
  Pose hull;
  const BodyId structure = pool.world.add_structure(box, hull);
  std::vector<BodyId> row;
  for (int i = 0; i < n_floes; ++i)
    row.push_back(add_below_keel(pool, {-(i + 0.5) * kLength, -2.0}, {(0.5 - i) * kLength, 2.0}));
  const Twist moves{{hull_speed, 0.0, 0.0}, {}};
  for (int step = 0; step < 4000; ++step) {
    hull.position.x += hull_speed * kStep;
    pool.world.move_structure(structure, hull, moves);
    pool.water.apply(pool.world, pool.floes, kStep, {});
    pool.world.step(kStep);
  }
  const double first = pool.world.twist(row.front()).linear.x;
  BOOST_TEST(pool.world.twist(row.back()).linear.x == first, boost::test_tools::tolerance(1e-3));
  return first;
}

/// The friction of the floe is balanced by the drag on its front, docs/theory/structures.md, (K10):
///
///     mu (rho_w - rho_i) g l = 1/2 rho_w C_d w^2,  w the floe's speed through the water.
///
/// It sticks where w would be more than the hull's speed.
BOOST_AUTO_TEST_CASE(a_floe_under_a_flat_bottom_slips_at_the_speed_of_the_closed_balance) {
  const model::Case c = io::read_case(kValidation, {});
  const double lift = (c.water.density - c.ice.density) * kGravity;
  const double balance = std::sqrt(2.0 * kFriction * lift * kLength / c.water.density);
  BOOST_TEST(balance == 0.69, boost::test_tools::tolerance(0.01));
  for (const double speed : {0.5, 1.0, 2.0}) {
    const double found = speed_under_hull(speed, "hydrodynamics.shading=false");
    BOOST_TEST_MESSAGE("hull " << speed << " m/s: the floe has " << found << " m/s, the balance " << balance);
    BOOST_TEST(found == std::min(speed, balance), boost::test_tools::tolerance(5e-3));
  }
  // The hull shades the upper quarter of the front, by a quarter in the mean: (H8) with the gap h / 2.
  const double shaded = balance / std::sqrt(1.0 - 1.0 / 16.0);
  BOOST_TEST(speed_under_hull(1.0, "hydrodynamics.shading=true") == shaded, boost::test_tools::tolerance(0.01));
}

/// All floes of a carpet rub, and the first has the only free front. The others shade each other's fronts, but for the
/// lowest quarter, where (H8) leaves a quarter open: 1/16 of a front each, beside the first one's 15/16. The quadrature
/// of a face in the shade errs by 3 % of its free drag (docs/theory/water.md).
BOOST_AUTO_TEST_CASE(a_carpet_under_a_flat_bottom_has_little_more_drag_than_one_floe) {
  const std::string shading = "hydrodynamics.shading=true";
  const double alone = speed_under_hull(2.0, shading);
  for (const int n : {2, 4}) {
    const double found = speed_under_hull(2.0, shading, n);
    const double drag = n * (alone / found) * (alone / found);  // at one speed, beside one floe's
    BOOST_TEST_MESSAGE(n << " floes: " << found << " m/s, " << drag << " times the drag of one");
    BOOST_TEST(std::abs(drag - (1.0 + (n - 1) / 15.0)) < 0.03 * (n - 1));
  }
  BOOST_TEST(speed_under_hull(1.0, shading, 4) == 1.0, boost::test_tools::tolerance(5e-3));
}

BOOST_AUTO_TEST_SUITE_END()

}  // namespace
