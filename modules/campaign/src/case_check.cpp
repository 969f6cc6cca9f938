// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <nlohmann/json.hpp>

#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/io/case.hpp"
#include "case_results.hpp"
#include "folder.hpp"

namespace brash::campaign {
namespace {

namespace fs = std::filesystem;

/// Why a result is not as the manifest lists it; empty: it is.
std::string why_changed(const fs::path& case_folder, const nlohmann::json& output) {
  const nlohmann::json name = output.is_object() ? output.value("path", nlohmann::json()) : nlohmann::json();
  if (!name.is_string() || fs::path(name.get<std::string>()).has_parent_path()) return "its manifest.json is damaged";
  const fs::path file = case_folder / name.get<std::string>();
  std::error_code ignored;
  if (!fs::is_regular_file(fs::symlink_status(file, ignored))) return "its " + name.get<std::string>() + " is missing";
  if (output.value("sha256", nlohmann::json()) == sha256_of_file(file.string())) return {};
  return "its " + name.get<std::string>() + " has changed since it was written";
}

}  // namespace

std::string why_unfit(const fs::path& case_folder, const model::Case& expected) {
  const std::string path = (case_folder / "manifest.json").string(), text = read_text(path);
  refuse_deep_json(text, path, "the manifest of a run");
  const nlohmann::json manifest = nlohmann::json::parse(text, nullptr, /*allow_exceptions=*/false);
  const nlohmann::json outputs = manifest.is_object() ? manifest.value("outputs", nlohmann::json()) : nlohmann::json();
  const auto is_summary = [](const nlohmann::json& output) {
    return output.is_object() && output.value("path", nlohmann::json()) == "summary.json";
  };
  if (!outputs.is_array() || std::ranges::none_of(outputs, is_summary)) return "its manifest.json is damaged";
  if (manifest.value("case", nlohmann::json()) !=
      nlohmann::json{{"name", expected.name}, {"toml", io::to_toml(expected)}})
    return "its manifest.json names another case";
  for (const nlohmann::json& output : outputs)
    if (std::string why = why_changed(case_folder, output); !why.empty()) return why;
  return {};
}

}  // namespace brash::campaign
