// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "brash/core/error.hpp"
#include "brash/io/results.hpp"

namespace brash::io {
namespace {

/// Creates `path` with `text` in it, on the disk and not only in the system's memory.
/// @return 0, or the system's error number.
int write_to_disk(const std::string& path, const std::string& text) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  int status = 0;
  for (std::size_t written = 0; written < text.size() && status == 0;) {
    const ssize_t n = ::write(file, text.data() + written, text.size() - written);
    if (n > 0)
      written += static_cast<std::size_t>(n);
    else if (n == 0)
      status = ENOSPC;
    else if (errno != EINTR)
      status = errno;
  }
  // The bytes must be on the disk before the name is: a crash may not leave the name with half of them.
  if (status == 0 && ::fsync(file) != 0) status = errno;
  if (::close(file) != 0 && status == 0) status = errno;
  return status;
}

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  const std::string partial = fmt::format("{}.{}.part", path, ::getpid());
  std::error_code folder_status;
  if (!folder.empty()) std::filesystem::create_directories(folder, folder_status);
  int status = folder_status.value();
  if (status == 0) status = write_to_disk(partial, text);
  if (status == 0 && ::rename(partial.c_str(), path.c_str()) != 0) status = errno;
  if (status == 0) return;
  ::unlink(partial.c_str());
  throw StorageError(fmt::format("{}: cannot be written: {}\n  remedy:  check that its folder may be written and has space",
                             path, std::generic_category().message(status)));
}

}  // namespace brash::io
