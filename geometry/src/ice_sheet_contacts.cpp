// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

namespace {

/// The middle by arc length of the polyline.
Vec2 middle_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  double left = 0.5 * length;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double edge = norm(line[i] - line[i - 1]);
    if (left <= edge && edge > 0.0) return line[i - 1] + left / edge * (line[i] - line[i - 1]);
    left -= edge;
  }
  return line.back();
}

double length_of(const std::vector<Vec2>& line) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) length += norm(line[i] - line[i - 1]);
  return length;
}

/// The longest run of free edge on the outline of an overlap; there must be something else on it.
/// Of equal ones it is the first after the outline's smallest edge, so that the plan alone decides.
std::vector<Vec2> longest_free_edge(const Arrangement::Walk& outline) {
  const std::size_t n = outline.size();
  const auto is_smaller = [](const Arrangement::Side& a, const Arrangement::Side& b) {
    return std::minmax(a.from, a.to) < std::minmax(b.from, b.to);
  };
  auto first = static_cast<std::size_t>(std::min_element(outline.begin(), outline.end(), is_smaller) - outline.begin());
  while (outline[first % n].is_free) ++first;
  std::vector<Vec2> longest;
  std::vector<Vec2> run;
  for (std::size_t i = first; i <= first + n; ++i) {
    const Arrangement::Side& side = outline[i % n];
    if (side.is_free) {
      if (run.empty()) run.push_back(metres(side.from));
      run.push_back(metres(side.to));
      continue;
    }
    if (length_of(run) > length_of(longest)) longest = run;
    run.clear();
  }
  return longest;
}

ContactRegion contact_of(const Arrangement::Piece& piece) {
  ContactRegion contact;
  const Arrangement::Walk& outline = piece.outline;
  const auto is_free = [](const Arrangement::Side& side) { return side.is_free; };
  const bool has_front = std::any_of(outline.begin(), outline.end(), is_free);
  const bool has_chord = !std::all_of(outline.begin(), outline.end(), is_free);
  contact.overlap = polygon_of(piece);
  if (!has_front || !has_chord) {
    std::vector<Vec2> around;
    for (const Point p : contact.overlap.outline) around.push_back(metres(p));
    around.push_back(around.front());
    contact.midpoint = has_front ? middle_of(around) : centroid(contact.overlap);
    contact.chord_from = contact.chord_to = around.front();
    return contact;
  }
  const std::vector<Vec2> free_edge = longest_free_edge(outline);
  contact.midpoint = middle_of(free_edge);
  // The section's boundary enters the ice where the free edge ends, and leaves it where the free edge starts.
  contact.chord_from = free_edge.back();
  contact.chord_to = free_edge.front();
  const Vec2 chord = contact.chord_to - contact.chord_from;
  contact.contact_length = norm(chord);
  if (contact.contact_length > 0.0) contact.normal = -perpendicular(chord) / contact.contact_length;
  return contact;
}

}  // namespace

std::vector<ContactRegion> IceSheet::contacts(std::span<const Point> section) const {
  expect_region(section);
  const Noding noding(impl_->boundary, section, {});
  std::vector<ContactRegion> contacts;
  for (const Arrangement::Piece& piece : Arrangement::overlap(noding, impl_->boundary)) {
    contacts.push_back(contact_of(piece));
  }
  std::sort(contacts.begin(), contacts.end(),
            [](const ContactRegion& a, const ContactRegion& b) { return a.overlap.outline < b.overlap.outline; });
  Vec2 middle;
  for (const Point p : section) middle += metres(p) / static_cast<double>(section.size());
  std::stable_sort(contacts.begin(), contacts.end(), [&](const ContactRegion& a, const ContactRegion& b) {
    const auto angle = [&](Vec2 p) { return std::atan2(p.y - middle.y, p.x - middle.x); };
    return angle(a.midpoint) < angle(b.midpoint);
  });
  return contacts;
}

