// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "brash/geometry/text.hpp"
#include "text_ring.hpp"

namespace brash::geometry {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Reads down a fixed grammar: geometry, polygon, ring, position. Nothing recurs, so no input overflows the stack.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  tl::expected<std::vector<Polygon>, GeometryError> read() {
    std::vector<Polygon> polygons;
    skip_space();
    if (is_at_end()) fail("there is no geometry: POLYGON or MULTIPOLYGON is expected");
    while (!error_ && !is_at_end()) {
      read_geometry(polygons);
      skip_space();
    }
    if (error_) return tl::unexpected(*error_);
    return polygons;
  }

 private:
  void fail_at(std::size_t offset, std::string_view what) {
    if (!error_) error_ = error_at(text_, offset, what);
  }
  void fail(std::string_view what) { fail_at(at_, what); }

  bool is_at_end() const { return at_ >= text_.size(); }
  void skip_space() {
    while (!is_at_end() && is_space(text_[at_])) ++at_;
  }
  std::string found() const { return is_at_end() ? "the end of the text" : fmt::format("'{}'", text_[at_]); }

  bool accept(char c) {
    skip_space();
    if (is_at_end() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!error_ && !accept(c)) fail(fmt::format("'{}' is expected, not {}", c, found()));
  }

  /// The word here in upper case; empty when there is none.
  std::string word() {
    skip_space();
    std::string result;
    for (; !is_at_end() && is_letter(text_[at_]); ++at_) result += static_cast<char>(text_[at_] & ~0x20);
    return result;
  }
  bool accept_empty() {
    skip_space();
    const std::size_t start = at_;
    const std::string w = word();
    if (w == "EMPTY") return true;
    if (!w.empty()) fail_at(start, fmt::format("'(' or EMPTY is expected, not {}: plan coordinates only", w));
    return false;
  }

  void read_geometry(std::vector<Polygon>& polygons) {
    skip_space();
    const std::size_t start = at_;
    const std::string kind = word();
    if (kind != "POLYGON" && kind != "MULTIPOLYGON") {
      return fail_at(start, fmt::format("POLYGON or MULTIPOLYGON is expected, not {}", kind.empty() ? found() : kind));
    }
    if (accept_empty() || error_) return;
    if (kind == "POLYGON") return read_polygon(polygons);
    expect('(');
    do {
      read_polygon(polygons);
    } while (!error_ && accept(','));
    expect(')');
  }

  void read_polygon(std::vector<Polygon>& polygons) {
    Polygon polygon;
    expect('(');
    if (error_) return;
    polygon.outline = read_ring(false);
    while (!error_ && accept(',')) polygon.holes.push_back(read_ring(true));
    expect(')');
    polygons.push_back(std::move(polygon));
  }

  Ring read_ring(bool is_hole) {
    skip_space();
    const std::size_t start = at_;
    std::vector<Vec2> positions;
    expect('(');
    do {
      const double x = number(), y = number();
      positions.push_back({x, y});
    } while (!error_ && accept(','));
    expect(')');
    if (error_) return {};
    auto result = ring_from_text(positions, is_hole);
    if (result) return *std::move(result);
    fail_at(start, result.error());
    return {};
  }

  double number() {
    if (error_) return 0.0;
    skip_space();
    const char* const end = text_.data() + text_.size();
    const char* const start = text_.data() + at_ + (!is_at_end() && text_[at_] == '+');
    double value = 0.0;
    const auto [stop, code] = std::from_chars(start, end, value);
    if (code == std::errc::result_out_of_range) {
      fail("the number is out of range");
    } else if (code != std::errc{} || (stop != end && (is_letter(*stop) || *stop == '.'))) {
      fail(fmt::format("a number is expected, not {}", found()));
    } else {
      at_ = static_cast<std::size_t>(stop - text_.data());
    }
    return value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::optional<GeometryError> error_;
};

void append_ring(const Ring& ring, std::string& text) {
  text += '(';
  for (const Point p : ring) text += position_to_text(p, ' ') + ", ";
  text += position_to_text(ring.front(), ' ') + ')';
}

void append_polygon(const Polygon& polygon, std::string& text) {
  text += '(';
  append_ring(polygon.outline, text);
  for (const Ring& hole : polygon.holes) {
    text += ", ";
    append_ring(hole, text);
  }
  text += ')';
}

}  // namespace

std::string to_wkt(std::span<const Polygon> polygons) {
  if (polygons.empty()) return "MULTIPOLYGON EMPTY";
  const bool is_one = polygons.size() == 1;
  std::string text = is_one ? "POLYGON " : "MULTIPOLYGON (";
  for (const Polygon& polygon : polygons) {
    if (&polygon != &polygons.front()) text += ", ";
    append_polygon(polygon, text);
  }
  return is_one ? text : text + ')';
}

tl::expected<std::vector<Polygon>, GeometryError> from_wkt(std::string_view text) { return Reader(text).read(); }

}  // namespace brash::geometry
