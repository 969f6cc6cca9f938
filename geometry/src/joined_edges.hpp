// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "noding.hpp"

namespace brash::geometry {

/// Counts along an edge, directed from its lexicographically smaller end to the larger one.
struct EdgeLabel {
  int number = -1;
  int sheet = 0;   ///< Sheet edges along it less those against it.
  int region = 0;  ///< The same for the region's boundary.
  bool is_crack = false;

  bool is_cancelled() const { return sheet == 0 && region == 0 && !is_crack; }
};

/// Coincident edges as one, with the sum of their counts: opposite ones cancel.
class JoinedEdges {
 public:
  struct Edge {
    int left;  ///< Node, lexicographically before the other.
    int right;
    EdgeLabel label;
    int older;  ///< The edge joined before from the same left node; -1 when there is none.
  };
  /// Where an edge that came in has gone.
  struct Place {
    int edge;  ///< Into edges().
    bool is_rightward;
  };
  /// `nodes` must outlive it.
  JoinedEdges(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges);

  const std::vector<Edge>& edges() const { return edges_; }
  /// Of each edge that came in.
  const std::vector<Place>& places() const { return places_; }

 private:
  Place add(const NodedEdge& edge);

  const std::vector<Point>& nodes_;
  std::vector<int> newest_;
  std::vector<Edge> edges_;
  std::vector<Place> places_;
};

/// Whether `p`, not on the free edge, lies in ice as `joined` says: edges that took part may have moved or cancelled
/// out.
bool is_in_ice(Point p, const Noding& noding, const JoinedEdges& joined, const FreeEdges& boundary);

}  // namespace brash::geometry
