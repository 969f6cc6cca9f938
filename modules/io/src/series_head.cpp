// SPDX-License-Identifier: GPL-3.0-or-later
#include "series_head.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cmath>

namespace brash::io {
namespace {

/// Ends of names that are units, and how UDUNITS writes them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 29> kUnitEnds{
    {{"us", "us"},   {"ms", "ms"},   {"s", "s"},      {"sec", "s"},    {"min", "min"},   {"h", "h"},
     {"hr", "h"},    {"N", "N"},     {"kN", "kN"},    {"MN", "MN"},    {"lbf", "lbf"},   {"kip", "kip"},
     {"kgf", "kgf"}, {"Nm", "N m"},  {"kNm", "kN m"}, {"MNm", "MN m"}, {"Pa", "Pa"},     {"kPa", "kPa"},
     {"MPa", "MPa"}, {"bar", "bar"}, {"psi", "psi"},  {"m", "m"},      {"cm", "cm"},     {"mm", "mm"},
     {"km", "km"},   {"ft", "ft"},   {"deg", "deg"},  {"rad", "rad"},  {"knots", "knot"}}};

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// Takes `n` digits off the front of `text`.
std::optional<int> take_digits(std::string_view& text, std::size_t n) {
  if (text.size() < n) return std::nullopt;
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + n, value);
  if (error != std::errc{} || end != text.data() + n || text.front() == '-') return std::nullopt;
  text.remove_prefix(n);
  return value;
}

bool take(std::string_view& text, std::string_view any_of) {
  if (text.empty() || any_of.find(text.front()) == std::string_view::npos) return false;
  text.remove_prefix(1);
  return true;
}

/// Seconds and their fraction; nothing is 0.
std::optional<Instant> take_seconds(std::string_view& text) {
  if (!take(text, ":")) return Instant{};
  const auto whole = take_digits(text, 2);
  if (!whole || *whole > 60) return std::nullopt;
  Instant seconds{*whole, 0.0};
  if (take(text, ".,")) {
    double scale = 0.1;
    for (; !text.empty() && std::isdigit(static_cast<unsigned char>(text.front())) != 0; text.remove_prefix(1)) {
      seconds.fraction += scale * (text.front() - '0');
      scale *= 0.1;
    }
  }
  return seconds;
}

/// Offset of a time ahead of Greenwich [s]; no offset or Z is 0.
std::optional<int> take_zone(std::string_view& text) {
  if (take(text, "Z") || text.empty()) return 0;
  const int sign = text.front() == '-' ? -1 : 1;
  if (!take(text, "+-")) return std::nullopt;
  const auto hours = take_digits(text, 2);
  static_cast<void>(take(text, ":"));
  const auto minutes = text.empty() ? std::optional(0) : take_digits(text, 2);
  if (!hours || !minutes || *hours > 14 || *minutes > 59) return std::nullopt;
  return sign * (3600 * *hours + 60 * *minutes);
}

/// How UDUNITS writes the unit in the end of a name, such as `kN` or `N/mm2`; nothing when it is none.
std::optional<std::string> unit_in(std::string_view end) {
  const std::size_t slash = end.find('/');
  std::string_view first = end.substr(0, slash);
  const auto unit = std::ranges::find_if(kUnitEnds, [&](const auto& known) { return known.first == first; });
  if (end == "1/s" || end == "1/min" || end == "1/h") return std::string(end);
  if (unit == kUnitEnds.end()) return std::nullopt;
  std::string text(unit->second);
  if (slash == std::string_view::npos) return text;
  std::string_view divisor = end.substr(slash + 1);
  const bool has_power = divisor.ends_with('2') || divisor.ends_with('3');
  const auto below = unit_in(divisor.substr(0, divisor.size() - (has_power ? 1 : 0)));
  if (!below) return std::nullopt;
  text += "/" + *below;
  return has_power ? text + divisor.back() : text;
}

}  // namespace

std::pair<std::string, std::string> name_and_unit(const std::string& head) {
  const std::size_t open = head.find_first_of("[(");
  if (open != std::string::npos && (head.back() == ']' || head.back() == ')'))
    return {std::string(without_blanks(std::string_view(head).substr(0, open))),
            head.substr(open + 1, head.size() - open - 2)};
  const auto parted = [&](std::size_t mark, const std::string& unit) {
    return std::pair(std::string(without_blanks(std::string_view(head).substr(0, mark))), unit);
  };
  // The longest end that is a unit: q_N/mm is in N/mm.
  for (std::size_t mark = head.find_first_of("_ ", 1); mark != std::string::npos;
       mark = head.find_first_of("_ ", mark + 1))
    if (const auto unit = unit_in(std::string_view(head).substr(mark + 1))) return parted(mark, *unit);
  // F/kN is in kN, and N/mm has no name.
  const std::size_t slash = head.rfind('/');
  if (slash == std::string::npos || slash == 0 || unit_in(head)) return {head, ""};
  const auto unit = unit_in(std::string_view(head).substr(slash + 1));
  return unit ? parted(slash, *unit) : std::pair(head, std::string());
}

bool is_text_time_name(std::string_view name) {
  constexpr std::array<std::string_view, 11> kNames{"time",        "t",         "zeit",    "timestamp", "datetime",
                                                    "date_time",   "date time", "elapsed", "seconds",   "elapsed time",
                                                    "elapsed_time"};
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return std::ranges::find(kNames, lower) != kNames.end();
}

double Instant::since(const Instant& other) const {
  constexpr std::int64_t kCentury = 3'155'760'000;  // nanoseconds of more do not fit
  const std::int64_t whole = seconds - other.seconds;
  const double parts = fraction - other.fraction;
  if (std::abs(whole) > kCentury) return static_cast<double>(whole) + parts;
  return static_cast<double>(1'000'000'000 * whole + std::llround(1e9 * parts)) / 1e9;
}

std::optional<Instant> iso_time(std::string_view cell) {
  const auto year = take_digits(cell, 4);
  if (!year || !take(cell, "-")) return std::nullopt;
  const auto month = take_digits(cell, 2);
  if (!month || !take(cell, "-")) return std::nullopt;
  const auto day = take_digits(cell, 2);
  if (!day || !take(cell, "T ")) return std::nullopt;
  const auto hour = take_digits(cell, 2);
  if (!hour || *hour > 23 || !take(cell, ":")) return std::nullopt;
  const auto minute = take_digits(cell, 2);
  if (!minute || *minute > 59) return std::nullopt;
  const auto seconds = take_seconds(cell);
  const auto zone = seconds ? take_zone(cell) : std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!zone || !cell.empty() || !date.ok()) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return Instant{86400 * days + 3600 * *hour + 60 * *minute + seconds->seconds - *zone, seconds->fraction};
}

}  // namespace brash::io
