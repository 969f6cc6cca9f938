// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/geometry/repair.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "brash/geometry/lines.hpp"
#include "brash/geometry/text.hpp"
#include "brash/geometry/unite.hpp"
#include "exact.hpp"

namespace brash::geometry {
namespace {

using exact::Box;
using Numbers = std::vector<std::size_t>;

/// Rounding moves edges by less [grid units].
constexpr std::int64_t kMargin = 64;
/// A round may round a crossing into a polygon beside it, which the next one repairs.
constexpr int kMostRounds = 8;

Box grown_box(const Polygon& polygon) {
  return polygon.outline.empty() ? Box{Point{}, Point{}} : exact::box_of(polygon.outline).grown(kMargin);
}

/// A point inside `polygon`, three times its coordinates: the centroid of a triangle in a convex part.
Point three_times_inside(const Polygon& polygon) {
  const std::vector<Ring> parts = convex_parts(polygon);
  BRASH_EXPECTS(!parts.empty(), polygon.outline.size());
  const Ring& part = parts.front();
  std::size_t i = 2;
  while (i + 1 < part.size() && turn(part[0], part[1], part[i]) == 0) ++i;
  return part[0] + part[1] + part[i];
}

bool holds(const Polygon& polygon, Point three_times) {
  const auto winds = [&](const Ring& ring) { return ring.size() > 2 && exact::winding(ring, three_times, 3) != 0; };
  return winds(polygon.outline) && std::ranges::none_of(polygon.holes, winds);
}

/// The rings without vertices on a straight line, which polygons beside them have left.
std::vector<Ring> corners_of(std::span<const Polygon> polygons) {
  std::vector<Ring> rings;
  const auto add = [&](const Ring& ring) {
    Ring& corners = rings.emplace_back();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point before = ring[(i + ring.size() - 1) % ring.size()], after = ring[(i + 1) % ring.size()];
      if (turn(before, ring[i], after) != 0) corners.push_back(ring[i]);
    }
  };
  for (const Polygon& polygon : polygons) {
    add(polygon.outline);
    for (const Ring& hole : polygon.holes) add(hole);
  }
  return rings;
}

/// The faces that the edges of polygons make, in a rectangle around them.
std::vector<Polygon> faces_of(std::span<const Repair::Part> parts, const Numbers& group) {
  constexpr auto kMost = static_cast<std::int64_t>(kMaxCoordinate / kGridUnit);
  Box box = grown_box(parts[group.front()].polygon);
  std::set<std::pair<Point, Point>> edges;
  for (const std::size_t i : group) {
    const Box own = grown_box(parts[i].polygon);
    box.add(own.low);
    box.add(own.high);
    visit_edges(parts[i].polygon, [&](Point a, Point b) {
      if (a != b) edges.insert(std::minmax(a, b));
    });
  }
  const auto clamped = [&](Point p) {
    return Point::of_units(std::clamp(p.x, -kMost, kMost), std::clamp(p.y, -kMost, kMost));
  };
  const Point low = clamped(box.low), high = clamped(box.high);
  const Polygon around{{low, Point::of_units(high.x, low.y), high, Point::of_units(low.x, high.y)}, {}};
  std::vector<Crack> cracks;
  cracks.reserve(edges.size());
  for (const auto& [from, to] : edges) cracks.push_back({from, to});
  return checked_sheet(std::span(&around, 1)).cut(around.outline, cracks).pieces;
}

/// One round of a repair.
class Round {
 public:
  Round(const std::vector<Repair::Part>& parts, const std::vector<Fault>& faults)
      : parts_(parts), is_faulty_(parts.size()) {
    for (const Fault& fault : faults) {
      is_faulty_[fault.first] = is_faulty_[fault.second] = 1;
      if (fault.first == fault.second) folded_.insert(fault.first);
    }
  }

  std::vector<Repair::Part> result(Repair& account) {
    std::map<std::size_t, std::vector<Polygon>> remade;
    for (const Numbers& group : groups()) remake(group, account, remade);
    std::vector<Repair::Part> result;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const auto made = remade.find(i);
      if (made == remade.end())
        result.push_back(parts_[i]);
      else
        for (Polygon& polygon : made->second) result.push_back({std::move(polygon), parts_[i].from});
    }
    return result;
  }

