// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/origin.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/unite.hpp"

namespace brash::geometry {

/// "line L, column C: `what`", counted from 1, for the byte at `offset` of `text`.
GeometryError error_at(std::string_view text, std::size_t offset, std::string_view what);

/// A coordinate as a text has it; nothing where the text has no finite decimal below 10^15 m.
using Coordinate = std::optional<Decimal>;

/// A position of a text, in the coordinates of the text.
struct Position {
  Coordinate x, y;
  Vec2 nearest;  ///< for messages

  friend bool operator==(const Position& a, const Position& b) { return a.x == b.x && a.y == b.y; }
};

/// The box around all positions of a text.
class Survey {
 public:
  void add(std::span<const Position> positions);
  /// Zero, where all positions lie within kMaxCoordinate of it; else the middle of the box to a hundred metres, or to a
  /// metre where the box leaves no room.
  Origin origin() const;
  /// Whether all positions lie within kMaxCoordinate of `origin`.
  bool lies_around(const Origin& origin) const;
  bool is_empty() const { return !low_; }
  Vec2 low() const { return low_ ? Vec2{low_->x.nearest_double(), low_->y.nearest_double()} : Vec2{}; }
  Vec2 high() const { return high_ ? Vec2{high_->x.nearest_double(), high_->y.nearest_double()} : Vec2{}; }

 private:
  std::optional<Origin> low_, high_;
};

/// Content of a text that the plan cannot hold.
struct LeftOut {
  std::size_t n_heights = 0, n_features = 0, n_ids = 0;
  std::size_t n_thin = 0;      ///< rings that are thinner than the grid
  std::size_t n_repaired = 0;  ///< polygons that rounding made cross themselves
  ExactArea repaired;          ///< area of their slivers and whiskers

  /// "heights (12), features without geometry (1)"; empty: nothing.
  std::string to_string() const;
};

/// Where the positions of a text go: onto the grid around `origin`, or into a survey alone.
struct Ground {
  Origin origin;
  Survey* survey = nullptr;  ///< where set, nothing else is done
  bool is_own = false;       ///< whether each polygon has an origin of its own, by its outline

  /// Goes to an outline, if each has a ground of its own.
  void go_to(std::span<const Position> outline);
};

/// The grid points of `positions`, or the first position beyond kMaxCoordinate of the origin, in words.
tl::expected<std::vector<Point>, std::string> points_from_text(std::span<const Position> positions,
                                                               const Origin& origin);

/// The grid ring through the closed list of `positions`, counter-clockwise, or clockwise for a hole.
/// @return the ring, or the error in it; empty where the positions have an area and rounding has left none.
tl::expected<Ring, std::string> ring_from_text(std::span<const Position> positions, bool is_hole, const Origin& origin);

/// Makes simple what rounding alone has made cross itself, and counts it. Polygons with larger faults stay.
void repair_round_off(std::vector<Feature>& features, LeftOut& left_out);

/// The cracks between neighbours of `positions`; two positions on one grid point make none.
tl::expected<std::vector<Crack>, std::string> cracks_from_positions(std::span<const Position> positions,
                                                                    const Origin& origin);

/// "x y" or "x,y" [m]: 17 significant digits without an origin, else the fewest decimals that read as `point`.
std::string position_to_text(Point point, char separator, const Origin& origin);

/// The lines of a WKT text.
tl::expected<Lines, GeometryError> lines_of_wkt(std::string_view text, const Origin& origin);

/// The polygons of a WKT text on `ground`, as sheet. The map has no origin.
tl::expected<Map, GeometryError> map_of_wkt(std::string_view text, const Ground& ground);

/// Why degrees are refused, with the remedy.
std::string degrees_refused(std::string_view name);

/// Whether all positions could be longitudes and latitudes of places with sea ice, beyond 40 degrees.
bool could_be_degrees(const Survey& survey);

/// The JSON object of `text` that begins at `offset`, as it is written.
std::string_view object_at(std::string_view text, std::size_t offset);

}  // namespace brash::geometry
