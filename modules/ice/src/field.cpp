// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/ice/field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include "brash/core/contract.hpp"
#include "laid_ice.hpp"

namespace brash::ice {
namespace {

/// A region that holds all of a plate reaches this far beyond it [m].
constexpr double kBeyond = 1.0;
/// A crack begins this far outside the ice [m].
constexpr double kOutside = 1e-3;

/// The way from a point to the end of the plane of the ice [m].
double to_end_of_plane(Vec2 from, Vec2 towards) {
  const auto along = [](double start, double slope) {
    if (slope == 0.0) return geometry::Extent::kFar;
    return (std::copysign(geometry::kMaxCoordinate - kOutside, slope) - start) / slope;
  };
  return std::min(along(from.x, towards.x), along(from.y, towards.y));
}

LaidIce laid(const model::FieldSection& section, const failure::IceProperties& ice, const Variation& variation) {
  return model::has_level_ice(section) ? lay_ice(section, ice, variation) : LaidIce{};
}

/// A plate for each sheet, and an empty one where there is none.
std::vector<Plate> plates_of(std::vector<geometry::Polygon> sheets, model::Border border,
                             const failure::IceProperties& ice) {
  const Hold hold = border == model::Border::kFree ? Hold::kDrifting : Hold::kFast;
  std::vector<Plate> plates;
  for (geometry::Polygon& sheet : sheets)
    plates.emplace_back(static_cast<int>(plates.size()), hold, ice, std::vector{std::move(sheet)});
  if (plates.empty()) plates.emplace_back(0, hold, ice, std::vector<geometry::Polygon>{});
  return plates;
}

geometry::ExactArea total(std::span<const geometry::Polygon> polygons) {
  geometry::ExactArea sum;
  for (const geometry::Polygon& polygon : polygons) sum += geometry::area(polygon);
  return sum;
}

geometry::ExactArea total(std::span<const Plate> plates) {
  geometry::ExactArea sum;
  for (const Plate& plate : plates) sum += plate.sheet().area();
  return sum;
}

bool has_table(const model::Checkpoint& checkpoint, std::string_view name) {
  return std::ranges::any_of(checkpoint.tables, [&](const model::Table& table) { return table.name == name; });
}

/// The ledger's members, for a checkpoint.
struct Accounts {
  geometry::Ledger ledger;