 private:
  /// Polygons at fault and those beside them, in groups that lie apart.
  std::vector<Numbers> groups() const {
    std::vector<Box> boxes;
    for (const Repair::Part& part : parts_) boxes.push_back(grown_box(part.polygon));
    Numbers by_left(parts_.size()), group(parts_.size());
    std::iota(by_left.begin(), by_left.end(), std::size_t{0});
    std::iota(group.begin(), group.end(), std::size_t{0});
    std::ranges::sort(by_left, {}, [&](std::size_t i) { return boxes[i].low.x; });
    const auto root = [&](std::size_t i) {
      while (group[i] != i) i = group[i] = group[group[i]];
      return i;
    };
    std::vector<char> takes_part = is_faulty_;
    for (std::size_t a = 0; a < by_left.size(); ++a)
      for (std::size_t b = a + 1; b < by_left.size(); ++b) {
        const std::size_t i = by_left[a], j = by_left[b];
        if (boxes[j].low.x > boxes[i].high.x) break;
        if (!(is_faulty_[i] || is_faulty_[j]) || !boxes[i].overlaps(boxes[j])) continue;
        takes_part[i] = takes_part[j] = 1;
        group[root(i)] = root(j);
      }
    std::map<std::size_t, Numbers> all;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (takes_part[i]) all[root(i)].push_back(i);
    std::vector<Numbers> groups;
    groups.reserve(all.size());
    for (auto& [first, numbers] : all) groups.push_back(std::move(numbers));
    return groups;
  }

  /// Gives each face of the group's edges to the first polygon that holds it.
  void remake(const Numbers& group, Repair& account, std::map<std::size_t, std::vector<Polygon>>& remade) const {
    look_for_interruption();
    std::map<std::size_t, std::vector<Polygon>> own;
    std::map<std::size_t, ExactArea> held;
    for (Polygon& face : faces_of(parts_, group)) {
      const Point inside = three_times_inside(face);
      const ExactArea size = area(face);
      bool is_taken = false;
      for (const std::size_t i : group) {
        if (!holds(parts_[i].polygon, inside)) continue;
        held[i] += size;
        if (is_taken)
          account.overlap += size;
        else
          own[i].push_back(face);
        is_taken = true;
      }
    }
    for (const std::size_t i : group) {
      (folded_.contains(i) ? account.folded : account.snap) += area(parts_[i].polygon) - held[i];
      remade[i] = unchanged_or(i, unite(own[i]).value().polygons);
    }
  }

  /// A polygon that the repair has left as it was keeps the order of its vertices.
  std::vector<Polygon> unchanged_or(std::size_t i, std::vector<Polygon> polygons) const {
    const Polygon& before = parts_[i].polygon;
    if (folded_.contains(i)) return polygons;
    const auto same = unite(std::span(&before, 1));
    return same && corners_of(same->polygons) == corners_of(polygons) ? std::vector{before} : std::move(polygons);
  }

  const std::vector<Repair::Part>& parts_;
  std::vector<char> is_faulty_;
  std::set<std::size_t> folded_;  ///< with a fault of their own
};

std::vector<Polygon> polygons_of(const std::vector<Repair::Part>& parts) {
  std::vector<Polygon> polygons;
  polygons.reserve(parts.size());
  for (const Repair::Part& part : parts) polygons.push_back(part.polygon);
  return polygons;
}

}  // namespace

tl::expected<Repair, GeometryError> repair(std::span<const Polygon> polygons) {
  Repair result;
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    result.parts.push_back({polygons[i], i});
    result.given += area(polygons[i]);
  }
  std::vector<Fault> faults = result.faults = faults_of(polygons);
  for (int round = 0; !faults.empty(); ++round) {
    if (round == kMostRounds) return tl::unexpected(GeometryError{"the repair leaves a fault: " + faults.front().what});
    result.parts = Round(result.parts, faults).result(result);
    faults = faults_of(polygons_of(result.parts));
  }
  std::vector<Numbers> parts_of(polygons.size());
  for (std::size_t k = 0; k < result.parts.size(); ++k) {
    parts_of[result.parts[k].from].push_back(k);
    result.kept += area(result.parts[k].polygon);
  }
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    if (parts_of[i].size() == 1 && result.parts[parts_of[i].front()].polygon == polygons[i]) continue;
    result.changed.push_back(i);
    if (parts_of[i].empty()) result.gone.push_back(i);
  }
  BRASH_EXPECTS(result.closes(), result.missing().to_string());
  return result;
}

}  // namespace brash::geometry
