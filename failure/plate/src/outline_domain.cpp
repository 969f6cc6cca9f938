// SPDX-License-Identifier: GPL-3.0-or-later
#include "outline_domain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "production_sizes.hpp"
#include "profiles.hpp"

namespace brash::plate {

namespace {

/// Points of the edge closer than this are one, over l_c.
constexpr double kSamePlace = 1e-6;
/// The edge is meshed finely, and its corners are roots, within this distance of B, over l_c.
constexpr double kNear = 3.0;
/// A corner is re-entrant when the ice around it spans this much more than half a turn [rad].
constexpr double kReentrant = 10.0 * std::numbers::pi / 180.0;

using Polyline = std::vector<Vec2>;

/// Angle from `from` to `to`, clockwise, in [0, 2 pi).
double clockwise(Vec2 from, Vec2 to) {
  const double angle = std::atan2(-cross(from, to), dot(from, to));
  return angle < 0.0 ? angle + 2.0 * std::numbers::pi : angle;
}

/// Angle of the ice at an inner point of the edge; the ice is on its right.
double ice_angle(const Polyline& edge, std::size_t i) {
  return clockwise(edge[i + 1] - edge[i], edge[i - 1] - edge[i]);
}

/// Makes `place`, which lies on segment i to i + 1, a point of the edge unless one is there; its number.
std::size_t insert_point(Polyline& edge, std::size_t i, Vec2 place) {
  if (norm(place - edge[i]) < kSamePlace) return i;
  if (norm(place - edge[i + 1]) < kSamePlace) return i + 1;
  edge.insert(edge.begin() + static_cast<std::ptrdiff_t>(i) + 1, place);
  return i + 1;
}

/// Makes the origin a point of the edge; nothing where the edge misses it.
std::optional<std::size_t> insert_origin(Polyline& edge) {
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const Vec2 along = edge[i + 1] - edge[i];
    const double s = std::clamp(-dot(edge[i], along) / dot(along, along), 0.0, 1.0);
    if (norm(edge[i] + s * along) >= kSamePlace) continue;
    const std::size_t origin = insert_point(edge, i, {0.0, 0.0});
    edge[origin] = {0.0, 0.0};
    return origin;
  }
  return std::nullopt;
}

/// Makes the point at `length` along the edge after point `start` a point of the edge; its number.
std::size_t insert_along(Polyline& edge, std::size_t start, double length) {
  std::size_t i = start;
  while (norm(edge[i + 1] - edge[i]) < length) {
    length -= norm(edge[i + 1] - edge[i]);
    ++i;
  }
  return insert_point(edge, i, edge[i] + length * normalized(edge[i + 1] - edge[i]));
}

/// Where the x-axis first meets the edge ahead of the origin: a segment and the abscissa.
struct Crossing {
  std::size_t segment = 0;
  double x = std::numeric_limits<double>::infinity();
};

Crossing first_crossing(const Polyline& edge) {
  Crossing first;
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const Vec2 a = edge[i];
    const Vec2 b = edge[i + 1];
    if (std::min(a.y, b.y) > 0.0 || std::max(a.y, b.y) < 0.0) continue;
    const double x = a.y == b.y ? std::min(a.x, b.x) : a.x + (b.x - a.x) * (a.y / (a.y - b.y));
    if (x > kSamePlace && x < first.x) first = {i, x};
  }
  return first;
}

std::optional<std::string> fault_of(const OutlinePlate& plate) {
  const auto& edge = plate.outline;
  if (edge.size() < 2) return "the edge has fewer than two points";
  for (const Vec2 point : edge) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) return "the edge has a point that is not finite";
    if (point.y < edge.front().y || point.y > edge.back().y) return "the edge passes its own ends sideways";
  }
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    if (norm(edge[i + 1] - edge[i]) < kSamePlace) return "two points of the edge coincide";
  }
  return std::nullopt;
}

