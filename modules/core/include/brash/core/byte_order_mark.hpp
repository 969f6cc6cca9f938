// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace brash {

/// A text without the byte order mark of UTF-8, with which spreadsheets begin their files.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

}  // namespace brash
