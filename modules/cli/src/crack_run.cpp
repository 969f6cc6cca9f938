// SPDX-License-Identifier: GPL-3.0-or-later
#include "crack_run.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace brash::cli {
namespace {

using geometry::Crack;
using geometry::Feature;
using geometry::IceSheet;
using geometry::Polygon;
using geometry::Ring;

/// The rectangle around all ice of the sheet, which is not empty.
Ring box_around(const IceSheet& sheet) {
  geometry::Extent box;
  for (const Polygon& part : sheet.polygons()) box.add(geometry::extent(part));
  const std::array corners{box.lower, Vec2{box.upper.x, box.lower.y}, box.upper, Vec2{box.lower.x, box.upper.y}};
  return geometry::ring(corners);
}

std::size_t n_holes_of(const std::vector<Polygon>& polygons) {
  std::size_t n = 0;
  for (const Polygon& polygon : polygons) n += polygon.holes.size();
  return n;
}

/// Calls `visit(a, b)` for the ends of each edge of a polygon.
template <typename Visit>
void visit_edges(const Polygon& polygon, Visit&& visit) {
  const auto visit_ring = [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) visit(ring[i], ring[(i + 1) % ring.size()]);
  };
  visit_ring(polygon.outline);
  std::ranges::for_each(polygon.holes, visit_ring);
}

/// Where the line from `a` to `b` meets edges of the polygon, as shares of its length, with both ends.
std::vector<double> places_of_crossings(const Polygon& polygon, Vec2 a, Vec2 b) {
  const Vec2 line = b - a;
  std::vector<double> places{0.0, 1.0};
  visit_edges(polygon, [&](geometry::Point from, geometry::Point to) {
    const Vec2 c = geometry::metres(from), edge = geometry::metres(to) - c;
    const double slope = cross(line, edge);
    if (slope == 0.0) return;
    const double t = cross(c - a, edge) / slope, s = cross(c - a, line) / slope;
    if (t > 0.0 && t < 1.0 && s >= 0.0 && s <= 1.0) places.push_back(t);
  });
  std::ranges::sort(places);
  return places;
}

/// Whether a place lies in the inside of the polygon, off its edges.
bool is_inside(const Polygon& polygon, Vec2 place) {
  constexpr double kOnEdge = 1e-6;  // [m]
  bool inside = false, on_edge = false;
  visit_edges(polygon, [&](geometry::Point from, geometry::Point to) {
    const Vec2 c = geometry::metres(from), d = geometry::metres(to), edge = d - c;
    if ((c.y > place.y) != (d.y > place.y) && place.x < c.x + (place.y - c.y) / edge.y * edge.x) inside = !inside;
    const double t = std::clamp(dot(place - c, edge) / dot(edge, edge), 0.0, 1.0);
    on_edge = on_edge || norm(place - (c + t * edge)) <= kOnEdge;
  });
  return inside && !on_edge;
}

/// Whether a stretch of the line from `a` to `b` lies in the inside of a polygon. Stretches of less than a millimetre
/// are errors of drawing.
bool runs_inside(const Polygon& polygon, Vec2 a, Vec2 b) {
  constexpr double kShortest = 1e-3;  // [m]
  const Vec2 line = b - a;
  const std::vector<double> places = places_of_crossings(polygon, a, b);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const bool is_long = (places[i + 1] - places[i]) * norm(line) >= kShortest;
    if (is_long && is_inside(polygon, a + 0.5 * (places[i] + places[i + 1]) * line)) return true;
  }
  return false;
}

}  // namespace

CrackRun::CrackRun(IceSheet sheet, const std::vector<Feature>& features) : sheet_(std::move(sheet)) {
  for (const Feature& f : features) {
    if (f.kind != "floe") {
      given_.push_back(f.polygon);
      continue;
    }
    floes_.push_back(f);
    ledger_.floes += geometry::area(f.polygon);
    next_id_ = std::max(next_id_, f.id + 1);
  }
  ledger_.initial = sheet_.area() + ledger_.floes;
}

