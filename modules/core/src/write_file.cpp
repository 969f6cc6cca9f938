// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "brash/core/error.hpp"
#include "brash/core/write_pieces.hpp"

namespace brash {
namespace {

/// Writes all of `text`. @return 0, or the system's error number.
int write_all(int file, std::string_view text) {
  for (std::size_t written = 0; written < text.size();) {
    const ssize_t n = ::write(file, text.data() + written, text.size() - written);
    if (n > 0)
      written += static_cast<std::size_t>(n);
    else if (n == 0)
      return ENOSPC;
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

/// Creates `path` with all pieces in it. @return 0, or the system's error number.
int write_part(const std::string& path, const std::function<bool(std::string_view& piece)>& next) {
  // A name may be left by an earlier process of the same number, or be a trap: a file that is there is never opened.
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) return errno;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int status = 0;
  for (std::string_view piece; status == 0 && next(piece);) status = write_all(file, piece);
  if (::close(file) != 0 && status == 0) status = errno;
  return status;
}

/// Waits until the bytes of `path` are on the disk and not only in the system's memory: a crash may not leave a file's
/// final name with half of its bytes. @return 0, or the system's error number.
int to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) return errno;
  const int status = ::fsync(file) == 0 ? 0 : errno;
  return ::close(file) == 0 || status != 0 ? status : errno;
}

[[noreturn]] void refuse(const std::string& part, const std::string& path, int status) {
  ::unlink(part.c_str());
  throw StorageError(
      fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space", path,
                  std::generic_category().message(status)));
}

/// Whether `name` is one of write_file's before it is whole: NAME.PROCESS.part.
bool is_part(const std::string& name) {
  constexpr std::string_view kEnd = ".part";
  if (!name.ends_with(kEnd)) return false;
  const std::string stem = name.substr(0, name.size() - kEnd.size());
  const std::size_t dot = stem.find_last_not_of("0123456789");
  return dot != std::string::npos && dot > 0 && stem[dot] == '.' && dot + 1 < stem.size();
}

}  // namespace

std::string part_of(const std::string& path) { return fmt::format("{}.{}.part", path, ::getpid()); }

void publish(const std::string& part, const std::string& path) {
  int status = to_disk(part);
  if (status == 0 && ::rename(part.c_str(), path.c_str()) != 0) status = errno;
  if (status != 0) refuse(part, path, status);
}

void write_pieces(const std::string& path, const std::function<bool(std::string_view& piece)>& next) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string part = part_of(path);
  std::error_code folder_status;
  if (!folder.empty()) std::filesystem::create_directories(folder, folder_status);
  int status = folder_status.value();
  if (status == 0) status = write_part(part, next);
  if (status != 0) refuse(part, path, status);
  publish(part, path);
}

void write_file(const std::string& path, const std::string& text) {
  write_pieces(path, [&text, done = false](std::string_view& piece) mutable {
    piece = text;
    return !std::exchange(done, true);
  });
}

void remove_parts(const std::string& folder) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (is_part(entry.path().filename().string()) && !entry.is_directory(ignored))
      std::filesystem::remove(entry.path(), ignored);
}

}  // namespace brash
