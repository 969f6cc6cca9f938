// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "brash/core/constants.hpp"
#include "brash/core/input_file.hpp"
#include "brash/io/campaign_plan.hpp"
#include "brash/io/case.hpp"
#include "brash/io/file_names.hpp"
#include "brash/io/new_case.hpp"
#include "brash/io/origin.hpp"
#include "brash/model/case_keys.hpp"
#include "brash/report/case_picture.hpp"
#include "brash/simulation/initial_floes.hpp"
#include "brash/simulation/scales.hpp"
#include "brash/structure/hull.hpp"
#include "brash/structure/mesh_file.hpp"
#include "brash/structure/motion.hpp"
#include "commands.hpp"
#include "messages.hpp"
#include "picture_file.hpp"
#include "table.hpp"

namespace brash::cli {
namespace {

/// What became of a mesh when it was read.
void print_mesh(const model::Mesh& mesh) {
  const structure::MeshReport report = structure::examine(mesh).value();  // the case has been checked
  print("# mesh                           {} triangles in {} shell{}\n", report.n_triangles, report.n_shells,
        report.n_shells == 1 ? "" : "s");
  print(
      "# repairs of the mesh            {} vertices joined, {} triangles dropped, {} turned, {} holes filled, {} inner "
      "shells left out\n",
      report.n_joined, report.n_dropped, report.n_turned, report.n_holes_filled, report.n_inner_shells);
  print("# convex parts of the mesh       {}, their volume is off by {:.2g} %\n", report.n_parts,
        100.0 * report.parts_error);
}

/// The hull as it lies in the water.
void print_hull(const model::Case& resolved) {
  const auto hull = structure::make_hull(resolved.structure);
  const auto [least, most] = hull->bounds();
  const structure::Displacement wet = hull->displaced({});
  print("# hull                           {:.4g} m long, {:.4g} m wide, {:.4g} m high\n", most.x - least.x,
        most.y - least.y, most.z - least.z);
  if (!resolved.structure.legs.empty()) print("# legs                           {}\n", resolved.structure.legs.size());
  print("# displacement                   {:.5g} m3, {:.5g} kg\n", wet.volume, resolved.water.density * wet.volume);
  print("# centre of buoyancy             {:.4g} m ahead, {:.4g} m to port, {:.4g} m under water\n", wet.centre.x,
        wet.centre.y, -wet.centre.z);
  print("# waterplane                     {:.5g} m2\n", wet.waterplane.area);
  for (const structure::NaturalMode& mode : structure::make_motion(resolved, *hull)->natural_modes()) {
    if (mode.squared_frequency > 0.0)
      print("# natural period                 {:.4g} s, mostly {}\n", 2.0 * kPi / std::sqrt(mode.squared_frequency),
            mode.motion);
    else
      print("# no way back                    mostly {}: the structure is not stable there\n", mode.motion);
  }
}

/// The large ones are plates.
void print_floes(const model::Case& resolved, const simulation::InitialField& field) {
  const std::size_t n_plates = field.sheets.size();
  const double area = field.area + field.sheet_area;
  print("# floes                          {}{}, {:.4g} m2, concentration {:.4g}\n", field.floes.size() + n_plates,
        n_plates == 0 ? "" : fmt::format(" ({} of them plates)", n_plates), area,
        area / (resolved.field.length * resolved.field.width));
}

void check_case(const std::string& path, const std::vector<std::string>& overrides, const std::string& picture) {
  refuse_overwriting(picture, {path});
  io::refuse_replacing_results(picture);
  model::Case resolved = io::read_case(path, overrides);
  for (const std::string* const file : model::files_of(resolved)) refuse_overwriting(picture, {*file});
  check_picture_name(picture);
  const simulation::DerivedScales scales = simulation::derived_scales(resolved);
  print_data(io::to_toml(resolved));
  const std::string keys = fmt::format("{}", fmt::join(io::keys_set_by_preset(path, overrides), ", "));
  print("\n# {}", io::origin_line(io::origin_of(resolved)));
  print("\n# set by algorithm.preset = \"{}\": {}\n\n# derived\n", model::name_of(resolved.algorithm.preset),
        keys.empty() ? "nothing, each of its keys is written" : keys);
  print("# characteristic length l_c      {:.4g} m\n", scales.characteristic_length);
  print("# thickness / l_c                {:.4g}\n", scales.thickness_over_lc);
  print("# mu1 straight ahead             {:.4g}\n", scales.mu1);
  print("# freeboard, draught             {:.4g} m, {:.4g} m\n", scales.freeboard, scales.draft);
  print("# T_col of a piece l_c x l_c / 4 {:.4g} s\n", scales.collision_time);
  const simulation::InitialField field = simulation::initial_field(resolved);
  if (resolved.field.kind == model::FieldKind::kLevelIce && resolved.field.initial_crack)
    print("# initial crack radius           {:.4g} m\n", scales.initial_crack_radius);
  if (model::has_ice_files(resolved.field)) {
    print("# level ice                      {} sheet{}, {:.6g} m2\n", field.sheets.size(),
          field.sheets.size() == 1 ? "" : "s", field.sheet_area);
    print("# floes                          {}, {:.4g} m2\n", field.floes.size(), field.area);
  }
  if (resolved.field.kind == model::FieldKind::kFloes) print_floes(resolved, field);
  if (scales.correlation_length > 0.0) print("# correlation length of the ice  {:.4g} m\n", scales.correlation_length);
  print_hull(resolved);
  if (const auto* const mesh = std::get_if<model::Mesh>(&resolved.structure.shape)) print_mesh(*mesh);
  if (!picture.empty()) write_picture(picture, report::case_picture(resolved, {field.sheets, field.floes, field.land}));
  print_warnings(scales.warnings);
}

}  // namespace

void add_check_command(CLI::App& app) {
  struct Options {
    std::string case_file, picture;
    std::vector<std::string> overrides;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("check", "Read a case, print it in SI with derived lengths and warnings");
  command->add_option("case", options->case_file, "case file (TOML)")->required();
  command->add_option("--set", options->overrides, "section.key=value")->take_all()->allow_extra_args(false);
  command->add_option("--picture", options->picture, "draw hull, waterline and field into this file, SVG or PNG");
  command->footer("Example: brash check experiments/ships/icebreaker.toml --picture ship.svg");
  command->callback([options] { check_case(options->case_file, options->overrides, options->picture); });
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
