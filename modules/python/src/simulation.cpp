// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/simulation/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "brash/advice/advice.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/origin.hpp"
#include "brash/recording/inputs.hpp"
#include "brash/recording/recording.hpp"
#include "brash/recording/run_folder.hpp"
#include "brash/report/report.hpp"
#include "brash/simulation/run.hpp"
#include "case.hpp"
#include "convert.hpp"
#include "results.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

/// The effects of some steps, one after the other.
struct Steps {
  std::vector<model::LoadRow> loads;
  std::vector<model::CrackEvent> events;
  std::vector<model::SheetSplit> splits;
  std::vector<model::FloeRecord> births;
  std::vector<simulation::FloeDeath> deaths;

  void add(simulation::StepReport report) {
    loads.push_back(report.loads);
    std::ranges::move(report.events, std::back_inserter(events));
    std::ranges::move(report.splits, std::back_inserter(splits));
    std::ranges::move(report.births, std::back_inserter(births));
    std::ranges::move(report.deaths, std::back_inserter(deaths));
  }
};

/// The two arrays of a pose or a twist. @throws InputError naming the argument `name`.
std::array<Array, 2> pair_of_arrays(const py::object& pair, const char* name) {
  if (!py::isinstance<py::sequence>(pair) || py::len(pair) != 2)
    throw InputError(fmt::format("{}: a pair of arrays is expected", name));
  const auto items = pair.cast<py::sequence>();
  return {numbers(items[0], name), numbers(items[1], name)};
}

/// @throws InputError unless it is a number of threads.
int checked(int threads) {
  constexpr int kMost = 1024;
  if (threads < 1 || threads > kMost)
    throw InputError(fmt::format("threads = {}: a number from 1 to {} is expected", threads, kMost));
  return threads;
}

/// While it lives, the case cannot be changed. Made and ended with the GIL.
class Frozen {
 public:
  explicit Frozen(const Case& c) : case_(c) { ++case_.runs.n; }
  Frozen(const Frozen&) = delete;
  Frozen& operator=(const Frozen&) = delete;
  ~Frozen() { --case_.runs.n; }

 private:
  const Case& case_;
};

/// A simulation, the records of its floes, and the flag that keeps a second thread out while it steps.
class LiveSimulation {
 public:
  LiveSimulation(const Case& c, int threads)
      : simulation_(c.resolved, checked(threads)),
        records_(by_id(simulation_.initial_births())),
        dt_(c.resolved.time.step) {
    const auto* const towed = std::get_if<model::Towed>(&c.resolved.structure.motion);
    if (towed != nullptr && !towed->path.empty()) end_of_path_ = towed->path.back().time;
  }

  Steps step(py::ssize_t n, const py::object& pose, const py::object& twist) {
    if (n < 0) throw InputError(fmt::format("n = {}: a number of steps is expected", n));
    const Busy busy(busy_, "this simulation");
    expect_on_path(n);
    drive(n, pose, twist);
    without_gil(static_cast<std::size_t>(n), [&](std::size_t) {
      simulation::StepReport report = simulation_.step();
      for (const model::FloeRecord& floe : report.births) records_.emplace(floe.id, floe);
      steps_.add(std::move(report));
    });
    return std::exchange(steps_, {});
  }

  /// The simulation at rest, for a look. @throws std::runtime_error while another thread steps it.
  const simulation::Simulation& look() const {
    if (busy_) throw std::runtime_error("this simulation is in use by another thread");
    return simulation_;
  }
  FrameView frame() const { return view_of(look().frame(), records_); }

 private:
  /// Beyond its path the structure would stand still. A run of the whole path takes the nearest number of steps.
  void expect_on_path(py::ssize_t n) const {
    if (!end_of_path_) return;
    const std::int64_t done = std::llround(simulation_.time() / dt_), left = std::llround(*end_of_path_ / dt_) - done;
    if (n <= left) return;
    const double to = simulation_.time() + static_cast<double>(n) * dt_;
    throw InputError(Complaint{
        fmt::format("n = {}", n),
        fmt::format("leads to {:.10g} s, beyond the last row of structure.motion.path at {:.10g} s", to, *end_of_path_),
        fmt::format("at most {} steps more", left), "take fewer steps, or add rows to the path"});
  }

