// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>

#include "brash/core/input_file.hpp"
#include "brash/core/write_file.hpp"
#include "brash/io/case.hpp"
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

}  // namespace

bool is_campaign(const std::string& directory) { return std::filesystem::exists(directory + "/campaign.csv"); }

std::string write_campaign_report(const std::string& directory) {
  const ordered_json data{{"format", "brash-report-1"},
                          {"kind", "campaign"},
                          {"manifest", read_json(directory + "/manifest.json")},
                          {"summary", read_json(directory + "/summary.json")},
                          {"schema", ordered_json::parse(io::case_schema())},
                          {"table", read_text_file(directory + "/campaign.csv", "the table of a campaign")},
                          {"reports", reports_of_cases(directory)},
                          {"blocks", ordered_json::array()}};
  const std::string path = directory + "/report.html";
  write_file(path, page_with(data, ""));
  return path;
}

}  // namespace brash::report
