// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "brash/geometry/ledger.hpp"
#include "brash/ice/crack_pattern.hpp"
#include "brash/ice/plate.hpp"
#include "brash/ice/variation.hpp"
#include "brash/model/checkpoint.hpp"

namespace brash::ice {

/// The result of a break.
struct Broken {
  std::vector<Plate> pieces;
  geometry::Extent changed;               ///< around all of the plate that is not as before
  std::vector<geometry::Extent> severed;  ///< around each part of it that lost its hold beyond the cut
};

/// The level ice, and the ledger of all ice: every operation moves area from one account to another, exactly.
class Field {
 public:
  /// Level ice as the case lays it, all of `ice`: a rectangle, x from 0 to `length`, |y| <= width/2 [m], or the ice of
  /// files, in one sheet or several. A field of floes has none before lay_floes().
  /// @param variation  of its thickness and strength. A piece that breaks off has the means over itself, and is even.
  /// @throws InputError naming file and place, where a file of the ice is at fault.
  Field(const model::FieldSection& section, const failure::IceProperties& ice, Variation variation = {});
  /// The field of a run that continues from a checkpoint.
  Field(const model::FieldSection& section, const failure::IceProperties& ice, Variation variation,
        const model::Checkpoint& checkpoint);
  void save(model::Checkpoint& checkpoint) const;

  /// Lays a field of floes: `plates` are level ice that drifts, each in the place of its number, and `floes` lie
  /// beside it. There is no ice yet.
  void lay_floes(std::vector<Plate> plates, std::vector<Plate> floes);

  /// Takes the floes beside the level ice: of its files, parts of it that nothing holds, or of a field of floes. They
  /// are not booked yet.
  std::vector<Plate> take_loose() { return std::exchange(loose_, {}); }

  /// The level ice, each in the place of its number.
  std::span<const Plate> level_ice() const { return level_ice_; }
  Plate& level_ice(int number) { return level_ice_[static_cast<std::size_t>(number)]; }
  const geometry::Ledger& ledger() const { return ledger_; }
  const Variation& variation() const { return variation_; }
  std::vector<geometry::Polygon> outlines() const;  ///< of the level ice

  /// Ice of `plate` inside `section` is crushed and leaves. @return around all of it that is not as before.
  geometry::Extent crush(Plate& plate, std::span<const geometry::Point> section);

  /// Releases the parts of `plate` that have lost their connection: of level ice with fixed borders the parts that no
  /// border holds, of other ice all but the largest. Costs nothing while the plate hangs together.
  ///
  /// @param structure, smallest_floe  as of break_off().
  /// @return the pieces.
  Broken release_severed(Plate& plate, std::span<const geometry::Ring> structure, double smallest_floe);

  /// Breaks ice off `plate` and splits it. The parts of the pieces under `structure` are crushed and leave.
  ///
  /// @param structure      the structure's section at mid-thickness: no piece is born inside it.
  /// @param smallest_floe  pieces below this area become brash [m2].
  /// @return the pieces, and the parts of the plate that lost their connection.
  Broken break_off(Plate& plate, const CrackPlan& plan, std::span<const geometry::Ring> structure,
                   double smallest_floe);

  /// Splits `floe` along the straight line through two points of its frame [m], and books the parts.
  ///
  /// @param smallest_floe  as of break_off().
  /// @return the parts that are left.
  std::vector<Plate> split(const Plate& floe, Vec2 from, Vec2 to, double smallest_floe);

  /// Books a floe that is there from the start.
  void add_floe(const Plate& floe);

  /// Splits drifting level ice along a straight crack from a place on its edge to the far border.
  ///
  /// @param from, towards  of the crack, frame of the ice; a unit vector [m].
  /// @return the pieces but the largest, which stays; none where the crack does not divide the ice.
  Broken split_sheet(Plate& plate, Vec2 from, Vec2 towards, double smallest_floe);

  /// A large piece of drifting level ice continues as level ice. @return its number, the next one.
  int add_level_ice(Plate&& piece);
  /// Drifting level ice that has become small continues as floes. It is empty then.
  std::vector<Plate> release(Plate& plate, double smallest_floe);

  /// Books a piece that has no body as brash.
  void to_brash(const Plate& piece);
  /// Books a crushed floe as deleted.
  void to_deleted(const Plate& floe);

 private:
  template <typename Take>
  geometry::Cut booked(Plate& plate, Take take);
  geometry::Cut cut(Plate& plate, std::span<const geometry::Point> region, std::span<const geometry::Crack> cracks);
  std::vector<geometry::Polygon> take_severed(Plate& plate, Broken& result);
  std::vector<geometry::Polygon> carve(Plate piece, std::span<const geometry::Ring> structure);
  std::vector<Plate> book_pieces(const Plate& plate, std::span<const geometry::Polygon> whole,
                                 std::span<const geometry::Ring> structure, double smallest_floe);
  void book_piece(const Plate& plate, geometry::Polygon part, double smallest_floe, std::vector<Plate>& pieces);
  void lay(Plate& plate, geometry::Polygon outline);
  geometry::ExactArea& account_of(const Plate& plate);

  model::FieldSection section_;
  std::vector<geometry::Polygon> land_;
  std::vector<Plate> level_ice_;
  std::vector<Plate> loose_;
  Variation variation_;
  geometry::Ledger ledger_;
};

}  // namespace brash::ice
