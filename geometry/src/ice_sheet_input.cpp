// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <sstream>

#include "brash/core/contract.hpp"
#include "ice_sheet_impl.hpp"

namespace brash::geometry {

namespace {

using exact::Box;

/// Polygons from outside on their way to a boundary.
struct Input {
  struct Edge {
    Point from;
    Point to;
    std::size_t polygon;
  };
  std::vector<Edge> edges;
  std::vector<Point> nodes;
  EdgeIndex index;

  int node_at(Point p) const {
    return static_cast<int>(std::lower_bound(nodes.begin(), nodes.end(), p) - nodes.begin());
  }
  void route(int from, int to, PlanarGraph& graph) const;
};

std::string place(Point p) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << metres(p).x << ", " << metres(p).y << ')';
  return text.str();
}

std::string polygon_name(std::size_t i) { return "polygon " + std::to_string(i); }

/// Adds a ring with the ice on its left. @return what is wrong with it, or nothing.
std::string add_ring(Input& input, Ring ring, bool is_hole, std::size_t polygon) {
  constexpr auto kMost = static_cast<std::int64_t>(kMaxCoordinate / kGridUnit);
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  while (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  const std::string name = polygon_name(polygon) + (is_hole ? ", a hole" : ", the outline");
  if (ring.size() < 3) return name + ": has fewer than 3 different vertices";
  for (const Point p : ring) {
    if (std::abs(p.x) > kMost || std::abs(p.y) > kMost) return name + ": beyond the grid at " + place(p);
  }
  const ExactArea enclosed = signed_area(ring);
  if (enclosed == ExactArea{}) return name + ": has no area, at " + place(ring.front());
  if ((enclosed < ExactArea{}) != is_hole) std::reverse(ring.begin(), ring.end());
  for (std::size_t i = 0; i < ring.size(); ++i) {
    input.edges.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], polygon});
  }
  return {};
}

/// @return where two edges cross, or nothing.
std::string find_crossing(const Input& input) {
  std::string found;
  for (std::size_t i = 0; i < input.edges.size() && found.empty(); ++i) {
    const Input::Edge& a = input.edges[i];
    input.index.query(Box::of(a.from, a.to), [&](int j) {
      const Input::Edge& b = input.edges[j];
      if (!found.empty() || static_cast<std::size_t>(j) >= i || !exact::cross_properly(a.from, a.to, b.from, b.to))
        return;
      found = polygon_name(b.polygon) +
              (a.polygon == b.polygon ? " crosses itself" : " crosses " + polygon_name(a.polygon)) + " at " +
              place(exact::rounded_crossing(a.from, a.to, b.from, b.to));
    });
  }
  return found;
}

/// Leads an edge through the vertices in whose pixels it comes.
void Input::route(int from, int to, PlanarGraph& graph) const {
  const Point a = nodes[from];
  const Point b = nodes[to];
  Ring met;
  index.query(Box::of(a, b), [&](int id) {
    const Point p = edges[id].from;
    if (p != a && p != b && exact::meets_pixel(a, b, p)) met.push_back(p);
  });
  std::sort(met.begin(), met.end(), [&](Point p, Point q) {
    const Int128 dp = exact::dot(a, b, p);
    const Int128 dq = exact::dot(a, b, q);
    return dp != dq ? dp < dq : p < q;
  });
  met.erase(std::unique(met.begin(), met.end()), met.end());
  int last = from;
  for (const Point p : met) {
    route(last, node_at(p), graph);
    last = node_at(p);
  }
  if (met.empty()) {
    graph.add(from, to, Source::kSheet);
  } else {
    route(last, to, graph);
  }
}

/// @return where ice would lie twice or on no side, judged at each vertex, or nothing.
std::string find_overlap(const PlanarGraph& graph) {
  for (int h = 0; h < graph.size(); ++h) {
    const int sheet = graph[h].sheet;
    const int right_of_next = graph[PlanarGraph::twin(graph[h].counter_clockwise)].sheet;
    if (sheet > 1 || sheet < -1 || (sheet > 0) != (right_of_next > 0)) return "ice overlaps at " + place(graph.from(h));
  }
  return {};
}

