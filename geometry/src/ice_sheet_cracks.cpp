// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <utility>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

namespace {

constexpr double kTurn = 2.0 * kPi;

double turned(double angle) {
  const double rest = std::fmod(angle, kTurn);
  return rest < 0.0 ? rest + kTurn : rest;
}

Point on_circle(Vec2 centre, double radius, double angle) {
  return snap(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
}

/// The disc with a vertex of its own where each crack ends. A crack takes the place of a vertex that is nearer than a
/// hundredth of a chord, so that no chord is much shorter than the others because of rounding.
Ring disc_with(Vec2 centre, double radius, std::span<const double> angles, int sides) {
  std::vector<double> at(angles.begin(), angles.end());
  for (double& angle : at) angle = turned(angle);
  for (int i = 0; i < sides; ++i) {
    const double angle = kTurn * i / sides;
    const auto is_near = [&](double crack) {
      return std::abs(std::remainder(crack - angle, kTurn)) < 0.01 * kTurn / sides;
    };
    if (std::none_of(angles.begin(), angles.end(), is_near)) at.push_back(angle);
  }
  std::sort(at.begin(), at.end());
  Ring ring;
  for (const double angle : at) ring.push_back(on_circle(centre, radius, angle));
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.back() == ring.front()) ring.pop_back();
  return ring;
}

/// Angles that the ice within the circle takes on it, seen from the centre: from `from` on over `span`.
struct Arc {
  double from = 0.0;
  double span = 0.0;
};

/// The turn less the widest gap between the sides of `pieces` that face away from the centre; they may overlap.
Arc ice_around(std::span<const Polygon> pieces, Vec2 centre) {
  std::vector<std::pair<double, double>> sides;
  for (const Polygon& piece : pieces) {
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      const Vec2 a = metres(piece.outline[i]) - centre;
      const Vec2 b = metres(piece.outline[i + 1 == piece.outline.size() ? 0 : i + 1]) - centre;
      if (cross(a, b) > 0.0) sides.emplace_back(std::atan2(a.y, a.x), std::atan2(cross(a, b), dot(a, b)));
    }
  }
  if (sides.empty()) return {};
  Arc arc{0.0, kTurn};
  double widest = 1e-9;
  for (const auto& [start, width] : sides) {
    // How far it is from the end of this side to the start of the next: nothing, if the end lies within one.
    const double end = start + width;
    double gap = kTurn, next = end;
    for (const auto& [other, other_width] : sides) {
      const double since = turned(end - other + 1e-9) - 1e-9;
      if (since < other_width - 1e-9) gap = 0.0;
      if (const double until = turned(other - end + 1e-9) - 1e-9; until < gap) gap = until, next = other;
    }
    if (gap > widest) widest = gap, arc = {next, kTurn - gap};
  }
  return arc;
}

/// The arc less the widest gap in its ice; ice that does not reach the circle counts with nothing where other ice does.
Arc ice_on_arc(const IceSheet& sheet, Vec2 centre, double radius, int sides) {
  const Ring circle = disc(centre, radius, sides);
  const std::vector<Polygon> pieces = sheet.within(circle);
  std::vector<std::pair<double, double>> covered;
  for (const Polygon& piece : pieces) {
    for (std::size_t i = 0; i < piece.outline.size(); ++i) {
      const Vec2 a = metres(piece.outline[i]) - centre;
      const Vec2 b = metres(piece.outline[i + 1 == piece.outline.size() ? 0 : i + 1]) - centre;
      // On the circle's chords, whose middles are no nearer than radius cos(pi / sides); the grid moves by 1 nm.
      const double chord = radius * std::cos(kPi / sides) - 4.0 * kGridUnit;
      const Vec2 d = b - a;
      const bool on_arc = std::abs(cross(a, b)) >= chord * norm(d) && cross(a, b) > 0.0;
      if (on_arc) covered.emplace_back(turned(std::atan2(a.y, a.x)), turned(std::atan2(b.y, b.x)));
    }
  }
  if (covered.empty()) return ice_around(pieces, centre);
  std::sort(covered.begin(), covered.end());
  Arc arc{0.0, 0.0};
  double widest = 0.0;
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const double next = covered[(i + 1) % covered.size()].first;
    const double gap = turned(next - covered[i].second + 1e-9) - 1e-9;
    if (gap > widest) {
      widest = gap;
      arc.from = next;
    }
  }
  // Gaps of less than a thousandth of a chord are the rounding of angles: the circle is closed.
  if (widest < 1e-3 * kTurn / sides) return {covered.front().first, kTurn};
  arc.span = kTurn - widest;
  return arc;
}