/// The edge, loaded to half the contact length on each side of the origin, and the far sides that close it.
void add_segments(Domain& domain, const Polyline& edge, double contact_length, double reach, double scale) {
  const auto middle = std::find(edge.begin(), edge.end(), Vec2{0.0, 0.0});
  Polyline ahead(middle, edge.end());
  Polyline behind(edge.begin(), middle + 1);
  std::reverse(behind.begin(), behind.end());
  double innermost = 0.0;
  for (const Vec2 point : edge) innermost = std::max(innermost, point.x);
  for (auto* arm : {&ahead, &behind}) {
    const std::size_t loaded = insert_along(*arm, 0, 0.5 * contact_length);
    for (std::size_t i = 0; i + 1 < arm->size(); ++i) {
      domain.segments.push_back({(*arm)[i], (*arm)[i + 1], i < loaded ? Side::kTip : Side::kFree});
    }
    const double size = scale * kTipCornerShare * tip_size(contact_length);
    domain.sizes.push_back({(*arm)[loaded], (*arm)[loaded], size, scale * kGradation});
  }
  const Vec2 right{innermost + reach, behind.back().y};
  const Vec2 left{innermost + reach, ahead.back().y};
  domain.segments.push_back({behind.back(), right, Side::kFar});
  domain.segments.push_back({right, left, Side::kFar});
  domain.segments.push_back({left, ahead.back(), Side::kFar});
}

/// Sizes along the edge near B; edge and corners of it as in the sheet with a trapezoidal protrusion.
void add_sizes(OutlineDomain& result, const Polyline& edge, double scale) {
  const double gradation = scale * kGradation;
  for (std::size_t i = 1; i + 1 < edge.size(); ++i) {
    if (norm(edge[i]) > kNear) continue;
    if (norm(edge[i + 1]) <= kNear) {
      result.domain.sizes.push_back({edge[i], edge[i + 1], kSideSize * scale, gradation});
    }
    if (ice_angle(edge, i) < std::numbers::pi + kReentrant) continue;
    result.roots.push_back(edge[i]);
    result.domain.sizes.push_back({edge[i], edge[i], kRootSize * scale, gradation});
  }
}

}  // namespace

tl::expected<OutlineDomain, std::string> sheet_behind(const OutlinePlate& plate, const MeshOptions& options) {
  if (const auto fault = fault_of(plate)) return tl::unexpected(*fault);
  const double tip = options.tip_size > 0.0 ? options.tip_size : tip_size(plate.contact_length);
  const double scale = tip / tip_size(plate.contact_length);
  const double reach = options.half_width > 0.0 ? options.half_width : kHalfWidth;

  // The edge from far to far with B, the ends of the contact and the end of the centre line as points of it.
  Polyline edge = plate.outline;
  edge.insert(edge.begin(), edge.front() - Vec2{0.0, reach});
  edge.push_back(edge.back() + Vec2{0.0, reach});
  auto origin = insert_origin(edge);
  if (!origin) return tl::unexpected(std::string("the edge misses B"));
  if (*origin == 0 || *origin + 1 == edge.size()) return tl::unexpected(std::string("B is at the end of the sheet"));
  if (clockwise(edge[*origin + 1], {1.0, 0.0}) >= ice_angle(edge, *origin)) {
    return tl::unexpected(std::string("there is no ice ahead of B"));
  }
  OutlineDomain result;
  for (const Vec2 point : edge) {
    if (norm(point) < kNear) result.base = std::max(result.base, point.x);
  }
  const auto crossing = first_crossing(edge);
  result.centre_line = std::min(crossing.x, result.base + kReach);
  if (crossing.x <= result.base + kReach) {
    const std::size_t end = insert_point(edge, crossing.segment, {crossing.x, 0.0});
    edge[end].y = 0.0;
    result.centre_line = edge[end].x;
  }
  add_sizes(result, edge, scale);
  add_segments(result.domain, edge, plate.contact_length, reach, scale);

  const double centre_end = crossing.x <= result.base + kReach ? result.centre_line : result.centre_line + 1.0;
  result.domain.segments.push_back({{0.0, 0.0}, {centre_end, 0.0}, Side::kInterior});
  result.domain.largest_size = options.far_size > 0.0 ? options.far_size : reach;
  const double fine_end = std::min(result.centre_line, result.base + kBreakingZone);
  result.domain.sizes.push_back({{0.0, 0.0}, {fine_end, 0.0}, kCentreSize * scale, scale * kGradation});
  for (const auto& segment : result.domain.segments) {
    if (segment.side != Side::kTip) continue;
    result.domain.sizes.push_back({segment.from, segment.to, tip, scale * kGradation});
  }
  return result;
}

}  // namespace brash::plate
