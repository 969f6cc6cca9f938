// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "edge_index.hpp"

namespace brash::geometry {

/// The free edges of a sheet: directed edges with ice on their left, linked into loops, and their index.
///
/// Loops follow the ice: where several meet in a vertex each turns leftmost, so parts that share only a vertex are
/// separate loops. A counter-clockwise loop is the outline of one connected part, a clockwise one a hole.
class FreeEdges {
 public:
  struct Edge {
    Point from;
    Point to;
    int next = -1;
    int previous = -1;
    int loop = -1;  ///< -1: the slot is free.
    int mark = 0;   ///< Scratch of apply().
  };
  /// A closed chain of edges.
  struct Loop {
    int edge = -1;  ///< One of its edges; -1: the slot is free.
    std::int64_t n_edges = 0;
    Int128 twice_area = 0;
  };
  /// An edge of a change: one that stays (its id) or the k-th added one (~k).
  using Ref = int;
  struct Directed {
    Point from;
    Point to;
  };
  struct Link {
    Ref in;
    Ref out;
  };
  /// The change that apply() makes: `links` lists, for every vertex at which an edge goes or comes, how its edges join
  /// afterwards.
  struct Change {
    std::vector<int> removed;
    std::vector<Directed> added;
    std::vector<Link> links;
  };

  const Edge& edge(int id) const { return edges_[id]; }
  const std::vector<Loop>& loops() const { return loops_; }
  std::size_t n_edges() const { return n_edges_; }
  std::size_t n_outlines() const { return n_outlines_; }
  Int128 twice_area() const { return twice_area_; }

  template <typename Visit>
  void query(const exact::Box& box, Visit&& visit) const {
    index_.query(box, [&](int id) {
      if (box.overlaps(exact::Box::of(edges_[id].from, edges_[id].to))) visit(id);
    });
  }
  /// Edges that start at `p`.
  std::vector<int> starting_at(Point p) const;

  /// The first edge that the ray from `p` in +x direction, raised by less than any vertex, meets; edges through p are
  /// not met, nor those in the sorted list `ignored`. -1 when there is none.
  int first_right_of(Point p, std::span<const int> ignored = {}) const;
  /// True when `p`, not on the boundary, lies in ice.
  bool is_inside(Point p) const;
  bool is_on_boundary(Point p) const;

  /// Replaces edges. Costs the change and, where loops divide or join, the shorter of their parts.
  void apply(const Change& change);
  /// Makes one edge of two that meet at `vertex` alone, if it comes through the vertex's pixel and meets nothing else.
  /// @return that edge.
  std::optional<Directed> straighten(Point vertex);
  /// Takes a whole loop out and returns its vertices.
  Ring take_loop(int loop);
  /// The vertices of a loop in its order.
  Ring ring_of(int loop) const;
  /// The outline loop of the part that `loop` belongs to.
  int outline_of(int loop) const;

  /// Throws when any link, loop, count or area disagrees with the edges. Reads everything.
  void check_loops() const;
  /// Throws when edges cross, coincide or come through the pixel of a vertex that is not theirs. Reads everything.
  void check_nodes() const;

 private:
  struct Stretch;
  int add_edge(const Directed& directed);
  void free_edge(int id);
  int add_loop();
  void forget(int id);
  std::vector<Stretch> stretches_of(const Change& change);
  void measure(std::vector<Stretch>& stretches);
  void rebuild_loops(std::vector<Stretch>& stretches, const std::vector<int>& added);
  void relabel(const Stretch& stretch, int loop);

  std::vector<Edge> edges_;
  std::vector<int> free_edges_;
  std::vector<Loop> loops_;
  std::vector<int> free_loops_;
  std::size_t n_edges_ = 0;
  std::size_t n_outlines_ = 0;
  Int128 twice_area_ = 0;
  EdgeIndex index_;
};

}  // namespace brash::geometry
