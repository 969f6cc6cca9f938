// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/core/quantity_text.hpp"

#include <fmt/format.h>

#include <string_view>

namespace brash {
namespace {

/// A multiple of a unit under a name of its own.
struct Multiple {
  std::string_view unit, name;
  double size;   ///< in the unit
  double least;  ///< of the values that are written with it, in the unit
};

constexpr Multiple kMultiples[] = {{"Pa", "GPa", 1e9, 1e9},   {"Pa", "MPa", 1e6, 1e6}, {"Pa", "kPa", 1e3, 1e3},
                                   {"m", "m", 1.0, 1.0},      {"m", "cm", 1e-2, 0.0},  {"kg m-3", "kg/m3", 1.0, 0.0},
                                   {"m s-1", "m/s", 1.0, 0.0}};

}  // namespace

std::string quantity_text(double value, const std::string& unit) {
  for (const Multiple& multiple : kMultiples)
    if (unit == multiple.unit && value >= multiple.least)
      return fmt::format("{:.4g} {}", value / multiple.size, multiple.name);
  return unit == "1" ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

}  // namespace brash
