// SPDX-License-Identifier: GPL-3.0-or-later
#include "laid_ice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "brash/core/interruption.hpp"

namespace brash::ice {
namespace {

using geometry::IceSheet;
using geometry::Point;
using geometry::Polygon;
using geometry::Ring;

/// Parts that lie closer than this touch [m].
constexpr double kTouch = 1e-6;
/// A region that holds all of the ice reaches this far beyond it [m].
constexpr double kBeyond = 1.0;

Polygon rectangle(double length, double width, const Variation& variation) {
  std::vector<Vec2> corners = variation.first_edge(width);
  std::rotate(corners.begin(), corners.end() - 1, corners.end());
  corners.insert(corners.begin() + 1, {Vec2{length, -0.5 * width}, Vec2{length, 0.5 * width}});
  return {geometry::ring(corners), {}};
}

IceSheet sheet_of(std::span<const Polygon> polygons) {
  auto sheet = IceSheet::from_polygons(polygons);
  BRASH_EXPECTS(sheet.has_value(), sheet.has_value() ? "" : sheet.error().what);
  return std::move(*sheet);
}

/// One sheet of all polygons, or one of each where some touch along an edge: that edge is a crack, and one sheet would
/// close it.
std::vector<IceSheet> sheets_of(std::span<const Polygon> polygons) {
  std::vector<IceSheet> each;
  std::size_t n_parts = 0;  // more than polygons, where a polygon touches itself in a vertex
  for (const Polygon& polygon : polygons) {
    each.push_back(sheet_of(std::span(&polygon, 1)));
    n_parts += each.back().n_parts();
  }
  std::vector<IceSheet> one;
  one.push_back(sheet_of(polygons));
  return one.front().n_parts() < n_parts ? std::move(each) : std::move(one);
}

/// The outlines of the case, and the floes that lie in their openings.
GivenLevelIce given_ice(const model::FieldSection& field, const Variation& variation) {
  if (!field.file.empty()) return read_level_ice(field.file, field);
  return {{rectangle(field.length, field.width, variation)}, {}};
}

/// Whether an edge of a part lies along a side or the far end of the rectangle.
bool has_edge_on_border(const Polygon& part, const model::FieldSection& field) {
  const Point corner = geometry::snap({field.length, 0.5 * field.width});
  const Point other = geometry::snap({0.0, -0.5 * field.width});
  const Ring& ring = part.outline;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const bool at_end = a.x == corner.x && b.x == corner.x;
    const bool at_side = a.y == b.y && (a.y == corner.y || a.y == other.y);
    if (at_end || at_side) return true;
  }
  return false;
}

/// As model::FieldSection::smallest_plate has it; docs/theory/fracture-of-floes.md.
double breadth(const Polygon& part) {
  const auto [lower, upper] = geometry::extent(part);
  return geometry::area(part).square_metres() / std::max(upper.x - lower.x, upper.y - lower.y);
}

/// The names of the files that a complaint about the laid ice goes to.
std::string files_of(const model::FieldSection& field) {
  std::string names;
  for (const std::string* file : {&field.file, &field.shore, &field.openings, &field.cracks})
    if (!file->empty()) names += (names.empty() ? "" : " with ") + *file;
  return names.empty() ? "field" : names;
}

/// Whether land lies along a part: a corner of one lies on an edge of the other.
bool touches(const Polygon& part, const Polygon& land) {
  const auto has_corner_on = [](const Polygon& one, const Polygon& other) {
    const Vec2 near{kTouch, kTouch};
    const auto [lower, upper] = geometry::extent(other);
    const geometry::Extent box{lower - near, upper + near};
    bool has = false;
    visit_edges(one, [&](Point from, Point) {
      const Vec2 corner = geometry::metres(from);
      has = has || (!are_apart(box, corner, corner) && distance_to_edges(other, corner) < kTouch);
    });
    return has;
  };
  return has_corner_on(part, land) || has_corner_on(land, part);
}

geometry::ExactArea total(std::span<const Polygon> polygons) {
  geometry::ExactArea sum;
  for (const Polygon& polygon : polygons) sum += geometry::area(polygon);
  return sum;
}

geometry::Extent extent_of(std::span<const Polygon> polygons) {
  geometry::Extent box;
  for (const Polygon& polygon : polygons) box.add(geometry::extent(polygon));
  return box;
}

/// Whether land lies along a part.
bool holds_any(std::span<const Polygon> land, std::span<const Polygon> parts) {
  return std::ranges::any_of(parts, [&](const Polygon& part) {
    return std::ranges::any_of(land, [&](const Polygon& one) { return touches(part, one); });
  });
}

void sort_held(std::vector<Polygon> parts, std::span<const Polygon> land, const model::FieldSection& field,
               LaidIce& laid) {
  for (Polygon& part : parts) {
    if (is_held(part, field, land))
      laid.sheets.push_back(std::move(part));
    else
      laid.floes.push_back({std::move(part), {}, {}});
  }
  if (!laid.sheets.empty()) return;
  throw InputError(Complaint{files_of(field), "leaves no ice that the borders hold",
                             fmt::format("level ice with an edge along y = +-field.width/2 = {} m, x = field.length "
                                         "= {} m or the shore, where land holds it",
                                         0.5 * field.width, field.length),
                             "let the ice reach a border, or write field.border = \"free\""});
}

void sort_drifting(std::vector<Polygon> parts, const model::FieldSection& field, const failure::IceProperties& ice,
                   LaidIce& laid) {
  if (parts.empty())
    throw InputError(Complaint{files_of(field), "leaves no ice", "level ice beside the openings",
                               "take less ice away, or write field.kind = \"floes\""});
  std::ranges::stable_sort(parts,
                           [](const Polygon& a, const Polygon& b) { return geometry::area(b) < geometry::area(a); });
  const double least = field.smallest_plate * failure::characteristic_length(ice);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (i == 0 || breadth(parts[i]) >= least)
      laid.sheets.push_back(std::move(parts[i]));
    else
      laid.floes.push_back({std::move(parts[i]), {}, {}});
  }
}

