// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/io/run_summary.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "brash/core/input_file.hpp"
#include "brash/io/origin.hpp"

namespace brash::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json read_summary(const std::string& path) {
  constexpr const char* kRunSummary = "the summary.json of a run";
  return json::parse(read_json_text(path, kRunSummary), nullptr, /*allow_exceptions=*/false);
}

/// The summary of the run that a history is of, if the file's name is of one and a summary is there.
std::optional<std::string> summary_beside(const std::string& history) {
  const fs::path file = history, summary = file.parent_path() / "summary.json";
  std::error_code ignored;
  if ((file.filename() != "history.csv" && file.filename() != "run.nc") || !fs::exists(summary, ignored))
    return std::nullopt;
  return summary.string();
}

std::optional<double> number_in(const std::string& summary, const char* key) {
  const json found = read_summary(summary);
  if (!found.is_object() || !found.contains(key) || !found[key].is_number()) return std::nullopt;
  return found[key].get<double>();
}

bool is_warning(const json& warning) {
  const auto has_text = [&](const char* key) { return warning.contains(key) && warning[key].is_string(); };
  return warning.is_object() && has_text("id") && has_text("text");
}

}  // namespace

bool is_campaign(const std::string& folder) {
  std::error_code ignored;
  return fs::exists(folder + "/campaign.csv", ignored);
}

std::optional<double> start_in(const std::string& summary) { return number_in(summary, "statistics_from"); }
std::optional<double> end_in(const std::string& summary) { return number_in(summary, "statistics_until"); }

std::optional<double> start_beside(const std::string& history) {
  const auto summary = summary_beside(history);
  return summary ? start_in(*summary) : std::nullopt;
}

std::optional<double> end_beside(const std::string& history) {
  const auto summary = summary_beside(history);
  return summary ? end_in(*summary) : std::nullopt;
}

std::vector<model::Warning> warnings_beside(const std::string& history) {
  const auto path = summary_beside(history);
  if (!path) return {};
  const json summary = read_summary(*path);
  std::vector<model::Warning> warnings;
  if (!summary.is_object() || !summary.contains("warnings") || !summary["warnings"].is_array()) return warnings;
  for (const json& warning : summary["warnings"])
    if (is_warning(warning)) warnings.push_back({warning["id"].get<std::string>(), warning["text"].get<std::string>()});
  return warnings;
}

model::Origin origin_of_history(const std::string& history) {
  const fs::path file = history;
  if (file.extension() == ".nc") return origin_in(history);
  return file.filename() == "history.csv" ? origin_in((file.parent_path() / "manifest.json").string())
                                          : model::Origin{};
}

}  // namespace brash::io
