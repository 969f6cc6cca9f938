// SPDX-License-Identifier: GPL-3.0-or-later
#include "ice_field.hpp"

#include <algorithm>
#include <array>

#include "brash/core/contract.hpp"

namespace brash::simulation {
namespace {

geometry::IceSheet lay(std::span<const geometry::Polygon> polygons) {
  auto sheet = geometry::IceSheet::from_polygons(polygons);
  BRASH_EXPECTS(sheet.has_value(), sheet.has_value() ? "" : sheet.error().what);
  return std::move(*sheet);
}

geometry::IceSheet rectangle(double length, double width) {
  const std::array<Vec2, 4> corners{Vec2{0.0, -0.5 * width}, Vec2{length, -0.5 * width}, Vec2{length, 0.5 * width},
                                    Vec2{0.0, 0.5 * width}};
  const geometry::Polygon polygon{geometry::ring(corners), {}};
  return lay(std::span(&polygon, 1));
}

geometry::ExactArea total(std::span<const geometry::Polygon> polygons) {
  geometry::ExactArea sum;
  for (const geometry::Polygon& polygon : polygons) sum += geometry::area(polygon);
  return sum;
}

/// A polygon of the sheet.
struct SheetPart {
  geometry::Polygon outline;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    visit("outline", "1", "polygons of the ice sheet, sheet frame", self.outline);
  }
};

/// The ledger's members, for a checkpoint.
struct Accounts {
  geometry::Ledger ledger;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    auto& ledger = self.ledger;
    visit("initial", "1", "twice the area at the start, squared grid units", ledger.initial);
    visit("sheet", "1", "likewise of the sheet", ledger.sheet);
    visit("floes", "1", "likewise of the floes", ledger.floes);
    visit("crushed", "1", "likewise crushed by the structure", ledger.crushed);
    visit("deleted", "1", "likewise of deleted floes", ledger.deleted);
    visit("brash", "1", "likewise of pieces without a body", ledger.brash);
    visit("snap", "1", "likewise moved by rounding to the grid", ledger.snap);
    visit("n_rounded", "1", "crossings rounded to the grid", ledger.n_rounded);
  }
};

std::vector<geometry::Polygon> saved_sheet(const model::Checkpoint& checkpoint) {
  const model::Table& table = checkpoint.table("sheet");
  std::vector<geometry::Polygon> polygons;
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    SheetPart part;
    model::RestoredRow row(table, i);
    SheetPart::visit(part, row);
    polygons.push_back(std::move(part.outline));
  }
  return polygons;
}

geometry::Ledger saved_ledger(const model::Checkpoint& checkpoint) {
  Accounts accounts;
  model::restore(checkpoint, "ledger", accounts);
  return accounts.ledger;
}

}  // namespace

IceField::IceField(const model::Checkpoint& checkpoint) : IceField(saved_sheet(checkpoint), saved_ledger(checkpoint)) {}

void IceField::save(model::Checkpoint& checkpoint) const {
  model::Table table{"sheet", {}};
  for (geometry::Polygon& polygon : sheet_.polygons()) {
    const SheetPart part{std::move(polygon)};
    model::SavedRow row(table);
    SheetPart::visit(part, row);
  }
  checkpoint.tables.push_back(std::move(table));
  model::save(checkpoint, "ledger", Accounts{ledger_});
}

IceField::IceField(double length, double width) : sheet_(rectangle(length, width)) {
  ledger_.initial = ledger_.sheet = sheet_.area();
}

IceField::IceField(std::span<const geometry::Polygon> sheet, const geometry::Ledger& ledger)
    : sheet_(lay(sheet)), ledger_(ledger) {
  BRASH_EXPECTS(ledger_.closes() && ledger_.sheet == sheet_.area(), ledger_.missing().to_string());
}

void IceField::book_cut(const geometry::Cut& cut) {
  ledger_.sheet = sheet_.area();
  ledger_.snap += cut.snap;
  ledger_.n_rounded += cut.n_rounded;
}

geometry::Extent IceField::crush(std::span<const geometry::Point> section) {
  const geometry::Cut cut = sheet_.cut(section);
  ledger_.crushed += total(cut.pieces);
  book_cut(cut);
  return cut.changed;
}

std::vector<geometry::Polygon> IceField::carve(const geometry::Polygon& piece,
                                               std::span<const geometry::Point> section) {
  geometry::IceSheet ice = lay(std::span(&piece, 1));
  const geometry::Cut cut = ice.cut(section);
  ledger_.crushed += total(cut.pieces);
  ledger_.snap += cut.snap;
  ledger_.n_rounded += cut.n_rounded;
  return ice.polygons();
}

Broken IceField::break_free(Vec2 centre, double radius, int n_wedges, int sides,
                            std::span<const geometry::Point> section, double smallest_floe) {
  geometry::Cut cut = geometry::cut_circumferential(sheet_, centre, radius, n_wedges, sides);
  std::vector<geometry::Polygon> broken = std::move(cut.pieces);
  Broken result{.floes = {}, .changed = cut.changed};
  for (geometry::Polygon& detached : sheet_.release_detached()) {
    result.changed.add(geometry::extent(detached));
    broken.push_back(std::move(detached));
  }
  book_cut(cut);

  for (const geometry::Polygon& piece : broken) {
    for (geometry::Polygon& floe : carve(piece, section)) {
      const geometry::ExactArea area = geometry::area(floe);
      if (area.square_metres() < smallest_floe) {
        ledger_.brash += area;
      } else {
        ledger_.floes += area;
        result.floes.push_back(std::move(floe));
      }
    }
  }
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return result;
}

void IceField::floe_to_brash(geometry::ExactArea area) {
  ledger_.floes -= area;
  ledger_.brash += area;
}

void IceField::floe_to_deleted(geometry::ExactArea area) {
  ledger_.floes -= area;
  ledger_.deleted += area;
}

}  // namespace brash::simulation
