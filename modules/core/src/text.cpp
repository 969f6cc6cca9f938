// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/text.hpp"

#include <algorithm>
#include <numeric>
#include <string_view>
#include <utility>

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

/// The number of a character of `length` bytes of UTF-8.
unsigned code_point(const std::string& text, std::size_t at, std::size_t length) {
  const auto first = static_cast<unsigned char>(text[at]);
  unsigned code = length == 1 ? first : first & (0x7fU >> length);
  for (std::size_t i = at + 1; i < at + length; ++i) code = code << 6 | (static_cast<unsigned char>(text[i]) & 0x3fU);
  return code;
}

/// Controls (C0, DEL, C1), and characters that turn the direction of writing or hide in a line: the marks, embeddings,
/// overrides and isolates of Unicode's bidirectional algorithm, its line and paragraph separators.
bool steers(unsigned code) {
  return code < 0x20 || (code >= 0x7f && code <= 0x9f) || code == 0x61c || (code >= 0x200b && code <= 0x200f) ||
         (code >= 0x2028 && code <= 0x202e) || (code >= 0x2060 && code <= 0x206f) || code == 0xfeff;
}

std::string escaped_but(const std::string& text, std::string_view kept) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(character_length(text, i), 1);
    if (kept.find(text[i]) != std::string_view::npos || !steers_output(text, i)) {
      shown += text.substr(i, length);
    } else {
      for (std::size_t k = i; k < i + length; ++k) {
        const auto byte = static_cast<unsigned char>(text[k]);
        shown += {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
      }
    }
    i += length;
  }
  return shown;
}

}  // namespace

bool steers_output(const std::string& text, std::size_t at) {
  const std::size_t length = character_length(text, at);
  return length == 0 || steers(code_point(text, at, length));
}

std::string escaped(const std::string& text) { return escaped_but(text, ""); }

std::string escaped_as_unicode(const std::string& text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string shown;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = character_length(text, i);
    const unsigned code = length == 0 ? 0U : code_point(text, i, length);
    if (length > 0 && text[i] != '\n' && steers(code))
      shown +=
          {'\\', 'u', kDigits[code >> 12 & 15], kDigits[code >> 8 & 15], kDigits[code >> 4 & 15], kDigits[code & 15]};
    else
      shown += text.substr(i, std::max<std::size_t>(length, 1));
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

std::string escaped_lines(const std::string& text) { return escaped_but(text, "\n\t"); }

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

namespace {

/// Levenshtein's distance: the least number of insertions, deletions and replacements between two names.
std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = std::exchange(row[j], std::min({row[j] + 1, row[j - 1] + 1, replaced}));
    }
  }
  return row.back();
}

}  // namespace

std::string nearest_name(const std::string& name, const std::vector<std::string>& known) {
  constexpr std::size_t kLongestName = 64;
  if (name.size() > kLongestName) return "";
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const std::string& candidate : known) {
    const std::size_t distance = edit_distance(name, candidate);
    if (nearest == nullptr || distance < least) {
      nearest = &candidate;
      least = distance;
    }
  }
  // With more than half of the letters wrong, the names are not similar.
  if (nearest == nullptr || 2 * least > std::max(name.size(), nearest->size())) return "";
  return *nearest;
}

}  // namespace brash
