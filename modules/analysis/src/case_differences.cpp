// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <sstream>

#include "brash/analysis/history_comparison.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/text.hpp"

namespace brash::analysis {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// The keys of a case as its manifest has them, "ice.thickness", with their values as text.
using CaseKeys = std::map<std::string, std::string>;

/// A manifest's statements on the origin of a history.
struct Behind {
  CaseKeys keys;
  std::string program;  ///< its hash
};

/// The keys of a resolved case: a line each, and a line with the name of each section.
CaseKeys keys_of(const std::string& toml) {
  CaseKeys keys;
  std::istringstream lines(toml);
  std::string section;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("[")) section = line.substr(1, line.find(']') - 1);
    const std::size_t equals = line.find(" = ");
    if (line.starts_with("#") || equals == std::string::npos) continue;
    std::string value = line.substr(equals + 3);
    if (!value.starts_with('"')) value = value.substr(0, value.find("  #"));
    keys[section + "." + line.substr(0, equals)] = value;
  }
  return keys;
}

/// Nothing where no manifest of a run lies beside the file.
std::optional<Behind> case_behind(const std::string& file) {
  const fs::path path = fs::path(file).parent_path() / "manifest.json";
  try {
    const ordered_json manifest =
        ordered_json::parse(read_json_text(path.string(), "the manifest of a run"), nullptr, false);
    if (!manifest.is_object() || !manifest.contains("case") || !manifest.contains("program")) return {};
    const ordered_json toml =
        manifest["case"].is_object() ? manifest["case"].value("toml", ordered_json()) : ordered_json();
    const ordered_json program =
        manifest["program"].is_object() ? manifest["program"].value("sha256", ordered_json()) : ordered_json();
    if (!toml.is_string() || !program.is_string()) return {};
    return Behind{keys_of(toml.get<std::string>()), program.get<std::string>()};
  } catch (const InputError&) {
    return {};
  }
}

bool are_one_file(const LoadHistory& a, const LoadHistory& b) {
  std::error_code ignored;
  return fs::equivalent(fs::path(a.file), fs::path(b.file), ignored) ||
         fs::equivalent(fs::absolute(a.file).parent_path() / "manifest.json",
                        fs::absolute(b.file).parent_path() / "manifest.json", ignored);
}

std::string value_of(const CaseKeys& keys, const std::string& key) {
  const auto found = keys.find(key);
  return found == keys.end() ? "" : found->second;
}

}  // namespace

void add_case_differences(const std::vector<LoadHistory>& runs, const std::vector<LoadHistory>& measured,
                          ordered_json& comparison) {
  for (const LoadHistory& run : runs)
    for (const LoadHistory& other : measured)
      if (are_one_file(run, other)) comparison["same_run"] = run.file;
  const std::optional<Behind> one = case_behind(runs.front().file), other = case_behind(measured.front().file);
  if (!one || !other) return;
  std::set<std::string> names;
  for (const CaseKeys* const keys : {&one->keys, &other->keys})
    for (const auto& [name, value] : *keys) names.insert(name);
  if (runs.size() > 1 || measured.size() > 1) names.erase("random.replicate");
  comparison["inputs_that_differ"] = ordered_json::array();
  for (const std::string& name : names)
    if (const std::string a = value_of(one->keys, name), b = value_of(other->keys, name); a != b)
      comparison["inputs_that_differ"].push_back({{"key", name}, {"run", a}, {"measured", b}});
  const bool is_repeated = one->program == other->program && one->keys == other->keys;
  if (is_repeated && !comparison.contains("same_run")) comparison["same_run"] = runs.front().file;
}

std::string case_differences_text(const ordered_json& comparison) {
  std::string text;
  if (comparison.contains("same_run"))
    text += fmt::format("both sides have the same run, {}: they cannot differ\n\n",
                        printable(comparison["same_run"].get<std::string>()));
  if (!comparison.contains("inputs_that_differ") || comparison["inputs_that_differ"].empty()) return text;
  const auto [first, second] = side_names(comparison);
  text += fmt::format("{:<36} {:>20} {:>20}\n", "inputs that differ", first, second);
  for (const ordered_json& row : comparison["inputs_that_differ"])
    text += fmt::format("{:<36} {:>20} {:>20}\n", row["key"].get<std::string>(),
                        printable(row["run"].get<std::string>()), printable(row["measured"].get<std::string>()));
  return text + "\n";
}

}  // namespace brash::analysis
