// SPDX-License-Identifier: GPL-3.0-or-later
#include "text_ring.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "polygon_edges.hpp"

namespace brash::geometry {
namespace {

/// ring() of points that lie on the grid already.
Ring ring(const std::vector<Point>& points) {
  Ring result;
  result.reserve(points.size());
  for (const Point point : points) {
    if (result.empty() || result.back() != point) result.push_back(point);
  }
  while (result.size() > 1 && result.back() == result.front()) result.pop_back();
  if (signed_area(result) < ExactArea{}) std::reverse(result.begin() + 1, result.end());
  return result;
}

/// Two lobes of one area that run opposite ways sum to zero.
bool crosses_itself(const Ring& ring) {
  PolygonEdges edges;
  edges.add({ring, {}}, 0);
  return !edges.crossings().empty();
}

/// Whether the digits of the positions say no more than the grid holds.
bool are_on_grid(std::span<const Position> positions, const std::vector<Point>& points, const Origin& origin) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (Decimal::of_grid_units(points[i].x, origin.x) != *positions[i].x) return false;
    if (Decimal::of_grid_units(points[i].y, origin.y) != *positions[i].y) return false;
  }
  return true;
}

}  // namespace

GeometryError error_at(std::string_view text, std::size_t offset, std::string_view what) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  const std::size_t last_break = before.rfind('\n');
  const std::size_t column = last_break == std::string_view::npos ? before.size() + 1 : before.size() - last_break;
  return {fmt::format("line {}, column {}: {}", line, column, what)};
}

void Survey::add(std::span<const Position> positions) {
  for (const Position& p : positions) {
    if (!p.x || !p.y) continue;
    if (!low_) low_ = high_ = Origin{*p.x, *p.y};
    low_ = Origin{std::min(low_->x, *p.x), std::min(low_->y, *p.y)};
    high_ = Origin{std::max(high_->x, *p.x), std::max(high_->y, *p.y)};
  }
}

bool Survey::lies_around(const Origin& origin) const {
  const auto is_near = [&](const Origin& p) { return p.x.grid_units_from(origin.x) && p.y.grid_units_from(origin.y); };
  return !low_ || (is_near(*low_) && is_near(*high_));
}

Origin Survey::origin() const {
  if (lies_around({})) return {};
  const auto middle = [](double low, double high) {
    constexpr double kCoarse = 100.0;
    const double step = high - low > 2.0 * kMaxCoordinate - kCoarse ? 1.0 : kCoarse;
    return Decimal(std::llround(0.5 * (low + high) / step) * static_cast<std::int64_t>(step));
  };
  return {middle(low().x, high().x), middle(low().y, high().y)};
}

void Ground::go_to(std::span<const Position> outline) {
  if (!is_own) return;
  Survey around;
  around.add(outline);
  origin = around.origin();
}

tl::expected<std::vector<Point>, std::string> points_from_text(std::span<const Position> positions,
                                                               const Origin& origin) {
  std::vector<Point> points;
  points.reserve(positions.size());
  for (const Position& p : positions) {
    const auto x = p.x ? p.x->grid_units_from(origin.x) : std::nullopt;
    const auto y = p.y ? p.y->grid_units_from(origin.y) : std::nullopt;
    if (!x || !y) {
      const bool is_zero = origin == Origin{};
      return tl::unexpected(fmt::format("({}, {}) is beyond +-{} m{}", p.nearest.x, p.nearest.y, kMaxCoordinate,
                                        is_zero ? "" : fmt::format(" of the origin ({})", to_string(origin))));
    }
    points.push_back(Point::of_units(*x, *y));
  }
  return points;
}

tl::expected<Ring, std::string> ring_from_text(std::span<const Position> positions, bool is_hole,
                                               const Origin& origin) {
  if (positions.size() < 4) {
    return tl::unexpected(fmt::format("a ring needs at least 4 positions, this has {}", positions.size()));
  }
  auto points = points_from_text(positions, origin);
  if (!points) return tl::unexpected(std::move(points).error());
  if (positions.front() != positions.back()) {
    return tl::unexpected(std::string("the ring is not closed: its last position is not its first"));
  }
  Ring result = ring(*points);
  const bool is_flat = result.size() < 3 || (signed_area(result) == ExactArea{} && !crosses_itself(result));
  if (is_flat && !are_on_grid(positions, *points, origin)) return Ring{};
  if (result.size() < 3) return tl::unexpected(std::string("the ring has fewer than 3 different vertices"));
  if (is_flat) return tl::unexpected(std::string("the ring has no area"));
  // Two lobes of one area have no orientation.
  if (is_hole && signed_area(result) != ExactArea{}) std::reverse(result.begin() + 1, result.end());
  return result;
}

tl::expected<std::vector<Crack>, std::string> cracks_from_positions(std::span<const Position> positions,
                                                                    const Origin& origin) {
  if (positions.size() < 2)
    return tl::unexpected(fmt::format("a line needs at least 2 positions, this has {}", positions.size()));
  const auto points = points_from_text(positions, origin);
  if (!points) return tl::unexpected(points.error());
  std::vector<Crack> cracks;
  for (std::size_t i = 0; i + 1 < points->size(); ++i) {
    if ((*points)[i] != (*points)[i + 1]) cracks.push_back({(*points)[i], (*points)[i + 1]});
  }
  return cracks;
}

std::string LeftOut::to_string() const {
  std::string text;
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0) text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", what, n);
  };
  add(n_heights, "heights");
  add(n_features, "features without geometry");
  add(n_ids, "ids that are not whole numbers");
  add(n_thin, "rings thinner than the grid of 1 nm");
  add(n_repaired, "slivers where rounding made an outline cross itself");
  if (repaired != ExactArea{}) text.insert(text.size() - 1, fmt::format(", {:.2g} m2", repaired.square_metres()));
  return text;
}

void repair_round_off(std::vector<Feature>& features, LeftOut& left_out) {
  std::vector<Feature> result;
  for (Feature& feature : features) {
    const auto repaired = fault_of(feature.polygon).empty() ? std::nullopt : without_round_off(feature.polygon);
    if (!repaired) {
      result.push_back(std::move(feature));
      continue;
    }
    ++left_out.n_repaired;
    left_out.repaired += repaired->changed;
    for (const Polygon& part : repaired->parts) {
      result.push_back(feature);
      result.back().polygon = part;
    }
  }
  features = std::move(result);
}

std::string fault_of(const Polygon& polygon) {
  const auto alone = IceSheet::from_polygons(std::span(&polygon, 1));
  if (alone) return {};
  std::string_view fault = alone.error().what;
  for (const std::string_view name : {"polygon 0, ", "polygon 0 "}) {  // the only one
    if (fault.starts_with(name)) fault.remove_prefix(name.size());
  }
  return std::string(fault);
}

IceSheet checked_sheet(std::span<const Polygon> polygons) {
  auto sheet = IceSheet::from_polygons(polygons);
  BRASH_EXPECTS(sheet.has_value(), sheet.has_value() ? "" : sheet.error().what);
  return *std::move(sheet);
}

std::string position_to_text(Point point, char separator, const Origin& origin) {
  if (origin == Origin{}) return fmt::format("{:.17g}{}{:.17g}", metres(point).x, separator, metres(point).y);
  return Decimal::of_grid_units(point.x, origin.x).to_string() + separator +
         Decimal::of_grid_units(point.y, origin.y).to_string();
}

}  // namespace brash::geometry
