// SPDX-License-Identifier: GPL-3.0-or-later
// Each watchdog sees the fault that is put before it.
#include "watchdog.hpp"

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <limits>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/checkpoint.hpp"
#include "brash/recording/recording.hpp"
#include "brash/simulation/run.hpp"
#include "pool.hpp"

namespace {

using namespace brash;
using namespace brash::simulation;
using namespace brash::simulation::testing;

constexpr double kStep = 0.01;
constexpr Twist kTow{{1.202, 0.0, 0.0}, {}};  // of the case's structure
const std::pair<Vec3, Vec3> kHull{{-8.7, -8.7, -5.68}, {8.7, 8.7, 3.4}};

/// A pool with its own watchdog and a ledger of area that fits its floes.
struct Guarded : Pool {
  explicit Guarded(std::vector<std::string> overrides = {}) : Pool(std::move(overrides)), watchdog(resolved, kHull) {
    for (const Vec2 corner : {Vec2{0, 0}, Vec2{1.1, 0}, Vec2{0, 1.1}})
      bodies.push_back(
          add(corner, corner + Vec2{1, 1}, {{0.5 - 0.5 * corner.x, 0.3 - 0.4 * corner.y, 0}, {0, 0.1, 0.2}}));
    for (const auto& [body, floe] : floes.floes()) area.floes += floe.area;
    area.initial = area.floes;
    model::LoadRow row;
    ledger.report(world, floes, row);
    watchdog.begin(watched(row, {}));
  }
  void look(const model::LoadRow& row) { look(row, ledger.taken()); }
  void look(const model::LoadRow& row, const Taken& taken) { watchdog.look(watched(row, taken)); }
  Watched watched(const model::LoadRow& row, const Taken& taken) const {
    return {world, floes, ledger, area, row, taken, kTow};
  }
  void steps(int n) {
    for (int i = 0; i < n; ++i) look(step(kStep));
  }
  void kick(const Twist& change) {
    Twist twist = world.twist(bodies[1]);
    twist.linear += change.linear;
    twist.angular += change.angular;
    world.set_state(bodies[1], world.pose(bodies[1]), twist);
  }

  Watchdog watchdog;
  geometry::Ledger area;
  std::vector<BodyId> bodies;
};

/// Whether the error's text has `words`.
auto says(const std::string& words) {
  return [words](const RunError& error) {
    BOOST_TEST_MESSAGE(error.what());
    return std::string(error.what()).find(words) != std::string::npos;
  };
}

BOOST_AUTO_TEST_CASE(floes_that_collide_drift_and_tilt_pass) {
  Guarded still;
  BOOST_CHECK_NO_THROW(still.steps(300));
  Guarded drifting({"water.current=[0.5, 0.2]"});
  BOOST_CHECK_NO_THROW(drifting.steps(300));
}

/// Two floes in the same place, the second so much higher that they overlap by `depth` [m].
BOOST_AUTO_TEST_CASE(rigid_floes_that_the_engine_parts_pass) {
  for (const char* const engine : {"brash", "bullet"}) {
    for (const double depth : {0.02, 0.08}) {
      Guarded pool({"contact.crushing_bound=level-ice", std::string("contact.engine=") + engine});
      Pose lifted = pool.world.pose(pool.bodies[0]);
      lifted.position.z += 0.33 - depth;
      pool.world.set_state(pool.bodies[1], lifted, {});
      model::LoadRow row;
      pool.ledger.report(pool.world, pool.floes, row);
      pool.watchdog = Watchdog(pool.resolved, kHull);
      pool.watchdog.begin(pool.watched(row, {}));
      BOOST_CHECK_NO_THROW(pool.steps(100));
      BOOST_TEST(pool.world.pose(pool.bodies[1]).position.z > pool.world.pose(pool.bodies[0]).position.z);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_floe_faster_than_its_work_explains_ends_the_run) {
  Guarded pool;
  pool.steps(50);
  pool.kick({{0.0, 0.0, 0.7}, {}});
  BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("floe 1 of 445.5 kg has an energy of"));
}

BOOST_AUTO_TEST_CASE(a_floe_that_spins_faster_than_its_work_explains_ends_the_run) {
  Guarded pool;
  pool.steps(50);
  pool.kick({{}, {0.0, 0.0, 3.0}});
  BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("floe 1 of 445.5 kg has an energy of"));
}

BOOST_AUTO_TEST_CASE(a_floe_born_with_energy_ends_the_run) {
  Guarded pool;
  pool.steps(10);
  const BodyId late = pool.add({5, 5}, {6, 6}, {{1.0, 0.0, 0.0}, {}});
  pool.area.floes += pool.floes.floes().at(late).area;
  pool.area.initial += pool.floes.floes().at(late).area;
  BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("floe 3 of 445.5 kg has an energy of"));
}

