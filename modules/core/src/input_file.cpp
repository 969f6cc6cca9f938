// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/input_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "brash/core/byte_order_mark.hpp"
#include "brash/core/error.hpp"

namespace brash {

namespace {

/// A file that is open for reading. Pipes are not waited for: opening one would take until somebody writes.
class Descriptor {
 public:
  explicit Descriptor(const std::string& path) : number_(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC)) {
    if (number_ >= 0) ::fcntl(number_, F_SETFL, ::fcntl(number_, F_GETFL) & ~O_NONBLOCK);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// Reads a file in blocks: a device has no size, and a file's may change.
void for_each_block(const std::string& path, const std::string& kind, std::size_t most_mebibytes,
                    const std::function<void(std::string_view)>& take) {
  const std::string size = std::to_string(most_mebibytes) + " MiB";
  const auto refuse = [&](const std::string& what, const std::string& remedy) {
    throw InputError(Complaint{path, what, kind + ": a readable file of at most " + size, remedy});
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) refuse("is a folder", "name the file in it");
  const Descriptor file(path);
  if (file.number() < 0)
    refuse("cannot be opened: " + std::generic_category().message(errno), "check the path and its permissions");
  const std::size_t most = most_mebibytes << 20;
  const auto file_size = std::filesystem::file_size(path, ignored);
  std::string block(std::size_t{1} << 16, '\0');
  std::size_t n_read = !ignored && file_size > most ? most + 1 : 0;
  while (n_read <= most) {
    const ssize_t n = ::read(file.number(), block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) refuse("cannot be read: " + std::generic_category().message(errno), "check the file");
    if (n == 0 && n_read == 0 && std::filesystem::is_fifo(path, ignored))
      refuse("is a pipe that nobody writes into", "name a file");
    if (n == 0) return;
    n_read += static_cast<std::size_t>(n);
    if (n_read <= most) take(std::string_view(block).substr(0, static_cast<std::size_t>(n)));
  }
  refuse("is larger than " + size, "check that it is the right file");
}

}  // namespace

std::string read_text_file(const std::string& path, const std::string& kind, std::size_t most_mebibytes) {
  std::error_code ignored;
  const auto size = std::filesystem::file_size(path, ignored);
  std::string text;
  if (!ignored) text.reserve(std::min<std::size_t>(size, most_mebibytes << 20));  // growth would take up twice as much
  for_each_block(path, kind, most_mebibytes, [&](std::string_view block) { text += block; });
  return text;
}

std::string read_characters(const std::string& path, const std::string& kind, std::size_t most_mebibytes) {
  return in_utf8(read_text_file(path, kind, most_mebibytes));
}

void for_each_line(const std::string& path, const std::string& kind, const std::function<void(std::string_view)>& take,
                   std::size_t most_mebibytes) {
  std::string begun;  // a line whose end is in a later block
  const auto take_lines = [&](std::string_view block) {
    for (std::size_t end = 0; (end = block.find('\n')) != std::string_view::npos; block.remove_prefix(end + 1)) {
      if (begun.empty()) {
        take(block.substr(0, end));
      } else {
        take(begun += block.substr(0, end));
        begun.clear();
      }
    }
    begun += block;
  };
  bool is_first = true;
  std::string wide;  // a text in UTF-16
  for_each_block(path, kind, most_mebibytes, [&](std::string_view block) {
    const bool begins = std::exchange(is_first, false);
    if (!wide.empty() || (begins && is_utf16(block)))
      wide += block;
    else
      take_lines(begins ? without_byte_order_mark(block) : block);
  });
  if (!wide.empty()) take_lines(in_utf8(std::move(wide)));
  if (!begun.empty()) take(begun);
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
    // Not equivalent where one of the two files is not there.
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
