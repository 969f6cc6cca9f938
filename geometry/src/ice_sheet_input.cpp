// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
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
  void route(int from, int to, std::vector<NodedEdge>& noded) const;
};

std::string place(Point p) {
  std::ostringstream text;
  text.precision(17);
  text << '(' << metres(p).x << ", " << metres(p).y << ')';
  return text.str();
}

std::string polygon_name(std::size_t i) { return "polygon " + std::to_string(i); }

/// Adds a ring with the ice on its left. @return the error in it, or nothing.
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
    look_for_interruption();
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

/// The fault of the polygon with the number `i`, or nothing.
std::string fault_alone(const Polygon& polygon, std::size_t i) {
  const auto alone = IceSheet::from_polygons(std::span(&polygon, 1));
  if (alone) return {};
  const std::string &fault = alone.error().what, name = polygon_name(0);
  return polygon_name(i) + (fault.starts_with(name) ? fault.substr(name.size()) : ": " + fault);
}

/// Leads an edge through the vertices in whose pixels it comes.
void Input::route(int from, int to, std::vector<NodedEdge>& noded) const {
  look_for_interruption();
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
    route(last, node_at(p), noded);
    last = node_at(p);
  }
  if (met.empty()) {
    noded.push_back({from, to, Source::kSheet});
  } else {
    route(last, to, noded);
  }
}

}  // namespace

tl::expected<IceSheet, GeometryError> IceSheet::from_polygons(std::span<const Polygon> polygons) {
  Input input;
  std::string fault;
  // Each polygon with holes is checked alone: among others a hole may lie in one that is not its own.
  for (std::size_t i = 0; i < polygons.size() && polygons.size() > 1 && fault.empty(); ++i)
    if (!polygons[i].holes.empty()) fault = fault_alone(polygons[i], i);
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

  std::vector<NodedEdge> noded;
  for (const Input::Edge& e : input.edges) input.route(input.node_at(e.from), input.node_at(e.to), noded);
  const auto change = boundary_of(input.nodes, noded);
  if (!change)
    return tl::unexpected(GeometryError{std::string(change.error().what) + " at " + place(change.error().at)});
  auto impl = std::make_unique<Impl>();
  impl->boundary.apply(*change);
  return IceSheet(std::move(impl));
}

void IceSheet::check() const {
  const FreeEdges& edges = impl_->boundary;
  edges.check_loops();
  edges.check_nodes();
  // Made again from its polygons the sheet is the same; that judges the sides and the nesting of loops.
  const std::vector<Polygon> before = polygons();
  const auto again = from_polygons(before);
  BRASH_EXPECTS(again.has_value(), again.error().what);
  BRASH_EXPECTS(again->area() == area() && again->n_vertices() == n_vertices() && again->polygons() == before,
                again->n_vertices(), n_vertices(), area().to_string());
}

}  // namespace brash::geometry
