// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash {

/// Writes `text` to `path` by rename when whole, and on the disk; missing folders are made.
/// @throws StorageError naming the file and the system's reason; a file that was there before is then as it was.
void write_file(const std::string& path, const std::string& text);

/// The name under which this process writes `path` before it is whole. It writes there only a file that it has made
/// itself: any file that has the name already, a link too, is removed and never opened.
std::string part_of(const std::string& path);

/// Gives the whole file `part` its name, once it is on the disk.
/// @throws StorageError as write_file; the part is then removed.
void publish(const std::string& part, const std::string& path);

/// Removes the parts of files that processes left in `folder` (not below it) when they were killed while writing.
/// No other process may be writing there.
void remove_parts(const std::string& folder);

}  // namespace brash
