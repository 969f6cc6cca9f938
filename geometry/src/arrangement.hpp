// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <tl/expected.hpp>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "free_edges.hpp"
#include "noding.hpp"

namespace brash::geometry {

/// The free edge after a cut, as a change of the boundary.
struct SheetChange {
  FreeEdges::Change change;
  Int128 twice_area = 0;  ///< The change of twice the area of the sheet.
};

/// The noded edges of a cut as a CGAL::Arrangement_2: half-edges and faces, labelled with ice and region.
class Arrangement {
 public:
  /// A directed edge with a piece of ice on its left.
  struct Side {
    Point from;
    Point to;
    bool is_free;  ///< Part of the free edge, not only of the region's boundary or a crack.
  };
  using Walk = std::vector<Side>;
  /// The boundary of one piece of ice inside the region.
  struct Piece {
    Walk outline;  ///< May come through a vertex more than once.
    std::vector<Walk> holes;
  };
  /// The cracks that drop_useless_cracks() has left.
  struct Cracks {
    std::vector<Crack> splitting;  ///< Edge by edge.
    bool has_traces = false;       ///< The others have left a node that would not be there without them.
  };

  /// Both must outlive the arrangement.
  /// @throws ContractViolation when the region is not simple or the free edges do not part ice from water.
  Arrangement(const Noding& noding, const FreeEdges& boundary);
  ~Arrangement();

  /// Takes out the cracks that split no piece: those with the same face on both sides.
  Cracks drop_useless_cracks();
  /// The faces with ice inside the region.
  std::vector<Piece> pieces() const;
  /// The same for a region without cracks, by arranging the boundary of these faces alone.
  /// @throws ContractViolation as the constructor does.
  static std::vector<Piece> overlap(const Noding& noding, const FreeEdges& boundary);
  /// The free edge without the region.
  SheetChange sheet_change() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Why noded edges of polygons are no boundary: `what` is wrong at a vertex.
struct OverlapError {
  const char* what;
  Point at;
};

/// The free edges that `edges` between `nodes` make, the ice on their left; or where ice lies twice or on no side.
tl::expected<FreeEdges::Change, OverlapError> boundary_of(const std::vector<Point>& nodes,
                                                          const std::vector<NodedEdge>& edges);

/// How often polygons cover the plane.
struct Coverage {
  FreeEdges::Change boundary;         ///< of all that is covered at least once
  std::map<int, Int128> twice_areas;  ///< of what is covered so many times; 0 is left out
};

/// The coverage by rings of `edges` between `nodes`, their inside on the left.
Coverage coverage_of(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges);

}  // namespace brash::geometry
