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

namespace brash::campaign {
namespace {

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}\n", ::getpid(), host.data());
}

}  // namespace

std::optional<FolderLock> FolderLock::take(const std::string& path, double patience) {
  const auto refuse = [&](int status) {
    throw StorageError(fmt::format("{}: cannot be locked: {}", path, std::generic_category().message(status)));
  };
  FolderLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  if (lock.file_ < 0) refuse(errno);
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::duration<double>(patience);
  while (::flock(lock.file_, LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK && errno != EINTR) refuse(errno);
    if (steady_clock::now() >= end) return {};
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  const std::string holder = this_process();
  if (::ftruncate(lock.file_, 0) != 0 || ::pwrite(lock.file_, holder.data(), holder.size(), 0) < 0) refuse(errno);
  return lock;
}

FolderLock::~FolderLock() {
  if (file_ >= 0) ::close(file_);
}

}  // namespace brash::campaign