/// The same for groups of loops that hang together: outside of each must be what lies around it.
std::string find_nested_overlap(const PlanarGraph& graph, const FreeEdges& boundary) {
  std::vector<int> group(graph.n_nodes());
  std::iota(group.begin(), group.end(), 0);
  const auto root = [&](int node) {
    while (group[node] != node) node = group[node] = group[group[node]];
    return node;
  };
  // Nodes are sorted: the largest of a group is its rightmost, upmost vertex and the root.
  for (int h = 0; h < graph.size(); ++h) {
    const int a = root(graph[h].from);
    const int b = root(graph[h].to);
    group[std::min(a, b)] = std::max(a, b);
  }
  for (int h = 0; h < graph.size(); ++h) {
    // All edges at a root go left or down; the first by angle has the sector towards +x on its right.
    if (root(graph[h].from) != graph[h].from) continue;
    const int before = graph[h].clockwise;
    if (before != h && !exact::angle_before(graph.from(h), graph.to(h), graph.to(before))) continue;
    const bool ice_outside = graph[PlanarGraph::twin(h)].sheet > 0;
    if (ice_outside != boundary.is_inside(graph.from(h))) return "ice overlaps left of " + place(graph.from(h));
  }
  return {};
}

FreeEdges free_edges_of(const PlanarGraph& graph) {
  const auto is_edge = [&](int h) { return graph[h].sheet > 0; };
  FreeEdges::Change change;
  std::vector<FreeEdges::Ref> refs(graph.size(), 0);
  for (int h = 0; h < graph.size(); ++h) {
    if (!is_edge(h)) continue;
    refs[h] = ~static_cast<int>(change.added.size());
    change.added.push_back({graph.from(h), graph.to(h)});
  }
  for (int h = 0; h < graph.size(); ++h) {
    if (is_edge(h)) change.links.push_back({refs[h], refs[graph.next_in_face(h, is_edge)]});
  }
  FreeEdges boundary;
  boundary.apply(change);
  return boundary;
}

}  // namespace

tl::expected<IceSheet, GeometryError> IceSheet::from_polygons(std::span<const Polygon> polygons) {
  Input input;
  std::string fault;
  for (std::size_t i = 0; i < polygons.size() && fault.empty(); ++i) {
    fault = add_ring(input, polygons[i].outline, false, i);
    for (const Ring& hole : polygons[i].holes) {
      if (fault.empty()) fault = add_ring(input, hole, true, i);
    }
  }
  if (!fault.empty()) return tl::unexpected(GeometryError{fault});
  for (std::size_t i = 0; i < input.edges.size(); ++i) {
    input.index.insert(static_cast<int>(i), input.edges[i].from, input.edges[i].to);
    input.nodes.push_back(input.edges[i].from);
  }
  std::sort(input.nodes.begin(), input.nodes.end());
  input.nodes.erase(std::unique(input.nodes.begin(), input.nodes.end()), input.nodes.end());
  fault = find_crossing(input);
  if (!fault.empty()) return tl::unexpected(GeometryError{fault});

  PlanarGraph graph;
  for (const Input::Edge& e : input.edges) input.route(input.node_at(e.from), input.node_at(e.to), graph);
  graph.build(input.nodes);
  fault = find_overlap(graph);
  if (!fault.empty()) return tl::unexpected(GeometryError{fault});
  auto impl = std::make_unique<Impl>(Impl{free_edges_of(graph)});
  fault = find_nested_overlap(graph, impl->boundary);
  if (!fault.empty()) return tl::unexpected(GeometryError{fault});
  return IceSheet(std::move(impl));
}

void IceSheet::check() const {
  const FreeEdges& edges = impl_->boundary;
  edges.check_loops();
  edges.check_nodes();
  // Made anew from its polygons the sheet is the same; that judges the sides and the nesting of loops.
  const std::vector<Polygon> before = polygons();
  const auto again = from_polygons(before);
  BRASH_EXPECTS(again.has_value(), again.error().what);
  BRASH_EXPECTS(again->area() == area() && again->n_vertices() == n_vertices() && again->polygons() == before,
                again->n_vertices(), n_vertices(), area().to_string());
}

}  // namespace brash::geometry
