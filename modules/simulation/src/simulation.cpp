// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/simulation.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "laid_floes.hpp"
#include "stages.hpp"

namespace brash::simulation {

struct Simulation::Impl {
  Laws laws;
  Workers workers;
  State state;
  StageTimes times;
  std::vector<model::FloeRecord> initial_births;

  Impl(const model::Case& c, int threads) : laws(c), workers(threads), state(laws, laid_field(c), workers) { begin(); }
  Impl(const model::Case& c, const model::Checkpoint& checkpoint, int threads)
      : laws(c), workers(threads), state(laws, field_of(c, checkpoint), workers) {
    restore(state, laws, checkpoint);
  }

  void begin();
  void begin_watch();
  StepReport step();
};

void Simulation::Impl::begin() {
  const model::FieldSection& field = laws.resolved.field;
  initial_births = lay_floes(state, laws);
  begin_asleep(state, laws);
  state.energy.book_drift_at_start(state.sheets.kinetic_energy());
  if (model::has_level_ice(field) && field.initial_crack) {
    Step step(laws);
    initial_crack(state, laws, step);
    std::ranges::move(step.report.births, std::back_inserter(initial_births));
    times += step.report.times;
  }
  begin_watch();
}

/// The watchdog starts from the present state.
void Simulation::Impl::begin_watch() {
  State& s = state;
  model::LoadRow row;
  s.energy.report(s.world, s.floes, row, s.sheets.kinetic_energy());
  double births = 0.0;
  for (const auto& [body, floe] : s.floes.floes()) births += s.floes.energy(s.world, body, floe);
  s.watchdog.begin({s.world, s.floes, s.energy, s.field.ledger(), row, {}, s.motion->now().twist}, births);
}

StepReport Simulation::Impl::step() {
  Step step(laws);
  take(step, state, laws);
  times += step.report.times;
  return std::move(step.report);
}

Simulation::Simulation(const model::Case& resolved, int threads) : impl_(std::make_unique<Impl>(resolved, threads)) {}
Simulation::Simulation(const model::Case& resolved, const model::Checkpoint& checkpoint, int threads)
    : impl_(std::make_unique<Impl>(resolved, checkpoint, threads)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::drive(const structure::State& goal) { impl_->state.motion->drive(goal); }
void Simulation::drive(const Pose& goal) {
  impl_->state.motion->drive(structure::way_to(goal, impl_->state.motion->now().pose, impl_->laws.resolved.time.step));
}
void Simulation::drive(const Twist& twist) {
  impl_->state.motion->drive(structure::way_at(twist, impl_->state.motion->now().pose, impl_->laws.resolved.time.step));
}
const structure::State& Simulation::structure() const { return impl_->state.motion->now(); }
StepReport Simulation::step() { return impl_->step(); }
model::Checkpoint Simulation::checkpoint() const { return checkpoint_of(impl_->state, impl_->laws); }
double Simulation::time() const { return impl_->state.time(impl_->laws); }
const std::vector<model::FloeRecord>& Simulation::initial_births() const { return impl_->initial_births; }
std::vector<geometry::Polygon> Simulation::sheet() const { return outlines_in_world(impl_->state); }
std::vector<model::SheetMotion> Simulation::sheet_motions() const { return impl_->state.sheets.motions(); }
const geometry::Ledger& Simulation::ledger() const { return impl_->state.field.ledger(); }
const StageTimes& Simulation::stage_times() const { return impl_->times; }

std::vector<std::pair<std::int64_t, double>> Simulation::peak_stresses() const {
  std::vector<std::pair<std::int64_t, double>> stresses;
  for (const auto& [body, floe] : impl_->state.floes.floes())
    stresses.emplace_back(floe.id, floe.stress.peak_compression);
  return stresses;
}

model::Frame Simulation::frame() const {
  model::Frame frame{.time = time(), .structure = impl_->state.motion->now().pose, .floes = {}};
  std::vector<std::pair<BodyId, double>> forces;
  for (const rigid_body::ContactLoad& contact : impl_->state.world.contacts()) {
    if (contact.normal_force == 0.0) continue;
    forces.emplace_back(contact.body, contact.normal_force);
    forces.emplace_back(contact.other, contact.normal_force);
  }
  // Summed in the order of their sizes: the order of the contacts names tiles of the sheet, which a resumed run lays
  // again.
  std::ranges::sort(forces);
  // A run keeps its frames to the end: room for twice as many poses would be kept with them.
  frame.floes.reserve(impl_->state.floes.floes().size());
  for (const auto& [body, floe] : impl_->state.floes.floes()) {
    double sum = 0.0;
    auto force = std::ranges::lower_bound(forces, body, {}, &std::pair<BodyId, double>::first);
    for (; force != forces.end() && force->first == body; ++force) sum += force->second;
    frame.floes.push_back({floe.id, impl_->state.world.pose(body), sum});
  }
  return frame;
}

StageTimes& StageTimes::operator+=(const StageTimes& other) {
  contacts += other.contacts;
  failure += other.failure;
  cutting += other.cutting;
  water += other.water;
  world += other.world;
  loads += other.loads;
  recording += other.recording;
  return *this;
}

BreakCounts& BreakCounts::operator+=(const BreakCounts& other) {
  under_floes += other.under_floes;
  radial_first += other.radial_first;
  true_edge += other.true_edge;
  along_stress += other.along_stress;
  buckled += other.buckled;
  sheets_split += other.sheets_split;
  return *this;
}

}  // namespace brash::simulation
