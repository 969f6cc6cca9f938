// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "brash/formats/replay.hpp"

namespace brash::formats {

/// A replay as a binary glTF 2.0 file: structure, floes, level ice and water, with one animation. Lengths are in
/// metres. Floes appear and vanish, and the sheet changes, at the frames of the run.
/// @param run  with at least one frame.
/// @see glTF 2.0 specification, Khronos Group, 2021.
std::string to_glb(const Replay& run);

}  // namespace brash::formats
