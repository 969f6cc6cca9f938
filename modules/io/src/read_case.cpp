// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/io/case.hpp"
#include "brash/model/case_keys.hpp"
#include "cross_checks.hpp"
#include "resolve.hpp"
#include "schema.hpp"
#include "validate.hpp"

namespace brash::io {
namespace {

/// A model file is named relative to the file that names it, or to the working folder where the command line does.
std::string resolve_file(const std::string& file, const CaseSource& source) {
  if (file.empty()) return file;
  const Place named = place_of(source, "failure", "file");
  const std::filesystem::path base =
      named.override_text.empty() ? std::filesystem::path(named.file).parent_path() : std::filesystem::path();
  return std::filesystem::absolute(base / file).lexically_normal().string();
}

/// A default that the chosen failure model does not take is no wish of the user.
void drop_options_not_taken(model::Case& c, const CaseSource& source) {
  const auto is_written = [&](const char* key) { return source.tree["failure"][key].node() != nullptr; };
  const model::FailureOptions takes = model::options_of(c.failure.model, !c.failure.file.empty());
  if (!takes.radial_first && !is_written("order")) c.failure.order = model::CrackOrder::kCircumferentialFirst;
  if (!takes.second_order && !is_written("second_order")) c.failure.second_order = false;
  if (!takes.moving_edge && !is_written("edge")) c.failure.edge = model::EdgeMotion::kStatic;
  if (!takes.knows_field && !is_written("judged")) c.failure.judged = model::JudgedAt::kCentreLine;
  if (!takes.knows_field && !is_written("pattern")) c.failure.pattern = model::CrackPattern::kDisc;
  if (!takes.joint_loads && !is_written("joint_loads")) c.failure.joint_loads = false;
}

/// Likewise of the laws of the water.
void drop_water_laws_not_taken(model::Case& c, const CaseSource& source) {
  const auto is_written = [&](const char* key) { return source.tree["hydrodynamics"][key].node() != nullptr; };
  model::HydrodynamicsSection& h = c.hydrodynamics;
  if (h.drag != model::DragLaw::kSurface && !is_written("form_drag_along"))
    h.form_drag_along = model::FormDragAlong::kVelocity;
  const bool by_share = is_written("added_mass") || c.contact.engine == model::ContactEngine::kBullet;
  if (by_share && !is_written("added_mass_law")) h.added_mass_law = model::AddedMassLaw::kIsotropic;
}

/// The problem of a model file outside the folder of the file that names it.
std::vector<Problem> leads_out(const std::string& file, const CaseSource& source) {
  const Place named = place_of(source, "failure", "file");
  if (file.empty() || !named.override_text.empty()) return {};
  const auto folder = std::filesystem::absolute(named.file).lexically_normal().parent_path();
  const std::filesystem::path inside = std::filesystem::path(file).lexically_relative(folder);
  if (!inside.empty() && *inside.begin() != "..") return {};
  return {{named, "failure.file", value_text(source, "failure", "file"),
           "leads out of the folder of the file that names it", "a file in that folder or below", "",
           "put the model beside the case, or name it on the command line: --set failure.file=PATH may lead anywhere"}};
}

}  // namespace

model::Case resolve(const CaseSource& source, const std::string& name, ModelFile model_file) {
  model::Case result = model::from_tree(validated(source, schema_of_cases()));
  result.name = name;
  result.failure.file = resolve_file(result.failure.file, source);
  drop_options_not_taken(result, source);
  drop_water_laws_not_taken(result, source);
  std::vector<Problem> problems;
  if (model_file == ModelFile::kInItsFolder) problems = leads_out(result.failure.file, source);
  if (problems.empty()) problems = cross_check(result, source);
  if (!problems.empty()) refuse(std::move(problems));
  return result;
}

std::vector<std::string> keys_set_by_preset(const std::string& path, const std::vector<std::string>& overrides) {
  const CaseSource source = parse_source(read_case_text(path), path, overrides);
  std::vector<std::string> keys;
  for (const auto& [section, part] : schema_of_cases().sections().items())
    for (const auto& [key, key_schema] : part.at("properties").items())
      if (key_schema.contains("x-presets") && source.tree[section][key].node() == nullptr)
        keys.push_back(section + "." + key);
  return keys;
}

model::Case read_case(const std::string& path, const std::vector<std::string>& overrides, ModelFile model_file) {
  return parse_case(read_case_text(path), path, overrides, model_file);
}

std::string read_case_text(const std::string& path) { return read_text(path, "case file"); }

model::Case parse_case(const std::string& text, const std::string& path, const std::vector<std::string>& overrides,
                       ModelFile model_file) {
  // "...toml" would name its results "..".
  const std::string name = std::filesystem::path(path).stem().string();
  if (name.empty() || name == "." || name == "..")
    throw InputError(Complaint{path, "gives its case no name", "a file name such as cone.toml", "rename the file"});
  return resolve(parse_source(text, path, overrides), name, model_file);
}

}  // namespace brash::io