  template <typename Self, typename Visit>
  static void visit(Self& self, Visit&& visit) {
    auto& ledger = self.ledger;
    visit("initial", "1", "twice the area at the start, squared grid units", ledger.initial);
    visit("sheet", "1", "the same of the sheet", ledger.sheet);
    visit("floes", "1", "the same of the floes", ledger.floes);
    visit("crushed", "1", "the same, crushed by the structure", ledger.crushed);
    visit("deleted", "1", "the same of deleted floes", ledger.deleted);
    visit("brash", "1", "the same of pieces without a body", ledger.brash);
    visit("snap", "1", "the same, moved by rounding to the grid", ledger.snap);
    visit("n_rounded", "1", "vertices that rounding made or led an edge to", ledger.n_rounded);
  }
};

}  // namespace

Field::Field(const model::FieldSection& section, const failure::IceProperties& ice, Variation variation)
    : section_(section), variation_(std::move(variation)) {
  LaidIce start = laid(section, ice, variation_);
  land_ = std::move(start.land);
  level_ice_ = plates_of(std::move(start.sheets), section.border, ice);
  for (GivenFloe& floe : start.floes) {
    failure::IceProperties own = variation_.mean(ice, floe.outline);
    own.thickness = floe.thickness.value_or(own.thickness);
    own.flexural_strength = floe.flexural_strength.value_or(own.flexural_strength);
    loose_.emplace_back(0, Hold::kAfloat, own, std::vector{std::move(floe.outline)});
  }
  ledger_.initial = ledger_.sheet = total(level_ice_);
}

Field::Field(const model::FieldSection& section, const failure::IceProperties& ice, Variation variation,
             const model::Checkpoint& checkpoint)
    : section_(section), variation_(std::move(variation)) {
  LaidIce start = laid(section, ice, variation_);
  land_ = std::move(start.land);
  level_ice_ = plates_of(std::move(start.sheets), section.border, ice);
  // Sheets that drift have split off others; some are no more, and have no outline.
  const bool drifts = has_table(checkpoint, "drift");
  std::vector<std::vector<geometry::Polygon>> outlines(drifts ? checkpoint.table("drift").n_rows() : level_ice_.size());
  std::vector<failure::IceProperties> of_each(outlines.size(), level_ice_.front().ice());
  const model::Table& table = checkpoint.table("level_ice");
  for (std::size_t i = 0; i < table.n_rows(); ++i) {
    PlatePart part;
    model::RestoredRow row(table, i);
    PlatePart::visit(part, row);
    const auto number = static_cast<std::size_t>(part.level_ice);
    outlines.at(number).push_back(std::move(part.outline));
    of_each[number].thickness = part.thickness;
    of_each[number].flexural_strength = part.flexural_strength;
  }
  const Hold hold = drifts ? Hold::kDrifting : level_ice_.front().hold();
  level_ice_.clear();
  for (std::size_t i = 0; i < outlines.size(); ++i)
    level_ice_.emplace_back(static_cast<int>(i), hold, of_each[i], std::move(outlines[i]));
  Accounts accounts;
  model::restore(checkpoint, "ledger", accounts);
  ledger_ = accounts.ledger;
  BRASH_EXPECTS(ledger_.closes() && ledger_.sheet == total(level_ice_), ledger_.missing().to_string());
}

void Field::save(model::Checkpoint& checkpoint) const {
  model::Table table{"level_ice", {}};
  for (const Plate& plate : level_ice_) {
    for (geometry::Polygon& polygon : plate.outline()) {
      const PlatePart part{plate.level_ice(), plate.ice().thickness, plate.ice().flexural_strength, std::move(polygon)};
      model::SavedRow row(table);
      PlatePart::visit(part, row);
    }
  }
  checkpoint.tables.push_back(std::move(table));
  model::save(checkpoint, "ledger", Accounts{ledger_});
}

std::vector<geometry::Polygon> Field::outlines() const {
  std::vector<geometry::Polygon> all;
  for (const Plate& plate : level_ice_) std::ranges::move(plate.outline(), std::back_inserter(all));
  return all;
}

/// Books the loss of a plate of whose sheet `take` cuts; where the pieces go is still to be booked.
template <typename Take>
geometry::Cut Field::booked(Plate& plate, Take take) {
  const geometry::ExactArea before = plate.area();
  const geometry::ExactArea laid = plate.sheet().area();  // vertices near another edge are rounded on their way in
  geometry::Cut cut = take(plate.sheet());
  account_of(plate) += plate.area() - before;
  ledger_.snap += before - laid + cut.snap;
  ledger_.n_rounded += cut.n_rounded;
  return cut;
}

geometry::Cut Field::cut(Plate& plate, std::span<const geometry::Point> region,
                         std::span<const geometry::Crack> cracks) {
  return booked(plate, [&](geometry::IceSheet& sheet) { return sheet.cut(region, cracks); });
}

geometry::ExactArea& Field::account_of(const Plate& plate) {
  return plate.hold() == Hold::kAfloat ? ledger_.floes : ledger_.sheet;
}

geometry::Extent Field::crush(Plate& plate, std::span<const geometry::Point> section) {
  const geometry::Cut crushed = booked(plate, [&](geometry::IceSheet& sheet) { return sheet.crush(section); });
  ledger_.crushed += total(crushed.pieces);
  return crushed.changed;
}

/// Takes parts that have lost their connection out of a plate; where they go is still to be booked.
std::vector<geometry::Polygon> Field::take_severed(Plate& plate, Broken& result) {
  const auto is_loose = [this](const geometry::Polygon& part) { return !is_held(part, section_, land_); };
  std::vector<geometry::Polygon> severed =
      plate.hold() == Hold::kFast ? plate.sheet().release_if(is_loose) : plate.sheet().release_detached();
  for (const geometry::Polygon& part : severed) {
    account_of(plate) -= geometry::area(part);
    result.severed.push_back(geometry::extent(part));
    result.changed.add(result.severed.back());
  }
  return severed;
}

/// The part of a piece outside `structure`; the rest is crushed.
std::vector<geometry::Polygon> Field::carve(Plate piece, std::span<const geometry::Ring> structure) {
  for (const geometry::Ring& outline : structure) {
    const geometry::Cut crushed = piece.sheet().cut(outline);
    ledger_.crushed += total(crushed.pieces);
    ledger_.snap += crushed.snap;
    ledger_.n_rounded += crushed.n_rounded;
  }
  return piece.outline();
}

/// A part of `plate` becomes a floe, or brash where it is small. Level ice varies; a floe is a prism of even ice.
void Field::book_piece(const Plate& plate, geometry::Polygon part, double smallest_floe, std::vector<Plate>& pieces) {
  const geometry::ExactArea area = geometry::area(part);
  if (area.square_metres() < smallest_floe) {
    ledger_.brash += area;
  } else {
    ledger_.floes += area;
    const failure::IceProperties ice = plate.hold() == Hold::kAfloat ? plate.ice() : variation_.mean(plate.ice(), part);
    pieces.push_back(plate.piece(std::move(part), ice));
  }
}

/// Books the parts of pieces outside `structure`.
std::vector<Plate> Field::book_pieces(const Plate& plate, std::span<const geometry::Polygon> whole,
                                      std::span<const geometry::Ring> structure, double smallest_floe) {
  std::vector<Plate> pieces;
  for (const geometry::Polygon& piece : whole) {
    for (geometry::Polygon& carved : carve(plate.piece(piece), structure))
      book_piece(plate, std::move(carved), smallest_floe, pieces);
  }
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return pieces;
}

Broken Field::release_severed(Plate& plate, std::span<const geometry::Ring> structure, double smallest_floe) {
  Broken result;
  const std::vector<geometry::Polygon> severed = take_severed(plate, result);
  result.pieces = book_pieces(plate, severed, structure, smallest_floe);
  return result;
}

Broken Field::break_off(Plate& plate, const CrackPlan& plan, std::span<const geometry::Ring> structure,
                        double smallest_floe) {
  geometry::Cut broken = cut(plate, plan.cracked.region, plan.cracked.cracks);
  Broken result{.pieces = {}, .changed = broken.changed, .severed = {}};
  std::ranges::move(take_severed(plate, result), std::back_inserter(broken.pieces));
  result.pieces = book_pieces(plate, broken.pieces, structure, smallest_floe);
  return result;
}

std::vector<Plate> Field::split(const Plate& floe, Vec2 from, Vec2 to, double smallest_floe) {
  const std::vector<geometry::Polygon> outline = floe.outline();
  BRASH_EXPECTS(floe.hold() == Hold::kAfloat && outline.size() == 1, outline.size());
  const geometry::Cut parts = geometry::split(outline.front(), geometry::snap(from), geometry::snap(to));
  ledger_.floes -= floe.area();
  ledger_.snap += parts.snap;
  ledger_.n_rounded += parts.n_rounded;
  std::vector<Plate> pieces;
  for (const geometry::Polygon& part : parts.pieces) book_piece(floe, part, smallest_floe, pieces);
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return pieces;
}

void Field::lay_floes(std::vector<Plate> plates, std::vector<Plate> floes) {
  BRASH_EXPECTS(ledger_.initial == geometry::ExactArea{} && loose_.empty(), loose_.size());
  for (std::size_t i = 0; i < plates.size(); ++i)
    BRASH_EXPECTS(plates[i].hold() == Hold::kDrifting && plates[i].level_ice() == static_cast<int>(i), i);
  if (!plates.empty()) level_ice_ = std::move(plates);
  loose_ = std::move(floes);
  ledger_.initial = ledger_.sheet = total(level_ice_);
}

void Field::add_floe(const Plate& floe) {
  ledger_.initial += floe.area();
  ledger_.floes += floe.area();
}

Broken Field::split_sheet(Plate& plate, Vec2 from, Vec2 towards, double smallest_floe) {
  BRASH_EXPECTS(plate.hold() == Hold::kDrifting, plate.level_ice());
  geometry::Extent extent;
  for (const geometry::Polygon& polygon : plate.outline()) extent.add(geometry::extent(polygon));
  Broken result;
  if (extent.is_empty()) return result;
  const Vec2 beyond{kBeyond, kBeyond}, lower = extent.lower - beyond, upper = extent.upper + beyond;
  const std::array<Vec2, 4> corners{lower, Vec2{upper.x, lower.y}, upper, Vec2{lower.x, upper.y}};
  const double length = std::min(norm(upper - lower), to_end_of_plane(from, towards));
  const geometry::Crack crack{geometry::snap(from - kOutside * towards), geometry::snap(from + length * towards)};
  geometry::Cut parts = cut(plate, geometry::ring(corners), std::array{crack});
  const auto largest =
      std::ranges::max_element(parts.pieces, {}, [](const geometry::Polygon& p) { return geometry::area(p); });
  std::iter_swap(parts.pieces.begin(), largest);
  lay(plate, std::move(parts.pieces.front()));
  for (std::size_t i = 1; i < parts.pieces.size(); ++i)
    book_piece(plate, std::move(parts.pieces[i]), smallest_floe, result.pieces);
  if (parts.pieces.size() > 1) result.changed = extent;
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return result;
}

/// Gives level ice a new outline, and books it as a sheet.
void Field::lay(Plate& plate, geometry::Polygon outline) {
  const geometry::ExactArea area = geometry::area(outline);
  plate = Plate(plate.level_ice(), plate.hold(), plate.ice(), {std::move(outline)});
  ledger_.sheet += plate.sheet().area();  // vertices near another edge are rounded on their way in
  ledger_.snap += area - plate.area();
}

int Field::add_level_ice(Plate&& piece) {
  const int number = static_cast<int>(level_ice_.size());
  ledger_.floes -= piece.area();
  // The variation of the ice is about the mean of all of it.
  const failure::IceProperties ice = level_ice_[static_cast<std::size_t>(piece.level_ice())].ice();
  level_ice_.emplace_back(number, Hold::kDrifting, ice, std::vector<geometry::Polygon>{});
  lay(level_ice_.back(), piece.outline().front());
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return number;
}

std::vector<Plate> Field::release(Plate& plate, double smallest_floe) {
  std::vector<Plate> pieces;
  ledger_.sheet -= plate.area();
  const std::vector<geometry::Polygon> outlines = plate.outline();
  for (const geometry::Polygon& outline : outlines) book_piece(plate, outline, smallest_floe, pieces);
  plate = Plate(plate.level_ice(), plate.hold(), plate.ice(), {});
  BRASH_EXPECTS(ledger_.closes(), ledger_.missing().to_string());
  return pieces;
}

void Field::to_brash(const Plate& piece) {
  ledger_.floes -= piece.area();
  ledger_.brash += piece.area();
}

void Field::to_deleted(const Plate& floe) {
  ledger_.floes -= floe.area();
  ledger_.deleted += floe.area();
}

}  // namespace brash::ice
