// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brash {

/// A file that one process at a time holds. The holder removes it in the end; the system releases it when the process
/// ends, however it ends, and the file that a killed process leaves locks nobody out. A link, a device or a file that
/// is not a lock of this program is never taken, written or removed.
class FolderLock {
 public:
  /// Takes `path`, made if missing, or waits up to `patience` [s] for another process that is about to end.
  /// @return nothing when another process holds it, or when its folder is not there: who held it has given the folder
  ///         another name. @throws StorageError when the file cannot be made. @throws InputError when something else
  ///         has its name.
  static std::optional<FolderLock> take(const std::string& path, double patience = 0.0);
  /// As take(), of the file `name` in `folder`, which is made if missing; one that is still empty in the end is
  /// removed.
  /// @throws InputError naming the process that holds it.
  static FolderLock take_or_refuse(const std::string& folder, const std::string& name);
  /// Removes the lock that a killed process left at `path`; a lock that another process holds, and a file that is not
  /// a lock, stay.
  static void remove_stale(const std::string& path);
  FolderLock(FolderLock&& other) noexcept
      : path_(std::move(other.path_)), made_(std::move(other.made_)), file_(std::exchange(other.file_, -1)) {}
  FolderLock& operator=(FolderLock&&) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}
  bool is_at(const std::string& path) const;

  std::string path_;                         ///< once it is held
  std::vector<std::filesystem::path> made_;  ///< folders, the inner first
  int file_;
};

}  // namespace brash