CrackedRegion circumferential_at(Vec2 centre, double radius, std::span<const double> angles, int sides) {
  BRASH_EXPECTS(radius > 0.0 && std::isfinite(radius), radius);
  BRASH_EXPECTS(sides >= 3, sides);
  const Point from = snap(centre);
  std::vector<Crack> cracks;
  for (const double angle : angles) cracks.push_back({from, on_circle(centre, radius, turned(angle))});
  return {disc_with(centre, radius, angles, sides), std::move(cracks)};
}

/// Whether there is ice all round a point, so that wedges about it begin where they end. An edge through the pixel of
/// the point goes through the point when it is cut.
bool lies_inside(const IceSheet& sheet, Vec2 point) {
  const Vec2 at = metres(snap(point));
  return sheet.contains(at) && sheet.free_edge(at, 0.75 * kGridUnit).empty();
}

/// The circle with even radial cracks. `parts_ends`: about a centre inside the ice one more crack runs through the gap
/// of the arc, and parts the last wedge from the first.
CrackedRegion even_wedges(const IceSheet& sheet, Vec2 centre, double radius, int n_wedges, int sides, bool parts_ends) {
  BRASH_EXPECTS(n_wedges >= 1, n_wedges);
  BRASH_EXPECTS(radius > 0.0 && std::isfinite(radius), radius);
  BRASH_EXPECTS(sides >= 3, sides);
  std::vector<double> angles;
  if (n_wedges > 1) {
    const Arc arc = ice_on_arc(sheet, centre, radius, sides);
    const bool all_round = arc.span >= kTurn;
    for (int i = all_round ? 0 : 1; i < n_wedges; ++i) angles.push_back(arc.from + arc.span * i / n_wedges);
    if (parts_ends && !all_round && lies_inside(sheet, centre)) angles.push_back(arc.from + 0.5 * (arc.span + kTurn));
  }
  return circumferential_at(centre, radius, angles, sides);
}

}  // namespace

CrackedRegion circumferential(const IceSheet& sheet, Vec2 centre, double radius, int n_wedges, int sides) {
  return even_wedges(sheet, centre, radius, n_wedges, sides, false);
}

Cut cut_circumferential(IceSheet& sheet, Vec2 centre, double radius, std::span<const double> angles, int sides) {
  const CrackedRegion cracked = circumferential_at(centre, radius, angles, sides);
  return sheet.cut(cracked.region, cracked.cracks);
}

Cut cut_circumferential(IceSheet& sheet, Vec2 centre, double radius, int n_wedges, int sides) {
  const CrackedRegion cracked = even_wedges(sheet, centre, radius, n_wedges, sides, true);
  return sheet.cut(cracked.region, cracked.cracks);
}

Cut split(const Polygon& floe, Point from, Point to) {
  BRASH_EXPECTS(from != to, from.x, from.y);
  const Polygon polygons[] = {floe};
  auto sheet = IceSheet::from_polygons(polygons);
  BRASH_EXPECTS(sheet.has_value(), sheet.error().what);
  // The line far enough on both sides to leave a window around the floe.
  exact::Box box = exact::box_of(floe.outline);
  const exact::Box window = box.grown(1024);
  box.add(from);
  box.add(to);
  const double reach = 2.0 * norm(metres(box.high) - metres(box.low)) + 1.0;
  const Vec2 along = normalized(metres(to - from));
  const auto moved = [](Point p, Vec2 by) {
    return p + Point::of_units(std::llround(by.x / kGridUnit), std::llround(by.y / kGridUnit));
  };
  const Point before = moved(from, -reach * along);
  const Point after = moved(to, reach * along);
  const Crack cracks[] = {{before, from}, {from, to}, {to, after}};
  const Ring around{window.low, Point::of_units(window.high.x, window.low.y), window.high,
                    Point::of_units(window.low.x, window.high.y)};
  const ExactArea laid_down = sheet->area();
  Cut cut = sheet->cut(around, cracks);
  // A floe whose vertices come within a pixel of its own edges has been rounded on its way in.
  cut.snap += area(floe) - laid_down;
  return cut;
}

}  // namespace brash::geometry
