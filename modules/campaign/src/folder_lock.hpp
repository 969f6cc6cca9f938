// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::campaign {

/// A file that one process at a time holds; the system lets go of it when the process ends, however it ends.
class FolderLock {
 public:
  /// Takes `path`, made if missing.
  /// @param what     is locked, for the message.
  /// @param patience how long to wait for another process that is about to end [s].
  /// @throws InputError naming the process that holds it. @throws StorageError when the file cannot be made.
  FolderLock(const std::string& path, const std::string& what, double patience = 0.0);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int file_ = -1;
};

}  // namespace brash::campaign
