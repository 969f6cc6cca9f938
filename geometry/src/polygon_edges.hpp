// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "edge_index.hpp"
#include "noding.hpp"

namespace brash::geometry {

/// Edges of polygons from outside on their way to a boundary, with the ice on their left.
class PolygonEdges {
 public:
  struct Edge {
    Point from;
    Point to;
    std::size_t polygon;
  };
  /// Where two edges cross properly, rounded to the grid.
  struct Crossing {
    std::size_t first, second;  ///< polygons, in the order of their numbers
    Point at;
  };
  struct Noded {
    std::vector<Point> nodes;  ///< sorted
    std::vector<NodedEdge> edges;
    Int128 twice_moved = 0;  ///< twice the area that leading edges through nodes added to the ice
  };

  /// Adds the outline and the holes of a polygon, either way round. @return the error in them, or nothing.
  std::string add(const Polygon& polygon, std::size_t number);
  /// The first ring whose turns cancel, in words. If it does not cross itself, it has no area.
  const std::string& flat_ring() const { return flat_ring_; }
  /// All crossings, as the edges come.
  std::vector<Crossing> crossings() const;
  /// The edges, led through all vertices and `crossings` in whose pixels they come.
  Noded noded(const std::vector<Crossing>& crossings);

 private:
  std::string add_ring(Ring ring, bool is_hole, std::size_t polygon);
  void route(int from, int to, Noded& noded) const;
  void insert(const Edge& edge);

  std::vector<Edge> edges_;  ///< crossings too, once noded() has them: edges without a length
  EdgeIndex index_;
  std::string flat_ring_;
};

/// "(x, y)" [m], 17 digits.
std::string place(Point p);
std::string polygon_name(std::size_t i);

}  // namespace brash::geometry
