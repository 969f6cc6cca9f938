// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>

namespace brash::campaign {

/// A file that one process at a time holds; the system lets go of it when the process ends, however it ends.
class FolderLock {
 public:
  /// Takes `path`, made if missing, or waits up to `patience` [s] for another process that is about to end.
  /// @return nothing when another process holds it. @throws StorageError when the file cannot be made.
  static std::optional<FolderLock> take(const std::string& path, double patience = 0.0);
  FolderLock(FolderLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}

  int file_;
};

}  // namespace brash::campaign
