// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace brash::model {

/// Values that have been measured.
struct Range {
  double least = 0.0;  ///< SI
  double most = 0.0;   ///< SI
  const char* source = "";

  bool has(double value) const { return value >= least && value <= most; }
};

/// The values of a key that are plausible, narrower than the values that are allowed: `x-plausible` of
/// modules/io/case.schema.json.
struct Plausible {
  const char* warning;  ///< of other values
  const char* key;      ///< "ice.thickness"
  const char* unit;     ///< UDUNITS; "1" where there is none
  Range sea;            ///< of natural ice and water
  /// Of model ice, at the scale of its basin or at full scale; absent: as at sea.
  std::optional<Range> model_ice{};
};

/// The row of a key that has one.
const Plausible& plausible(std::string_view key);

}  // namespace brash::model
