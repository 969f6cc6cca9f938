// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"

namespace brash::geometry {

/// A JSON value that knows where in the text it is, so that a fault in its meaning can be shown.
struct JsonNode {
  enum class Kind { kNull, kBoolean, kNumber, kString, kArray, kObject };

  Kind kind = Kind::kNull;
  /// Byte of the opening bracket; other values have the opening byte of the array or object around them.
  std::size_t offset = 0;
  double number = 0.0;
  /// The number, where it is a whole one that fits.
  std::optional<std::int64_t> integer;
  /// A string, or a number as it is written where it is not a whole one that fits.
  std::string text;
  std::vector<JsonNode> items;
  /// Names of `items` in an object.
  std::vector<std::string> names;
};

/// Deepest nesting of arrays and objects that is read.
inline constexpr std::size_t kMaxJsonDepth = 64;

/// Parses `text`, which must hold one JSON value. @return it or the fault with line and column.
tl::expected<JsonNode, GeometryError> parse_json(std::string_view text);

}  // namespace brash::geometry
