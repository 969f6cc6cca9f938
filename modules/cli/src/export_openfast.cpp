// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "brash/analysis/campaign_histories.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/core/write_file.hpp"
#include "brash/formats/openfast.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "brash/io/run_summary.hpp"
#include "commands.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using formats::OpenFastOptions;
using Loads = std::vector<model::LoadRow>;

struct LoadExport {
  std::string given, directory;
  std::vector<double> point{0.0, 0.0, 0.0};
  OpenFastOptions openfast;
  std::optional<double> from;
  double join = 0.0;  ///< [s]; 0: a file for each run
};

/// The run.nc or the history.csv of a run; a campaign keeps the histories alone.
std::string loads_file(const std::string& run) { return io::file_in(run, {"run.nc", "history.csv"}); }

/// Writes both files.
/// @return for how long there is load [s].
double write_files(const Loads& loads, const std::string& directory, const OpenFastOptions& options) {
  const double end = loads.empty() ? 0.0 : loads.back().time;
  if (!(options.from < end))
    throw InputError(Complaint{fmt::format("--from={}", options.from), "leaves nothing of the load history",
                               fmt::format("less than the end of the run, {} s", end), "lower it"});
  const double duration = end - options.from;
  if (!(options.ramp < duration))
    throw InputError(Complaint{fmt::format("--ramp={}", options.ramp), "leaves no time of the full load",
                               fmt::format("less than the {} s of load", duration), "lower it"});
  const std::string forces = "ice_forces.dat", control = "ice_StC.dat";
  write_file((fs::path(directory) / forces).string(), formats::to_openfast_forces(loads, options));
  write_file((fs::path(directory) / control).string(), formats::to_openfast_structural_control(forces, options));
  return duration;
}

void export_run(const LoadExport& o) {
  const std::string file = loads_file(o.given);
  const fs::path folder = o.directory.empty() ? fs::path(file).parent_path() / "openfast" : fs::path(o.directory);
  const double duration = write_files(io::read_loads(file), folder.string(), o.openfast);
  print("{:.9g} s of load in {}\n", duration, (folder / "ice_forces.dat").string());
  print("TMax of OpenFAST: at most {:.9g} s, since the load is zero after that\n", duration);
  print("structural control in {}\n", (folder / "ice_StC.dat").string());
}

/// The rows of a replicate that its statistics are of, or the ones from --from on.
Loads steady_loads(const fs::path& run, const std::optional<double>& from) {
  analysis::HistoryChoice span;
  if (from) {
    span.from = *from;
    span.has_from = true;
  }
  analysis::begin_as_summary(span, (run / "summary.json").string());
  Loads loads = io::read_loads(loads_file(run.string()));
  std::erase_if(loads, [&](const model::LoadRow& row) {
    const bool is_early = span.after ? row.time <= span.from : row.time < span.from;
    return is_early || (span.to && row.time > *span.to);
  });
  if (loads.size() < 2)
    throw InputError(Complaint{run.string(), fmt::format("has no load from {} s on", span.from),
                               "two steps at least in each replicate", "give an earlier --from"});
  return loads;
}

/// One pair of files for a setting.
void join_replicates(const LoadExport& o, const std::string& setting, const std::vector<std::string>& cases,
                     const fs::path& folder) {
  std::vector<Loads> replicates;
  replicates.reserve(cases.size());
  for (const std::string& name : cases) replicates.push_back(steady_loads(fs::path(o.given) / "cases" / name, o.from));
  formats::JoinedLoads all = formats::joined(replicates, o.join);
  const double step = all.loads[1].time - all.loads[0].time, duration = all.loads.back().time;
  if (duration < o.join - 1.5 * step)
    throw InputError(Complaint{
        o.given,
        fmt::format("setting '{}': {} replicates have {:.6g} s together", printable(setting), cases.size(), duration),
        fmt::format("at least the {:g} s of --join", o.join), "run more replicates or longer ones, or lower --join"});
  OpenFastOptions options = o.openfast;
  options.from = 0.0;
  options.joints = all.joints;
  write_files(all.loads, (folder / setting).string(), options);
  if (all.joints.empty()) return print("  {}: {:.9g} s of one replicate\n", printable(setting), duration);
  print("  {}: {:.9g} s of {} replicates, the load jumps from one to the next at {} s\n", printable(setting), duration,
        all.n_used, fmt::format("{:.9g}", fmt::join(all.joints, ", ")));
}

