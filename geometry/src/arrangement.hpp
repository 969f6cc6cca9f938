// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "free_edges.hpp"
#include "planar_graph.hpp"

namespace brash::geometry {

/// The free edges near a region, the region's boundary and the cracks in it as one arrangement on the grid.
///
/// Nodes are the vertices of all three and their crossings, rounded to the grid. Every edge is led through every node
/// in whose pixel it comes (iterated snap rounding), so edges meet in nodes only and neighbours share them exactly.
class Arrangement {
 public:
  /// A sheet edge that takes part.
  struct ActiveEdge {
    int id;
    int from;  ///< Node.
    int to;
    int added;  ///< Its number in the graph; -1 when it has been split or moved.
  };

  Arrangement(const FreeEdges& boundary, std::span<const Point> region, std::span<const Crack> cracks);
  Arrangement(const Arrangement&) = delete;
  Arrangement& operator=(const Arrangement&) = delete;

  const PlanarGraph& graph() const { return graph_; }
  const std::vector<ActiveEdge>& active() const { return active_; }
  /// Twice the area that leading sheet edges through nodes added to the ice.
  Int128 twice_moved() const { return twice_moved_; }
  std::int64_t n_rounded() const { return n_rounded_; }
  /// For each node whether it is there without any crack: it ends an edge of the sheet or of the region.
  std::vector<char> nodes_without_cracks() const;

  bool has_ice_left(int h) const { return left_[h].ice != 0; }
  bool is_region_left(int h) const { return left_[h].region != 0; }
  bool is_piece_left(int h) const { return has_ice_left(h) && is_region_left(h); }
  bool is_sheet_left(int h) const { return has_ice_left(h) && !is_region_left(h); }
  /// True for a half-edge of the free edge as it is after the region has gone.
  bool is_new_sheet_edge(int h) const { return is_sheet_left(h) && !is_sheet_left(PlanarGraph::twin(h)); }

 private:
  struct Segment {
    Segment(Point a, Point b, Source of, int sheet_edge = -1)
        : from(a), to(b), box(exact::Box::of(a, b)), source(of), edge(sheet_edge) {}

    Point from;
    Point to;
    exact::Box box;
    Source source;
    int edge;  ///< Of the sheet.
    int from_node = -1;
    int to_node = -1;
  };
  struct Target {
    int node;
    int depth;
  };
  /// How often ice and region cover a face: 0 or 1 once all is labelled.
  struct Cover {
    int ice;
    int region;
  };

  void gather(std::span<const Point> region, std::span<const Crack> cracks);
  void add_crossings();
  void sort_nodes();
  int node_at(Point p) const;
  void route_all();
  void route(const Segment& s, std::vector<int>& chain);
  void add_nodes_met(int from, int to, bool is_moved, int depth);
  void activate_around(const std::vector<int>& nodes);
  void label();
  void label_group(int start, const std::vector<char>& is_complete, std::vector<int>& group);
  void check_labels(const std::vector<char>& is_complete) const;
  bool is_in_ice(Point p) const;
  bool is_in_region(Point p) const;

  const FreeEdges& boundary_;
  exact::Box box_;         ///< Of the region and the cracks.
  exact::Box safe_box_;    ///< Every sheet edge that comes here takes part, wherever routing leads it.
  exact::Box gather_box_;  ///< Sheet edges whose boxes come here take part from the start.
  std::vector<Segment> segments_;
  std::vector<Point> nodes_;     ///< Sorted up to n_sorted_, then nodes outside the safe box.
  std::vector<Target> targets_;  ///< Where the edge that is being routed has to go, the next one last.
  std::size_t n_sorted_ = 0;
  std::vector<Point> crossings_;
  std::vector<ActiveEdge> active_;
  PlanarGraph graph_;
  std::vector<Cover> left_;  ///< Of the face left of each half-edge.
  Int128 twice_moved_ = 0;
  std::int64_t n_rounded_ = 0;
};

/// The parts of `cracks` inside `region`, with their ends on its boundary rounded to the grid.
std::vector<Crack> cracks_inside(std::span<const Point> region, std::span<const Crack> cracks);

}  // namespace brash::geometry
