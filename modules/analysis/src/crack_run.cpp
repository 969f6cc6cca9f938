// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/analysis/crack_run.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "brash/geometry/lines.hpp"

namespace brash::analysis {
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
  std::set<std::int64_t> taken;  // the members of a multi-part feature share an id
  for (Feature& floe : floes_)
    if (!taken.insert(floe.id).second) floe.id = next_id_++;
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
    result.push_back({std::move(part), "sheet", next_id_ + static_cast<std::int64_t>(result.size())});
  result.insert(result.end(), floes_.begin(), floes_.end());
  return result;
}

std::vector<Crack> CrackRun::seams() const {
  std::vector<Crack> edges;
  std::size_t n_parts = 0;
  for (const Polygon& polygon : given_) {
    for (const Polygon& part : geometry::checked_sheet({&polygon, 1}).polygons()) {
      ++n_parts;
      geometry::visit_edges(part, [&](geometry::Point from, geometry::Point to) { edges.push_back({from, to}); });
    }
  }
  if (sheet_.n_parts() == n_parts) edges.clear();
  return edges;
}

void CrackRun::split_floes(std::span<const Crack> cracks) {
  for (const Feature& floe : std::exchange(floes_, {})) {
    IceSheet ice = geometry::checked_sheet({&floe.polygon, 1});
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
  std::vector<IceSheet> each;
  boxes.reserve(features.size());
  each.reserve(features.size());
  for (const Feature& f : features) {
    boxes.push_back(geometry::extent(f.polygon));
    each.push_back(geometry::checked_sheet({&f.polygon, 1}));
  }
  const auto is_in_ice = [&](const Crack& crack) {
    const Vec2 a = geometry::metres(crack.from), b = geometry::metres(crack.to);
    for (std::size_t i = 0; i < features.size(); ++i)
      if (!geometry::are_apart(boxes[i], a, b) && geometry::tail_in(features[i].polygon, each[i], a, b)) return true;
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

}  // namespace brash::analysis
