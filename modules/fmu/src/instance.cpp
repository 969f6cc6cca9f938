// SPDX-License-Identifier: GPL-3.0-or-later
#include "instance.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/failure/model_files.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/motion.hpp"

namespace brash::fmu {
namespace {

/// A host adds up its times, and may be off by this part of a time step [-].
constexpr double kTimeTolerance = 1e-3;
/// Numbers of time steps beyond this are a mistake, and a double does not count them one by one [-].
constexpr double kMostSteps = 0x1p53;
/// An angle of more turns than these is a mistake: a sine of 1e9 rad says nothing about where a structure is [rad].
constexpr double kMostAngle = 1000.0 * 2.0 * kPi;

const char* name_of(Phase phase) {
  switch (phase) {
    case Phase::kInstantiated:
      return "instantiated";
    case Phase::kInitialization:
      return "in initialization mode";
    case Phase::kStepping:
      return "between steps";
    case Phase::kTerminated:
      return "terminated";
  }
  return "";
}

Outputs outputs_of(const model::LoadRow& row) {
  const Vec3 place{row.structure.x, row.structure.y, row.height};
  const Twist twist{{row.velocity.x, row.velocity.y, row.rise}, row.spin};
  return {row.total, row.crushing, row.floe_normal, row.floe_friction, place, row.attitude, twist, row.regions};
}

/// Loads and velocities added; the pose of the later one.
Outputs joined(Outputs sum, const Outputs& next) {
  sum.total += next.total;
  sum.crushing += next.crushing;
  sum.floe_normal += next.floe_normal;
  sum.floe_friction += next.floe_friction;
  sum.twist.linear += next.twist.linear;
  sum.twist.angular += next.twist.angular;
  sum.place = next.place;
  sum.attitude = next.attitude;
  for (std::size_t i = 0; i < sum.regions.size(); ++i) {
    sum.regions[i].total += next.regions[i].total;
    sum.regions[i].crushing += next.regions[i].crushing;
  }
  return sum;
}

Outputs mean_of(Outputs sum, double n) {
  for (Wrench* const load : {&sum.total, &sum.crushing, &sum.floe_normal, &sum.floe_friction})
    *load = {load->force / n, load->moment / n};
  for (model::RegionLoad& load : sum.regions) load = {load.total / n, load.crushing / n};
  sum.twist = {sum.twist.linear / n, sum.twist.angular / n};
  return sum;
}

/// The number that a `visit` names at this place.
template <typename Owner>
auto& nth_number(Owner& owner, std::size_t place) {
  std::conditional_t<std::is_const_v<Owner>, const double, double>* found = nullptr;
  Owner::visit(owner, [&](const auto&, const auto&, const auto&, auto& number) {
    if (place-- == 0) found = &number;
  });
  BRASH_EXPECTS(found != nullptr, place);
  return *found;
}

Unit read_unit(const std::string& resources) {
  const std::string path = resources + "/" + kUnitFile;
  Unit unit = unit_from(read_json_text(path, "the case of the unit (JSON)"), path);
  for (std::string* const file : model::files_of(unit.resolved))
    if (!file->empty()) *file = resources + "/" + *file;
  return unit;
}

}  // namespace

Instance::Instance(const std::string& resources, const std::string& token)
    : resources_(resources), unit_(read_unit(resources)), variables_(variables_of(unit_)) {
  if (token != unit_.token)
    throw InputError(Complaint{"the token of the host", "is " + token, unit_.token + ", as in modelDescription.xml",
                               "take description and library from the same unit"});
  failure::use_models_in(resources + "/" + kModelFolder);
  reset();
}

void Instance::expect(const char* call, std::initializer_list<Phase> phases) const {
  if (std::ranges::find(phases, state_.phase) == phases.end())
    throw std::runtime_error(fmt::format("{} is not allowed: the instance is {}", call, name_of(state_.phase)));
}

void Instance::reset() {
  simulation_.reset();
  state_ = State{};
  state_.resolved = unit_.resolved;
  state_.inputs = inputs_at_rest(state_.resolved);
  place_structure();
}

void Instance::place_structure() {
  const auto hull = structure::make_hull(state_.resolved.structure);
  const structure::State start = structure::make_motion(state_.resolved, *hull)->now();
  state_.outputs.place = start.pose.position;
  state_.outputs.attitude = structure::attitude_of(start.pose.rotation);
  state_.outputs.twist = start.twist;
}

void Instance::set_up(double start_time, std::optional<double> stop_time) {
  expect("setting up the experiment", {Phase::kInstantiated});
  if (!std::isfinite(start_time) || (stop_time && !(*stop_time >= start_time)))
    throw std::runtime_error("start and stop time are not in order");
  state_.start_time = start_time;
  state_.stop_time = stop_time;
}

void Instance::enter_initialization() {
  expect("entering initialization mode", {Phase::kInstantiated});
  state_.phase = Phase::kInitialization;
}

void Instance::exit_initialization() {
  expect("leaving initialization mode", {Phase::kInitialization});
  simulation_.emplace(state_.resolved);
  state_.phase = Phase::kStepping;
}

void Instance::terminate() {
  expect("terminating", {Phase::kStepping});
  warning_ = state_.track.count();
  state_.phase = Phase::kTerminated;
}

const Variable& Instance::variable(unsigned reference) const {
  if (reference < variables_.size()) return variables_[reference];
  throw std::runtime_error(fmt::format("no variable has the value reference {}", reference));
}

Number Instance::value(unsigned reference) const {
  const Variable& v = variable(reference);
  switch (v.causality) {
    case Causality::kIndependent:
      return time();
    case Causality::kInput:
      return nth_number(state_.inputs, v.place);
    case Causality::kOutput:
      return nth_number(state_.outputs, v.place);
    case Causality::kParameter:
      return value_of(state_.resolved, unit_.parameters[v.place]);
  }
  return 0.0;
}

double Instance::number(unsigned reference) const {
  const Number found = value(reference);
  if (const double* const number = std::get_if<double>(&found)) return *number;
  throw std::runtime_error(variable(reference).name + " is a whole number");
}

std::int64_t Instance::whole_number(unsigned reference) const {
  const Number found = value(reference);
  if (const std::int64_t* const number = std::get_if<std::int64_t>(&found)) return *number;
  throw std::runtime_error(variable(reference).name + " is not a whole number");
}

void Instance::check(const Variable& v, Number value) const {
  if (value.index() != v.start.index()) throw std::runtime_error(v.name + " has another type");
  const double number = std::visit([](auto given) { return static_cast<double>(given); }, value);
  if (v.causality == Causality::kInput) {
    expect("setting an input", {Phase::kInstantiated, Phase::kInitialization, Phase::kStepping});
    if (!std::isfinite(number)) throw Discarded(fmt::format("{} = {}: allowed is a finite number", v.name, number));
    if (v.unit == "rad" && std::abs(number) > kMostAngle)
      throw Discarded(fmt::format("{} = {}: allowed is at most {:.0f} rad, 1000 turns", v.name, number, kMostAngle));
  } else if (v.causality == Causality::kParameter) {
    expect("setting a parameter", {Phase::kInstantiated, Phase::kInitialization});
    if (!(number >= v.least && number <= v.most))
      throw Discarded(fmt::format("{} = {}: allowed is {} to {}", v.name, number, *v.least, *v.most));
  } else {
    throw std::runtime_error(v.name + " cannot be set");
  }
}

void Instance::set(const std::vector<Setting>& settings) {
  for (const Setting& setting : settings) check(variable(setting.reference), setting.value);
  bool has_parameter = false;
  for (const auto& [reference, value] : settings) {
    const Variable& v = variable(reference);
    if (v.causality == Causality::kInput) {
      nth_number(state_.inputs, v.place) = std::get<double>(value);
    } else {
      set_value(state_.resolved, unit_.parameters[v.place], value);
      has_parameter = true;
    }
  }
  if (has_parameter) place_structure();
}

/// Takes in where the host has put the structure at the start of a step of this size [s].
void Instance::follow(double size) {
  if (unit_.velocity_from_poses) state_.inputs.twist = state_.track.mean_twist(state_.inputs).value_or(Twist{});
  state_.track.add(state_.inputs, size);
  if (!unit_.velocity_from_poses) warning_ = state_.track.take_warning();
}

/// Along the way that the inputs say, to where it leads in `time` from the communication point [s].
void Instance::drive(double time) {
  simulation_->drive(structure::way_at(state_.inputs.twist, pose_of(state_.inputs), time));
}

void Instance::step(double from, double size) {
  const std::int64_t n = n_steps_of(from, size);
  const double dt = state_.resolved.time.step;
  if (is_driven(state_.resolved)) follow(size);
  Outputs sum;
  for (std::int64_t i = 0; i < n; ++i) {
    if (is_driven(state_.resolved)) drive(static_cast<double>(i + 1) * dt - state_.remainder);
    const Outputs one = outputs_of(simulation_->step().loads);
    ++state_.n_steps;
    sum = i == 0 ? one : joined(sum, one);
  }
  if (n > 0) state_.outputs = n == 1 ? sum : mean_of(sum, static_cast<double>(n));
  const double rest = time_past_steps(from + size);
  state_.remainder = std::abs(rest) <= kTimeTolerance * dt ? 0.0 : rest;
}

double Instance::time_past_steps(double time) const {
  return time - (state_.start_time + static_cast<double>(state_.n_steps) * state_.resolved.time.step);
}

std::int64_t Instance::n_steps_of(double from, double size) const {
  expect("stepping", {Phase::kStepping});
  const double dt = state_.resolved.time.step, tolerance = kTimeTolerance * dt;
  const double n = std::floor(time_past_steps(from + size) / dt + kTimeTolerance);
  if (!(size > 0.0) || !(n < kMostSteps))
    throw Discarded(fmt::format("a step of {} s: allowed is a finite time above 0 s", size));
  if (!(std::abs(from - time()) <= tolerance))
    throw Discarded(fmt::format("a step from {} s, but the unit is at {} s", from, time()));
  // Both standards ask for an error: fmi2SetupExperiment, fmi3EnterInitializationMode.
  if (state_.stop_time && !(from + size <= *state_.stop_time + tolerance))
    throw std::runtime_error(fmt::format("a step to {} s, beyond the stop time {} s", from + size, *state_.stop_time));
  const auto* const towed = std::get_if<model::Towed>(&state_.resolved.structure.motion);
  if (towed != nullptr && !towed->path.empty()) {
    const double end = state_.start_time + towed->path.back().time;
    if (!(from + size <= end + tolerance))
      throw Discarded(fmt::format("a step to {} s, beyond the last row of the path at {} s", from + size, end));
  }
  return std::max<std::int64_t>(0, std::llround(n));
}

State Instance::state() const {
  State copy = state_;
  if (simulation_) copy.checkpoint = simulation_->checkpoint();
  return copy;
}

void Instance::restore(State state) {
  model::Case unit = unit_.resolved;  // its files lie where this unit was unpacked
  const auto files = model::files_of(state.resolved), here = model::files_of(unit);
  for (std::size_t i = 0; i < files.size(); ++i) *files[i] = *here.at(i);
  simulation_.reset();
  if (state.checkpoint) {
    state.checkpoint->resolved = state.resolved;
    simulation_.emplace(state.resolved, *state.checkpoint);
    state.checkpoint.reset();
  }
  state_ = std::move(state);
}

}  // namespace brash::fmu
