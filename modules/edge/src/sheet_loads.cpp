// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/edge/sheet_loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace brash::edge {
namespace {

using Polyline = std::vector<Vec2>;

/// Loads so far from B along the edge bend the ice ahead of B by 2.5 % of the same load at B, in characteristic
/// lengths.
constexpr double kReach = 5.0;
/// Of a contact longer than twice that, the edge is needed as far as this beyond its ends, in characteristic lengths.
constexpr double kBeyond = 1.0;
/// Share of all loads that may be left out.
constexpr double kWeak = 0.02;
/// The chord's ends lie on the free edge to within this [m]; they are rounded to the geometry's grid, 2^-30 m.
constexpr double kOnTheEdge = 1e-6;

/// A place on a polyline.
struct Foot {
  std::size_t segment = 0;
  Vec2 place{};
  double distance = std::numeric_limits<double>::infinity();
};

/// The place nearest to `point` on the segments `first` to `last` of `line`; the first of several.
/// @param side  unless zero: only segments that have this direction on their left side.
Foot nearest(const Polyline& line, Vec2 point, std::size_t first, std::size_t last, Vec2 side = {}) {
  constexpr double kRounding = 1.0 + 1e-12;
  const bool any = side == Vec2{};
  Foot best;
  double reach2 = best.distance;  // most segments lie farther off: they need no root
  for (std::size_t i = first; i <= last; ++i) {
    const Vec2 along = line[i + 1] - line[i];
    if (!any && !(cross(along, side) > 0.0)) continue;
    const double square = dot(along, along);
    const double s = square > 0.0 ? std::clamp(dot(point - line[i], along) / square, 0.0, 1.0) : 0.0;
    const Vec2 place = line[i] + s * along;
    if (dot(place - point, place - point) > reach2) continue;
    const double distance = norm(place - point);
    if (distance < best.distance) best = {i, place, distance};
    reach2 = best.distance * best.distance * kRounding;
  }
  return best;
}
Foot nearest(const Polyline& line, Vec2 point) {
  return line.size() < 2 ? Foot{} : nearest(line, point, 0, line.size() - 2);
}

bool presses(const EdgeContact& contact) { return contact.load.pressure > 0.0; }
bool of_structure(const EdgeContact& contact) { return contact.floe == model::kNoFloe; }

/// A crushed stretch of the edge, which runs with the ice on its left: it dives into the structure and leaves it.
struct Crushed {
  Foot dives, leaves;
  std::size_t contact = 0;
};

/// The stretches of `chain` that contacts have crushed, one after the other.
std::vector<Crushed> crushed_stretches(const Polyline& chain, const std::vector<EdgeContact>& all) {
  std::vector<Crushed> stretches;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!of_structure(all[i]) || !presses(all[i])) continue;
    const Crushed found{nearest(chain, all[i].region.chord_to), nearest(chain, all[i].region.chord_from), i};
    const bool on_chain = found.dives.distance < kOnTheEdge && found.leaves.distance < kOnTheEdge;
    if (on_chain && found.dives.segment <= found.leaves.segment) stretches.push_back(found);
  }
  std::ranges::stable_sort(stretches, {}, [](const Crushed& c) { return c.dives.segment; });
  return stretches;
}

/// The edge with chords in place of its crushed stretches, the ice on its left; a stretch that another one covers
/// stays.
struct Edge {
  Polyline line;
  std::vector<std::size_t> chords;  ///< contacts whose chord is on it
};

Edge with_chords(const Polyline& chain, const std::vector<EdgeContact>& all) {
  Edge edge;
  const auto append = [&](Vec2 point) {
    if (edge.line.empty() || norm(edge.line.back() - point) > kOnTheEdge) edge.line.push_back(point);
  };
  std::size_t next = 0;  // point of the chain
  for (const Crushed& stretch : crushed_stretches(chain, all)) {
    if (stretch.dives.segment + 1 < next) continue;
    const geometry::ContactRegion& region = all[stretch.contact].region;
    while (next <= stretch.dives.segment) append(chain[next++]);
    if (norm(edge.line.back() - region.chord_to) <= kOnTheEdge) edge.line.pop_back();
    edge.line.push_back(region.chord_to);
    edge.line.push_back(region.chord_from);
    edge.chords.push_back(stretch.contact);
    next = stretch.leaves.segment + 1;
  }
  while (next < chain.size()) append(chain[next++]);
  return edge;
}