  /// Takes the pose and the twist of the next step, of which either may be None.
  void drive(py::ssize_t n, const py::object& pose, const py::object& twist) {
    if (!pose.is_none() && n != 1) throw InputError(fmt::format("n = {}: a pose is reached in one step", n));
    const auto half = [](const py::object& pair, py::ssize_t i, const char* name, py::ssize_t size) {
      const Array values = pair_of_arrays(pair, name)[static_cast<std::size_t>(i)];
      if (values.ndim() != 1 || values.shape(0) != size)
        throw InputError(fmt::format("{}[{}]: has shape {}, must have shape ({},)", name, i, shape_text(values), size));
      return values;
    };
    Pose goal;
    Twist velocity;
    if (!pose.is_none()) {
      const Array p = half(pose, 0, "pose", 3), q = half(pose, 1, "pose", 4);
      goal = {{p.at(0), p.at(1), p.at(2)}, {q.at(0), q.at(1), q.at(2), q.at(3)}};
    }
    if (!twist.is_none()) {
      const Array v = half(twist, 0, "twist", 3), w = half(twist, 1, "twist", 3);
      velocity = {{v.at(0), v.at(1), v.at(2)}, {w.at(0), w.at(1), w.at(2)}};
    }
    if (!pose.is_none() && !twist.is_none())
      simulation_.drive(structure::State{goal, velocity});
    else if (!pose.is_none())
      simulation_.drive(goal);
    else if (!twist.is_none())
      simulation_.drive(velocity);
  }

  simulation::Simulation simulation_;
  std::map<std::int64_t, model::FloeRecord> records_;
  double dt_;                          ///< [s]
  std::optional<double> end_of_path_;  ///< time of its last row [s]
  Steps steps_;                        ///< done, and not handed over: Ctrl-C came
  bool busy_ = false;
};

py::list motions_of(const std::vector<model::SheetMotion>& sheets) {
  py::list all;
  for (const model::SheetMotion& sheet : sheets) {
    py::dict one;
    one["mass"] = sheet.mass;
    one["centre"] = py::make_tuple(sheet.centre.x, sheet.centre.y);
    one["heading"] = sheet.heading;
    one["velocity"] = py::make_tuple(sheet.velocity.x, sheet.velocity.y);
    one["spin"] = sheet.spin;
    all.append(std::move(one));
  }
  return all;
}

py::dict ledger_of(const geometry::Ledger& l) {
  py::dict out;
  out["initial"] = fraction(l.initial);
  out["sheet"] = fraction(l.sheet);
  out["floes"] = fraction(l.floes);
  out["crushed"] = fraction(l.crushed);
  out["deleted"] = fraction(l.deleted);
  out["brash"] = fraction(l.brash);
  out["snap"] = fraction(l.snap);
  return out;
}

py::list deaths_of(const Steps& steps) {
  py::list out;
  for (const simulation::FloeDeath& death : steps.deaths)
    out.append(py::make_tuple(death.floe, model::name_of(death.cause)));
  return out;
}

/// The inputs of a run of this case; a case without a file is recorded as the text that gives it.
recording::Inputs inputs_of(const Case& c) {
  if (c.has_file) return recording::inputs_of(c.path, c.text, c.resolved);
  return recording::inputs_of("case.toml", io::to_toml(c.resolved), c.resolved);
}

simulation::Run run(const Case& c, const py::object& output, bool resume, bool replace, int threads) {
  if (resume && output.is_none()) throw InputError("resume: name the folder of the interrupted run as output");
  const std::string directory =
      output.is_none() ? "" : py::module_::import("os").attr("fspath")(output).cast<std::string>();
  if (directory.empty() && !output.is_none()) throw InputError("output: is an empty name; name a folder, or give None");
  const recording::Inputs inputs = inputs_of(c);
  const std::string checkpoint = directory + "/checkpoint.nc";
  bool goes_on = false;
  std::optional<FolderLock> lock;
  std::optional<recording::NewResults> results;
  simulation::RunOptions options;
  if (!directory.empty())
    options.checkpoint = recording::checkpoint_file(checkpoint, resume, inputs, recording::Rows::kInMemory);
  options.begun = [&] {
    if (directory.empty()) return;
    recording::expect_unchanged(inputs);
    results->begin();
    if (!goes_on) recording::remove_checkpoint(checkpoint);
  };
  options.threads = checked(threads);
  SignalPoll poll;
  options.interrupted = [&] { return poll.raised(); };
  simulation::Run finished;
  const Frozen frozen(c);
  {
    const Released release;
    if (!directory.empty()) {
      lock.emplace(recording::open_run_folder(directory));
      results.emplace(directory);
      goes_on = resume && std::filesystem::exists(checkpoint);
      if (!goes_on && !replace) recording::refuse_replacing(directory, ", or take replace=True");
    }
    finished = advice::run(c.resolved, options);
    if (finished.complete && results) report::write_results(*results, inputs, finished);
  }
  if (!finished.complete) throw py::error_already_set();
  finished.summary.origin = io::origin_of(c.resolved);
  return finished;
}

