// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <map>

#include "brash/core/write_file.hpp"
#include "brash/formats/exports.hpp"
#include "brash/formats/vtk.hpp"

namespace brash::formats {
namespace {

enum Part { kFloes, kSheet, kStructure };

PolyData floes_at(const model::Case& resolved, const model::Frame& frame,
                  const std::map<std::int64_t, const model::FloeRecord*>& records) {
  PolyData data;
  data.cell_data = {{"id", {}}, {"parent", {}}, {"age", {}}, {"area", {}}, {"thickness", {}}, {"contact_force", {}}};
  for (const model::FloePose& floe : frame.floes) {
    const model::FloeRecord& record = *records.at(floe.floe);
    const double thickness = thickness_of(record, resolved);
    const std::array values{static_cast<double>(record.id),
                            static_cast<double>(record.parent),
                            frame.time - record.birth,
                            record.area,
                            thickness,
                            floe.contact_force};
    for (const geometry::Polygon& polygon : polygons_of(record.rings)) {
      const std::size_t n = add_prism(data, polygon, -0.5 * thickness, 0.5 * thickness, floe.pose);
      for (std::size_t i = 0; i < values.size(); ++i) {
        std::vector<double>& column = data.cell_data[i].second;
        column.insert(column.end(), n, values[i]);
      }
    }
  }
  return data;
}

/// Calls `write(name, bytes)` for each file of a run's time series: floes, level ice and structure at each frame. A
/// run without level ice has no files of it.
/// @return the collection of these files.
std::string to_vtk_series(const Replay& run,
                          const std::function<void(const std::string& name, const std::string& bytes)>& write) {
  std::map<std::int64_t, const model::FloeRecord*> records;
  for (const model::FloeRecord& floe : run.results.floes) records[floe.id] = &floe;

  SheetReplay replay(run);
  std::vector<VtkStep> steps;
  std::size_t number = 0;  // of the frame
  const auto add = [&](double time, Part part, const std::string& name, const PolyData& data) {
    if (data.faces.empty() && part == kSheet) return;  // a field of floes has no level ice
    const std::string file = fmt::format("{}_{:05}.vtp", name, number);
    write(file, to_vtp(data));
    steps.push_back({time, part, file});
  };
  for (const model::Frame& frame : run.results.frames) {
    add(frame.time, kFloes, "floes", floes_at(run.resolved, frame, records));
    add(frame.time, kSheet, "sheet", sheet_surface(run.resolved, replay.at(frame)));
    add(frame.time, kStructure, "structure", mesh_surface(run.hull->mesh(), frame.structure));
    ++number;
  }
  return to_pvd(steps);
}

}  // namespace

Export vtk_series_export() {
  return {.name = "vtk",
          .meaning = "A time series for ParaView: run.pvd with .vtp files",
          .output = "folder of the files",
          .beside = "vtk",
          .example = "cone_vtk",
          .ending = "",
          .kind = "",
          .write = [](const Replay& run, const std::string& folder) {
            const auto path_of = [&](const std::string& name) {
              return (std::filesystem::path(folder) / name).string();
            };
            const std::string collection = path_of("run.pvd");
            write_file(collection, to_vtk_series(run, [&](const std::string& name, const std::string& bytes) {
                         write_file(path_of(name), bytes);
                       }));
            return collection;
          }};
}

}  // namespace brash::formats
