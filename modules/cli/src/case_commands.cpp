// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "brash/advice/advice.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/io/case.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/new_case.hpp"
#include "brash/io/origin.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/report/pictures.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/run.hpp"
#include "brash/simulation/setup.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/mesh_file.hpp"
#include "brash/structure/motion.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "messages.hpp"

namespace brash::cli {
namespace {

/// Rows of a name and what is known of it.
class Rows {
 public:
  template <typename... Values>
  void add(const char* name, fmt::format_string<Values...> format, Values&&... values) {
    rows_.push_back(fmt::format("{:<31}{}", name, fmt::format(format, std::forward<Values>(values)...)));
  }
  /// @param before  each row.
  void print(const char* before) const {
    for (const std::string& row : rows_) cli::print("{}{}\n", before, row);
  }

 private:
  std::vector<std::string> rows_;
};

void add_scales(const model::Case& resolved, const simulation::DerivedScales& scales, Rows& rows) {
  rows.add("characteristic length l_c", "{:.4g} m", scales.characteristic_length);
  rows.add("thickness / l_c", "{:.4g}", scales.thickness_over_lc);
  rows.add("mu1 straight ahead", "{:.4g}", scales.mu1);
  rows.add("freeboard, draught", "{:.4g} m, {:.4g} m", scales.freeboard, scales.draft);
  rows.add("T_col of a piece l_c x l_c / 4", "{:.4g} s", scales.collision_time);
  if (model::has_level_ice(resolved.field) && resolved.field.initial_crack)
    rows.add("initial crack radius", "{:.4g} m", scales.initial_crack_radius);
  if (scales.correlation_length > 0.0) rows.add("correlation length of the ice", "{:.4g} m", scales.correlation_length);
}

/// How long the run is, and the part of it that its statistics cover.
void add_times(const model::Case& resolved, const simulation::StatisticsWindow& window, Rows& rows) {
  rows.add("simulated time", "{:.6g} s in {} steps", resolved.time.duration,
           std::llround(resolved.time.duration / resolved.time.step));
  if (window.from >= resolved.time.duration)
    rows.add("statistics", "none: the run is over before they begin");
  else
    rows.add("statistics", "from {:.4g} s to {:.4g} s; they begin when {}", window.from, window.until, window.begins);
}

/// The large ones are plates.
void add_field(const model::Case& resolved, const simulation::InitialField& field, Rows& rows) {
  rows.add("field", "{:.4g} m x {:.4g} m", resolved.field.length, resolved.field.width);
  if (model::has_ice_files(resolved.field)) {
    rows.add("level ice", "{} sheet{}, {:.6g} m2", field.sheets.size(), field.sheets.size() == 1 ? "" : "s",
             field.sheet_area);
    rows.add("floes", "{}, {:.4g} m2", field.floes.size(), field.area);
  }
  if (resolved.field.kind != model::FieldKind::kFloes) return;
  const std::size_t n_plates = field.sheets.size();
  const double area = field.area + field.sheet_area;
  rows.add("floes", "{}{}, {:.4g} m2, concentration {:.4g}", field.floes.size() + n_plates,
           n_plates == 0 ? "" : fmt::format(" ({} plates)", n_plates), area,
           area / (resolved.field.length * resolved.field.width));
}

/// The hull as it lies in the water.
void add_hull(const model::Case& resolved, Rows& rows) {
  const auto hull = structure::make_hull(resolved.structure);
  const auto [least, most] = hull->bounds();
  const structure::Displacement wet = hull->displaced({});
  rows.add("hull", "{:.4g} m long, {:.4g} m wide, {:.4g} m high", most.x - least.x, most.y - least.y, most.z - least.z);
  if (!resolved.structure.legs.empty()) rows.add("legs", "{}", resolved.structure.legs.size());
  rows.add("displacement", "{:.5g} m3, {:.5g} kg", wet.volume, resolved.water.density * wet.volume);
  constexpr double kRounding = 1e-9;  // of sums that would be zero [m]
  const auto shown = [](double length) { return std::abs(length) < kRounding ? 0.0 : length; };
  rows.add("centre of buoyancy", "{:.4g} m ahead, {:.4g} m to port, {:.4g} m under water", shown(wet.centre.x),
           shown(wet.centre.y), -wet.centre.z);
  rows.add("waterplane", "{:.5g} m2", wet.waterplane.area);
  for (const structure::NaturalMode& mode : structure::make_motion(resolved, *hull)->natural_modes()) {
    if (mode.squared_frequency > 0.0)
      rows.add("natural period", "{:.4g} s, mostly {}", 2.0 * kPi / std::sqrt(mode.squared_frequency), mode.motion);
    else
      rows.add("no restoring force", "mostly {}: the structure is not stable there", mode.motion);
  }
}

/// What became of a mesh when it was read.
void add_mesh(const model::Mesh& mesh, Rows& rows) {
  const structure::MeshReport report = structure::examine(mesh).value();  // the case has been checked
  rows.add("mesh", "{} triangles in {} shell{}", report.n_triangles, report.n_shells, report.n_shells == 1 ? "" : "s");
  rows.add("repairs of the mesh",
           "{} vertices joined, {} triangles dropped, {} turned, {} holes filled, {} inner shells left out",
           report.n_joined, report.n_dropped, report.n_turned, report.n_holes_filled, report.n_inner_shells);
  rows.add("convex parts of the mesh", "{}, their volume is off by {:.2g} %", report.n_parts,
           100.0 * report.parts_error);
}

struct CheckOptions {
  std::string case_file, picture;
  std::vector<std::string> overrides;
  bool keys = false;  ///< every key in SI as well
};

void print_keys(const model::Case& resolved, const CheckOptions& options) {
  const std::string keys =
      fmt::format("{}", fmt::join(io::keys_set_by_preset(options.case_file, options.overrides), ", "));
  print("# set by algorithm.preset = \"{}\": {}\n\n", model::name_of(resolved.algorithm.preset),
        keys.empty() ? "nothing, each of its keys is written" : keys);
  print_data(io::to_toml(resolved));
}

/// With the keys, the whole is a case file: the rows are comments in it.
void check_case(const CheckOptions& options) {
  refuse_overwriting(options.picture, {options.case_file});
  io::refuse_replacing_results(options.picture);
  model::Case resolved = io::read_case(options.case_file, options.overrides);
  for (const std::string* const file : model::files_of(resolved)) refuse_overwriting(options.picture, {*file});
  check_picture_name(options.picture);
  const simulation::Setup setup(resolved);
  const simulation::InitialField field = simulation::initial_field(resolved);
  Rows rows;
  add_scales(resolved, setup.scales, rows);
  add_times(resolved, setup.window, rows);
  add_field(resolved, field, rows);
  add_hull(resolved, rows);
  if (const auto* const mesh = std::get_if<model::Mesh>(&resolved.structure.shape)) add_mesh(*mesh, rows);
  const char* const before = options.keys ? "# " : "";
  print("{}{}\n", before, io::origin_line(io::origin_of(resolved)));
  rows.print(before);
  if (!options.picture.empty())
    write_picture(options.picture, report::case_picture(resolved, {field.sheets, field.floes, field.land}));
  say_warnings(advice::warnings_of(setup));
  if (options.keys) print_keys(resolved, options);
}

}  // namespace

void add_check_command(CLI::App& app) {
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command = app.add_subcommand("check", "Read a case, print its lengths, its statistics' start and warnings");
  command->add_option("case", options->case_file, "case file (TOML)")->required();
  command->add_option("--set", options->overrides, "section.key=value")->take_all()->allow_extra_args(false);
  command->add_flag("--keys", options->keys, "print every key in SI too: the whole is a case file");
  command->add_option("--picture", options->picture, "draw hull, waterline and field into this file, SVG or PNG");
  command->footer("Example: brash check experiments/ships/icebreaker.toml --picture ship.svg");
  command->callback([options] { check_case(*options); });
}

void add_schema_command(CLI::App& app) {
  struct Options {
    bool as_template = false;
    std::string ice = "basin";
    bool of_plan = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("schema", "Print the schema of a case file");
  CLI::Option* as_template = command->add_flag("--template", options->as_template, "a commented case file instead");
  command
      ->add_option("--ice", options->ice,
                   fmt::format("ice of the template, with sourced values: {} [basin]", fmt::join(io::site_ice(), ", ")))
      ->needs(as_template);
  command->add_flag("--plan", options->of_plan, "the schema of a campaign's plan instead")->excludes(as_template);
  command->footer("Example: brash schema --template --ice baltic > mine.toml");
  command->callback([options] {
    print("{}", options->as_template ? io::case_template(options->ice)
                                     : io::editor_schema(options->of_plan ? io::plan_schema() : io::case_schema()));
  });
}

}  // namespace brash::cli
