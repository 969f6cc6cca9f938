// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace brash::fmu {

/// The path that a URI with the scheme `file` names, in letters of either case, without its query and its fragment. A
/// plain path stays as it is (RFC 8089; RFC 3986 Secs. 2.1, 3).
inline std::string path_of_uri(const std::string& uri) {
  constexpr std::string_view kScheme = "file:";
  const auto in_lower_case = [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  if (!std::ranges::equal(uri.substr(0, kScheme.size()), kScheme, {}, in_lower_case)) return uri;
  std::string rest = uri.substr(kScheme.size(), uri.find_first_of("?#") - kScheme.size());
  if (rest.starts_with("//")) rest.erase(0, rest.find('/', 2));  // with the name of this host
  std::string path;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    const auto digit = [&](std::size_t at) {
      return std::string_view("0123456789abcdefABCDEF").find(at < rest.size() ? rest[at] : '?');
    };
    const std::size_t high = digit(i + 1), low = digit(i + 2);
    if (rest[i] != '%' || high == std::string_view::npos || low == std::string_view::npos) {
      path += rest[i];
      continue;
    }
    const auto value = [](std::size_t place) { return place < 16 ? place : place - 6; };
    path += static_cast<char>(16 * value(high) + value(low));
    i += 2;
  }
  return path;
}

}  // namespace brash::fmu
