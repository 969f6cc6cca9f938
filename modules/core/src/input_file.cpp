// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/input_file.hpp"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "brash/core/error.hpp"

namespace brash {

std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mebibytes) {
  const std::string size = std::to_string(most_mebibytes) + " MiB";
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw InputError(Complaint{path, what, kind + ": a readable file of at most " + size, remedy});
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("is a folder", "name the file in it");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    refuse("cannot be opened: " + std::generic_category().message(errno), "check the path and its permissions");
  }
  // In blocks: a device has no size, and a file's may change.
  constexpr std::size_t kBlock = std::size_t{1} << 16;
  const std::size_t most = most_mebibytes << 20;
  const auto file_size = std::filesystem::file_size(path, ignored);
  std::string text;
  if (!ignored && file_size <= most) text.reserve(file_size + kBlock);
  for (bool more = ignored || file_size <= most; more;) {
    const std::size_t before = text.size();
    text.resize(before + kBlock);
    stream.read(text.data() + before, kBlock);
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
    if (stream.bad()) refuse("cannot be read", "check the file");
    if (stream.eof() && text.size() <= most) return text;
    more = text.size() <= most;
  }
  refuse("is larger than " + size, "check that it is the right file");
  return {};
}

std::string read_json_text(const std::string& path, const std::string& kind) {
  std::string text = read_text_file(path, kind, 64);
  refuse_deep_json(text, path, kind);
  return text;
}

void refuse_deep_json(const std::string& text, const std::string& path, const std::string& kind) {
  constexpr int kDeepest = 64;
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string && c == '\\')
      ++i;
    else if (c == '"')
      in_string = !in_string;
    else if (!in_string && (c == '[' || c == '{'))
      ++depth;
    else if (!in_string && (c == ']' || c == '}'))
      --depth;
    if (depth > kDeepest) {
      throw InputError(Complaint{path + ", byte " + std::to_string(i + 1), "is nested too deeply",
                                 kind + ", at most " + std::to_string(kDeepest) + " deep",
                                 "check that it is the right file"});
    }
  }
}

void refuse_overwriting(const std::string& output, std::initializer_list<std::string> inputs) {
  for (const std::string& input : inputs) {
    // Not equivalent where one of them is not there.
    std::error_code ignored;
    if (std::filesystem::equivalent(output, input, ignored)) {
      throw InputError(Complaint{output, "would be written over " + input + ", which is an input",
                                 "a file that the command does not read", "give another name for what is written"});
    }
  }
}

std::size_t most_values_in(std::uintmax_t n_bytes) {
  constexpr std::uintmax_t kBestDeflation = 1032;
  constexpr std::uintmax_t kMost = std::uintmax_t{1} << 27;
  return static_cast<std::size_t>(std::min(kMost, kBestDeflation * std::min(n_bytes, kMost)));
}

}  // namespace brash
