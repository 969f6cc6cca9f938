// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/write_file.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/io/case.hpp"
#include "brash/io/results.hpp"
#include "brash/structure/hull.hpp"
#include "commands.hpp"
#include "fmu.hpp"
#include "messages.hpp"
#include "openfast.hpp"
#include "vtk_meshes.hpp"

namespace brash::cli {
namespace {

namespace fs = std::filesystem;
using geometry::IceSheet;

enum Part { kFloes, kSheet, kStructure };

/// The sheet at the frames of a run, which stores it after each step with cracks: since then the structure's section in
/// the waterplane has been crushed. Between frames its path is not followed, so the channel's walls differ from the
/// run's by less than the structure moves in a frame.
class SheetReplay {
 public:
  SheetReplay(const structure::Hull& hull, const model::RunResults& results) : hull_(hull), results_(results) {
    take(results.initial_sheet);
  }

  /// The sheet at `frame`; frames in the order of time.
  std::vector<geometry::Polygon> at(const model::Frame& frame) {
    if (&frame == &results_.frames.back()) return polygons_of(results_.final_sheet);
    const auto& cracked = results_.cracked_sheets;
    const std::size_t before = next_;
    while (next_ < cracked.size() && cracked[next_].time <= frame.time) ++next_;
    if (next_ > before) take(cracked[next_ - 1].rings);
    for (const structure::Outline& outline : hull_.footprint(frame.structure, 0.0, 0.0).leading)
      sheet_->cut(geometry::ring(outline));
    sheet_->release_detached();
    return sheet_->polygons();
  }

 private:
  void take(std::span<const std::vector<Vec2>> rings) {
    auto sheet = IceSheet::from_polygons(polygons_of(rings));
    BRASH_EXPECTS(sheet.has_value(), sheet.error().what);
    sheet_ = std::make_unique<IceSheet>(*std::move(sheet));
  }