/// No floe of a file lies on land.
void expect_afloat(std::span<const GivenFloe> floes, std::span<const Polygon> land, const std::string& file) {
  for (const GivenFloe& floe : floes) {
    look_for_interruption();
    const IceSheet ice = sheet_of(std::span(&floe.outline, 1));
    for (const Polygon& outline : land)
      for (const Ring& part : geometry::convex_parts(outline))
        if (const std::vector<Polygon> on_land = ice.within(part); !on_land.empty()) {
          const Vec2 at = geometry::centroid(on_land.front());
          throw InputError(Complaint{file, fmt::format("has a floe on land, at ({:.6g}, {:.6g}) m", at.x, at.y),
                                     "floes beside the land of field.shore", "move or cut the floe, or the shore"});
        }
  }
}

void expect_no_tails(const std::vector<geometry::Tail>& tails, const std::string& file) {
  if (tails.empty()) return;
  const geometry::Tail& tail = tails.front();
  throw InputError(Complaint{
      file,
      fmt::format("has a line that ends inside the ice, at ({:.6g}, {:.6g}) m: over {:.3g} m it parts nothing{}",
                  tail.to.x, tail.to.y, norm(tail.to - tail.from),
                  tails.size() > 1 ? fmt::format(" (and {} more like it)", tails.size() - 1) : ""),
      "lines that cut the ice through, to an edge, an opening or another line",
      "lead the line on to an edge, end it where it meets another line, or draw it as a narrow polygon in "
      "field.openings"});
}

/// The ice without polygons, which are idle where they take less than a square as wide as the ice is thick.
std::vector<Polygon> without(std::span<const Polygon> ice, std::span<const Polygon> polygons, const char* key,
                             double thickness, std::vector<IdleFile>& idle) {
  std::vector<Polygon> rest = with_openings(ice, polygons);
  const double taken = (total(ice) - total(rest)).square_metres();
  if (taken < thickness * thickness) idle.push_back({key, taken, extent_of(polygons), extent_of(ice)});
  return rest;
}

std::size_t n_holes(std::span<const Polygon> polygons) {
  std::size_t n = 0;
  for (const Polygon& polygon : polygons) n += polygon.holes.size();
  return n;
}

/// The ice parted by field.cracks. Lines that leave as many parts and holes are idle.
std::vector<Polygon> with_cracks(std::span<const Polygon> ice, const model::FieldSection& field,
                                 std::vector<IdleFile>& idle) {
  const std::vector<geometry::Crack> lines = read_cracks(field.cracks, field.origin);
  Parted cut = parted_by(geometry::beyond_free_ends(lines), ice);
  expect_no_tails(cut.tails, field.cracks);
  if (cut.parts.size() == ice.size() && n_holes(cut.parts) == n_holes(ice)) {
    geometry::Extent reach;
    for (const geometry::Crack& line : lines)
      for (const Point end : {line.from, line.to}) reach.add(geometry::metres(end));
    idle.push_back({"cracks", 0.0, reach, extent_of(ice)});
  }
  return std::move(cut.parts);
}

}  // namespace

