// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/io/recorded_case.hpp"
#include "brash/io/series.hpp"
#include "brash/model/case_keys.hpp"
#include "resolve.hpp"
#include "schema.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

/// A key that names a file.
struct FileKey {
  const char* section;
  const char* key = "file";
  std::string* value;

  Place place(const CaseSource& source) const { return place_of(source, section, key); }
};

/// The file keys of a case: the model of the failure, the ice and the shore of a field, the mesh of the structure.
std::vector<FileKey> file_keys(model::Case& c) {
  std::vector<FileKey> keys{{.section = "failure", .value = &c.failure.file}};
  model::visit_files_of_field(c.field, [&](const char* key, std::string& file) {
    keys.push_back({.section = "field", .key = key, .value = &file});
  });
  if (auto* const mesh = std::get_if<model::Mesh>(&c.structure.shape))
    keys.push_back({.section = "structure", .value = &mesh->file});
  return keys;
}

/// A file is named relative to the file that names it, or to the working folder where the command line does.
void resolve_file(const FileKey& file, const CaseSource& source) {
  if (file.value->empty()) return;
  const Place named = file.place(source);
  const std::filesystem::path base =
      named.override_text.empty() ? std::filesystem::path(named.file).parent_path() : std::filesystem::path();
  *file.value = std::filesystem::absolute(base / *file.value).lexically_normal().string();
}

/// Reports a file outside the folder of the file that names it, and a mesh without a file.
void add_leads_out(const FileKey& file, const CaseSource& source, std::vector<Problem>& problems) {
  const Place named = file.place(source);
  if (file.value->empty() && file.section == std::string("structure"))
    problems.push_back({named, "structure.file", "", "names no file", "a mesh in STL, OBJ, PLY or OFF", "",
                        "write its name, relative to the case file"});
  if (file.value->empty() || !named.override_text.empty()) return;
  const auto folder = std::filesystem::absolute(named.file).lexically_normal().parent_path();
  const auto lies_in = [&](const std::filesystem::path& allowed) {
    const std::filesystem::path inside = std::filesystem::path(*file.value).lexically_relative(allowed);
    return !inside.empty() && *inside.begin() != "..";
  };
  // The settings of a campaign name its copies of the files.
  if (lies_in(folder) || (folder.filename() == "settings" && lies_in(folder.parent_path() / "inputs"))) return;
  const std::string name = fmt::format("{}.{}", file.section, file.key);
  problems.push_back(
      {named, name, value_text(source, file.section, file.key), "leads out of the folder of the file that names it",
       "a file in that folder or below", "",
       fmt::format("put the file beside the case, or name it on the command line: --set {}=PATH may lead anywhere",
                   name)});
}

/// A path in a file becomes the table in it.
void read_path(Json& motion, const CaseSource& source, ModelFile in) {
  const auto path = motion.find("path");
  if (path == motion.end() || !path->is_string()) return;
  std::string file = path->get<std::string>();
  const FileKey key{"structure.motion", "path", &file};
  resolve_file(key, source);
  std::vector<Problem> problems;
  if (in == ModelFile::kInItsFolder) add_leads_out(key, source, problems);
  if (!problems.empty()) refuse(std::move(problems));
  const Series series = read_series(file);
  const auto column = [&](const char* name, const char* unit) -> const std::vector<double>& {
    const auto found = std::ranges::find(series.names, name);
    const auto i = static_cast<std::size_t>(found - series.names.begin());
    if (found == series.names.end() || (!series.units[i].empty() && series.units[i] != unit))
      throw InputError(Complaint{file, fmt::format("has no column {} in {}", name, unit),
                                 "the columns time, x, y and heading, each with or without a unit",
                                 "name the columns in the first line, such as time,x,y,heading_deg"});
    return series.columns[i];
  };
  const auto &time = column("time", "s"), &x = column("x", "m"), &y = column("y", "m"),
             &heading = column("heading", "rad");
  Json rows = Json::array();
  for (std::size_t i = 0; i < time.size(); ++i) {
    for (const double value : {time[i], x[i], y[i], heading[i]})
      if (!std::isfinite(value))
        throw InputError(Complaint{series.place(i), "has no number in a column of the path", "four finite numbers",
                                   "complete the row, or remove it"});
    rows.push_back({time[i], x[i], y[i], heading[i]});
  }
  *path = std::move(rows);
}