/// The edge in the frame, the ice on its right.
struct Outline {
  Polyline whole;
  /// From y < 0 to y > 0, without the part of each arm beyond its outermost point: from there the edge is taken to go
  /// on sideways.
  Polyline line;

  /// Whether a place is in the ice on the right of `line`: an odd number of edges lies between it and x = -infinity.
  bool has_inside(Vec2 place) const {
    bool inside =
        (place.y < line.front().y && place.x > line.front().x) || (place.y >= line.back().y && place.x > line.back().x);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Vec2 a = line[i], b = line[i + 1];
      if ((a.y <= place.y) == (b.y <= place.y)) continue;
      if (place.x > a.x + (b.x - a.x) * ((place.y - a.y) / (b.y - a.y))) inside = !inside;
    }
    return inside;
  }
  /// Whether a place lies beyond an end, where the edge is taken to continue sideways, and in front of it.
  bool ends_before(Vec2 place) const {
    const Vec2 front = line.front(), back = line.back();
    return (place.y < front.y && place.x < front.x) || (place.y > back.y && place.x < back.x);
  }
};

/// Nothing where no point is on one side of B.
std::optional<Outline> outline_in(const Frame& frame, const Polyline& line) {
  Outline result;
  for (auto point = line.rbegin(); point != line.rend(); ++point) result.whole.push_back(frame.place(*point));
  result.line = result.whole;
  Polyline& outline = result.line;
  const Foot origin = nearest(outline, {});
  const auto by_y = [](Vec2 a, Vec2 b) { return a.y < b.y; };
  const auto after = outline.begin() + static_cast<std::ptrdiff_t>(origin.segment) + 1;
  outline.erase(std::max_element(after, outline.end(), by_y) + 1, outline.end());
  const auto before = outline.begin() + static_cast<std::ptrdiff_t>(origin.segment) + 1;
  outline.erase(outline.begin(), std::min_element(outline.begin(), before, by_y));
  if (outline.size() < 2 || !(outline.front().y < 0.0) || !(outline.back().y > 0.0)) return std::nullopt;
  return result;
}

/// The load of a contact in the frame, without its place.
class Resultant {
 public:
  /// @param mid_height  of the ice at rest [m].
  Resultant(const EdgeContact& contact, const Frame& frame, double mid_height, double own_way)
      : in_plane_(frame.turned(plan(contact.on_ice))),
        out_of_plane_(own_way * contact.on_ice.z),
        // N above mid-thickness bends the edge up, N below it down. The plate knows how far the edge has given way.
        eccentricity_(own_way * (contact.point.z - mid_height - contact.shift)),
        has_verdict_(contact.has_verdict) {}

  failure::SheetLoad on_edge(Vec2 from, Vec2 to) const {
    const Vec2 inwards = -1.0 * perpendicular(normalized(to - from));
    return {.from = from,
            .to = to,
            .in_plane = in_plane_,
            .out_of_plane = out_of_plane_,
            .moment = eccentricity_ * dot(in_plane_, inwards),
            .has_verdict = has_verdict_};
  }
  failure::SheetLoad on_disc(Vec2 centre, double radius) const {
    return {.from = centre, .to = centre, .radius = radius, .out_of_plane = out_of_plane_, .has_verdict = has_verdict_};
  }

 private:
  Vec2 in_plane_;
  double out_of_plane_;
  double eccentricity_;
  bool has_verdict_;
};

/// A stretch of a line.
struct Stretch {
  Foot from, to;
};

