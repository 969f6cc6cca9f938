// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace brash {

/// A text without the byte order mark of UTF-8, with which spreadsheets begin their files.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";
  return text.starts_with(kMark) ? text.substr(kMark.size()) : text;
}

/// Whether bytes begin with the mark of UTF-16, in which spreadsheets save "Unicode text".
constexpr bool is_utf16(std::string_view bytes) {
  return bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff");
}

/// A text in UTF-8 without a byte order mark, also of UTF-16 with its mark. Half of a pair becomes U+FFFD.
std::string in_utf8(std::string bytes);

}  // namespace brash