bool is_held(const Polygon& part, const model::FieldSection& field, std::span<const Polygon> land) {
  return has_edge_on_border(part, field) ||
         std::ranges::any_of(land, [&](const Polygon& one) { return touches(part, one); });
}

std::vector<Polygon> with_openings(std::span<const Polygon> ice, std::span<const Polygon> openings) {
  std::vector<IceSheet> sheets = sheets_of(ice);
  for (const Polygon& opening : openings) {
    std::vector<IceSheet> islands;
    for (IceSheet& sheet : sheets) {
      const std::vector<Polygon> inside = sheet.cut(opening.outline).pieces;
      if (inside.empty() || opening.holes.empty()) continue;
      IceSheet whole = sheet_of(inside);
      for (Ring hole : opening.holes) {
        std::ranges::reverse(hole);
        if (const auto kept = whole.cut(hole).pieces; !kept.empty()) islands.push_back(sheet_of(kept));
      }
    }
    std::ranges::move(islands, std::back_inserter(sheets));
  }
  std::vector<Polygon> parts;
  for (const IceSheet& sheet : sheets) std::ranges::move(sheet.polygons(), std::back_inserter(parts));
  return parts;
}

Parted parted_by(std::span<const geometry::Crack> lines, std::span<const Polygon> ice) {
  const geometry::Extent box = extent_of(ice);
  if (box.is_empty()) return {};
  const Vec2 beyond{kBeyond, kBeyond}, lower = box.lower - beyond, upper = box.upper + beyond;
  const std::array<Vec2, 4> corners{lower, Vec2{upper.x, lower.y}, upper, Vec2{lower.x, upper.y}};
  Parted parted;
  for (IceSheet& sheet : sheets_of(ice))
    std::ranges::move(sheet.cut(geometry::ring(corners), lines).pieces, std::back_inserter(parted.parts));
  std::vector<geometry::Extent> boxes;
  std::vector<IceSheet> sheets;
  for (const Polygon& part : parted.parts) {
    boxes.push_back(geometry::extent(part));
    sheets.push_back(sheet_of(std::span(&part, 1)));
  }
  for (const geometry::Crack& line : lines) {
    const Vec2 a = geometry::metres(line.from), b = geometry::metres(line.to);
    for (std::size_t i = 0; i < parted.parts.size(); ++i) {
      if (geometry::are_apart(boxes[i], a, b)) continue;
      if (const auto tail = geometry::tail_in(parted.parts[i], sheets[i], a, b)) parted.tails.push_back(*tail);
    }
  }
  return parted;
}

LaidIce lay_ice(const model::FieldSection& field, const failure::IceProperties& ice, const Variation& variation) {
  GivenLevelIce given = given_ice(field, variation);
  if (!model::has_ice_files(field)) return {std::move(given.sheets), {}, {}, {}};
  LaidIce laid;
  std::vector<Polygon> parts = std::move(given.sheets);
  std::vector<Polygon> land;
  if (!field.shore.empty()) {
    land = read_outlines(field.shore, field.origin);
    parts = without(parts, land, "shore", ice.thickness, laid.idle);
    if (!laid.idle.empty() && holds_any(land, parts)) laid.idle.clear();
    expect_afloat(given.floes, land, field.file);
  }
  if (!field.openings.empty())
    parts = without(parts, read_openings(field.openings, field.origin), "openings", ice.thickness, laid.idle);
  if (!field.cracks.empty()) parts = with_cracks(parts, field, laid.idle);
  if (field.border == model::Border::kFixed)
    sort_held(std::move(parts), land, field, laid);
  else
    sort_drifting(std::move(parts), field, ice, laid);
  std::ranges::move(given.floes, std::back_inserter(laid.floes));
  laid.land = std::move(land);
  return laid;
}

std::vector<IdleFile> idle_files(const model::FieldSection& field, const failure::IceProperties& ice) {
  return model::has_ice_files(field) ? lay_ice(field, ice, {}).idle : std::vector<IdleFile>{};
}

}  // namespace brash::ice
