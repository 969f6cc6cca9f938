// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "brash/core/byte_order_mark.hpp"
#include "brash/geometry/text.hpp"
#include "text_ring.hpp"

namespace brash::geometry {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

/// Reads down a fixed grammar: geometry, polygon, ring, position. Nothing recurs, so no input overflows the stack.
class Reader {
 public:
  Reader(std::string_view text, const Ground& ground)
      : text_(text), ground_(ground), at_(text.size() - without_byte_order_mark(text).size()) {}

  tl::expected<Map, GeometryError> map() {
    auto features = all<Feature>("POLYGON", [this](std::vector<Feature>& read) { read_polygon(read); });
    if (!features) return tl::unexpected(std::move(features).error());
    repair_round_off(*features, left_out_);
    return Map{*std::move(features), {}, crs(), false, left_out_.to_string()};
  }
  tl::expected<Lines, GeometryError> lines() {
    Lines lines;
    auto cracks = all<Crack>("LINESTRING", [&](std::vector<Crack>& read) {
      const std::size_t n_before = read.size();
      read_line(read);
      lines.n_cracks.push_back(read.size() - n_before);
    });
    if (!cracks) return tl::unexpected(std::move(cracks).error());
    lines.cracks = *std::move(cracks);
    lines.crs = crs();
    lines.left_out = left_out_.to_string();
    return lines;
  }

 private:
  /// Every geometry of the text. `kind` is the word before one member, MULTI and `kind` the word before several.
  template <typename T, typename ReadMember>
  tl::expected<std::vector<T>, GeometryError> all(std::string_view kind, const ReadMember& read_member) {
    std::vector<T> result;
    skip_space();
    if (is_at_end()) fail(fmt::format("there is no geometry: {} or MULTI{} is expected", kind, kind));
    while (!error_ && !is_at_end()) {
      read_geometry(kind, [&] { read_member(result); });
      skip_space();
    }
    if (error_) return tl::unexpected(*error_);
    return result;
  }

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
    if (!w.empty()) fail_at(start, fmt::format("'(' or EMPTY is expected, not {}", w));
    return false;
  }

  /// The kind of the geometry here, without the Z, M or ZM of one with heights or measures.
  std::string kind() {
    std::string result = word();
    while (result.ends_with('Z') || result.ends_with('M')) result.pop_back();
    const std::size_t after = at_;
    if (const std::string suffix = word(); suffix != "Z" && suffix != "M" && suffix != "ZM") at_ = after;
    return result;
  }

  /// Takes "SRID=32633;", which PostGIS writes before a geometry. 0 is not a code.
  void take_srid() {
    skip_space();
    const std::size_t start = at_;
    if (word() != "SRID") return void(at_ = start);
    expect('=');
    skip_space();
    std::string code;
    for (; !is_at_end() && is_digit(text_[at_]); ++at_) code += text_[at_];
    expect(';');
    if (code == "0") return;
    const std::string name = "EPSG:" + code;
    if (code.empty()) fail_at(start, "SRID= is followed by no code of EPSG");
    if (is_geographic(name)) fail_at(start, degrees_refused(name));
    if (!code_.empty() && code_ != code) fail_at(start, fmt::format("SRID={} comes after SRID={}", code, code_));
    code_ = code;
  }
  std::string crs() const { return code_.empty() ? "" : crs_of_code(code_); }

  template <typename ReadMember>
  void read_geometry(std::string_view kind, const ReadMember& read_member) {
    take_srid();
    skip_space();
    const std::size_t start = at_;
    const std::string found_kind = this->kind();
    const bool is_multi = found_kind == fmt::format("MULTI{}", kind);
    if (found_kind != kind && !is_multi) {
      return fail_at(start, fmt::format("{} or MULTI{} is expected, not {}", kind, kind,
                                        found_kind.empty() ? found() : found_kind));
    }
    n_ordinates_ = 0;
    if (accept_empty() || error_) return;
    if (!is_multi) return read_member();
    expect('(');
    do {
      if (!accept_empty()) read_member();
    } while (!error_ && accept(','));
    expect(')');
  }

