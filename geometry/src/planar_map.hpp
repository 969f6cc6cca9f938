// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's planar map of noded edges. Only arrangement.cpp includes this file: CGAL takes 15 s to compile.
#pragma once

#include <CGAL/Arr_curve_data_traits_2.h>
#include <CGAL/Arr_extended_dcel.h>
#include <CGAL/Arr_non_caching_segment_traits_2.h>
#include <CGAL/Arrangement_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <limits>
#include <vector>

#include "brash/core/contract.hpp"
#include "free_edges.hpp"
#include "joined_edges.hpp"

namespace brash::geometry {

/// How often ice and region cover a face: 0 or 1 once all is labelled.
struct FaceLabel {
  static constexpr int kUnknown = std::numeric_limits<int>::min();
  int ice = kUnknown;
  int region = kUnknown;

  bool is_piece() const { return ice == 1 && region == 1; }
};

/// Edges are joined before they go in, so the traits never merge labels.
struct NoMerge {
  EdgeLabel operator()(const EdgeLabel& label, const EdgeLabel&) const { return label; }
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Arr_curve_data_traits_2<CGAL::Arr_non_caching_segment_traits_2<Kernel>, EdgeLabel, NoMerge>;
/// A vertex carries the number of its node, a half-edge its place among the free edges of a change.
using Dcel = CGAL::Arr_extended_dcel<Traits, int, FreeEdges::Ref, FaceLabel>;
using PlanarMap = CGAL::Arrangement_2<Traits, Dcel>;
using Edge = PlanarMap::Halfedge_handle;
using HalfEdge = PlanarMap::Halfedge_const_handle;
using Face = PlanarMap::Face_const_handle;

inline constexpr FreeEdges::Ref kNoRef = std::numeric_limits<FreeEdges::Ref>::max();

/// Grid coordinates have 44 bits: doubles hold them, so that CGAL's predicates on them are exact.
inline Kernel::Point_2 exactly(Point p) { return {static_cast<double>(p.x), static_cast<double>(p.y)}; }

/// False for a handle that points to nothing.
inline bool is_there(HalfEdge h) { return h != HalfEdge{}; }
inline int along(HalfEdge h) { return h->direction() == CGAL::ARR_LEFT_TO_RIGHT ? 1 : -1; }
inline int sheet(HalfEdge h) { return along(h) * h->curve().data().sheet; }
inline int region(HalfEdge h) { return along(h) * h->curve().data().region; }

/// Calls visit(half-edge) for the boundary of the face, the outer one first.
template <typename FaceHandle, typename Visit>
void for_each_side(FaceHandle face, Visit&& visit) {
  const auto walk = [&](auto start) {
    auto h = start;
    do visit(h);
    while (++h != start);
  };
  for (auto ccb = face->outer_ccbs_begin(); ccb != face->outer_ccbs_end(); ++ccb) walk(*ccb);
  for (auto ccb = face->inner_ccbs_begin(); ccb != face->inner_ccbs_end(); ++ccb) walk(*ccb);
}

/// Noded edges as a planar map, and which half-edge each edge has become.
struct NodedMap {
  NodedMap(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges);

  /// The half-edge along the edge that came in with this number; null when it has been cancelled.
  Edge along_edge(int number) const {
    const auto& [edge, is_rightward] = joined.places()[number];
    const Edge right = rightward[edge];
    return is_rightward || !is_there(right) ? right : right->twin();
  }

  JoinedEdges joined;
  PlanarMap map;
  std::vector<Edge> rightward;  ///< Of each joined edge; null when it has been cancelled.
};

inline NodedMap::NodedMap(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges)
    : joined(nodes, edges), rightward(joined.edges().size()) {
  std::vector<Traits::X_monotone_curve_2> curves;
  curves.reserve(joined.edges().size());
  for (const JoinedEdges::Edge& e : joined.edges()) {
    if (e.label.is_cancelled()) continue;
    curves.emplace_back(Kernel::Segment_2(exactly(nodes[e.left]), exactly(nodes[e.right])), e.label);
  }
  CGAL::insert_non_intersecting_curves(map, curves.begin(), curves.end());
  for (auto h = map.edges_begin(); h != map.edges_end(); ++h) {
    const Edge right = along(h) > 0 ? Edge(h) : h->twin();
    const JoinedEdges::Edge& e = joined.edges()[right->curve().data().number];
    rightward[e.label.number] = right;
    right->source()->set_data(e.left);
    right->target()->set_data(e.right);
    right->set_data(kNoRef);
    right->twin()->set_data(kNoRef);
  }
}

/// Counts in `cover` how often each face is covered, from the unbounded one inwards: `step` is the count that an edge
/// adds.
inline void cover_faces(PlanarMap& map, int FaceLabel::*cover, int (*step)(HalfEdge)) {
  std::vector<PlanarMap::Face_handle> reached{map.unbounded_face()};
  reached.front()->data().*cover = 0;
  while (!reached.empty()) {
    const PlanarMap::Face_handle face = reached.back();
    reached.pop_back();
    for_each_side(face, [&](Edge h) {
      const PlanarMap::Face_handle across = h->twin()->face();
      if (across->data().*cover != FaceLabel::kUnknown) return;
      across->data().*cover = face->data().*cover - step(h);
      reached.push_back(across);
    });
  }
}

/// The next half-edge along a boundary, where only active ones count: the leftmost turn at the end of `h`.
template <typename IsActive>
HalfEdge next_active(HalfEdge h, IsActive&& is_active) {
  HalfEdge next = h->next();
  while (!is_active(next)) {
    next = next->twin()->next();
    BRASH_EXPECTS(next != h->next(), "a chain of edges ends", h->target()->point().x(), h->target()->point().y());
  }
  return next;
}

}  // namespace brash::geometry
