// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace brash::training {

/// Removes the chunks of `path`, and their folder once it is empty: the holder of the lock in it removes it otherwise.
void remove_chunks(const std::string& path);

/// @throws InputError when the folder of the chunks holds a file that no build left, or is a link.
void refuse_files_of_others(const std::string& path);

}  // namespace brash::training