  const structure::Hull& hull_;
  const model::RunResults& results_;
  std::unique_ptr<IceSheet> sheet_;
  std::size_t next_ = 0;  ///< of the cracked sheets
};

io::PolyData floes_at(const model::Case& resolved, const model::Frame& frame,
                      const std::map<std::int64_t, const model::FloeRecord*>& records) {
  io::PolyData data;
  std::vector<double> id, age, area;
  const double half = 0.5 * resolved.ice.thickness;
  for (const model::FloePose& floe : frame.floes) {
    const model::FloeRecord& record = *records.at(floe.floe);
    for (const geometry::Polygon& polygon : polygons_of(record.rings)) {
      const std::size_t n = add_prism(data, polygon, -half, half, floe.pose);
      id.insert(id.end(), n, static_cast<double>(record.id));
      age.insert(age.end(), n, frame.time - record.birth);
      area.insert(area.end(), n, record.area);
    }
  }
  data.cell_data = {{"id", std::move(id)}, {"age", std::move(age)}, {"area", std::move(area)}};
  return data;
}

io::PolyData sheet_of(const model::Case& resolved, const std::vector<geometry::Polygon>& polygons) {
  io::PolyData data;
  const double top = resolved.ice.thickness * (1.0 - resolved.ice.density / resolved.water.density);
  for (const geometry::Polygon& polygon : polygons) add_prism(data, polygon, top - resolved.ice.thickness, top);
  return data;
}

io::PolyData structure_at(const structure::TriangleMesh& mesh, const Pose& pose) {
  io::PolyData data;
  for (const Vec3& vertex : mesh.vertices) data.points.push_back(to_world(pose, vertex));
  for (const auto& [a, b, c] : mesh.triangles) data.faces.push_back({a, b, c});
  return data;
}

/// Refuses polygons that cannot be drawn, before anything is written.
void check_polygons(const std::string& run_file, const model::RunResults& results) {
  const auto check = [&](const std::string& of, std::span<const std::vector<Vec2>> rings) {
    const auto sheet = IceSheet::from_polygons(polygons_of(rings));
    if (sheet) return;
    throw InputError(Complaint{fmt::format("{}, {}", run_file, of), sheet.error().what,
                               "polygons that neither cross nor overlap",
                               "copy the run.nc again, or run the case again"});
  };
  check("initial_sheet", results.initial_sheet);
  check("final_sheet", results.final_sheet);
  for (const model::CrackedSheet& sheet : results.cracked_sheets)
    check(fmt::format("the sheet cracked at {} s", sheet.time), sheet.rings);
  for (const model::FloeRecord& floe : results.floes) check(fmt::format("floe {}", floe.id), floe.rings);
}

void export_vtk(const std::string& run_file, const std::string& directory) {
  const model::RunResults results = io::read_results(run_file);
  // The failure model is not needed: its file may be gone.
  const model::Case resolved = io::parse_case(io::read_case_of(run_file), run_file, {"failure.file=''"});
  check_polygons(run_file, results);
  std::map<std::int64_t, const model::FloeRecord*> records;
  for (const model::FloeRecord& floe : results.floes) records[floe.id] = &floe;
  const auto hull = structure::make_hull(resolved.structure.shape);

  SheetReplay replay(*hull, results);
  std::vector<io::VtkStep> steps;
  const auto write = [&](double time, Part part, const std::string& name, const io::PolyData& data) {
    const std::string file = fmt::format("{}_{:05}.vtp", name, steps.size() / 3);
    write_file((fs::path(directory) / file).string(), io::to_vtp(data));
    steps.push_back({time, part, file});
  };
  for (const model::Frame& frame : results.frames) {
    write(frame.time, kFloes, "floes", floes_at(resolved, frame, records));
    write(frame.time, kSheet, "sheet", sheet_of(resolved, replay.at(frame)));
    write(frame.time, kStructure, "structure", structure_at(hull->mesh(), frame.structure));
  }
  const std::string collection = (fs::path(directory) / "run.pvd").string();
  write_file(collection, io::to_pvd(steps));
  print("{} frames in {}\n", results.frames.size(), collection);
}

void export_openfast(const std::string& run_file, const std::string& directory, const OpenFastOptions& options) {
  const model::RunResults results = io::read_results(run_file);
  const double end = results.loads.empty() ? 0.0 : results.loads.back().time;
  if (!(options.from < end))
    throw InputError(Complaint{fmt::format("--from={}", options.from), "leaves nothing of the load history",
                               fmt::format("less than the end of the run, {} s", end), "lower it"});
  const std::string forces = "ice_forces.dat", control = "ice_StC.dat";
  write_file((fs::path(directory) / forces).string(), to_openfast_forces(results.loads, options));
  write_file((fs::path(directory) / control).string(), to_openfast_structural_control(forces, options));
  print("{} s of load in {}\n", end - options.from, (fs::path(directory) / forces).string());
  print("structural control in {}\n", (fs::path(directory) / control).string());
}

void add_fmu_command(CLI::App& command) {
  struct Options {
    std::string case_file, file;
    std::vector<std::string> overrides;
    int standard = 2;
  };
  auto options = std::make_shared<Options>();
  CLI::App* fmu = command.add_subcommand("fmu", "A case as a co-simulation unit (FMI) for other programs to step");
  fmu->add_option("case", options->case_file, "case file (TOML)")->required();
  fmu->add_option("-o,--output", options->file, "file of the unit [<name of the case>.fmu]");
  fmu->add_option("--fmi", options->standard, "version of the standard, 2 or 3 [2]")->check(CLI::IsMember({2, 3}));
  fmu->add_option("--set", options->overrides, "section.key=value, in place of the case file's")
      ->take_all()
      ->allow_extra_args(false);
  fmu->footer("Example: brash export fmu cone.toml -o cone.fmu --fmi 3");
  fmu->callback([options] {
    const std::string beside = fs::path(options->case_file).stem().string() + ".fmu";
    export_fmu(options->case_file, options->overrides, options->file.empty() ? beside : options->file,
               static_cast<fmu::Standard>(options->standard));
  });
}

}  // namespace

void add_export_command(CLI::App& app) {
  struct Options {
    std::string run;
    std::string directory;
    std::vector<double> point{0.0, 0.0, 0.0};
    OpenFastOptions openfast;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a run for other programs");
  command->require_subcommand(1);
  command->footer("Example: brash export vtk results/cone/run.nc");
  CLI::App* vtk = command->add_subcommand("vtk", "A time series for ParaView: run.pvd with .vtp files");
  vtk->add_option("run", options->run, "run.nc of a run")->required();
  vtk->add_option("-o,--output", options->directory, "folder of the files [vtk beside the run.nc]");
  vtk->footer("Example: brash export vtk results/cone/run.nc -o cone_vtk");
  vtk->callback([options] {
    const std::string beside = (fs::path(options->run).parent_path() / "vtk").string();
    export_vtk(options->run, options->directory.empty() ? beside : options->directory);
  });
  CLI::App* openfast = command->add_subcommand("openfast", "The ice load as a prescribed force for OpenFAST");
  openfast->add_option("run", options->run, "run.nc of a run")->required();
  openfast->add_option("-o,--output", options->directory, "folder of the files [openfast beside the run.nc]");
  openfast
      ->add_option("--point", options->point,
                   "where it acts, x,y,z in m from the structure's origin in the waterplane; x as the ice drifts")
      ->delimiter(',')
      ->expected(3)
      ->check(CLI::Range(-1e4, 1e4));
  openfast->add_option("--from", options->openfast.from, "time of the run that becomes 0 s")
      ->check(CLI::Range(0.0, 1e9));
  openfast->footer("Example: brash export openfast results/cone/run.nc -o results/openfast --from 6");
  openfast->callback([options] {
    options->openfast.point = {options->point[0], options->point[1], options->point[2]};
    const std::string beside = (fs::path(options->run).parent_path() / "openfast").string();
    export_openfast(options->run, options->directory.empty() ? beside : options->directory, options->openfast);
  });
  add_fmu_command(*command);
}

}  // namespace brash::cli
