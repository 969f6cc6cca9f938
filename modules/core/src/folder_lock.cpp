// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <thread>

#include "brash/core/error.hpp"
#include "brash/core/text.hpp"

namespace brash {
namespace {

std::string this_process() {
  std::array<char, 256> host{};
  ::gethostname(host.data(), host.size() - 1);
  return fmt::format("process {} on {}\n", ::getpid(), host.data());
}

/// Whether a file is one that a process wrote as its lock, or that it had only just made.
bool is_lock(int file) {
  struct stat held {};
  if (::fstat(file, &held) != 0 || !S_ISREG(held.st_mode) || held.st_nlink > 1) return false;
  constexpr std::string_view kBegin = "process ";
  std::array<char, kBegin.size()> begin{};
  return held.st_size == 0 ||
         (held.st_size < 512 && ::pread(file, begin.data(), begin.size(), 0) == static_cast<ssize_t>(begin.size()) &&
          std::string_view(begin.data(), begin.size()) == kBegin);
}

[[noreturn]] void refuse_other_file(const std::string& path) {
  throw InputError(Complaint{path, "has the name of a lock and is none: a link, or a file of something else",
                             "a file that this program made, or none", "move it away, or give another folder"});
}

}  // namespace

/// Whether the file that is held is still the one named `path`: its last holder may have removed it meanwhile, or its
/// folder may have another name.
bool FolderLock::is_at(const std::string& path) const {
  struct stat held {};
  struct stat named {};
  return ::fstat(file_, &held) == 0 && ::lstat(path.c_str(), &named) == 0 && held.st_dev == named.st_dev &&
         held.st_ino == named.st_ino;
}

void FolderLock::remove_stale(const std::string& path) {
  FolderLock lock(::open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (lock.file_ < 0 || !is_lock(lock.file_) || ::flock(lock.file_, LOCK_EX | LOCK_NB) != 0) return;
  lock.path_ = path;  // a held lock is removed in the end
}

std::optional<FolderLock> FolderLock::take(const std::string& path, double patience) {
  const auto refuse = [&](int status) {
    throw StorageError(fmt::format("{}: cannot be locked: {}\n  remedy:  check that its folder may be written", path,
                                   std::generic_category().message(status)));
  };
  using std::chrono::steady_clock;
  const auto end = steady_clock::now() + std::chrono::duration<double>(patience);
  while (true) {
    FolderLock lock(::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666));
    if (lock.file_ < 0 && errno == ENOENT) return {};  // who held it has given its folder another name
    if (lock.file_ < 0 && (errno == ELOOP || errno == EISDIR || errno == ENXIO)) refuse_other_file(path);
    if (lock.file_ < 0) refuse(errno);
    if (!is_lock(lock.file_)) refuse_other_file(path);
    while (::flock(lock.file_, LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK && errno != EINTR) refuse(errno);
      if (steady_clock::now() >= end) return {};
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    if (!lock.is_at(path)) continue;
    lock.path_ = path;
    const std::string holder = this_process();
    if (::ftruncate(lock.file_, 0) != 0 || ::pwrite(lock.file_, holder.data(), holder.size(), 0) < 0) refuse(errno);
    return lock;
  }
}

FolderLock FolderLock::take_or_refuse(const std::string& folder, const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code reason;
  std::vector<fs::path> made;
  for (fs::path missing = fs::absolute(folder, reason); !fs::exists(missing, reason) && missing.has_relative_path();
       missing = missing.parent_path())
    made.push_back(missing);
  fs::create_directories(folder, reason);
  if (reason)
    throw InputError(
        fmt::format("{}: cannot be made: {}\n  remedy:  check the path and its permissions", folder, reason.message()));
  const std::string path = folder + "/" + name;
  std::optional<FolderLock> lock = take(path);
  if (lock) {
    lock->made_ = std::move(made);
    return std::move(*lock);
  }
  std::ifstream stream(path);
  const std::string holder{std::istreambuf_iterator<char>(stream), {}};
  throw InputError(fmt::format("{}: is in use by {}  remedy:  wait until it is over, or give another folder", folder,
                               holder.empty() ? "another process\n" : escaped_lines(holder)));
}

FolderLock::~FolderLock() {
  if (file_ < 0) return;
  if (!path_.empty() && is_at(path_)) ::unlink(path_.c_str());
  ::close(file_);
  std::error_code has_content;
  for (const auto& folder : made_)
    if (!std::filesystem::remove(folder, has_content)) break;
}

}  // namespace brash
