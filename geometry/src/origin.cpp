// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/origin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "brash/core/contract.hpp"
#include "brash/geometry/point.hpp"

namespace brash::geometry {
namespace {

constexpr int kDecimals = 31;    // 2^-31 m, half a grid unit, has so many
constexpr int kMostDigits = 15;  // before the point: an int64 has room to spare
constexpr std::int64_t kMostUnits = static_cast<std::int64_t>(kMaxCoordinate) << 30;

constexpr Int128 power(int base, int exponent) {
  Int128 result = 1;
  for (int i = 0; i < exponent; ++i) result *= base;
  return result;
}

constexpr Int128 kOne = power(10, kDecimals);
constexpr Int128 kHalfUnit = power(5, kDecimals);  // 10^31/2^31
constexpr Int128 kUnit = 2 * kHalfUnit;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The digits of a number and the place of its point.
struct Digits {
  std::string_view whole, fraction;
  std::int64_t exponent = 0;
  bool negative = false;

  std::int64_t size() const { return static_cast<std::int64_t>(whole.size() + fraction.size()); }
  /// The digit `place` places after the point, negative before it; 0 outside of the text.
  int at(std::int64_t place) const {
    const std::int64_t i = static_cast<std::int64_t>(whole.size()) + exponent + place;
    if (i < 0 || i >= size()) return 0;
    const auto index = static_cast<std::size_t>(i);
    return (index < whole.size() ? whole[index] : fraction[index - whole.size()]) - '0';
  }
};

std::string_view take_digits(std::string_view& text) {
  const auto end = std::find_if_not(text.begin(), text.end(), is_digit);
  const std::string_view digits = text.substr(0, static_cast<std::size_t>(end - text.begin()));
  text.remove_prefix(digits.size());
  return digits;
}

bool take(std::string_view& text, std::string_view any) {
  if (text.empty() || any.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

std::optional<Digits> digits_of(std::string_view text) {
  Digits digits;
  digits.negative = text.starts_with('-');
  take(text, "+-");
  digits.whole = take_digits(text);
  if (take(text, ".")) digits.fraction = take_digits(text);
  if (digits.size() == 0) return std::nullopt;
  if (take(text, "eE")) {
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), digits.exponent);
    constexpr std::int64_t kFar = 1'000'000'000;  // beyond the digits of any text
    if (code != std::errc{} || digits.exponent > kFar || digits.exponent < -kFar) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(stop - text.data()));
  }
  if (!text.empty()) return std::nullopt;
  return digits;
}

/// The text without the blanks around it.
std::string_view without_blanks(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") + 1 - first);
}

}  // namespace

std::optional<Decimal> Decimal::parse(std::string_view text) {
  const std::optional<Digits> digits = digits_of(text);
  if (!digits) return std::nullopt;
  const std::int64_t first = -static_cast<std::int64_t>(digits->whole.size()) - digits->exponent;
  for (std::int64_t place = first; place < std::min<std::int64_t>(-kMostDigits, first + digits->size()); ++place) {
    if (digits->at(place) != 0) return std::nullopt;
  }
  std::int64_t whole = 0;
  for (int place = -kMostDigits; place < 0; ++place) whole = 10 * whole + digits->at(place);
  Int128 fraction = 0;
  for (int place = 0; place < kDecimals; ++place) fraction = 10 * fraction + digits->at(place);
  if (!digits->negative) return Decimal(whole, fraction);
  return fraction == 0 ? Decimal(-whole) : Decimal(-whole - 1, kOne - fraction);
}

Decimal operator-(const Decimal& a, const Decimal& b) {
  const Int128 fraction = a.fraction_ - b.fraction_;
  const std::int64_t whole = a.whole_ - b.whole_;
  return fraction < 0 ? Decimal(whole - 1, fraction + kOne) : Decimal(whole, fraction);
}

std::optional<std::int64_t> Decimal::grid_units_from(const Decimal& origin) const {
  const bool negative = *this < origin;
  const Decimal distance = negative ? origin - *this : *this - origin;
  if (distance.whole_ > static_cast<std::int64_t>(kMaxCoordinate)) return std::nullopt;
  const auto units = (distance.whole_ << 30) + static_cast<std::int64_t>((distance.fraction_ + kHalfUnit) / kUnit);
  if (units > kMostUnits) return std::nullopt;
  return negative ? -units : units;
}

Decimal Decimal::rounded(int n_decimals) const {
  const Int128 step = power(10, kDecimals - n_decimals);
  const Int128 fraction = (fraction_ + step / 2) / step * step;
  return fraction == kOne ? Decimal(whole_ + 1) : Decimal(whole_, fraction);
}

Decimal Decimal::of_grid_units(std::int64_t units, const Decimal& origin) {
  constexpr std::int64_t kMetre = 1LL << 30;
  const std::int64_t whole = units >> 30;  // rounds down
  const Decimal place(whole, static_cast<Int128>(units - whole * kMetre) * kUnit);
  const Decimal exact = place - (Decimal{} - origin);
  for (int n = 0; n < kDecimals; ++n) {
    const Decimal shorter = exact.rounded(n);
    if (shorter.grid_units_from(origin) == units) return shorter;
  }
  return exact;
}

double Decimal::nearest_double() const {
  const std::string text = to_string();
  double value = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

std::string Decimal::to_string() const {
  if (whole_ < 0) {
    const std::string magnitude = (Decimal{} - *this).to_string();
    return '-' + magnitude;
  }
  std::string text = fmt::format("{}", whole_);
  if (fraction_ == 0) return text;
  text += '.';
  for (Int128 rest = fraction_, place = kOne / 10; rest != 0; place /= 10) {
    text += static_cast<char>('0' + static_cast<int>(rest / place));
    rest %= place;
  }
  return text;
}

Origin origin_from_metres(Vec2 metres) {
  const auto decimal = [](double value) {
    const std::optional<Decimal> read = Decimal::parse(fmt::format("{}", value));
    BRASH_EXPECTS(read.has_value(), value);
    return *read;
  };
  return {decimal(metres.x), decimal(metres.y)};
}

std::optional<Origin> origin_from_text(std::string_view text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) return std::nullopt;
  const auto x = Decimal::parse(without_blanks(text.substr(0, comma)));
  const auto y = Decimal::parse(without_blanks(text.substr(comma + 1)));
  if (!x || !y) return std::nullopt;
  return Origin{*x, *y};
}

std::string to_string(const Origin& origin) { return origin.x.to_string() + ',' + origin.y.to_string(); }

}  // namespace brash::geometry
