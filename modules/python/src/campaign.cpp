// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "brash/core/own_path.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

namespace fs = std::filesystem;

std::string path_of(const py::object& path) {
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

/// The command that this module came with: bin/brash of the installation or of the build tree.
std::string own_program() {
  for (fs::path folder = own_path().parent_path(); folder.has_relative_path(); folder = folder.parent_path()) {
    if (std::error_code ignored; fs::is_regular_file(folder / "bin/brash", ignored)) return folder / "bin/brash";
  }
  throw InputError("program: the `brash` command is not beside this module; name its path");
}

struct Interrupted {};

py::dict to_dict(const campaign::Counts& counts) {
  py::dict out;
  out["n_cases"] = counts.n_cases;
  out["n_done"] = counts.n_done;
  out["n_failed"] = counts.n_failed;
  out["n_missing"] = counts.n_missing();
  return out;
}

py::dict run(const py::object& plan, const py::object& output, int jobs, bool resume, bool quick,
             const py::object& program) {
  const std::string plan_file = path_of(plan), directory = path_of(output);
  if (jobs < 0 || jobs > 100'000) throw InputError(fmt::format("jobs = {}: 1 to 100000, or 0 for the cores", jobs));
  std::vector<std::string> unfit;
  const campaign::Campaign campaign{
      .plan = io::read_campaign_plan(plan_file, {.quick = quick,
                                                 .replicates = {},
                                                 .overrides = {},
                                                 .known_columns = campaign::known_columns(),
                                                 .default_columns = campaign::default_columns()}),
      .plan_file = plan_file,
      .directory = directory,
      .resume = resume,
      .program = program.is_none() ? own_program() : path_of(program),
      .unfit = [&](const std::string& what) { unfit.push_back(what); }};
  const int n_workers = jobs > 0 ? jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  // A signal may reach another thread than the one that waits for the cases: Python knows of it all the same.
  SignalPoll poll;
  const campaign::Progress progress = [&](const campaign::Counts&, std::size_t) {
    if (poll.raised()) throw Interrupted{};
  };
  campaign::Counts counts;
  bool interrupted = false;
  {
    const Released release;
    try {
      counts = campaign::run_local(campaign, n_workers, progress);
    } catch (const Interrupted&) {
      interrupted = true;
    }
  }
  if (interrupted) throw py::error_already_set();
  for (const std::string& what : unfit) py::module_::import("warnings").attr("warn")(what + ": the case was run again");
  if (counts.n_missing() > 0) {
    throw RunError(
        fmt::format("stopped with {} of {} cases missing; resume=True continues", counts.n_missing(), counts.n_cases));
  }
  return to_dict(counts);
}

}  // namespace

void add_campaign(py::module_& m) {
  m.def("campaign", &run, py::arg("plan"), py::arg("output"), py::arg("jobs") = 0, py::arg("resume") = false,
        py::arg("quick") = false, py::arg("program") = py::none(),
        "Runs the plan of a campaign in processes on this machine and leaves its tables in `output`.\n\n"
        "jobs: cases at once, 0 for as many as there are cores; quick: the plan's small variant; program: path of the "
        "`brash` command, left out the one beside this module. Returns the counts of cases. Ctrl-C stops the cases "
        "with a checkpoint; resume=True continues.");
}

}  // namespace brash::python
