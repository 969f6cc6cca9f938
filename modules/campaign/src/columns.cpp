// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "brash/campaign/campaign.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/core/sha256.hpp"
#include "brash/simulation/run.hpp"
#include "brash/statistics/summary.hpp"
#include "case_results.hpp"

namespace brash::campaign {
namespace {

using Json = nlohmann::ordered_json;

/// Walks the numbers of a summary in the order of the file.
class Walk {
 public:
  explicit Walk(const Json& summary) : levels_(summary.value("quantile_levels", std::vector<double>())) {
    visit("", summary);
  }
  std::vector<std::pair<std::string, double>> found;

 private:
  void visit(const std::string& name, const Json& value) {
    if (value.is_number()) found.emplace_back(name, value.get<double>());
    if (value.is_boolean()) found.emplace_back(name, value.get<bool>() ? 1.0 : 0.0);
    if (value.is_object())
      for (const auto& [key, member] : value.items()) visit(name.empty() ? key : name + "." + key, member);
    if (!value.is_array() || name == "quantile_levels") return;
    for (std::size_t i = 0; i < value.size(); ++i) visit(name + "." + item(name, value.size(), i), value[i]);
  }

  /// How an item of an array is called: the ends of an interval, a quantile by its level, else its number.
  std::string item(const std::string& name, std::size_t n, std::size_t i) const {
    if (name.ends_with("_95") && n == 2) return i == 0 ? "lower" : "upper";
    if (name.ends_with("quantiles") && n == levels_.size()) return fmt::format("{:02.0f}", 100.0 * levels_[i]);
    return std::to_string(i);
  }

  std::vector<double> levels_;
};

/// A summary with each of the numbers that every run has.
simulation::RunSummary summary_of_any_run() {
  simulation::RunSummary summary;
  const std::size_t n_levels = Json::parse(simulation::to_json(summary)).at("quantile_levels").size();
  // Enough samples for an interval, so that its ends are numbers.
  summary.horizontal.effective_sample_size = summary.vertical.effective_sample_size = 1e3;
  summary.piece_area_quantiles.resize(n_levels);
  summary.breaking_length_quantiles.resize(n_levels);
  summary.overload_quantiles.resize(n_levels);
  summary.stress_quantiles.resize(n_levels);
  return summary;
}

std::vector<std::string> names_in(const simulation::RunSummary& summary) {
  std::vector<std::string> names;
  for (const auto& [name, value] : Walk(Json::parse(simulation::to_json(summary))).found) names.push_back(name);
  return names;
}

}  // namespace

const std::vector<std::string>& default_columns() {
  static const std::vector<std::string> names = names_in(summary_of_any_run());
  return names;
}

const std::vector<std::string>& known_columns() {
  static const std::vector<std::string> names = [] {
    simulation::RunSummary summary = summary_of_any_run();
    model::RegionLoads::visit([&](const char* region, const char*, std::size_t) {
      summary.regions.push_back({region, {}});  // of a ship
    });
    summary.fastest_floe = 0.0;  // of a run with frames
    summary.energy.losses.bed_contact = 1.0;
    summary.initial_floes.emplace();
    summary.initial_floes->size_quantiles.resize(summary.piece_area_quantiles.size());
    return names_in(summary);
  }();
  return names;
}

std::string fingerprint(const std::map<std::string, double>& numbers) {
  std::string text;
  for (const auto& [name, value] : numbers) text += fmt::format("{}={}\n", name, value);
  return sha256(text);
}

std::string unit_of(const std::string& column) {
  const std::string last = column.substr(column.rfind('.') + 1);
  std::string unit_of_statistic;
  statistics::Summary::visit([&](const statistics::Statistic& of, auto) {
    if (last == of.name) unit_of_statistic = of.unit;
  });
  if (!unit_of_statistic.empty()) return unit_of_statistic;
  // The first that fits: numbers of a load without the unit of a load come before the loads.
  using Unit = std::pair<std::string_view, const char*>;
  constexpr auto kUnits = std::to_array<Unit>({{"verdicts.latest", "s"},
                                               {"statistics_from", "s"},
                                               {"statistics_until", "s"},
                                               {"breaking_frequency", "s-1"},
                                               {"breaking_length", "m"},
                                               {"size_quantiles", "m"},
                                               {"piece_area", "m2"},
                                               {"energy.", "J"},
                                               {"fastest_floe", "m s-1"},
                                               {"contact_iterations.", "m s-1"},
                                               {"horizontal", "N"},
                                               {"vertical", "N"},
                                               {"mean_by_region.", "N"}});
  for (const auto& [part, unit] : kUnits)
    if (column.find(part) != std::string::npos) return unit;
  return "1";
}

statistics::Interval possible_values(const std::string& column) {
  constexpr double kNoEnd = std::numeric_limits<double>::infinity();
  const auto is_about = [&](const auto& parts) {
    return std::ranges::any_of(parts, [&](std::string_view part) { return column.find(part) != std::string::npos; });
  };
  if (is_about(std::to_array<std::string_view>({".covered", ".long_enough", "ledger.closes"}))) return {0.0, 1.0};
  if (is_about(std::to_array<std::string_view>({".standard_deviation", ".autocorrelation_time", ".effective_sample"})))
    return {0.0, kNoEnd};
  const bool has_sign = is_about(
      std::to_array<std::string_view>({"horizontal", "vertical", "mean_by_region.", "energy.", "ledger.snap"}));
  return {has_sign ? -kNoEnd : 0.0, kNoEnd};
}

std::vector<model::Warning> warnings_in(const std::string& summary) {
  std::vector<model::Warning> warnings;
  const Json json = Json::parse(summary, nullptr, /*allow_exceptions=*/false);
  if (!json.is_object() || !json.contains("warnings") || !json["warnings"].is_array()) return warnings;
  for (const Json& warning : json["warnings"])
    if (warning.is_object() && warning.contains("id") && warning["id"].is_string())
      warnings.push_back(
          {warning["id"], warning.contains("text") && warning["text"].is_string() ? warning["text"] : ""});
  return warnings;
}

std::map<std::string, double> columns_of(const std::string& path, const std::string& summary) {
  refuse_deep_json(summary, path, "the summary of a run");
  try {
    const Walk walk(Json::parse(summary));
    return {walk.found.begin(), walk.found.end()};
  } catch (const Json::exception& error) {
    throw InputError(
        fmt::format("{}: cannot be read: {}\n  allowed: the summary of a run\n  remedy:  remove its folder; "
                    "`--resume` runs the case again",
                    path, error.what()));
  }
}

}  // namespace brash::campaign