namespace {

/// The part of the segment a b within `radius` of `at`, as parameters along it; nothing when it stays outside.
std::optional<std::pair<double, double>> part_within(Vec2 a, Vec2 b, Vec2 at, double radius) {
  const Vec2 d = b - a;
  const double length2 = dot(d, d);
  const double nearest = dot(at - a, d) / length2;
  const Vec2 offset = a + nearest * d - at;
  const double rest = radius * radius - dot(offset, offset);
  if (rest <= 0.0) return std::nullopt;
  const double half = std::sqrt(rest / length2);
  const double from = std::max(0.0, nearest - half);
  const double to = std::min(1.0, nearest + half);
  if (from >= to) return std::nullopt;
  return std::pair{from, to};
}

/// A free edge within the circle.
struct ClippedEdge {
  int id;
  Vec2 from;
  Vec2 to;
  bool starts_whole;
  bool ends_whole;
  bool is_used = false;
};

/// The edges of `boundary` within `radius` of `at`, in the order of the plan, not of their ids.
std::vector<ClippedEdge> edges_within(const FreeEdges& boundary, Vec2 at, double radius) {
  const Vec2 reach{radius, radius};
  std::vector<int> ids;
  boundary.query(exact::Box::of(snap(at - reach), snap(at + reach)).grown(1), [&](int id) { ids.push_back(id); });
  std::sort(ids.begin(), ids.end(), [&](int i, int j) {
    const FreeEdges::Edge& a = boundary.edge(i);
    const FreeEdges::Edge& b = boundary.edge(j);
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  std::vector<ClippedEdge> edges;
  for (const int id : ids) {
    const Vec2 a = metres(boundary.edge(id).from);
    const Vec2 b = metres(boundary.edge(id).to);
    const auto part = part_within(a, b, at, radius);
    if (!part) continue;
    const auto [from, to] = *part;
    edges.push_back({id, from > 0.0 ? a + from * (b - a) : a, to < 1.0 ? a + to * (b - a) : b, from <= 0.0, to >= 1.0});
  }
  return edges;
}

double distance_to(const std::vector<Vec2>& chain, Vec2 at) {
  double nearest = norm(chain.front() - at);
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Vec2 d = chain[i] - chain[i - 1];
    const double length2 = dot(d, d);
    const double t = length2 > 0.0 ? std::clamp(dot(at - chain[i - 1], d) / length2, 0.0, 1.0) : 0.0;
    nearest = std::min(nearest, norm(chain[i - 1] + t * d - at));
  }
  return nearest;
}

}  // namespace

std::vector<std::vector<Vec2>> IceSheet::free_edge(Vec2 at, double radius) const {
  BRASH_EXPECTS(radius > 0.0 && std::isfinite(radius), radius);
  const FreeEdges& boundary = impl_->boundary;
  std::vector<ClippedEdge> edges = edges_within(boundary, at, radius);
  std::vector<std::pair<int, std::size_t>> places;
  for (std::size_t i = 0; i < edges.size(); ++i) places.emplace_back(edges[i].id, i);
  std::sort(places.begin(), places.end());
  const auto find = [&](int id) -> ClippedEdge* {
    const auto place = std::lower_bound(places.begin(), places.end(), std::pair<int, std::size_t>{id, 0});
    return place != places.end() && place->first == id ? &edges[place->second] : nullptr;
  };
  /// The edge that continues where `e` ends, when that is within the circle.
  const auto next_of = [&](const ClippedEdge& e) -> ClippedEdge* {
    ClippedEdge* next = e.ends_whole ? find(boundary.edge(e.id).next) : nullptr;
    return next != nullptr && next->starts_whole ? next : nullptr;
  };
  std::vector<std::vector<Vec2>> chains;
  const auto follow = [&](ClippedEdge* e) {
    std::vector<Vec2>& chain = chains.emplace_back(1, e->from);
    for (; e != nullptr && !e->is_used; e = next_of(*e)) {
      e->is_used = true;
      chain.push_back(e->to);
    }
  };
  for (ClippedEdge& e : edges) {
    const ClippedEdge* previous = e.starts_whole ? find(boundary.edge(e.id).previous) : nullptr;
    if (previous == nullptr || !previous->ends_whole) follow(&e);
  }
  for (ClippedEdge& e : edges) {
    if (!e.is_used) follow(&e);
  }
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < chains.size(); ++i) order.emplace_back(distance_to(chains[i], at), i);
  std::sort(order.begin(), order.end());
  std::vector<std::vector<Vec2>> sorted;
  for (const auto& [distance, i] : order) sorted.push_back(std::move(chains[i]));
  return sorted;
}

}  // namespace brash::geometry
