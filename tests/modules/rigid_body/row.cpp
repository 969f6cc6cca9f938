// SPDX-License-Identifier: GPL-3.0-or-later
// A row of floes that is pushed against a wall: the load of each contact is known. The messages are the table of
// docs/theory/contacts-and-bodies.md: test_rigid_body_row --log_level=message.
#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "helpers.hpp"

using namespace brash;
using namespace brash::rigid_body;
using namespace brash::rigid_body::testing;

namespace {

constexpr std::size_t kFloes = 12;
constexpr double kDrive = 78.0;       // on a floe [N]
constexpr double kSettling = 1.0;     // [s]
constexpr double kBatch = 0.1;        // [s]
constexpr std::size_t kBatches = 10;  // of which the mean and its interval are made
constexpr double kStudent = 2.262;    // 97.5 % of Student's t with kBatches - 1 degrees of freedom

using Loads = std::array<double, kFloes>;  ///< of the contacts, from the wall on [N]

Loads loads(const World& world, const std::vector<BodyId>& floes) {
  Loads result{};
  for (const ContactLoad& contact : world.contacts()) {
    // Ids ascend from the wall on, so the farther floe has the number of the contact.
    const BodyId farther =
        contact.other_kind == BodyKind::kSheet ? contact.body : std::max(contact.body, contact.other);
    result[static_cast<std::size_t>(std::ranges::find(floes, farther) - floes.begin())] += contact.normal_force;
  }
  return result;
}

/// Loads of a row, relative to the exact ones [-]: contact k carries the drives on the floes k, k + 1 and so on.
struct Row {
  double error = 0.0;     ///< of the mean of the contact whose mean is farthest off
  double interval = 0.0;  ///< half of the 95 % interval of that mean
  double scatter = 0.0;   ///< largest standard deviation of a contact's load
};

/// @param batches  mean loads of each batch [N]. @param squares  mean squares of each contact's load [N2].
Row compared(const std::array<Loads, kBatches>& batches, const Loads& squares) {
  Row row;
  for (std::size_t k = 0; k < kFloes; ++k) {
    const double exact = kDrive * static_cast<double>(kFloes - k);
    double mean = 0.0, variance = 0.0;
    for (const Loads& batch : batches) mean += batch[k] / kBatches;
    for (const Loads& batch : batches) variance += std::pow(batch[k] - mean, 2) / (kBatches - 1);
    row.scatter = std::max(row.scatter, std::sqrt(std::max(0.0, squares[k] - mean * mean)) / exact);
    if (std::abs(mean / exact - 1.0) < std::abs(row.error)) continue;
    row.error = mean / exact - 1.0;
    row.interval = kStudent * std::sqrt(variance / kBatches) / exact;
  }
  return row;
}

Row pushed_row(Engine engine, int sweeps, double dt) {
  World world({.ice_structure = {0.027, 0.5e6}, .ice_ice = {0.3, 0.5e6}, .iterations = sweeps, .engine = engine});
  world.add_sheet_part(rectangle({0, -2}, {2, 2}), -0.2, 0.2);
  std::vector<BodyId> floes;
  for (std::size_t i = 0; i < kFloes; ++i) {
    const auto x = -static_cast<double>(i);
    floes.push_back(add_floe(world, rectangle({x - 1.0, -0.5}, {x, 0.5}), 0.33));
  }
  const auto step = [&] {
    for (const BodyId floe : floes) world.apply(floe, {{kDrive, 0, 0}, {}});
    world.step(dt);
    return loads(world, floes);
  };
  for (int i = 0; i < std::lround(kSettling / dt); ++i) step();
  const long n = std::lround(kBatch / dt);
  std::array<Loads, kBatches> batches{};
  Loads squares{};
  for (Loads& batch : batches)
    for (long i = 0; i < n; ++i) {
      const Loads now = step();
      for (std::size_t k = 0; k < kFloes; ++k) {
        batch[k] += now[k] / static_cast<double>(n);
        squares[k] += now[k] * now[k] / static_cast<double>(n * kBatches);
      }
    }
  return compared(batches, squares);
}

}  // namespace

BOOST_AUTO_TEST_CASE(Each_contact_of_a_row_carries_the_drives_behind_it) {
  for (const Engine engine : {Engine::kBrash, Engine::kBullet})
    for (const double dt : {0.75e-3, 1.5e-3, 3e-3})
      for (const int sweeps : {30, 100, 300}) {
        const Row row = pushed_row(engine, sweeps, dt);
        BOOST_TEST_MESSAGE((engine == Engine::kBrash ? "brash" : "bullet")
                           << ", step " << 1e3 * dt << " ms, " << sweeps << " sweeps: error " << row.error << " +- "
                           << row.interval << ", scatter " << row.scatter);
        // A contact that carries one drive too much has 0.08 at the wall.
        if (engine == Engine::kBrash) BOOST_TEST(std::abs(row.error) < 1e-3);
      }
}