/// A floe that a checkpoint finds short of its explained energy may get this energy back.
BOOST_AUTO_TEST_CASE(a_restored_watchdog_goes_on_with_the_accounts_of_the_first) {
  const Twist drift{{0.7, 0.0, 0.0}, {}};  // 109 J, of which the time step explains 87 J
  Guarded pool;
  pool.kick(drift);
  const model::LoadRow start = pool.step(kStep);
  pool.watchdog = Watchdog(pool.resolved, kHull);
  pool.watchdog.begin(pool.watched(start, {}));
  pool.kick({{-0.7, 0.0, 0.0}, {}});
  pool.steps(1);

  model::Checkpoint saved;
  pool.watchdog.save(pool.floes, saved);
  Watchdog restored(pool.resolved, kHull), anew(pool.resolved, kHull);
  restored.restore(pool.floes, saved);
  anew.begin(pool.watched(start, {}));
  pool.kick(drift);
  const model::LoadRow row = pool.step(kStep);
  BOOST_CHECK_NO_THROW(pool.look(row));
  BOOST_CHECK_NO_THROW(restored.look(pool.watched(row, pool.ledger.taken())));
  BOOST_CHECK_EXCEPTION(anew.look(pool.watched(row, pool.ledger.taken())), RunError, says("floe 1 of 445.5 kg has"));

  model::Checkpoint later, of_restored;
  pool.watchdog.save(pool.floes, later);
  restored.save(pool.floes, of_restored);
  BOOST_TEST((of_restored == later));
}

BOOST_AUTO_TEST_CASE(a_floe_outside_ends_the_run) {
  for (const Vec3 place : {Vec3{200, 0, 0}, Vec3{0, -200, 0}, Vec3{0, 0, 13}, Vec3{0, 0, -15}}) {
    Guarded pool;
    pool.steps(1);
    pool.world.set_state(pool.bodies[2], {place, {}}, {});
    BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("floe 2 is at"));
  }
}

BOOST_AUTO_TEST_CASE(a_floe_that_the_structure_may_have_pushed_out_of_the_field_passes) {
  Guarded pool;
  pool.steps(1);
  Pose place = pool.world.pose(pool.bodies[2]);
  place.position.x = 200.0;  // 150 m beyond the field, and 122 m from where the structure has come in 100 s
  pool.world.set_state(pool.bodies[2], place, {});
  model::LoadRow row = pool.step(kStep);
  row.time = 100.0;
  BOOST_CHECK_NO_THROW(pool.look(row));
}

BOOST_AUTO_TEST_CASE(contacts_or_still_water_that_give_energy_end_the_run) {
  Guarded pool;
  pool.steps(50);
  const model::LoadRow row = pool.step(kStep);
  const auto [contacts, water] = pool.ledger.taken();
  BOOST_CHECK_NO_THROW(pool.look(row, {contacts, water}));
  BOOST_CHECK_EXCEPTION(pool.look(row, {contacts - 1.0, water}), RunError, says("contacts gave the floes"));
  BOOST_CHECK_EXCEPTION(pool.look(row, {contacts, water - 20.0}), RunError, says("drag gave the floes"));
}

BOOST_AUTO_TEST_CASE(the_first_step_is_watched_like_any_other) {
  Guarded pool;
  const model::LoadRow row = pool.step(kStep);
  BOOST_CHECK_EXCEPTION(pool.look(row, {-1.0, 0.0}), RunError, says("contacts gave the floes"));
  Guarded kicked;
  kicked.kick({{0.0, 0.0, 0.7}, {}});
  BOOST_CHECK_EXCEPTION(kicked.steps(1), RunError, says("floe 1 of 445.5 kg has an energy of"));
}

