// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "text_ring.hpp"

namespace brash::geometry {
namespace {

/// Codes of EPSG for longitude and latitude: WGS 72 and 84, ETRS89, NAD27 and 83, GDA94 and 2020, JGD, CGCS2000, RGF93,
/// NZGD2000, SIRGAS 2000, NAD83(CSRS and HARN), Hughes 1980, GR96, ISN, Pulkovo 1942, and WGS 84 and ETRS89 with
/// heights.
constexpr std::array<std::string_view, 24> kGeographic{"4326", "4258", "4267", "4269", "4283", "7844", "4612", "6668",
                                                       "4490", "4171", "4167", "4674", "4617", "4747", "4659", "5324",
                                                       "8086", "4284", "4979", "4937", "4054", "4555", "4322", "4152"};

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }

/// The last word of a name, such as 32633 of EPSG::32633.
std::string_view code_of(std::string_view name) {
  const auto last = std::find_if_not(name.rbegin(), name.rend(), is_letter_or_digit);
  return name.substr(static_cast<std::size_t>(name.rend() - last));
}

}  // namespace

bool is_geographic(std::string_view name) {
  const std::string_view code = code_of(name);
  if (code == "CRS84" || code == "CRS84h" || code == "CRS83" || code == "CRS27") return true;
  return name.find("EPSG") != std::string_view::npos && std::ranges::find(kGeographic, code) != kGeographic.end();
}

std::string degrees_refused(std::string_view name) {
  return fmt::format(
      "the coordinates are degrees (crs {}), and the kernel needs metres: project the file, as "
      "`ogr2ogr -t_srs EPSG:32633 metres.geojson degrees.geojson` does with the zone of your map",
      name);
}

std::string crs_of_code(std::string_view code) {
  return fmt::format(R"({{"type":"name","properties":{{"name":"urn:ogc:def:crs:EPSG::{}"}}}})", code);
}

std::string name_of_crs(std::string_view crs) {
  const nlohmann::json json = nlohmann::json::parse(crs, nullptr, false);
  const nlohmann::json::json_pointer name("/properties/name");
  return json.contains(name) && json.at(name).is_string() ? json.at(name).get<std::string>() : std::string();
}

bool are_same_crs(std::string_view a, std::string_view b) {
  const bool are_of_epsg = a.find("EPSG") != std::string_view::npos && b.find("EPSG") != std::string_view::npos;
  return a == b || (are_of_epsg && code_of(a) == code_of(b));
}

bool could_be_degrees(const Survey& survey) {
  if (survey.is_empty()) return false;
  constexpr double kLeastLatitude = 40.0;  // sea ice reaches down to it
  const Vec2 low = survey.low(), high = survey.high();
  const bool is_north = low.y >= kLeastLatitude && high.y <= 90.0;
  const bool is_south = high.y <= -kLeastLatitude && low.y >= -90.0;
  return low.x >= -180.0 && high.x <= 180.0 && (is_north || is_south);
}

std::string_view object_at(std::string_view text, std::size_t offset) {
  int depth = 0;
  bool is_in_string = false;
  for (std::size_t i = offset; i < text.size(); ++i) {
    const char c = text[i];
    if (is_in_string && c == '\\') {
      ++i;
    } else if (c == '"') {
      is_in_string = !is_in_string;
    } else if (!is_in_string && (c == '{' || c == '[')) {
      ++depth;
    } else if (!is_in_string && (c == '}' || c == ']') && --depth == 0) {
      return text.substr(offset, i + 1 - offset);
    }
  }
  return {};
}

}  // namespace brash::geometry
