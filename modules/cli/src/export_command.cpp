// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <limits>
#include <memory>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/formats/exports.hpp"
#include "brash/formats/maps.hpp"
#include "brash/io/file_names.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "fmu.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;

void export_map(const std::string& run_file, const std::string& file, double time, const std::string& crs) {
  formats::check_map_name(file);
  refuse_overwriting(file, {run_file});
  io::refuse_replacing_results(file);
  geometry::Map map = formats::ice_map(formats::read_replay(run_file), time);
  if (!crs.empty()) formats::take_crs(map, crs);
  write_map_file(file, map);
  print("{} polygons in {}\n", map.features.size(), file);
  if (map.crs.empty())
    say("note: {}: names no coordinate reference system, so programs for maps take its metres for degrees; --crs "
        "EPSG:CODE names one\n",
        file);
}

std::string run_file(const std::string& given) { return io::file_in(given, {"run.nc"}); }

/// What to write: `given`, or without it `name` beside the file of the run.
std::string or_beside(const std::string& run_file, const std::string& given, const char* name) {
  return given.empty() ? (fs::path(run_file).parent_path() / name).string() : given;
}

void add_run_export(CLI::App& command, const formats::Export& format) {
  struct Options {
    std::string run, output;
  };
  auto options = std::make_shared<Options>();
  CLI::App* added = command.add_subcommand(format.name, format.meaning);
  added->add_option("run", options->run, "folder of a run, or its run.nc")->required();
  added->add_option("-o,--output", options->output,
                    fmt::format("{} [{} beside the run.nc]", format.output, format.beside));
  added->footer(fmt::format("Example: brash export {} results/cone -o {}", format.name, format.example));
  added->callback([options, &format] {
    const formats::Exported done = formats::export_run(format, options->run, options->output);
    print("{} frames in {}\n", done.n_frames, done.file);
  });
}

void add_map_command(CLI::App& command) {
  struct Options {
    std::string run, file, crs;
    double time = std::numeric_limits<double>::infinity();
  };
  auto options = std::make_shared<Options>();
  CLI::App* map = command.add_subcommand("map", "The ice of a run as a map, in the coordinates of field.origin");
  map->add_option("run", options->run, "folder of a run, or its run.nc")->required();
  map->add_option("-o,--output", options->file, "file of the map, .geojson or .wkt [ice.geojson beside the run.nc]");
  map->add_option("--time", options->time, "the frame at this time, or the last before it [s] [the last one]")
      ->check(CLI::NonNegativeNumber);
  map->add_option("--crs", options->crs,
                  "coordinate reference system of field.origin, such as EPSG:32633 [the one of field.file]");
  map->footer("Example: brash export map results/cone -o ice.geojson --time 10");
  map->callback([options] {
    const std::string run = run_file(options->run);
    export_map(run, or_beside(run, options->file, "ice.geojson"), options->time, options->crs);
  });
}

void add_fmu_command(CLI::App& command) {
  struct Options {
    std::string case_file, file;
    std::vector<std::string> overrides;
    int standard = 2;
    bool velocity_from_poses = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* fmu = command.add_subcommand("fmu", "A case as a co-simulation unit (FMI) for other programs to step");
  fmu->add_option("case", options->case_file, "case file (TOML)")->required();
  fmu->add_option("-o,--output", options->file, "file of the unit [<name of the case>.fmu]");
  fmu->add_option("--fmi", options->standard, "version of the standard, 2 or 3 [2]")->check(CLI::IsMember({2, 3}));
  fmu->add_option("--set", options->overrides, "section.key=value, in place of the case file's")
      ->take_all()
      ->allow_extra_args(false);
  fmu->add_flag("--velocity-from-poses", options->velocity_from_poses,
                "of a driven structure: the host gives poses, the unit takes velocities from them");
  fmu->footer("Example: brash export fmu cone.toml -o cone.fmu --fmi 3");
  fmu->callback([options] {
    const std::string beside = fs::path(options->case_file).stem().string() + ".fmu";
    export_fmu(options->case_file, options->overrides, options->file.empty() ? beside : options->file,
               static_cast<fmu::Standard>(options->standard), options->velocity_from_poses);
  });
}

}  // namespace

void add_export_command(CLI::App& app) {
  CLI::App* command = app.add_subcommand("export", "Write a run for other programs");
  command->require_subcommand(1);
  command->footer("Example: brash export vtk results/cone");
  for (const formats::Export& format : formats::exports()) add_run_export(*command, format);
  add_openfast_command(*command);
  add_map_command(*command);
  add_fmu_command(*command);
}

}  // namespace brash::cli
