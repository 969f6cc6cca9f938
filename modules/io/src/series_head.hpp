// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace brash::io {

/// A head as name and unit: "time [ms]", "Fx (kN)", and as loggers write them "time_ms", "Fx kN", "Fx/kN". The end of a
/// name is its unit only when it is one that times or loads come in.
std::pair<std::string, std::string> name_and_unit(const std::string& head);

/// Whether a text column of this name holds times, whatever its place: time, t, Zeit, timestamp and the like.
bool is_text_time_name(std::string_view name);

/// Seconds since 1970 of "2024-02-01T12:00:00.5", also with a blank for the T and with Z or +01:00 behind; nothing for
/// anything else.
std::optional<double> iso_time(std::string_view cell);

}  // namespace brash::io
