// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "brash/core/error.hpp"
#include "brash/io/results.hpp"

namespace brash::io {

void fail_to_write(const std::string& path, int reason) {
  throw RunError(
      fmt::format("{}: cannot be written: {}\n  remedy:  check that the folder exists, may be written and has space",
                  path, std::generic_category().message(reason)));
}

WholeFile::WholeFile(std::string path)
    : path_(std::move(path)), partial_(fmt::format("{}.{}.part", path_, ::getpid())) {
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  std::error_code reason;
  if (!folder.empty()) std::filesystem::create_directories(folder, reason);
  if (reason) fail_to_write(path_, reason.value());
}

WholeFile::~WholeFile() {
  if (!published_) ::unlink(partial_.c_str());
}

void WholeFile::publish() {
  // The bytes must be on the disk before the name is: a crash may not leave the name with half of them.
  const int file = ::open(partial_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail_to_write(path_, errno);
  const int synced = ::fsync(file);
  const int reason = errno;
  ::close(file);
  if (synced != 0) fail_to_write(path_, reason);
  if (::rename(partial_.c_str(), path_.c_str()) != 0) fail_to_write(path_, errno);
  published_ = true;
}

void write_file(const std::string& path, const std::string& text) {
  WholeFile whole(path);
  const int file = ::open(whole.partial().c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) fail_to_write(path, errno);
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t n = ::write(file, text.data() + written, text.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) {
      const int reason = errno;
      ::close(file);
      fail_to_write(path, reason);
    }
    written += static_cast<std::size_t>(n);
  }
  if (::close(file) != 0) fail_to_write(path, errno);
  whole.publish();
}

}  // namespace brash::io