  void read_polygon(std::vector<Feature>& features) {
    Feature feature{{}, "sheet", n_polygons_};
    feature.number = static_cast<std::size_t>(n_polygons_++);
    expect('(');
    if (error_) return;
    feature.polygon.outline = read_ring(false);
    while (!error_ && accept(',')) {
      if (accept_empty()) continue;
      Ring hole = read_ring(true);
      if (!hole.empty()) feature.polygon.holes.push_back(std::move(hole));
    }
    expect(')');
    if (!feature.polygon.outline.empty()) features.push_back(std::move(feature));
  }

  /// The first position of a geometry decides how many numbers each has: a missing comma is not a height.
  Position read_position() {
    constexpr int kMostOrdinates = 4;
    Position position;
    Coordinate passed_over;
    position.nearest.x = number(position.x);
    position.nearest.y = number(position.y);
    int n = 2;
    for (; !error_ && (n_ordinates_ > 0 ? n < n_ordinates_ : n < kMostOrdinates && is_at_number()); ++n)
      number(passed_over);
    n_ordinates_ = n;
    left_out_.n_heights += n > 2 ? 1 : 0;
    return position;
  }

  std::vector<Position> read_positions() {
    std::vector<Position> positions;
    expect('(');
    do {
      positions.push_back(read_position());
    } while (!error_ && accept(','));
    expect(')');
    if (ground_.survey != nullptr) ground_.survey->add(positions);
    return positions;
  }

  Ring read_ring(bool is_hole) {
    skip_space();
    const std::size_t start = at_;
    const std::vector<Position> positions = read_positions();
    if (error_ || ground_.survey != nullptr) return {};
    if (!is_hole) ground_.go_to(positions);
    auto result = ring_from_text(positions, is_hole, ground_.origin);
    if (result) {
      left_out_.n_thin += result->empty() ? 1 : 0;
      return *std::move(result);
    }
    fail_at(start, result.error());
    return {};
  }

  void read_line(std::vector<Crack>& cracks) {
    skip_space();
    const std::size_t start = at_;
    const std::vector<Position> positions = read_positions();
    if (error_) return;
    const auto read = cracks_from_positions(positions, ground_.origin);
    if (!read) return fail_at(start, read.error());
    cracks.insert(cracks.end(), read->begin(), read->end());
  }

  bool is_at_number() {
    skip_space();
    return !is_at_end() && std::string_view("0123456789+-.nN").find(text_[at_]) != std::string_view::npos;
  }

  /// The number here, also as the decimals that write it.
  double number(Coordinate& decimal) {
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
      decimal = Decimal::parse({start, static_cast<std::size_t>(stop - start)});
    }
    return value;
  }

  std::string_view text_;
  Ground ground_;
  std::size_t at_;
  int n_ordinates_ = 0;  ///< of a position of the geometry here; 0: none is read
  std::string code_;     ///< of EPSG, of the geometries
  LeftOut left_out_;
  std::int64_t n_polygons_ = 0;
  std::optional<GeometryError> error_;
};

void append_ring(const Ring& ring, const Origin& origin, std::string& text) {
  text += '(';
  for (const Point p : ring) text += position_to_text(p, ' ', origin) + ", ";
  text += position_to_text(ring.front(), ' ', origin) + ')';
}

void append_polygon(const Polygon& polygon, const Origin& origin, std::string& text) {
  text += '(';
  append_ring(polygon.outline, origin, text);
  for (const Ring& hole : polygon.holes) {
    text += ", ";
    append_ring(hole, origin, text);
  }
  text += ')';
}

}  // namespace

std::string to_wkt(std::span<const Polygon> polygons, const Origin& origin) {
  if (polygons.empty()) return "MULTIPOLYGON EMPTY";
  const bool is_one = polygons.size() == 1;
  std::string text = is_one ? "POLYGON " : "MULTIPOLYGON (";
  for (const Polygon& polygon : polygons) {
    if (&polygon != &polygons.front()) text += ", ";
    append_polygon(polygon, origin, text);
  }
  return is_one ? text : text + ')';
}

tl::expected<Map, GeometryError> map_of_wkt(std::string_view text, const Ground& ground) {
  return Reader(text, ground).map();
}

tl::expected<Lines, GeometryError> lines_of_wkt(std::string_view text, const Origin& origin) {
  return Reader(text, {origin}).lines();
}

}  // namespace brash::geometry
