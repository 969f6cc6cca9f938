// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "brash/geometry/polygon.hpp"
#include "exact.hpp"

namespace brash::geometry {

/// Where an edge of the arrangement comes from.
enum class Source { kSheet, kRegion, kCrack };

/// Noded straight edges as half-edges: they meet in common nodes only. Half-edges 2e and 2e + 1 are twins.
class PlanarGraph {
 public:
  struct HalfEdge {
    int from = -1;
    int to = -1;
    int counter_clockwise = -1;  ///< Next half-edge out of `from`, counter-clockwise.
    int clockwise = -1;
    std::int8_t sheet = 0;   ///< Sheet edges along it less those against it.
    std::int8_t region = 0;  ///< The same for the region's boundary.
    bool crack = false;
  };

  void reserve(std::size_t n_edges) { raw_.reserve(n_edges); }
  /// Adds the directed edge; coincident ones are joined by build(), opposite ones cancel. @return its number.
  int add(int from, int to, Source source) {
    raw_.push_back({from, to, source});
    return static_cast<int>(raw_.size()) - 1;
  }
  void build(const std::vector<Point>& nodes);

  static int twin(int half_edge) { return half_edge ^ 1; }
  const HalfEdge& operator[](int half_edge) const { return half_[half_edge]; }
  int size() const { return static_cast<int>(half_.size()); }
  std::size_t n_nodes() const { return nodes_->size(); }
  /// The half-edge along the edge that add() gave this number; -1 when it has been cancelled.
  int half_edge_of(int added) const { return raw_[added].half_edge; }
  Point from(int half_edge) const { return (*nodes_)[half_[half_edge].from]; }
  Point to(int half_edge) const { return (*nodes_)[half_[half_edge].to]; }

  /// The half-edge that follows on the boundary of the face left of `half_edge`.
  int next_in_face(int half_edge) const { return half_[twin(half_edge)].clockwise; }
  /// The same, where only active ones count.
  template <typename IsActive>
  int next_in_face(int half_edge, IsActive&& is_active) const {
    int next = next_in_face(half_edge);
    while (!is_active(next)) next = half_[next].clockwise;
    return next;
  }
  /// All closed boundaries of the faces of the active half-edges, in no particular order.
  template <typename IsActive>
  std::vector<std::vector<int>> trace(IsActive&& is_active) const;

  Int128 twice_area(const std::vector<int>& cycle) const;
  Ring ring_of(const std::vector<int>& cycle) const;

 private:
  struct Raw {
    int from;
    int to;
    Source source;
    int half_edge = -1;
  };
  void join_coincident();
  void drop_cancelled();
  void order_around_nodes();

  std::vector<Raw> raw_;
  std::vector<HalfEdge> half_;
  const std::vector<Point>* nodes_ = nullptr;
};

template <typename IsActive>
std::vector<std::vector<int>> PlanarGraph::trace(IsActive&& is_active) const {
  std::vector<std::vector<int>> cycles;
  cycles.reserve(8);
  std::vector<char> seen(half_.size(), 0);
  std::vector<int> cycle;
  cycle.reserve(half_.size());
  for (int start = 0; start < size(); ++start) {
    if (seen[start] || !is_active(start)) continue;
    cycle.clear();
    for (int h = start; !seen[h]; h = next_in_face(h, is_active)) {
      seen[h] = 1;
      cycle.push_back(h);
    }
    cycles.push_back(cycle);
  }
  return cycles;
}

/// The simple loops that a closed chain with repeated vertices consists of.
std::vector<Ring> simple_loops(Ring ring);

/// `ring` started at its smallest vertex.
Ring from_smallest(Ring ring);

/// Polygons of loops traced with the ice on their left: outlines counter-clockwise, holes clockwise, which may touch
/// themselves and each other in vertices. Sorted by the smallest vertex of the outline.
std::vector<Polygon> polygons_of(std::vector<Ring> loops);

}  // namespace brash::geometry