void export_campaign(const LoadExport& o) {
  const fs::path folder = o.directory.empty() ? fs::path(o.given) / "openfast" : fs::path(o.directory);
  const auto settings = analysis::counted_cases(o.given);
  if (settings.empty())
    throw InputError(Complaint{o.given, "has no case that is done", "one case at least", "resume the campaign"});
  if (o.join > 0.0) {
    print("load of joined replicates, a folder for each setting in {}\n", folder.string());
    for (const auto& [setting, cases] : settings) join_replicates(o, setting, cases, folder);
    return;
  }
  std::size_t n_runs = 0;
  double shortest = INFINITY;
  for (const auto& [setting, cases] : settings)
    for (const std::string& name : cases) {
      const std::string file = loads_file((fs::path(o.given) / "cases" / name).string());
      shortest = std::min(shortest, write_files(io::read_loads(file), (folder / name).string(), o.openfast));
      ++n_runs;
    }
  print("load of {} runs, a folder for each in {}\n", n_runs, folder.string());
  print("TMax of OpenFAST: at most {:.9g} s, since the shortest load is zero after that\n", shortest);
}

void add_options(CLI::App& command, LoadExport& o) {
  command.add_option("run", o.given, "folder of a run or of a campaign, a run.nc or a history.csv")->required();
  command.add_option("-o,--output", o.directory, "folder of the files [openfast beside the run.nc]");
  command
      .add_option("--point", o.point,
                  "where it acts, x,y,z in m from the structure's origin in the waterplane; x as the ice drifts")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(-1e4, 1e4));
  command
      .add_option("--reference", o.openfast.reference,
                  "height above the still water from which StC_P_Z counts: ElastoDyn's PtfmRefzt for the substructure, "
                  "TowerBsHt for the tower [m] [0]")
      ->check(CLI::Range(-1e4, 1e4));
  command.add_option("--openfast", o.openfast.version, "version of OpenFAST, 4 or 5 [5]")->check(CLI::IsMember({4, 5}));
  command.add_option("--from", o.from, "time of the run that becomes 0 s [0; with --join, where the statistics begin]")
      ->check(CLI::Range(0.0, 1e9));
  command.add_option("--ramp", o.openfast.ramp, "time in which the load grows from zero at the start [s] [0]")
      ->check(CLI::Range(0.0, 1e9));
  command
      .add_option("--join", o.join,
                  "of a campaign: one load for each setting, its replicates one after another up to this time [s]")
      ->check(CLI::Range(1.0, 1e6));
}

}  // namespace

void add_openfast_command(CLI::App& command) {
  auto options = std::make_shared<LoadExport>();
  CLI::App* openfast = command.add_subcommand("openfast", "The ice load as a prescribed force for OpenFAST");
  add_options(*openfast, *options);
  openfast->footer("Example: brash export openfast results/cone -o results/openfast --from 6 --ramp 2");
  openfast->callback([options] {
    LoadExport& o = *options;
    o.openfast.point = {o.point[0], o.point[1], o.point[2]};
    o.openfast.from = o.from.value_or(0.0);
    if (io::is_campaign(o.given)) return export_campaign(o);
    if (o.join > 0.0)
      throw InputError(Complaint{o.given, "is not a campaign, and --join joins the replicates of one",
                                 "the folder of a campaign", "leave --join out, or run a campaign"});
    export_run(o);
  });
}

}  // namespace brash::cli
