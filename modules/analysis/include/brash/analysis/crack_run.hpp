// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/geometry/ice_sheet.hpp"
#include "brash/geometry/ledger.hpp"
#include "brash/geometry/origin.hpp"
#include "brash/geometry/text.hpp"

namespace brash::analysis {

/// One circumferential crack with its radial cracks.
struct CrackEvent {
  /// Collision point B, from the origin [m].
  Vec2 centre;
  /// Breaking length [m], > 0.
  double radius = 0.0;
  /// Number of wedges, at least 1; the radial cracks are then spread evenly.
  int wedges = 1;
  /// Where given, the radial cracks run at these angles instead [rad], counter-clockwise from x.
  std::optional<std::vector<double>> angles;
  /// Of the file, counted from 1.
  int line = 0;
};

/// Reads rows `x,y,radius,wedges[,angles]`, one event a line, with or without that header; empty lines and lines that
/// start with # are passed over. The angles of a row are separated by spaces or semicolons; `wedges` is then empty or
/// one more than the angles, or as many (a full circle). An angle beyond a full turn is refused: it is of degrees.
///
/// @param name    of the file, for messages.
/// @param origin  of the grid in the coordinates of the file; centres are relative to it.
/// @throws InputError naming file, line, column's name, value and the allowed values.
std::vector<CrackEvent> read_crack_events(const std::string& name, const std::string& text,
                                          const geometry::Origin& origin = {});

/// A sheet that is cut again and again, its floes and its ledger.
class CrackRun {
 public:
  /// @param sheet     of all features of the kind sheet.
  /// @param features  of the map; each floe is simple on its own, and floes may overlap.
  CrackRun(geometry::IceSheet sheet, const std::vector<geometry::Feature>& features);

  /// @return whether it cut ice, here and below.
  bool apply(const CrackEvent& event, int sides);
  bool apply(const geometry::Polygon& cutter);
  /// Splits all ice along the cracks, the ice of the floes too. Every part becomes a floe; polygons with a common
  /// edge stay apart there.
  void apply(std::span<const geometry::Crack> cracks);
  void release();

  geometry::Ledger ledger() const;
  std::size_t n_floes() const { return floes_.size(); }
  bool has_sheet() const { return sheet_.n_vertices() > 0; }
  std::vector<geometry::Polygon> sheet() const { return sheet_.polygons(); }
  /// Sheet parts, then the floes of the file or their parts in its order, and new ones in the order of their birth. No
  /// two have one id; a sheet's is above every floe's.
  std::vector<geometry::Feature> features() const;

 private:
  /// The edges of the given polygons, if some have a common edge: the sheet of all has closed it.
  std::vector<geometry::Crack> seams() const;
  /// Cuts each floe on its own; a floe that stays whole stays as it is.
  void split_floes(std::span<const geometry::Crack> cracks);
  void add_floe(geometry::Feature floe);
  /// @param like  floe whose properties the pieces keep.
  bool book(geometry::Cut cut, const geometry::Feature& like = {{}, "floe"});

  geometry::IceSheet sheet_;
  std::vector<geometry::Polygon> given_;  ///< of the sheet
  std::vector<geometry::Feature> floes_;
  geometry::Ledger ledger_;
  std::int64_t next_id_ = 0;
};

/// Whether each line runs in the inside of a polygon: of a line that is cut no more, a part that splits nothing.
std::vector<bool> lines_inside(const geometry::Lines& lines, const std::vector<geometry::Feature>& features);

}  // namespace brash::analysis
