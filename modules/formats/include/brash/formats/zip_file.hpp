// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace brash::formats {

/// A file in an archive.
struct ZipEntry {
  std::string path;  ///< inside, with forward slashes
  std::string bytes;
};

/// Writes the archive `path` by rename when whole. Equal entries give equal bytes: every file has one and the same
/// date.
/// @throws StorageError naming the file.
void write_zip(const std::string& path, const std::vector<ZipEntry>& entries);

}  // namespace brash::formats
