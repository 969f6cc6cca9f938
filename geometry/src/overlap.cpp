// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlap.hpp"

#include <algorithm>
#include <cstdlib>

#include "brash/core/contract.hpp"
#include "joined_edges.hpp"

namespace brash::geometry {
namespace {

class Overlap {
 public:
  Overlap(const Noding& noding, const FreeEdges& boundary);
  void add_region_edges();
  void add_free_edges();

  std::vector<NodedEdge> edges;

 private:
  /// A free edge at a node.
  struct Spoke {
    int to;
    bool is_outgoing;
    int older;  ///< The next one at the node; -1 when there is none.
  };
  enum class Side : char { kUnknown, kOutside, kInside, kOnRegion };

  Point at(int node) const { return noding_.nodes()[node]; }
  bool has_free_edge(int node) const { return newest_spoke_[node] >= 0; }
  void add_spoke(int from, int to, bool is_outgoing);
  bool starts_in_ice(const NodedEdge& edge) const;
  bool is_in_region(const JoinedEdges::Edge& edge);

  const Noding& noding_;
  const FreeEdges& boundary_;
  JoinedEdges joined_;
  std::vector<std::size_t> region_edges_;  ///< Into the noded edges, around the region.
  Ring ring_;                              ///< The region as it has been noded.
  std::vector<Spoke> spokes_;
  std::vector<int> newest_spoke_;  ///< Of each node.
  std::vector<Side> side_;         ///< Of each node, as far as it is known.
};

Overlap::Overlap(const Noding& noding, const FreeEdges& boundary)
    : noding_(noding),
      boundary_(boundary),
      joined_(noding.nodes(), noding.edges()),
      newest_spoke_(noding.nodes().size(), -1),
      side_(noding.nodes().size(), Side::kUnknown) {
  for (std::size_t i = 0; i < noding.edges().size(); ++i) {
    const NodedEdge& edge = noding.edges()[i];
    if (edge.source != Source::kRegion) continue;
    region_edges_.push_back(i);
    ring_.push_back(at(edge.from));
    side_[edge.from] = Side::kOnRegion;
  }
  for (const JoinedEdges::Edge& e : joined_.edges()) {
    const bool is_simple = std::abs(e.label.sheet) <= 1 && std::abs(e.label.region) <= 1;
    BRASH_EXPECTS(is_simple, e.label.sheet, e.label.region, at(e.left).x, at(e.left).y);
    if (e.label.sheet == 0) continue;
    add_spoke(e.left, e.right, e.label.sheet > 0);
    add_spoke(e.right, e.left, e.label.sheet < 0);
  }
}

void Overlap::add_spoke(int from, int to, bool is_outgoing) {
  spokes_.push_back({to, is_outgoing, newest_spoke_[from]});
  newest_spoke_[from] = static_cast<int>(spokes_.size()) - 1;
}

/// The first free edge clockwise from `edge`, around the node where it starts, has ice on that side or water.
bool Overlap::starts_in_ice(const NodedEdge& edge) const {
  const Point centre = at(edge.from);
  const Point along = at(edge.to);
  int first = newest_spoke_[edge.from];
  for (int i = spokes_[first].older; i >= 0; i = spokes_[i].older) {
    const Point best = at(spokes_[first].to);
    const Point other = at(spokes_[i].to);
    const bool is_best_right = side(centre, along, best) < 0;
    const bool is_other_right = side(centre, along, other) < 0;
    if (is_other_right != is_best_right ? is_other_right : side(centre, best, other) > 0) first = i;
  }
  return spokes_[first].is_outgoing;
}

void Overlap::add_region_edges() {
  const std::size_t n = region_edges_.size();
  std::size_t start = 0;
  while (start < n && !has_free_edge(noding_.edges()[region_edges_[start]].from)) ++start;
  bool in_ice = start == n && is_in_ice(ring_.front(), noding_, joined_, boundary_);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t number = region_edges_[(start + i) % n];
    const NodedEdge& edge = noding_.edges()[number];
    const auto& [joined, is_rightward] = joined_.places()[number];
    const EdgeLabel& label = joined_.edges()[joined].label;
    if (label.sheet == 0) {
      if (has_free_edge(edge.from)) in_ice = starts_in_ice(edge);
      if (in_ice && label.region != 0) edges.push_back(edge);
    } else if (label.sheet == label.region) {
      edges.push_back({edge.from, edge.to, Source::kSheet});
    }
  }
}

/// Free edges meet the region in nodes only, so all free edges at a node beside the region are on the same side.
bool Overlap::is_in_region(const JoinedEdges::Edge& edge) {
  for (const int node : {edge.left, edge.right}) {
    if (side_[node] == Side::kInside || side_[node] == Side::kOutside) return side_[node] == Side::kInside;
  }
  const Point left = at(edge.left);
  const Point right = at(edge.right);
  const int turns = exact::winding(ring_, left + right, 2);
  BRASH_EXPECTS(turns == 0 || turns == 1, "the region is not simple", turns, left.x, left.y);
  return turns == 1;
}

void Overlap::add_free_edges() {
  for (const JoinedEdges::Edge& e : joined_.edges()) {
    if (e.label.sheet == 0 || e.label.region != 0) continue;
    const bool is_inside = is_in_region(e);
    for (const int node : {e.left, e.right}) {
      if (side_[node] == Side::kUnknown) side_[node] = is_inside ? Side::kInside : Side::kOutside;
    }
    if (!is_inside) continue;
    const bool is_rightward = e.label.sheet > 0;
    edges.push_back({is_rightward ? e.left : e.right, is_rightward ? e.right : e.left, Source::kSheet});
  }
}

}  // namespace

std::vector<NodedEdge> overlap_edges(const Noding& noding, const FreeEdges& boundary) {
  Overlap overlap(noding, boundary);
  overlap.add_region_edges();
  overlap.add_free_edges();
  return std::move(overlap.edges);
}

}  // namespace brash::geometry
