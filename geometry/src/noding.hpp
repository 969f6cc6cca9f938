// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "free_edges.hpp"

namespace brash::geometry {

/// Where an edge comes from.
enum class Source { kSheet, kRegion, kCrack };

/// A directed edge between two nodes, by their numbers.
struct NodedEdge {
  int from;
  int to;
  Source source;
};

/// The free edges near a region, the region's boundary and the cracks in it, noded on the grid.
///
/// Nodes are the vertices of all three and their crossings, rounded to the grid. Every edge is led through every node
/// in whose pixel it comes (iterated snap rounding), so edges meet in nodes only and neighbours share them exactly.
/// Edges may coincide.
class Noding {
 public:
  /// A sheet edge that takes part.
  struct ActiveEdge {
    int id;
    int from;  ///< Node.
    int to;
    int edge;  ///< Its number in edges(); -1 when it has been split or moved.
  };

  Noding(const FreeEdges& boundary, std::span<const Point> region, std::span<const Crack> cracks);

  const std::vector<Point>& nodes() const { return nodes_; }
  const std::vector<NodedEdge>& edges() const { return edges_; }
  const std::vector<ActiveEdge>& active() const { return active_; }
  /// Twice the area that leading sheet edges through nodes added to the ice.
  Int128 twice_moved() const { return twice_moved_; }
  /// How many nodes rounding made or led a sheet edge to: crossings, and ends of cracks beside an edge.
  std::int64_t n_rounded() const { return std::ranges::count(is_rounded_, 1); }
  /// For each node whether it is there without any crack: it ends an edge of the sheet or of the region.
  std::vector<char> nodes_without_cracks() const;
  /// True when all edges at the node take part. Sheet edges that end farther out do so at nodes where others may lack.
  bool is_complete(int node) const { return safe_box_.contains(nodes_[node]); }

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
  void gather(std::span<const Point> region, std::span<const Crack> cracks);
  void add_crossings();
  void sort_nodes();
  int node_at(Point p) const;
  void route_all();
  void route(const Segment& s, std::vector<int>& chain);
  void add_nodes_met(int from, int to, bool is_moved, int depth);
  void activate_around(const std::vector<int>& nodes);
  int add_edge(int from, int to, Source source);

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
  std::vector<NodedEdge> edges_;
  Int128 twice_moved_ = 0;
  std::vector<char> is_rounded_;  ///< of each node
};

/// The parts of `cracks` inside `region`, with their ends on its boundary rounded to the grid.
std::vector<Crack> cracks_inside(std::span<const Point> region, std::span<const Crack> cracks);

}  // namespace brash::geometry
