// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brash {

/// `text` with control characters (C0, DEL, C1), characters that turn the direction of writing, and bytes that are not
/// UTF-8 escaped: text from a file may not steer a terminal.
std::string escaped(const std::string& text);
/// The same, line breaks and tabs left as they are: for messages and tables of several lines.
std::string escaped_lines(const std::string& text);
/// The same, such characters as "\\u" and four digits, as in the strings of JSON and TOML; line breaks and bytes that
/// are not UTF-8 are left as they are.
std::string escaped_as_unicode(const std::string& text);
/// Whether the character of UTF-8 that begins at `at` steers a terminal or the direction of writing.
bool steers_output(const std::string& text, std::size_t at);
/// The same, cut after 80 bytes.
std::string printable(const std::string& text);

/// The name in `known` with the least edit distance from `name` (ties: the first), or "" when none is similar.
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace brash
