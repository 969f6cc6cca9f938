// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.hpp"

#include <fmt/format.h>

#include "brash/formats/exports.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/results.hpp"
#include "convert.hpp"
#include "rooms.hpp"
#include "signals.hpp"

namespace brash::python {
namespace {

py::list rings_of(const std::vector<std::vector<Vec2>>& rings) {
  py::list out;
  for (const std::vector<Vec2>& ring : rings) out.append(to_array(ring));
  return out;
}

/// The mid-plane's outline and holes in the world; shape=(n, 3) each.
py::list world_rings(const FloeState& floe) {
  py::list out;
  for (const std::vector<Vec2>& ring : floe.record.rings) {
    py::array_t<double> array({static_cast<py::ssize_t>(ring.size()), py::ssize_t{3}});
    auto view = array.mutable_unchecked<2>();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 v = to_world(floe.pose, {ring[i].x, ring[i].y, 0.0});
      const auto row = static_cast<py::ssize_t>(i);
      view(row, 0) = v.x, view(row, 1) = v.y, view(row, 2) = v.z;
    }
    out.append(array);
  }
  return out;
}

void add_floes(py::module_& m) {
  py::class_<model::FloeRecord>(m, "FloeRecord", "A floe's life.")
      .def_readonly("id", &model::FloeRecord::id)
      .def_readonly("area", &model::FloeRecord::area, "[m2]")
      .def_readonly("thickness", &model::FloeRecord::thickness, "[m]")
      .def_readonly("birth", &model::FloeRecord::birth, "[s]")
      .def_readonly("death", &model::FloeRecord::death,
                    "[s]; of a floe alive the run's end, and 0 in Simulation.frame() and Steps.births")
      .def_property_readonly(
          "end", [](const model::FloeRecord& f) { return model::name_of(f.end); },
          "alive, crushed or broken (into floes of their own)")
      .def_readonly("peak_stress", &model::FloeRecord::peak_stress,
                    "Largest compression of the deletion criterion [Pa]; 0 in Simulation.frame() and Steps.births.")
      .def_property_readonly(
          "rings", [](const model::FloeRecord& f) { return rings_of(f.rings); },
          "Outline and holes in the body frame; shape (n, 2) each [m].");
  py::class_<FloeState>(m, "Floe", "A floe at one time.")
      .def_readonly("record", &FloeState::record)
      .def_property_readonly("id", [](const FloeState& f) { return f.record.id; })
      .def_property_readonly(
          "position", [](const FloeState& f) { return to_array(f.pose.position); }, "Centre of mass, shape (3,) [m].")
      .def_property_readonly(
          "rotation", [](const FloeState& f) { return to_array(f.pose.rotation); },
          "Unit quaternion (w, x, y, z) from body to world, shape (4,).")
      .def_property_readonly("rings", &world_rings,
                             "Outline and holes of the mid-plane in the world; shape (n, 3) each [m].");
  py::class_<FrameView>(m, "Frame", "Where everything is at one time.")
      .def_readonly("time", &FrameView::time, "[s]")
      .def_property_readonly(
          "structure", [](const FrameView& f) { return to_array(f.structure.position); },
          "The structure's origin, shape (3,) [m].")
      .def_property_readonly(
          "structure_rotation", [](const FrameView& f) { return to_array(f.structure.rotation); },
          "Unit quaternion (w, x, y, z) from the structure's frame to the world, shape (4,).")
      .def_readonly("floes", &FrameView::floes, "A list of Floe.");
}

}  // namespace

std::map<std::int64_t, model::FloeRecord> by_id(const std::vector<model::FloeRecord>& floes) {
  std::map<std::int64_t, model::FloeRecord> records;
  for (const model::FloeRecord& floe : floes) records.emplace(floe.id, floe);
  return records;
}

FrameView view_of(const model::Frame& frame, const std::map<std::int64_t, model::FloeRecord>& records) {
  FrameView view{frame.time, frame.structure, {}};
  for (const model::FloePose& floe : frame.floes) view.floes.push_back({records.at(floe.floe), floe.pose});
  return view;
}

void add_results(py::module_& m) {
  add_floes(m);
  using model::RunResults;
  py::class_<RunResults>(
      m, "Results",
      "Loads, crack events, splits, floes and frames of a run, and its sheet at the start and at the end.\n\n"
      "A run.nc has more: the sheet after each step with cracks (``cracked_sheet_...``).")
      .def_property_readonly(
          "loads", [](const RunResults& r) { return table(std::span<const model::LoadRow>(r.loads)); },
          "Load history: a structured array with all columns that a history.csv can have; shape (n_steps,). Those of a "
          "motion, a region or a leg that the structure does not have are 0, and are left out of history.csv.")
      .def_property_readonly(
          "events", [](const RunResults& r) { return table(std::span<const model::CrackEvent>(r.events)); },
          "Crack events, the lines `break` of events.csv: a structured array with its columns up to flexural_strength; "
          "shape (n_events,).")
      .def_property_readonly(
          "splits", [](const RunResults& r) { return table(std::span<const model::SheetSplit>(r.splits)); },
          "Drifting sheets that split: a structured array with the columns ``split_...`` of run.nc; shape (n_splits,).")
      .def_readonly("floes", &RunResults::floes, "A list of FloeRecord.")
      .def_property_readonly(
          "initial_sheet", [](const RunResults& r) { return rings_of(r.initial_sheet); },
          "Rings with the ice on their left; shape (n, 2) each [m].")
      .def_property_readonly("final_sheet", [](const RunResults& r) { return rings_of(r.final_sheet); })
      .def_property_readonly("n_frames", [](const RunResults& r) { return r.frames.size(); })
      .def(
          "frame",
          [](const RunResults& r, py::ssize_t number) {
            const auto n = static_cast<py::ssize_t>(r.frames.size());
            if (number < -n || number >= n) throw py::index_error(fmt::format("frame {} of {}", number, n));
            return view_of(r.frames[static_cast<std::size_t>(number < 0 ? number + n : number)], by_id(r.floes));
          },
          py::arg("number"), "Frame of the replay; negative numbers count from the end.");
  m.def(
      "read_results",
      [](const py::object& path) {
        const auto name = py::module_::import("os").attr("fspath")(path).cast<std::string>();
        const Released release;
        return io::read_results(io::file_in(name, {"run.nc"}));
      },
      py::arg("path"), "Reads the run.nc of a run, given as a file or by its folder.");
  m.def(
      "export_run",
      [](const py::object& run, const std::string& format, const py::object& output) {
        const auto path = py::module_::import("os").attr("fspath");
        const auto from = path(run).cast<std::string>();
        const auto to = output.is_none() ? std::string() : path(output).cast<std::string>();
        if (to.empty() && !output.is_none()) throw InputError("output: is an empty name; name a file, or give None");
        const Released release;
        return formats::export_run(formats::export_named(format), from, to).file;
      },
      py::arg("run"), py::arg("format"), py::arg("output") = py::none(),
      "Writes a run for another program, as `brash export FORMAT RUN -o OUTPUT` does; the file to open.");
}

}  // namespace brash::python
