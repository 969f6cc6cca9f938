// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_ring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brash::geometry {

GeometryError error_at(std::string_view text, std::size_t offset, std::string_view what) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column = last_break == std::string_view::npos ? before.size() + 1 : before.size() - last_break;
  return {fmt::format("line {}, column {}: {}", line, column, what)};
}

std::optional<std::string> fault_of_positions(std::span<const Vec2> positions) {
  for (const Vec2 p : positions) {
    // A NaN fails both comparisons.
    if (std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate) continue;
    return fmt::format("({}, {}) is beyond +-{} m", p.x, p.y, kMaxCoordinate);
  }
  return std::nullopt;
}

tl::expected<Ring, std::string> ring_from_text(std::span<const Vec2> positions, bool is_hole) {
  if (positions.size() < 4) {
    return tl::unexpected(fmt::format("a ring needs at least 4 positions, this has {}", positions.size()));
  }
  if (auto fault = fault_of_positions(positions)) return tl::unexpected(*std::move(fault));
  if (positions.front() != positions.back()) {
    return tl::unexpected(std::string("the ring is not closed: its last position is not its first"));
  }
  Ring result = ring(positions);
  if (result.size() < 3) return tl::unexpected(std::string("the ring has fewer than 3 different vertices"));
  if (signed_area(result) == ExactArea{}) return tl::unexpected(std::string("the ring has no area"));
  if (is_hole) std::reverse(result.begin() + 1, result.end());
  return result;
}

std::string position_to_text(Point point, char separator) {
  return fmt::format("{:.17g}{}{:.17g}", metres(point).x, separator, metres(point).y);
}

}  // namespace brash::geometry
