// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "brash/analysis/crack_run.hpp"
#include "brash/core/byte_order_mark.hpp"
#include "brash/core/constants.hpp"
#include "brash/core/error.hpp"
#include "brash/core/text.hpp"
#include "brash/geometry/point.hpp"

namespace brash::analysis {
namespace {

constexpr std::array<std::string_view, 5> kColumns{"x", "y", "radius", "wedges", "angles"};
constexpr const char* kRemedy = "correct the line; a line that begins with # is passed over";
/// A full turn and the rounding of its digits [rad]; more of it is of degrees.
constexpr double kMostAngle = 2.0 * kPi + 0.01;
/// More radial cracks than anyone breaks ice into, and few enough to draw.
constexpr int kMostWedges = 1000;
/// The vertices of a 16-gon in a smaller circle fall together on the geometry's grid [m].
constexpr double kLeastRadius = 8.0 * geometry::kGridUnit;

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t first = text.find_first_not_of(kSpace);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

std::vector<std::string_view> split_at(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = text.find_first_of(separators);
    fields.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return fields;
    text.remove_prefix(end + 1);
  }
}

/// One line of the file: its place for messages and its fields.
class Row {
 public:
  Row(const std::string& file, int line, std::string_view text) : place_(fmt::format("{}, line {}", file, line)) {
    fields_ = split_at(text, ",");
    if (fields_.size() < 4 || fields_.size() > 5) {
      throw InputError(Complaint{place_, fmt::format("'{}': {} fields", printable(std::string(text)), fields_.size()),
                                 "x,y,radius,wedges or x,y,radius,wedges,angles", kRemedy});
    }
  }

  [[noreturn]] void refuse(std::size_t column, std::string_view allowed) const {
    throw InputError(Complaint{
        place_, fmt::format("{} = '{}' is not allowed", kColumns[column], printable(std::string(fields_[column]))),
        std::string(allowed), kRemedy});
  }

  template <typename T>
  T number(std::size_t column, std::string_view text, std::string_view allowed) const {
    if (text.starts_with('+')) text.remove_prefix(1);
    T value{};
    const auto [stop, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{} || stop != text.data() + text.size()) refuse(column, allowed);
    return value;
  }

  /// Metres from the origin; the difference is exact before it is rounded to a double.
  double metres_from(std::size_t column, const geometry::Decimal& zero) const {
    const double value = number<double>(column, fields_[column], "a number of metres");
    const auto decimal = geometry::Decimal::parse(fields_[column]);
    // A number that is not a decimal lies outside of every circle.
    return decimal ? (*decimal - zero).nearest_double() : value;
  }

  CrackEvent event(const geometry::Origin& origin) const {
    CrackEvent event;
    event.centre = {metres_from(0, origin.x), metres_from(1, origin.y)};
    const auto metres = fmt::format("a number of metres, at least {:.3g}", kLeastRadius);
    event.radius = number<double>(2, fields_[2], metres);
    if (!(event.radius >= kLeastRadius)) refuse(2, metres);
    for (const std::size_t axis : {0, 1}) {
      const double at = axis == 0 ? event.centre.x : event.centre.y;
      // A NaN fails the comparison.
      if (std::abs(at) + event.radius <= geometry::kMaxCoordinate) continue;
      const std::string centre = origin == geometry::Origin{} ? "" : " of the origin " + to_string(origin);
      refuse(axis, fmt::format("the circle must stay within +-{} m{}", geometry::kMaxCoordinate, centre));
    }
    if (fields_.size() == 5 && !fields_[4].empty()) event.angles = angles();
    if (event.angles && fields_[3].empty()) return event;
    const auto allowed = fmt::format("a whole number from 1 to {}", kMostWedges);
    event.wedges = number<int>(3, fields_[3], allowed);
    if (event.wedges < 1 || event.wedges > kMostWedges) refuse(3, allowed);
    if (!event.angles) return event;
    const int n = static_cast<int>(event.angles->size());
    if (event.wedges != n && event.wedges != n + 1) {
      refuse(3, fmt::format("{} angles make {} wedges at an edge and {} all round; or leave it empty", n, n + 1, n));
    }
    return event;
  }

 private:
  std::vector<double> angles() const {
    std::vector<double> result;
    for (const std::string_view text : split_at(fields_[4], " ;")) {
      if (text.empty()) continue;
      result.push_back(number<double>(4, text, "radians, separated by spaces or semicolons"));
      if (!std::isfinite(result.back())) refuse(4, "finite radians");
      if (std::abs(result.back()) > kMostAngle) refuse(4, "radians within a full turn, 2 pi; 60 degrees are 1.047");
      if (result.size() > static_cast<std::size_t>(kMostWedges)) refuse(4, fmt::format("at most {}", kMostWedges));
    }
    return result;
  }

  std::string place_;
  std::vector<std::string_view> fields_;
};

bool is_header(std::string_view line) {
  const std::vector<std::string_view> fields = split_at(line, ",");
  if (fields.size() < 4 || fields.size() > 5) return false;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (fields[i] != kColumns[i]) return false;
  }
  return true;
}

}  // namespace

std::vector<CrackEvent> read_crack_events(const std::string& name, const std::string& text,
                                          const geometry::Origin& origin) {
  std::vector<CrackEvent> events;
  bool is_first = true;
  int line = 0;
  for (const std::string_view row : split_at(without_byte_order_mark(text), "\n")) {
    ++line;
    if (row.empty() || row.front() == '#') continue;
    if (std::exchange(is_first, false) && is_header(row)) continue;
    events.push_back(Row(name, line, row).event(origin));
    events.back().line = line;
  }
  return events;
}

}  // namespace brash::analysis
