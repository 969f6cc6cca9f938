// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/origin.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <vector>

#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"
#include "brash/core/version.hpp"
#include "brash/io/case.hpp"
#include "netcdf_file.hpp"
#include "schema.hpp"
#include "toml_source.hpp"
#include "toml_value.hpp"

namespace brash::io {
namespace {

using Json = nlohmann::json;

/// Whether `section.key` is written with another value than its preset gives.
bool is_changed(const toml::table& tree, const std::string& preset, const std::string& section, const std::string& key,
                const OrderedJson& key_schema) {
  const toml::node* const node = tree[section][key].node();
  if (node == nullptr) return false;  // an earlier version wrote the case and did not know the key
  if (!Schema::has_default(key_schema, preset)) return false;
  const auto value = json_value(*node, key_schema);
  return !value || *value != Json::parse(Schema::default_in(key_schema, preset).dump());
}

/// The preset of a resolved case, with the number of its keys that differ; "" in cases from before there were presets.
std::string preset_in(const toml::table& tree) {
  const std::string preset = tree["algorithm"]["preset"].value_or(std::string());
  if (preset.empty()) return "";
  int n_changed = 0;
  for (const auto& [section, part] : schema_of_cases().sections().items())
    for (const auto& [key, key_schema] : part.at("properties").items())
      n_changed += key_schema.contains("x-presets") && is_changed(tree, preset, section, key, key_schema) ? 1 : 0;
  const std::string name = printable(preset);
  return n_changed == 0 ? name : fmt::format("{} ({} key{} changed)", name, n_changed, n_changed == 1 ? "" : "s");
}

/// The origin of a case that `program` resolved, such as "brash 0.2.0".
model::Origin origin_from(const std::string& resolved_toml, const std::string& program) {
  model::Origin origin;
  if (const std::string preset = preset_in(parse_source(resolved_toml, "case", {}).tree); !preset.empty())
    origin.presets.push_back(preset);
  origin.programs.push_back(printable(program));
  return origin;
}

model::Origin origin_in_manifest(const std::string& path) {
  const Json manifest = Json::parse(read_json_text(path, "the manifest of a run"), nullptr, /*allow_exceptions=*/false);
  const Json::json_pointer toml("/case/toml"), version("/program/version");
  const auto is_text = [&](const auto& at) { return manifest.contains(at) && manifest[at].is_string(); };
  if (!manifest.is_object() || !is_text(toml) || !is_text(version)) return {};
  return origin_from(manifest[toml].get<std::string>(), "brash " + manifest[version].get<std::string>());
}

model::Origin origin_in_results(const std::string& path) {
  const NetcdfReader file(path);
  return origin_from(file.attribute("case"), file.attribute("source"));
}

std::string named(const char* what, const std::vector<std::string>& names) {
  return names.empty() ? "" : fmt::format("{}{}: {}", what, names.size() == 1 ? "" : "s", fmt::join(names, ", "));
}

}  // namespace

model::Origin origin_of(const model::Case& resolved) {
  return origin_from(to_toml(resolved), std::string("brash ") + kVersion);
}

model::Origin origin_in(const std::string& path) {
  try {
    return std::filesystem::path(path).extension() == ".nc" ? origin_in_results(path) : origin_in_manifest(path);
  } catch (const InputError&) {
    return {};
  }
}

std::string origin_line(const model::Origin& origin) {
  const std::string presets = named("preset", origin.presets), programs = named("program", origin.programs);
  return presets + (presets.empty() || programs.empty() ? "" : "; ") + programs;
}

}  // namespace brash::io