/// The stretch of an edge that a floe presses on: it faces the push, and lies within the floe's own reach. No contact
/// can push a floe's load out of the ice, so an edge that faces the other way belongs to other ice.
/// @param side  the floe's push as the line has it on its left side.
std::optional<Stretch> pressed_stretch(const Polyline& line, Vec2 middle, Vec2 side, double length, double thickness) {
  const Foot foot = nearest(line, middle, 0, line.size() - 2, side);
  const double half = 0.5 * length;
  if (!(foot.distance <= half + thickness)) return std::nullopt;
  const Vec2 along = half * normalized(line[foot.segment + 1] - line[foot.segment]);
  const Stretch found{nearest(line, foot.place - along, 0, foot.segment),
                      nearest(line, foot.place + along, foot.segment, line.size() - 2)};
  const Vec2 chord = found.to.place - found.from.place;
  if (norm(chord) <= kOnTheEdge || !(cross(chord, side) > 0.0)) return std::nullopt;
  return found;
}

/// The load of a floe: on the edge, or on a disc where it presses inside the ice. Left out beyond the outline's ends,
/// and on an edge that the outline leaves out.
void place_floe(const EdgeContact& contact, const Resultant& load, const Frame& frame, const Outline& outline,
                double thickness, std::vector<failure::SheetLoad>& loads) {
  const Vec2 middle = frame.place(contact.region.midpoint);
  if (outline.ends_before(middle)) return;
  const double length = contact.region.contact_length;
  if (nearest(outline.line, middle).distance > 0.5 * thickness && outline.has_inside(middle)) {
    loads.push_back(load.on_disc(middle, 0.5 * length));
    return;
  }
  const Vec2 out = -1.0 * frame.turned(contact.region.normal);  // the ice is on the right of the outline
  const Foot foot = nearest(outline.line, middle, 0, outline.line.size() - 2, out);
  if (nearest(outline.whole, middle, 0, outline.whole.size() - 2, out).distance < foot.distance - kOnTheEdge) return;
  if (const auto stretch = pressed_stretch(outline.line, middle, out, length, thickness))
    loads.push_back(load.on_edge(stretch->from.place, stretch->to.place));
}

/// How much a load bends the ice near B, about [N].
double weight_of(const failure::SheetLoad& load, double reach, double l_c) {
  const double near = std::max(0.0, 1.0 - norm(0.5 * (load.from + load.to)) / reach);
  return near * (std::abs(load.out_of_plane) + std::abs(load.moment) / l_c);
}

/// Leaves loads out that together bend the ice near B by a share of kWeak at most.
/// @param own  weight of the load at B: it stays, and what weighs as much.
void drop_weak(double reach, double l_c, double own, std::vector<failure::SheetLoad>& loads) {
  const auto weight = [&](const failure::SheetLoad& load) { return weight_of(load, reach, l_c); };
  std::vector<double> weights;
  for (const failure::SheetLoad& load : loads) weights.push_back(weight(load));
  std::ranges::sort(weights);
  const double allowed = kWeak * std::accumulate(weights.begin(), weights.end(), 0.0);
  double dropped = 0.0, least = 0.0;
  for (const double w : weights) {
    dropped += w;
    least = w;
    if (dropped > allowed) break;
  }
  least = std::min(least, own);
  std::erase_if(loads, [&](const failure::SheetLoad& load) { return weight(load) < least; });
}

/// The edge around a contact, the ice on its left, with the contact's chord in it.
struct OwnEdge {
  Frame frame;
  Polyline line;
  std::optional<std::pair<Vec2, Vec2>> chord{};  ///< of a floe on the edge, its ends in the order of the outline
};

