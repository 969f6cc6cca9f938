// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "units.hpp"

namespace brash::io {
namespace {

/// Exponents of the base units m, kg, s, rad.
using Dimension = std::array<int, 4>;

/// A unit as a multiple of base units.
struct Unit {
  long double size = 1.0L;  ///< in SI
  Dimension dimension{};
};

struct Symbol {
  std::string_view name;
  Unit unit;
  bool takes_prefix = false;
};

constexpr Dimension kRatio{}, kLength{1}, kMass{0, 1}, kTime{0, 0, 1}, kAngle{0, 0, 0, 1}, kSpeed{1, 0, -1},
    kForce{1, 1, -2}, kPressure{-1, 1, -2}, kEnergy{2, 1, -2}, kPower{2, 1, -3}, kFrequency{0, 0, -1};
/// As UDUNITS-2 has it in its database.
constexpr long double kDegree = 3.14159265358979323846L / 180.0L;

constexpr std::array kSymbols{
    Symbol{"m", {1.0L, kLength}, true},
    Symbol{"meter", {1.0L, kLength}, true},
    Symbol{"metre", {1.0L, kLength}, true},
    Symbol{"in", {0.0254L, kLength}},
    Symbol{"inch", {0.0254L, kLength}},
    Symbol{"inches", {0.0254L, kLength}},
    Symbol{"ft", {0.3048L, kLength}},
    Symbol{"foot", {0.3048L, kLength}},
    Symbol{"feet", {0.3048L, kLength}},
    Symbol{"nmi", {1852.0L, kLength}},
    Symbol{"nautical_mile", {1852.0L, kLength}},
    Symbol{"mile", {1609.344L, kLength}},
    Symbol{"g", {0.001L, kMass}, true},
    Symbol{"gram", {0.001L, kMass}, true},
    Symbol{"t", {1000.0L, kMass}},
    Symbol{"tonne", {1000.0L, kMass}},
    Symbol{"s", {1.0L, kTime}, true},
    Symbol{"second", {1.0L, kTime}},
    Symbol{"min", {60.0L, kTime}},
    Symbol{"minute", {60.0L, kTime}},
    Symbol{"h", {3600.0L, kTime}},
    Symbol{"hr", {3600.0L, kTime}},
    Symbol{"hour", {3600.0L, kTime}},
    Symbol{"d", {86400.0L, kTime}},
    Symbol{"day", {86400.0L, kTime}},
    Symbol{"rad", {1.0L, kAngle}},
    Symbol{"radian", {1.0L, kAngle}},
    Symbol{"deg", {kDegree, kAngle}},
    Symbol{"degree", {kDegree, kAngle}},
    Symbol{"arc_degree", {kDegree, kAngle}},
    Symbol{"N", {1.0L, kForce}, true},
    Symbol{"newton", {1.0L, kForce}, true},
    Symbol{"Pa", {1.0L, kPressure}, true},
    Symbol{"pascal", {1.0L, kPressure}, true},
    Symbol{"bar", {1e5L, kPressure}, true},
    Symbol{"J", {1.0L, kEnergy}, true},
    Symbol{"W", {1.0L, kPower}, true},
    Symbol{"Hz", {1.0L, kFrequency}, true},
    Symbol{"hertz", {1.0L, kFrequency}, true},
    Symbol{"knot", {1852.0L / 3600.0L, kSpeed}},
    Symbol{"kt", {1852.0L / 3600.0L, kSpeed}},
    Symbol{"%", {0.01L, kRatio}},
    Symbol{"percent", {0.01L, kRatio}},
    Symbol{"ppt", {0.001L, kRatio}},
};

struct Prefix {
  std::string_view name;
  long double factor;
};
constexpr std::array kPrefixes{
    Prefix{"T", 1e12L},      Prefix{"G", 1e9L},      Prefix{"M", 1e6L},    Prefix{"k", 1e3L},    Prefix{"h", 1e2L},
    Prefix{"da", 1e1L},      Prefix{"d", 1e-1L},     Prefix{"c", 1e-2L},   Prefix{"m", 1e-3L},   Prefix{"u", 1e-6L},
    Prefix{"\u00b5", 1e-6L}, Prefix{"n", 1e-9L},     Prefix{"giga", 1e9L}, Prefix{"mega", 1e6L}, Prefix{"kilo", 1e3L},
    Prefix{"centi", 1e-2L},  Prefix{"milli", 1e-3L},
};

std::optional<Unit> named(std::string_view name) {
  const auto found = std::ranges::find(kSymbols, name, &Symbol::name);
  if (found != kSymbols.end()) return found->unit;
  // The plural of a name that is written out.
  if (name.size() > 3 && name.ends_with('s')) {
    const auto one = std::ranges::find(kSymbols, name.substr(0, name.size() - 1), &Symbol::name);
    if (one != kSymbols.end() && one->name.size() > 2) return one->unit;
  }
  return std::nullopt;
}

std::optional<Unit> symbol(std::string_view name) {
  if (const auto found = named(name)) return found;
  for (const auto& [prefix, factor] : kPrefixes) {
    if (!name.starts_with(prefix)) continue;
    for (const Symbol& each : kSymbols)
      if (each.takes_prefix && each.name == name.substr(prefix.size()))
        return Unit{factor * each.unit.size, each.unit.dimension};
  }
  return std::nullopt;
}

/// Multiplies `unit` by a power of `factor`.
void multiply(Unit& unit, const Unit& factor, int power) {
  for (int i = 0; i < std::abs(power); ++i) power > 0 ? unit.size *= factor.size : unit.size /= factor.size;
  for (std::size_t i = 0; i < unit.dimension.size(); ++i) unit.dimension[i] += power * factor.dimension[i];
}

bool is_exponent(char c) { return (c >= '0' && c <= '9') || c == '-' || c == '^'; }
bool is_separator(char c) { return c == ' ' || c == '*' || c == '/' || c == '.'; }

/// A product of symbols with whole exponents. A slash divides by the next symbol alone.
std::optional<Unit> parsed(std::string_view text) {
  Unit unit;
  for (bool divided = false; !text.empty();) {
    if (is_separator(text.front()) || text.front() == '1') {
      divided = divided || text.front() == '/';
      text.remove_prefix(1);
      continue;
    }
    std::size_t end = 0;
    while (end < text.size() && !is_separator(text[end]) && !is_exponent(text[end])) ++end;
    const std::optional<Unit> factor = symbol(text.substr(0, end));
    if (!factor) return std::nullopt;
    int power = 1, sign = divided ? -1 : 1;
    for (; end < text.size() && is_exponent(text[end]); ++end) {
      if (text[end] == '-') sign = -sign;
      if (text[end] >= '0' && text[end] <= '9') power = text[end] - '0';
    }
    multiply(unit, *factor, sign * power);
    text.remove_prefix(end);
    divided = false;
  }
  return unit;
}

}  // namespace

tl::expected<InOtherUnit, UnitFault> in_unit_of_table(double value, const std::string& from, const std::string& to) {
  const std::optional<Unit> unit = parsed(from), target = parsed(to);
  if (!unit || !target) return tl::unexpected(UnitFault::kUnknown);
  if (unit->dimension != target->dimension) return tl::unexpected(UnitFault::kOtherKind);
  const auto factor = static_cast<double>(unit->size / target->size);
  return InOtherUnit{0.0, factor, factor * value};
}

}  // namespace brash::io