/// A default that the chosen failure model does not take is not a wish of the user.
void drop_options_not_taken(model::Case& c, const CaseSource& source) {
  const auto is_written = [&](const char* key) { return source.tree["failure"][key].node() != nullptr; };
  const model::FailureOptions takes = model::options_of(c.failure.model, !c.failure.file.empty());
  if (!takes.radial_first && !is_written("order")) c.failure.order = model::CrackOrder::kCircumferentialFirst;
  if (!takes.second_order && !is_written("second_order")) c.failure.second_order = false;
  if (!takes.moving_edge && !is_written("edge")) c.failure.edge = model::EdgeMotion::kStatic;
  if (!takes.knows_field && !is_written("judged")) c.failure.judged = model::JudgedAt::kCentreLine;
  if (!takes.knows_field && !is_written("pattern")) c.failure.pattern = model::CrackPattern::kDisc;
  if (!takes.joint_loads && !is_written("joint_loads")) c.failure.joint_loads = false;
  if (!takes.knows_field && !is_written("lateness")) c.failure.lateness = 0.0;
  if (!takes.file && !is_written("small_contact")) c.failure.small_contact = model::SmallContact::kKeepsForce;
  if (!takes.meta_model && !is_written("length_density")) c.failure.length_density = model::LengthDensity::kWater;
  if (!takes.meta_model && !is_written("pressure")) c.failure.pressure = model::EdgePressure::kEdge;
}

/// The same for the laws of the water.
void drop_water_laws_not_taken(model::Case& c, const CaseSource& source) {
  const auto is_written = [&](const char* key) { return source.tree["hydrodynamics"][key].node() != nullptr; };
  model::HydrodynamicsSection& h = c.hydrodynamics;
  if (h.drag != model::DragLaw::kSurface && !is_written("form_drag_along"))
    h.form_drag_along = model::FormDragAlong::kVelocity;
  const bool by_share = is_written("added_mass") || c.contact.engine == model::ContactEngine::kBullet;
  const bool is_plate = h.added_mass_law == model::AddedMassLaw::kPlate;
  if (is_plate && by_share && !is_written("added_mass_law")) h.added_mass_law = model::AddedMassLaw::kIsotropic;
}

/// The preset's engine gives way where another key needs the program's own.
void drop_engine_not_taken(model::Case& c, const CaseSource& source) {
  if (source.tree["contact"]["engine"].node() != nullptr) return;
  const bool drifts = model::has_level_ice(c.field) && c.field.border == model::Border::kFree;
  const bool by_direction = c.hydrodynamics.added_mass_law == model::AddedMassLaw::kPlate;
  if (drifts || by_direction || c.water.depth || c.contact.restitution > 0.0)
    c.contact.engine = model::ContactEngine::kBrash;
}

std::string name_of_case(const std::string& path) {
  // "...toml" would name its results "..".
  const std::string name = std::filesystem::path(path).stem().string();
  if (name.empty() || name == "." || name == "..")
    throw InputError(Complaint{path, "gives its case no name", "a file name such as cone.toml", "rename the file"});
  return name;
}

/// The initial crack belongs to the straight edge of a rectangle.
void drop_initial_crack_of_files(model::Case& c, const CaseSource& source) {
  if (model::has_ice_files(c.field) && source.tree["field"]["initial_crack"].node() == nullptr)
    c.field.initial_crack = false;
}

}  // namespace

model::Case resolve(const CaseSource& source, const std::string& name, ModelFile model_file, FieldFiles files) {
  Json document = validated(source, schema_of_cases());
  read_path(document.at("structure.motion"), source, model_file);
  model::Case result = model::from_tree(document);
  result.name = name;
  for (const FileKey& file : file_keys(result)) resolve_file(file, source);
  drop_options_not_taken(result, source);
  drop_engine_not_taken(result, source);
  drop_water_laws_not_taken(result, source);
  drop_initial_crack_of_files(result, source);
  std::vector<Problem> problems;
  if (model_file == ModelFile::kInItsFolder)
    for (const FileKey& file : file_keys(result)) add_leads_out(file, source, problems);
  if (problems.empty()) problems = cross_check(result, source, files);
  if (!problems.empty()) refuse(std::move(problems));
  return result;
}

std::vector<std::string> keys_set_by_preset(const std::string& path, const std::vector<std::string>& overrides) {
  const CaseSource source = parse_source(read_case_text(path), path, overrides);
  const std::string preset = source.tree["algorithm"]["preset"].value_or(std::string());
  std::vector<std::string> keys;
  for (const auto& [section, part] : schema_of_cases().sections().items())
    for (const auto& [key, key_schema] : part.at("properties").items())
      if (key_schema.contains("x-presets") && Schema::has_default(key_schema, preset) &&
          source.tree[section][key].node() == nullptr)
        keys.push_back(section + "." + key);
  return keys;
}

model::Case read_case(const std::string& path, const std::vector<std::string>& overrides, ModelFile model_file) {
  return parse_case(read_case_text(path), path, overrides, model_file);
}

std::string read_case_text(const std::string& path) { return read_text(path, "case file"); }

model::Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
                       ModelFile model_file) {
  const std::string name = name_of_case(path);
  return resolve(parse_source(text, path, overrides), name, model_file);
}

model::Case parse_recorded_case(const std::string& text, const std::string& path,
                                const std::vector<std::string>& overrides, ModelFile model_file) {
  const std::string name = name_of_case(path);
  return resolve(parse_source(text, path, overrides), name, model_file, FieldFiles::kMayBeGone);
}

}  // namespace brash::io