/// The edge under a floe: a chord takes the place of the stretch that it presses, as for the structure, and the frame
/// is the chord's. A load inside the ice has none: there the frame goes from the nearest edge through its middle.
/// Nothing if no edge here faces the floe's push.
std::optional<OwnEdge> under_floe(const EdgeContact& own, const geometry::IceSheet& sheet, const Polyline& edge,
                                  const failure::IceProperties& ice) {
  const Vec2 at = own.region.midpoint;
  const Foot foot = nearest(edge, at);
  if (foot.distance > 0.5 * ice.thickness && sheet.contains(at))
    return OwnEdge{{foot.place, normalized(at - foot.place)}, edge};
  const auto stretch = pressed_stretch(edge, at, own.region.normal, own.region.contact_length, ice.thickness);
  if (!stretch) return std::nullopt;
  const Vec2 from = stretch->from.place, to = stretch->to.place;
  OwnEdge result{{0.5 * (from + to), perpendicular(normalized(to - from))}, {}, std::pair{to, from}};
  result.line.assign(edge.begin(), edge.begin() + static_cast<std::ptrdiff_t>(stretch->from.segment) + 1);
  result.line.insert(result.line.end(), {from, to});
  result.line.insert(result.line.end(), edge.begin() + static_cast<std::ptrdiff_t>(stretch->to.segment) + 1,
                     edge.end());
  return result;
}

}  // namespace

std::optional<Frame> place_loads(const EdgeModel& model, const geometry::IceSheet& sheet,
                                 const std::vector<EdgeContact>& all, std::size_t contact, bool joint,
                                 failure::LoadCase& load) {
  const EdgeContact& own = all[contact];
  const double l_c = failure::characteristic_length(model.ice);
  const double reach = std::max(kReach * l_c, 0.5 * own.region.contact_length + kBeyond * l_c);
  const Vec2 at = 0.5 * (own.region.chord_from + own.region.chord_to);
  for (const Polyline& chain : sheet.free_edge(at, reach)) {
    const Edge edge = with_chords(chain, all);
    const auto has_chord = [&](std::size_t i) { return std::ranges::find(edge.chords, i) != edge.chords.end(); };
    if (edge.line.size() < 2 || (of_structure(own) && !has_chord(contact))) continue;
    const auto here =
        of_structure(own) ? OwnEdge{{at, own.region.normal}, edge.line} : under_floe(own, sheet, edge.line, model.ice);
    if (!here) continue;
    const Frame& frame = here->frame;
    const auto outline = outline_in(frame, here->line);
    if (!outline) return std::nullopt;

    const Freeboard heights = freeboard(model.resolved);
    const double own_way = own.on_ice.z > 0.0 ? 1.0 : -1.0;
    const auto add = [&](std::size_t i) {
      const EdgeContact& other = all[i];
      const Resultant resultant(other, frame, 0.5 * (heights.top + heights.bottom), own_way);
      if (of_structure(other)) {
        // The chord of a floe may have taken an end of the structure's chord along.
        const double moved = here->chord ? own.region.contact_length : kOnTheEdge;
        const Foot from = nearest(outline->line, frame.place(other.region.chord_from));
        const Foot to = nearest(outline->line, frame.place(other.region.chord_to));
        const bool is_there = has_chord(i) && from.distance < moved && to.distance < moved;
        if (is_there && norm(to.place - from.place) > kOnTheEdge)
          load.loads.push_back(resultant.on_edge(from.place, to.place));
      } else if (i == contact && here->chord) {
        load.loads.push_back(resultant.on_edge(frame.place(here->chord->first), frame.place(here->chord->second)));
      } else if (norm(frame.place(other.region.midpoint)) < reach) {
        place_floe(other, resultant, frame, *outline, model.ice.thickness, load.loads);
      }
    };
    add(contact);
    if (load.loads.empty()) return std::nullopt;
    const double own_weight = weight_of(load.loads.front(), reach, l_c);
    for (std::size_t i = 0; joint && i < all.size(); ++i)
      if (i != contact && presses(all[i])) add(i);
    drop_weak(reach, l_c, own_weight, load.loads);
    load.outline = outline->line;
    return frame;
  }
  return std::nullopt;
}

std::optional<Vec2> into_ice_near(const geometry::IceSheet& sheet, Vec2 at, double reach) {
  const std::vector<Polyline> chains = sheet.free_edge(at, reach);
  if (chains.empty() || chains.front().size() < 2) return std::nullopt;
  const Polyline& chain = chains.front();
  const std::size_t i = nearest(chain, at).segment;
  return perpendicular(normalized(chain[i + 1] - chain[i]));
}

}  // namespace brash::edge