BOOST_AUTO_TEST_CASE(a_ledger_that_does_not_close_ends_the_run) {
  Guarded pool;
  pool.steps(50);
  const geometry::Ledger area = pool.area;
  const geometry::ExactArea one_unit{1};
  pool.area.snap += one_unit;
  BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("the ledger does not close"));
  pool.area = area;
  pool.area.floes += one_unit;
  pool.area.sheet -= one_unit;
  BOOST_CHECK_EXCEPTION(pool.steps(1), RunError, says("the ledger does not fit the floes"));
  pool.area = area;
  model::LoadRow row = pool.step(kStep);
  row.energy_error += 200.0;  // three floes of 2900 N, half of it along 30 mm: 130 J
  BOOST_CHECK_EXCEPTION(pool.look(row), RunError, says("the energies do not close"));
  row.energy_error = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EXCEPTION(pool.look(row), RunError, says("the energies do not close"));
}

BOOST_AUTO_TEST_CASE(the_error_that_a_floe_has_left_passes_after_the_floe_has_gone) {
  Guarded pool;
  pool.steps(50);
  for (int i = 0; i < 2; ++i) {
    const BodyId body = pool.bodies.back();
    pool.bodies.pop_back();
    const floes::Floe& floe = pool.floes.at(body);
    pool.area.floes -= floe.area;
    pool.area.deleted += floe.area;
    pool.watchdog.remove(body, floe.weight);
    pool.ledger.remove(pool.world, pool.floes, body);
    pool.remove(body);
  }
  model::LoadRow row = pool.step(kStep);
  row.energy_error += 100.0;  // of three floes: 43 J each
  BOOST_CHECK_NO_THROW(pool.look(row));
  row.energy_error += 100.0;
  BOOST_CHECK_EXCEPTION(pool.look(row), RunError, says("the energies do not close"));
}

/// A run of the validation case to 2.5 s, where floes move; then `spoil` alters its checkpoint, and it goes on.
struct Spoilt {
  const model::Case resolved =
      io::read_case(kValidation, {"failure.model=wedge", "time.duration=3", "output.statistics_from=0"});
  const std::string file = (std::filesystem::temp_directory_path() / "brash-test-watchdog.nc").string();
  model::Checkpoint good;

  Spoilt() {
    std::filesystem::remove(file);
    double now = 0.0;
    (void)simulation::run(resolved, {.observer = [&](const Simulation& s, const StepReport&) { now = s.time(); },
                                     .checkpoint = recording::checkpoint_file(file, false),
                                     .interrupted = [&] { return now >= 2.5; }});
    good = io::read_checkpoint(file);
    BOOST_REQUIRE(good.table("floe").n_rows() > 5u);
  }
  ~Spoilt() { std::filesystem::remove(file); }

  void resume(const model::Checkpoint& spoilt, const std::string& reason) {
    io::write_checkpoint(file, spoilt);
    const RunOptions options{.checkpoint = recording::checkpoint_file(file, true)};
    std::string first;
    const auto keep = [&](const RunError& error) {
      first = error.what();
      return says(reason)(error) && says("step 251 failed, from t = 2.5 s")(error) && says(file)(error);
    };
    BOOST_CHECK_EXCEPTION(simulation::run(resolved, options), RunError, keep);
    // The checkpoint left behind is the state before the step. A run from it repeats the error.
    BOOST_TEST((io::read_checkpoint(file) == spoilt));
    BOOST_CHECK_EXCEPTION(simulation::run(resolved, options), RunError, says(first));
  }
};

/// Of the fourth floe.
double& floe_cell(model::Checkpoint& state, const char* column) {
  return std::get<std::vector<double>>(state.table("floe").column(column).values).at(3);
}

BOOST_AUTO_TEST_CASE(a_failed_step_ends_the_run_and_leaves_the_state_that_repeats_it) {
  Spoilt run;
  model::Checkpoint spoilt = run.good;
  floe_cell(spoilt, "x") += 1000.0;
  run.resume(spoilt, "floe 3 is at");

  spoilt = run.good;
  floe_cell(spoilt, "linear_z") = 1e200;  // its drag exceeds all numbers
  run.resume(spoilt, "not finite");

  spoilt = run.good;
  model::Table& ledger = spoilt.table("ledger");
  std::swap(ledger.column("crushed").values, ledger.column("floes").values);  // still the right sum
  run.resume(spoilt, "the ledger does not fit the floes");
}

}  // namespace
