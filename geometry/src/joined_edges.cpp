// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_edges.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace brash::geometry {

JoinedEdges::JoinedEdges(const std::vector<Point>& nodes, const std::vector<NodedEdge>& edges)
    : nodes_(nodes), newest_(nodes.size(), -1) {
  edges_.reserve(edges.size());
  places_.reserve(edges.size());
  for (const NodedEdge& edge : edges) places_.push_back(add(edge));
}

JoinedEdges::Place JoinedEdges::add(const NodedEdge& edge) {
  const bool is_rightward = nodes_[edge.from] < nodes_[edge.to];
  const int left = is_rightward ? edge.from : edge.to;
  const int right = is_rightward ? edge.to : edge.from;
  int at = newest_[left];
  while (at >= 0 && edges_[at].right != right) at = edges_[at].older;
  if (at < 0) {
    at = static_cast<int>(edges_.size());
    edges_.push_back({left, right, {.number = at}, newest_[left]});
    newest_[left] = at;
  }
  EdgeLabel& label = edges_[at].label;
  if (edge.source == Source::kSheet) label.sheet += is_rightward ? 1 : -1;
  if (edge.source == Source::kRegion) label.region += is_rightward ? 1 : -1;
  if (edge.source == Source::kCrack) label.is_crack = true;
  return {at, is_rightward};
}

bool is_in_ice(Point p, const Noding& noding, const JoinedEdges& joined, const FreeEdges& boundary) {
  std::vector<int> ignored;
  for (const Noding::ActiveEdge& e : noding.active()) ignored.push_back(e.id);
  std::sort(ignored.begin(), ignored.end());
  const int hit = boundary.first_right_of(p, ignored);
  std::optional<FreeEdges::Directed> first;
  if (hit >= 0) first = {boundary.edge(hit).from, boundary.edge(hit).to};
  for (const JoinedEdges::Edge& e : joined.edges()) {
    if (e.label.sheet == 0) continue;
    FreeEdges::Directed edge{noding.nodes()[e.left], noding.nodes()[e.right]};
    if (e.label.sheet < 0) std::swap(edge.from, edge.to);
    if (!exact::meets_ray(edge.from, edge.to, p)) continue;
    if (first && !exact::is_met_before(edge.from, edge.to, first->from, first->to)) continue;
    first = edge;
  }
  return first && first->from.y < first->to.y;
}

}  // namespace brash::geometry
