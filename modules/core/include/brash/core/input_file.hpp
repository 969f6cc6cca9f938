// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace brash {

/// The bytes of a file.
/// @param kind            expected kind of file, for messages: "a model (JSON)".
/// @param most_mebibytes  size above which it is refused, whatever it states of itself.
/// @throws InputError when it is a folder, cannot be read or is larger.
std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mebibytes = 256);

/// The characters of a text file, as in_utf8() has them. @throws InputError as above.
std::string read_characters(const std::string& path, const std::string& kind, std::size_t most_mebibytes = 256);

/// Calls `take` with each line of a text file, without its end, in UTF-8 without a byte order mark. The file is read in
/// blocks, so a long one needs no room, but for one in UTF-16.
/// @throws InputError as above.
void for_each_line(const std::string& path, const std::string& kind, const std::function<void(std::string_view)>& take,
                   std::size_t most_mebibytes = 256);

/// The text of a JSON file of at most 64 MiB, not nested deeper than 64: a recursive function may walk through it.
/// @throws InputError as above, or naming the byte.
std::string read_json_text(const std::string& path, const std::string& kind);

/// Refuses a JSON `text` that is nested deeper than 64, before anyone parses it.
/// @throws InputError naming `path` and the byte.
void refuse_deep_json(const std::string& text, const std::string& path, const std::string& kind);

/// Refuses an output that would take the place of a file that the same command reads, under whatever name.
/// @param output  path to write; empty: nothing is written.
/// @param inputs  paths to read; missing files and empty paths are passed over.
/// @throws InputError naming both.
void refuse_overwriting(const std::string& output, std::initializer_list<std::string> inputs);

/// How many numbers a variable of a netCDF file of `n_bytes` has at most: deflate packs 1032 bytes into one, and 2^27
/// doubles are 1 GiB. Nobody makes room for more, whatever a file states.
std::size_t most_values_in(std::uintmax_t n_bytes);

}  // namespace brash
