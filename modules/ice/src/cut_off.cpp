// SPDX-License-Identifier: GPL-3.0-or-later
#include "cut_off.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace brash::ice {
namespace {

using Polyline = std::vector<Vec2>;

/// The crack knows the free edge to this share of its length: its ends are sought so far beyond them.
constexpr double kBeyond = 0.1;
/// The region's boundary leaves the ice by this much [m].
constexpr double kOutside = 1e-3;

double length_of(const Polyline& line) {
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length += norm(line[i + 1] - line[i]);
  return length;
}

/// A place on the free edge.
struct Place {
  std::size_t segment = 0;
  double share = 0.0;  ///< of it
};

/// Where an arm of the crack leaves the ice.
struct Exit {
  Place at;
  Polyline arm;    ///< up to there, from the middle of the crack
  Vec2 outside{};  ///< a little further
};

/// The first crossing of the arm with the edge.
std::optional<Exit> exit_of(Polyline arm, const Polyline& edge, double beyond) {
  arm.push_back(arm.back() + beyond * normalized(arm.back() - arm[arm.size() - 2]));
  for (std::size_t i = 0; i + 1 < arm.size(); ++i) {
    const Vec2 a = arm[i], d = arm[i + 1] - a;
    std::optional<Exit> first;
    double nearest = 2.0;
    for (std::size_t j = 0; j + 1 < edge.size(); ++j) {
      const Vec2 e = edge[j + 1] - edge[j];
      const double area = cross(d, e);
      if (area == 0.0) continue;
      const double s = cross(edge[j] - a, e) / area, t = cross(edge[j] - a, d) / area;
      if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0 || s >= nearest) continue;
      nearest = s;
      first = Exit{{j, t}, {}, a + s * d + kOutside * normalized(d)};
    }
    if (!first) continue;
    first->arm.assign(arm.begin(), arm.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    first->arm.push_back(a + nearest * d);
    return first;
  }
  return std::nullopt;
}

bool comes_before(Place a, Place b) { return a.segment != b.segment ? a.segment < b.segment : a.share < b.share; }

/// The place of the edge nearest to a point.
Place nearest(const Polyline& edge, Vec2 point) {
  Place best;
  double least = -1.0;
  for (std::size_t i = 0; i + 1 < edge.size(); ++i) {
    const Vec2 along = edge[i + 1] - edge[i];
    const double s = std::clamp(dot(point - edge[i], along) / dot(along, along), 0.0, 1.0);
    const double distance = norm(edge[i] + s * along - point);
    if (least >= 0.0 && distance >= least) continue;
    best = {i, s};
    least = distance;
  }
  return best;
}

double signed_area(const Polyline& ring) {
  double twice = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) twice += cross(ring[i], ring[(i + 1) % ring.size()]);
  return 0.5 * twice;
}

/// Whether the ring does not cross itself. One that leaves the ice close to a notch may cross the edge beyond it.
bool is_simple(const Polyline& ring) {
  const geometry::Polygon polygon{geometry::ring(ring), {}};
  return geometry::IceSheet::from_polygons(std::span(&polygon, 1)).has_value();
}

}  // namespace

std::optional<CutOff> cut_off(const geometry::IceSheet& sheet, Vec2 tip, const std::vector<Vec2>& crack) {
  if (crack.size() < 4) return std::nullopt;
  double reach = 0.0;
  for (const Vec2 point : crack) reach = std::max(reach, norm(point - tip));
  const double beyond = kBeyond * length_of(crack);
  const std::vector<Polyline> chains = sheet.free_edge(tip, reach + 2.0 * beyond);
  if (chains.empty() || chains.front().size() < 2) return std::nullopt;
  const Polyline& edge = chains.front();

  const auto middle = crack.begin() + static_cast<std::ptrdiff_t>(crack.size() / 2);
  auto one = exit_of({middle, crack.end()}, edge, beyond);
  auto other = exit_of({std::make_reverse_iterator(middle + 1), crack.rend()}, edge, beyond);
  if (!one || !other) return std::nullopt;
  if (comes_before(other->at, one->at)) std::swap(one, other);
  const Place at_tip = nearest(edge, tip);
  if (comes_before(at_tip, one->at) || comes_before(other->at, at_tip)) return std::nullopt;

  CutOff result;
  result.crack.assign(one->arm.rbegin(), one->arm.rend());
  result.crack.insert(result.crack.end(), other->arm.begin() + 1, other->arm.end());
  result.region = result.crack;
  result.region.front() = one->outside;
  result.region.back() = other->outside;
  for (std::size_t i = other->at.segment; i > one->at.segment; --i) result.region.push_back(edge[i]);
  if (signed_area(result.region) < 0.0) std::ranges::reverse(result.region);
  if (!is_simple(result.region)) return std::nullopt;
  return result;
}

Vec2 along(const std::vector<Vec2>& line, double share) {
  double left = share * length_of(line);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double length = norm(line[i + 1] - line[i]);
    if (left <= length) return line[i] + (left / length) * (line[i + 1] - line[i]);
    left -= length;
  }
  return line.back();
}

}  // namespace brash::ice
