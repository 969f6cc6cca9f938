// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <tl/expected.hpp>
#include <vector>

#include "brash/core/vec.hpp"
#include "brash/plate/plate.hpp"

namespace brash::plate {

/// A load on a straight stretch of the free edge, even along it. The components are resultants over the stretch.
struct EdgeLoad {
  /// Its ends, in the order in which the outline runs: towards +y, the ice on its right. They lie on the outline to
  /// within 1e-3 and become points of it [l_c].
  Vec2 from{}, to{};
  Vec2 in_plane{};            ///< N and f as a vector of the sheet's frame [k l_c^3]
  double out_of_plane = 0.0;  ///< P [k l_c^3], positive as the deflection
  /// Moment about the edge [k l_c^4]. It is positive if it bends the ice ahead as a positive P bends a cantilever.
  double moment = 0.0;
};

/// An even load out of the plane on a disc inside the ice: a floe under the sheet.
struct PatchLoad {
  Vec2 at{};                  ///< centre of the disc [l_c]
  double radius = 0.0;        ///< [l_c], >= 0; the ice takes the load also if the disc reaches beyond it
  double out_of_plane = 0.0;  ///< [k l_c^3], positive as the deflection
};

/// How finely the sheet is meshed.
enum class Accuracy {
  /// As kFast, with quadratic elements in bending, to screen: errs by 1.5 and 4.9 %.
  /// docs/theory/fracture-of-the-edge.md has the table.
  kCoarse,
  kFast,  ///< errs by 0.8 % in the largest stress in the median, by 2.4 % in 95 of 100 recorded sheets
  kFine,  ///< the sizes of the production mesh: errs by 0.3 and 1.7 %
};

/// A wide floating sheet with the free edge as it is and all the loads on it.
///
/// Units: lengths over l_c, line forces over k l_c^2, forces over k l_c^3, moments over k l_c^4, with k = rho_w g.
/// Frame: origin at B, the middle of a contact, x into the ice. The stress on a surface, over k l_c, is
/// `+-6 m (l_c/h)^2 + n (l_c/h)`, with the moment m and the membrane stress resultant n.
struct LoadedSheet {
  /// The free edge, from y < 0 to y > 0, through the origin, the ice on its right (+x). Beyond its first and last
  /// point, which have the least and the largest y, the edge continues along -y and +y. Features that are small
  /// against l_c and the contacts are simplified away: points, slivers and necks of ice, slots. If the edge cannot be
  /// meshed otherwise, necks with loads behind them are cut too, and these loads move to the edge next to them.
  std::vector<Vec2> outline{};
  std::vector<EdgeLoad> edge_loads{};    ///< shape=(n,), at least one load of either kind
  std::vector<PatchLoad> patch_loads{};  ///< shape=(m,)
  double thickness = 0.1;                ///< h / l_c [-]
  double poisson_ratio = 0.3;            ///< nu [-]
  /// The membrane stress of the in-plane loads acts on the bent plate; docs/theory/fracture-of-the-edge.md, (4).
  bool second_order = false;
  /// A radial crack from B has split the sheet along the whole x-axis: no moment across it. In the plane it is closed.
  bool split = false;
  Accuracy accuracy = Accuracy::kFast;
};

/// Deflection and stress resultants at a point.
struct SheetState {
  Tensor2 moment;           ///< per length [k l_c^3], axes of the sheet's frame; sign as UnitProfiles::bending
  Tensor2 membrane;         ///< stress resultant sigma h [k l_c^2], tension positive
  double deflection = 0.0;  ///< w [l_c]
};

/// Deflection and stress resultants along a line; shape=(n_stations,) each.
struct LineProfile {
  std::vector<double> station;  ///< distance from the line's first point over l_c
  std::vector<SheetState> state;
};

/// A place of the ice with its fields.
struct SheetPlace {
  Vec2 at{};  ///< [l_c]
  SheetState state;
};

/// Where the processor time of a solution went [s].
struct SheetTimes {
  double mesh = 0.0;
  double membrane = 0.0;
  double bending = 0.0;
};

/// The bent sheet: its mesh and its fields. It can be moved, and read from several threads at a time.
class SheetSolution {
 public:
  struct Impl;
  explicit SheetSolution(std::unique_ptr<const Impl> impl);
  SheetSolution(SheetSolution&&) noexcept;
  SheetSolution& operator=(SheetSolution&&) noexcept;
  ~SheetSolution();

  /// The fields at even distances along a line. It ends where the line leaves the ice, or after `length`.
  ///
  /// @param from        in the ice, or off it by at most 0.05, because the edge is simplified [l_c]; the
  ///                    stations before the ice have the state of its edge.
  /// @param direction   of any length > 0.
  /// @param length      over l_c, > 0.
  /// @param n_stations  at least 2.
  /// @return no stations where the line has no ice ahead of `from`.
  LineProfile along(Vec2 from, Vec2 direction, double length, int n_stations = 200) const;

  /// The fields at a point; nothing outside the ice.
  std::optional<SheetState> at(Vec2 place) const;

  /// The fields at those corners of elements and middles of their sides that are `wanted`. A place comes once, and on
  /// the crack of a split sheet once for each half.
  std::vector<SheetPlace> at_nodes(const std::function<bool(Vec2)>& wanted) const;

  int n_elements() const;
  const SheetTimes& times() const;

 private:
  std::unique_ptr<const Impl> impl_;
};

/// Solves the floating sheet under all its loads at once.
///
/// @return the solution, or why not: the edge touches itself or misses a load, or needs too many elements; there is no
/// load, or one is not finite or lies off the ice; the edge of a split sheet misses B; the plate buckles (second
/// order).
/// @see docs/theory/fracture-of-the-edge.md, "All loads on one sheet"
tl::expected<SheetSolution, PlateError> solve(const LoadedSheet& sheet);

}  // namespace brash::plate
