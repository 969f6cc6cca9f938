// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

/// A point in time, of which far ones keep their fraction of a second.
struct Instant {
  std::int64_t seconds = 0;  ///< since 1970
  double fraction = 0.0;     ///< of a second, at least 0

  /// Seconds from another one to this, to the nanosecond.
  double since(const Instant& other) const;
};

/// The point in time of "2024-02-01T12:00:00.5", also with a blank for the T and with Z or +01:00 behind; nothing for
/// anything else.
std::optional<Instant> iso_time(std::string_view cell);

}  // namespace brash::io
