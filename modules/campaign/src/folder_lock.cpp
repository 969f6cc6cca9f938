// SPDX-License-Identifier: GPL-3.0-or-later
#include "folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "brash/core/error.hpp"
#include "folder.hpp"

namespace brash::campaign {
namespace {

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}\n", ::getpid(), host.data());
}

}  // namespace

FolderLock::FolderLock(const std::string& path, const std::string& what, double patience)
    : file_(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
  const auto refuse = [&](int status) {
    if (file_ >= 0) ::close(file_);
    throw StorageError(fmt::format("{}: cannot be locked: {}", path, std::generic_category().message(status)));
  };
  if (file_ < 0) refuse(errno);
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::duration<double>(patience);
  while (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) refuse(errno);
    if (steady_clock::now() >= end) {
      ::close(file_);
      throw InputError(fmt::format("{}: is in use by {}  remedy:  wait until it is over, or give another folder", what,
                                   read_text(path)));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const std::string holder = this_process();
  if (::ftruncate(file_, 0) != 0 || ::pwrite(file_, holder.data(), holder.size(), 0) < 0) refuse(errno);
}

FolderLock::~FolderLock() { ::close(file_); }

}  // namespace brash::campaign
