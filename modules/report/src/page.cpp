// SPDX-License-Identifier: GPL-3.0-or-later
#include "page.hpp"

#include <fmt/format.h>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/input_file.hpp"
#include "brash/report/report.hpp"

namespace brash::report {
namespace {

constexpr std::string_view kDataMark = "BRASH-REPORT-DATA";
constexpr std::string_view kPackedMark = "BRASH-REPORT-PACKED";

/// JSON that is placed inside an HTML element: no character of it means anything to HTML.
std::string inside_html(const nlohmann::ordered_json& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) {
    if (c == '<' || c == '>' || c == '&')
      text += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      text += c;
  }
  return text;
}

}  // namespace

bool has_page() { return !kPage.empty(); }

std::string page_with(const nlohmann::ordered_json& data, const std::string& packed) {
  if (!has_page())
    throw RunError(
        "no report: this program was built without the report's page\n"
        "  remedy:  install Node.js and npm (Debian: nodejs, npm), configure and build again");
  const std::size_t at_data = kPage.find(kDataMark), at_packed = kPage.find(kPackedMark);
  BRASH_EXPECTS(at_data < at_packed && at_packed != std::string_view::npos);
  std::string page(kPage.substr(0, at_data));
  page += inside_html(data);
  page += kPage.substr(at_data + kDataMark.size(), at_packed - at_data - kDataMark.size());
  page += packed;
  page += kPage.substr(at_packed + kPackedMark.size());
  return page;
}

std::string live_page_with(const nlohmann::ordered_json& data, const std::string& packed) {
  constexpr std::string_view kPolicy = "default-src 'none';";
  std::string page = page_with(data, packed);
  const std::size_t at = page.find(kPolicy);
  BRASH_EXPECTS(at != std::string::npos);
  return page.insert(at + kPolicy.size(), " connect-src 'self';");
}

nlohmann::ordered_json read_json(const std::string& path) {
  constexpr const char* kAllowed = "a file (JSON) of the folder that `brash run` or `brash campaign` wrote";
  const std::string text = read_json_text(path, kAllowed);
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw InputError(Complaint{path, fmt::format("is not JSON: {}", error.what()), kAllowed,
                               "copy it again, or run the case or campaign again"});
  }
}

}  // namespace brash::report