bool CrackRun::apply(const CrackEvent& event, int sides) {
  return book(event.angles ? geometry::cut_circumferential(sheet_, event.centre, event.radius, *event.angles, sides)
                           : geometry::cut_circumferential(sheet_, event.centre, event.radius, event.wedges, sides));
}

bool CrackRun::apply(const Polygon& cutter) { return book(sheet_.cut(cutter.outline)); }

void CrackRun::apply(std::span<const Crack> cracks) {
  split_floes(cracks);
  if (!has_sheet()) return;
  std::vector<Crack> all = seams();
  all.insert(all.end(), cracks.begin(), cracks.end());
  book(sheet_.cut(box_around(sheet_), all));
}

void CrackRun::release() {
  for (Polygon& part : sheet_.release_detached()) add_floe({std::move(part), "floe"});
}

geometry::Ledger CrackRun::ledger() const {
  geometry::Ledger result = ledger_;
  result.sheet = sheet_.area();
  return result;
}

std::vector<Feature> CrackRun::features() const {
  std::vector<Feature> result;
  for (Polygon& part : sheet_.polygons())
    result.push_back({std::move(part), "sheet", static_cast<std::int64_t>(result.size())});
  result.insert(result.end(), floes_.begin(), floes_.end());
  return result;
}

std::vector<Crack> CrackRun::seams() const {
  std::vector<Crack> edges;
  std::size_t n_parts = 0;
  for (const Polygon& polygon : given_) {
    for (const Polygon& part : IceSheet::from_polygons(std::span(&polygon, 1))->polygons()) {
      ++n_parts;
      visit_edges(part, [&](geometry::Point from, geometry::Point to) { edges.push_back({from, to}); });
    }
  }
  if (sheet_.n_parts() == n_parts) edges.clear();
  return edges;
}

void CrackRun::split_floes(std::span<const Crack> cracks) {
  for (const Feature& floe : std::exchange(floes_, {})) {
    auto ice = IceSheet::from_polygons(std::span(&floe.polygon, 1)).value();
    const geometry::ExactArea laid_down = ice.area();
    const std::size_t n_parts = ice.n_parts(), n_holes = n_holes_of(ice.polygons());
    geometry::Cut cut = ice.cut(box_around(ice), cracks);
    if (cut.pieces.size() == n_parts && n_holes_of(cut.pieces) == n_holes) {
      floes_.push_back(floe);
      continue;
    }
    ledger_.floes -= geometry::area(floe.polygon);
    ledger_.snap += geometry::area(floe.polygon) - laid_down;
    book(std::move(cut), floe);
  }
}

void CrackRun::add_floe(Feature floe) {
  ledger_.floes += geometry::area(floe.polygon);
  floe.id = next_id_++;
  floes_.push_back(std::move(floe));
}

bool CrackRun::book(geometry::Cut cut, const Feature& like) {
  ledger_.snap += cut.snap;
  ledger_.n_rounded += cut.n_rounded;
  for (Polygon& piece : cut.pieces) add_floe({std::move(piece), like.kind, 0, like.thickness, like.flexural_strength});
  return !cut.pieces.empty();
}

std::vector<bool> lines_inside(const geometry::Lines& lines, const std::vector<Feature>& features) {
  std::vector<geometry::Extent> boxes;
  boxes.reserve(features.size());
  for (const Feature& f : features) boxes.push_back(geometry::extent(f.polygon));
  const auto is_in_ice = [&](const Crack& crack) {
    const Vec2 a = geometry::metres(crack.from), b = geometry::metres(crack.to);
    for (std::size_t i = 0; i < features.size(); ++i) {
      const auto& [lower, upper] = boxes[i];
      const bool is_apart = std::max(a.x, b.x) < lower.x || std::min(a.x, b.x) > upper.x ||
                            std::max(a.y, b.y) < lower.y || std::min(a.y, b.y) > upper.y;
      if (!is_apart && runs_inside(features[i].polygon, a, b)) return true;
    }
    return false;
  };
  std::vector<bool> inside;
  std::span<const Crack> rest = lines.cracks;
  for (const std::size_t n : lines.n_cracks) {
    inside.push_back(std::ranges::any_of(rest.first(n), is_in_ice));
    rest = rest.subspan(n);
  }
  return inside;
}

}  // namespace brash::cli
