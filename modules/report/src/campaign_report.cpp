// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
#include "brash/io/origin.hpp"
#include "brash/io/results.hpp"
#include "brash/report/report.hpp"
#include "page.hpp"

namespace brash::report {
namespace {

using nlohmann::ordered_json;

/// Cases of the campaign that kept a report of their own.
ordered_json reports_of_cases(const std::string& directory) {
  ordered_json found = ordered_json::array();
  std::vector<std::string> names;
  const std::filesystem::path cases = std::filesystem::path(directory) / "cases";
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(cases, ignored))
    if (std::filesystem::exists(entry.path() / "report.html")) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  for (const std::string& name : names) found.push_back(name);
  return found;
}

/// The presets and programs of the cases; none in a summary of an earlier version.
model::Origin origin_in_summary(const ordered_json& summary) {
  model::Origin origin;
  const auto add_names = [&](const char* pointer, std::vector<std::string>& names) {
    const ordered_json::json_pointer at(pointer);
    if (!summary.contains(at) || !summary[at].is_array()) return;
    for (const ordered_json& name : summary[at])
      if (name.is_string()) names.push_back(name.get<std::string>());
  };
  add_names("/origin/presets", origin.presets);
  add_names("/origin/programs", origin.programs);
  return origin;
}

}  // namespace

std::string write_campaign_report(const std::string& directory) {
  const ordered_json summary = read_json(directory + "/summary.json");
  const ordered_json data{{"format", "brash-report-1"},
                          {"kind", "campaign"},
                          {"manifest", read_json(directory + "/manifest.json")},
                          {"origin", io::origin_line(origin_in_summary(summary))},
                          {"summary", summary},
                          {"schema", ordered_json::parse(io::case_schema())},
                          {"table", read_text_file(directory + "/campaign.csv", "the table of a campaign")},
                          {"reports", reports_of_cases(directory)},
                          {"blocks", ordered_json::array()}};
  const std::string path = directory + "/report.html";
  write_file(path, page_with(data, ""));
  return path;
}

}  // namespace brash::report
