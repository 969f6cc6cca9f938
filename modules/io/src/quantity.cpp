// SPDX-License-Identifier: GPL-3.0-or-later
#include "quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <map>

#include "brash/core/text.hpp"
#include "units.hpp"

namespace brash::io {
namespace {

#ifdef BRASH_UNIT_TABLE  // the simulator in a page
constexpr auto& in_unit = in_unit_of_table;
#else
constexpr auto& in_unit = in_unit_of_udunits;
#endif

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%' ||
         static_cast<unsigned char>(c) >= 0x80;
}

/// The spelling error of a unit, a product of symbols with whole exponents; empty when the spelling is right.
std::string spelling_error(std::string_view unit) {
  if (unit.starts_with("1/")) unit.remove_prefix(2);
  bool symbol_expected = true;
  std::size_t i = 0;
  while (i < unit.size()) {
    if (unit[i] == ' ' || unit[i] == '*' || unit[i] == '/' || unit[i] == '.') {
      if (unit[i] != ' ') symbol_expected = true;
      ++i;
      continue;
    }
    if (!is_letter(unit[i])) return fmt::format("'{}' is not part of a unit", unit[i]);
    while (i < unit.size() && is_letter(unit[i])) ++i;
    symbol_expected = false;
    // An exponent: ^ and sign are optional, one digit. UDUNITS would raise kilo to the ninety-ninth.
    if (i < unit.size() && unit[i] == '^') ++i;
    if (i < unit.size() && unit[i] == '(') return "an exponent must be a whole number";
    if (i < unit.size() && unit[i] == '-') ++i;
    const std::size_t first_digit = i;
    while (i < unit.size() && is_digit(unit[i])) ++i;
    if (i - first_digit > 1) return "an exponent is too large";
    if (i == first_digit && i > 0 && (unit[i - 1] == '^' || unit[i - 1] == '-')) return "an exponent is missing";
    if (i + 1 < unit.size() && unit[i] == '.' && is_digit(unit[i + 1])) return "an exponent must be a whole number";
  }
  return symbol_expected ? "it is incomplete" : "";
}

/// The short decimal that `factor` represents, when it is within the roundings of a product of prefixes (0.0254 for
/// 0.025400000000000002); else `factor`.
double without_rounding(double factor) {
  double decimal = factor;
  const std::string text = fmt::format("{:.12g}", factor);
  std::from_chars(text.data(), text.data() + text.size(), decimal);
  return std::abs(decimal / factor - 1.0) < 1e-15 ? decimal : factor;
}

/// The value in another unit, rounded once where the units differ by a power of ten.
double rounded_once(double value, const InOtherUnit& other) {
  if (other.zero != 0.0) return other.value;
  const double factor = without_rounding(other.one);
  const double inverse = std::round(1.0 / factor);
  if (factor < 1.0 && inverse < 1e15 && std::abs(factor * inverse - 1.0) < 1e-15) return value / inverse;
  return value * factor;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

tl::unexpected<QuantityError> error(std::string what, std::string remedy) {
  return tl::unexpected(QuantityError{std::move(what), std::move(remedy)});
}

/// "write a unit that converts to Pa: MPa, GPa, kPa or the like"
std::string unit_remedy(const std::string& unit) {
  const std::vector<std::string>& usual = usual_units(unit);
  return usual.empty() ? "write a unit that converts to " + unit
                       : fmt::format("write a unit that converts to {}: {} or the like", unit, fmt::join(usual, ", "));
}

/// `value` given in the unit spelled `from`, in the unit spelled `to`.
tl::expected<double, QuantityError> convert_units(double value, const std::string& from, const std::string& to) {
  const auto converted = in_unit(value, from, to);
  if (converted) return rounded_once(value, *converted);
  switch (converted.error()) {
    case UnitFault::kUnknown:
      return error(fmt::format("the unit {} is not known", printable(from)), unit_remedy(to));
    case UnitFault::kOtherKind:
      return error(fmt::format("the unit {} does not convert to {}", printable(from), to), unit_remedy(to));
    case UnitFault::kNoConverter:
      break;
  }
  return error(fmt::format("the unit {} does not convert to {}", printable(from), to), "use another unit");
}

/// The unit of a toughness. UDUNITS has no fractional exponents: the root of the metre is read here, alone.
constexpr std::string_view kRoot = " m^0.5";

/// `value` given in a unit with the root of the metre last, in the unit spelled `to`, which has it too.
tl::expected<double, QuantityError> convert_toughness(double value, std::string_view from, const std::string& to) {
  const std::string remedy = fmt::format("write a unit that converts to {}: kPa m^0.5, MPa m^0.5 or the like", to);
  std::string_view pressure = from;
  if (!pressure.ends_with(kRoot.substr(1)))
    return error(fmt::format("the unit {} does not convert to {}", printable(std::string(from)), to), remedy);
  pressure.remove_suffix(kRoot.size() - 1);
  while (pressure.ends_with(' ') || pressure.ends_with('*') || pressure.ends_with('.')) pressure.remove_suffix(1);
  if (pressure.empty() || !spelling_error(pressure).empty())
    return error(fmt::format("the unit {} cannot be read", printable(std::string(from))), remedy);
  return convert_units(value, std::string(pressure), to.substr(0, to.size() - kRoot.size()));
}

/// `text` with a decimal point, when it begins with a number with a decimal comma; else "".
std::string with_decimal_point(std::string_view text) {
  const std::size_t comma = text.find_first_not_of("0123456789+-");
  const bool is_one = comma != std::string_view::npos && comma > 0 && text[comma] == ',' && comma + 1 < text.size() &&
                      is_digit(text[comma + 1]);
  return is_one ? std::string(text.substr(0, comma)) + "." + std::string(text.substr(comma + 1)) : "";
}

}  // namespace

const std::vector<std::string>& usual_units(const std::string& unit) {
  static const std::map<std::string, std::vector<std::string>> kUsual{
      {"m", {"mm", "cm", "km"}},          {"Pa", {"MPa", "kPa", "GPa"}},  {"s", {"min", "h", "ms"}}, {"rad", {"deg"}},
      {"m s-1", {"km/h", "knot", "m/s"}}, {"kg m-3", {"kg/m3", "g/cm3"}}, {"N", {"kN", "MN"}},       {"s-1", {"Hz"}},
      {"N m-1", {"kN/m", "MN/m"}},        {"m2", {"m2", "cm2"}}};
  static const std::vector<std::string> kNone;
  const auto found = kUsual.find(unit);
  return found == kUsual.end() ? kNone : found->second;
}

tl::expected<double, QuantityError> read_quantity(const std::string& text, const std::string& unit) {
  std::string_view rest = trimmed(text);
  if (const std::string pointed = with_decimal_point(rest); !pointed.empty())
    return error("the number has a decimal comma", fmt::format("write a decimal point: {}", printable(pointed)));
  if (rest.starts_with('+')) rest.remove_prefix(1);
  double value = 0.0;
  const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (status == std::errc::result_out_of_range)
    return error("the number is too large or too small", "write a number of ordinary size");
  if (status != std::errc{}) return error("the string does not begin with a number", "write number, blank, unit");
  if (!std::isfinite(value)) return error("the number is not finite", "write a finite number");

  const std::string from(trimmed(rest.substr(static_cast<std::size_t>(end - rest.data()))));
  if (from.empty())
    return error("the string has no unit",
                 fmt::format("write the number without quotes (SI) or with a unit that converts to {}", unit));
  if (unit.ends_with(kRoot)) return convert_toughness(value, from, unit);
  if (const std::string spelling = spelling_error(from); !spelling.empty())
    return error(fmt::format("the unit {} cannot be read: {}", printable(from), spelling),
                 "write the unit as symbols with whole exponents, such as kg/m3 or m s^-1");
  const auto converted = convert_units(value, from, unit);
  if (converted && !std::isfinite(*converted)) return error("the number is too large", "write a finite number");
  return converted;
}

}  // namespace brash::io
