// SPDX-License-Identifier: GPL-3.0-or-later
// The coupled step against its floor: bench_coupled [seconds] [repetitions].
//
// The validation run goes step by step. Beside it Bullet's own world steps the same floes, sheet and structure, set to
// the run's state before each step, with the run's margin and iterations. Only the two steps are timed, in the
// process's own time, one after the other. Prints a JSON object.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "brash/io/case.hpp"
#include "brash/simulation/setup.hpp"
#include "brash/simulation/simulation.hpp"
#include "brash/structure/hull.hpp"
#include "bullet_world.hpp"

namespace {

using namespace brash;
using benchmarks::BulletWorld;
using benchmarks::FloeThen;

double process_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

struct Times {
  double coupled = 0.0;
  double bullet = 0.0;
  double n_bullet_points = 0.0;
  std::size_t n_floes = 0;
};

std::vector<FloeThen> floes_of(const model::Checkpoint& state) {
  const model::Table& table = state.table("floe");
  std::vector<FloeThen> floes(table.n_rows());
  for (std::size_t i = 0; i < floes.size(); ++i) {
    model::RestoredRow row(table, i);
    row("id", "", "", floes[i].id);
    row("outline", "", "", floes[i].outline);
    model::visit_pose(floes[i].pose, row);
    model::visit_twist(floes[i].twist, row);
  }
  return floes;
}

Times run(const model::Case& c, double seconds) {
  simulation::Simulation simulation(c);
  BulletWorld bullet(c);
  const double dt = c.time.step;
  const double speed = model::speed(c.structure.motion);
  const auto structure_at = [&](int step) {
    return Pose{{-c.structure.start_distance + step * dt * speed, 0.0, 0.0}, {}};
  };
  bullet.add_structure(structure::make_hull(c.structure.shape)->parts().front(), structure_at(0));
  const simulation::DerivedScales slab = simulation::Setup(c).scales;
  Times times;
  const int n_steps = static_cast<int>(std::lround(seconds / dt));
  std::vector<geometry::Polygon> sheet;
  for (int i = 0; i < n_steps; ++i) {
    const std::vector<FloeThen> floes = floes_of(simulation.checkpoint());
    std::vector<geometry::Polygon> sheet_now = simulation.sheet();
    const double before = process_seconds();
    static_cast<void>(simulation.step());
    times.coupled += process_seconds() - before;

    if (sheet_now != sheet) bullet.set_sheet(sheet = std::move(sheet_now), -slab.draft, slab.freeboard);
    bullet.set_floes(floes);
    bullet.place_structure(structure_at(i), structure_at(i + 1), {speed, 0.0, 0.0});
    const double ready = process_seconds();
    bullet.step(dt);
    times.bullet += process_seconds() - ready;
    times.n_bullet_points += bullet.n_points();
    times.n_floes = floes.size();
  }
  times.n_bullet_points /= n_steps;
  return times;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc > 1 ? std::atof(argv[1]) : 10.0;
  const int repetitions = argc > 2 ? std::atoi(argv[2]) : 5;
  const model::Case c = io::read_case(BRASH_SOURCE_DIR "/experiments/validation/cone.toml", {});
  std::string rows;
  for (int i = 0; i < repetitions; ++i) {
    const Times t = run(c, seconds);
    rows += fmt::format("{}{{\"coupled_s\": {:.4f}, \"bullet_s\": {:.4f}, \"bullet_points\": {:.0f}, \"floes\": {}}}",
                        i == 0 ? "" : ", ", t.coupled, t.bullet, t.n_bullet_points, t.n_floes);
  }
  fmt::print("{{\"simulated_s\": {}, \"runs\": [{}]}}\n", seconds, rows);
}