void add_run(py::module_& m) {
  using simulation::Run;
  py::class_<Run>(m, "Run", "A finished run.")
      .def_readonly("results", &Run::results)
      .def_property_readonly(
          "loads", [](const Run& r) { return table(std::span<const model::LoadRow>(r.results.loads)); },
          "Load history, see Results.loads.")
      .def_property_readonly(
          "events", [](const Run& r) { return table(std::span<const model::CrackEvent>(r.results.events)); },
          "Crack events, see Results.events.")
      .def_property_readonly(
          "summary", [](const Run& r) { return from_json(simulation::to_json(r.summary)); },
          "What summary.json holds, a dict; SI.")
      .def_readonly("wall_seconds", &Run::wall_seconds);
  m.attr("Case").attr("run") = py::cpp_function(
      &run, py::name("run"), py::is_method(m.attr("Case")), py::arg("output") = py::none(), py::arg("resume") = false,
      py::arg("replace") = false, py::arg("threads") = 1,
      "Runs the case to its end and returns a Run; with `output` it leaves there what `brash run` leaves.\n\n"
      "It prints nothing: the warnings that `brash run` prints are in Run.summary[\"warnings\"]. "
      "A folder that holds a run already is refused without replace=True. "
      "threads share out the work of a step; results do not depend on their number. "
      "Ctrl-C stops it; with `output` it keeps a checkpoint, and resume=True continues from there. Without a "
      "checkpoint "
      "it begins at 0 s.");
}

}  // namespace

void add_simulation(py::module_& m) {
  add_run(m);
  py::class_<Steps>(m, "Steps", "What one or several steps did.")
      .def_property_readonly(
          "loads", [](const Steps& s) { return table(std::span<const model::LoadRow>(s.loads)); },
          "Structured array with all columns that a history.csv can have; shape (n_steps,). Those of a motion, a "
          "region or a leg that the structure does not have are 0.")
      .def_property_readonly(
          "events", [](const Steps& s) { return table(std::span<const model::CrackEvent>(s.events)); },
          "Crack events, the lines `break` of events.csv: a structured array with its columns up to flexural_strength; "
          "shape (n_events,).")
      .def_property_readonly(
          "splits", [](const Steps& s) { return table(std::span<const model::SheetSplit>(s.splits)); },
          "Drifting sheets that split: structured array with the columns ``split_...`` of run.nc; shape (n_splits,).")
      .def_readonly("births", &Steps::births, "A list of FloeRecord.")
      .def_property_readonly("deaths", &deaths_of, "A list of (id, cause).");
  py::class_<LiveSimulation>(m, "Simulation", R"(One structure driving into one ice sheet, step by step.

>>> simulation = brash.Simulation(case)
>>> steps = simulation.step(100)
>>> steps.loads["Fx"].max()                                     # [N]
>>> [floe.rings[0] for floe in simulation.frame().floes]        # outlines, shape (n, 3) [m])")
      .def(py::init([](const Case& c, int threads) {
             const Frozen frozen(c);
             return unlocked([&] { return std::make_unique<LiveSimulation>(c, threads); });
           }),
           py::arg("case"), py::arg("threads") = 1,
           "Lays the sheet, cuts the initial crack, places the structure.\n\n"
           "threads share out the work of a step; results do not depend on their number.")
      .def(
          "step", &LiveSimulation::step, py::arg("n") = 1, py::kw_only(), py::arg("pose") = py::none(),
          py::arg("twist") = py::none(),
          "Advances by n time steps; Ctrl-C stops between two steps. The next call gives the steps done before it, "
          "too. Steps beyond the last row of structure.motion.path are refused, and none is done.\n\n"
          "With structure.motion.kind = \"driven\", pose = (position, rotation) is reached at the end of one step [m], "
          "and twist = (velocity, angular velocity) is the motion during the step [m/s], [rad/s], each in the sheet "
          "frame. "
          "One gives the other. Without both, the structure continues at its last twist.")
      .def_property_readonly(
          "time", [](const LiveSimulation& s) { return s.look().time(); }, "[s]")
      .def_property_readonly(
          "sheet", [](const LiveSimulation& s) { return s.look().sheet(); },
          "The ice sheet's connected parts, a list of Polygon.")
      .def_property_readonly(
          "sheet_motions", [](const LiveSimulation& s) { return motions_of(s.look().sheet_motions()); },
          "How sheets with free borders move (field.border = \"free\"), a list of dicts: mass [kg], centre [m], "
          "heading "
          "[rad], velocity of the centre [m/s], spin [rad/s]. A sheet that has gone has no mass.")
      .def_property_readonly(
          "ledger", [](const LiveSimulation& s) { return ledger_of(s.look().ledger()); },
          "Where every square metre of ice is: Fractions [m2].")
      .def("frame", &LiveSimulation::frame, "Where structure and floes are now.")
      .def("__repr__",
           [](const LiveSimulation& s) { return fmt::format("<brash.Simulation at t = {:.6g} s>", s.look().time()); });
}

}  // namespace brash::python
