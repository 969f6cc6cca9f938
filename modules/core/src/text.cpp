// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/text.hpp"

#include <algorithm>
#include <string_view>

#include "brash/core/error.hpp"

namespace brash {
namespace {

/// Bytes of the UTF-8 character that begins at `at`; 0 when none does.
std::size_t character_length(const std::string& text, std::size_t at) {
  const auto first = static_cast<unsigned char>(text[at]);
  const std::size_t length = first < 0x80   ? 1
                             : first < 0xc2 ? 0
                             : first < 0xe0 ? 2
                             : first < 0xf0 ? 3
                             : first < 0xf5 ? 4
                                            : 0;
  if (at + length > text.size()) return 0;
  for (std::size_t i = at + 1; i < at + length; ++i)
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  return length;
}

}  // namespace

std::string escaped(const std::string& text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    if (length == 0 || byte < 0x20 || byte == 0x7f)
      shown += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
    else
      shown += text.substr(i, length);
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

std::string printable(const std::string& text) {
  constexpr std::size_t kLongest = 80;
  if (text.size() <= kLongest) return escaped(text);
  // A character of several bytes is not cut: the bytes after its first begin with the bits 10.
  std::size_t end = kLongest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
  return escaped(text.substr(0, end)) + "...";
}

InputError::InputError(const Complaint& complaint)
    : std::runtime_error(escaped(complaint.where) + ": " + escaped(complaint.what) +
                         "\n  allowed: " + escaped(complaint.allowed) + "\n  remedy:  " + escaped(complaint.remedy)) {}

}  // namespace brash
