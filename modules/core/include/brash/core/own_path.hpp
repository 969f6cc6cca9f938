// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace brash {

/// Absolute path of the program or module that this code was linked into; empty where the system does not report it.
inline std::filesystem::path own_path() {
  const auto here = reinterpret_cast<std::uintptr_t>(&own_path);
  std::ifstream maps("/proc/self/maps");
  // Lines `from-to rights offset device inode path`; numbers hexadecimal.
  for (std::string line; std::getline(maps, line);) {
    std::istringstream fields(line);
    std::uintptr_t from = 0, to = 0;
    char dash = 0;
    std::string rights, offset, device, inode, path;
    fields >> std::hex >> from >> dash >> to >> rights >> offset >> device >> inode >> std::ws;
    std::getline(fields, path);
    if (from <= here && here < to) return path;
  }
  return {};
}

}  // namespace brash
