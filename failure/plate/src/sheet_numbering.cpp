// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet_numbering.hpp"

#include <algorithm>

namespace brash::plate {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

int n_vertices(const Mesh& mesh) { return static_cast<int>(mesh.vertices.size()); }

int n_nodes(const Mesh& mesh, int order) {
  return n_vertices(mesh) + (order - 1) * static_cast<int>(mesh.edges.size());
}

/// Whether each node lies on an edge with that tag.
std::vector<char> nodes_on(const Mesh& mesh, int order, Side side) {
  std::vector<char> marks(at(n_nodes(mesh, order)), 0);
  for (const auto& tagged : mesh.tagged) {
    if (tagged.side != side) continue;
    for (const int node : nodes_of_edge(mesh, order, tagged.edge)) marks[at(node)] = 1;
  }
  return marks;
}

bool is_below_the_axis(const Mesh& mesh, int triangle) {
  double y = 0.0;
  for (const int corner : mesh.triangles[at(triangle)]) y += mesh.vertices[at(corner)].y;
  return y < 0.0;
}

/// A vertex or an edge with its nodes. Entities are numbered: vertices, then edges.
struct Entity {
  int first_node = 0;
  int n_nodes = 0;
};

std::vector<Entity> entities_of(const Mesh& mesh, int order) {
  std::vector<Entity> entities;
  entities.reserve(mesh.vertices.size() + mesh.edges.size());
  for (int v = 0; v < n_vertices(mesh); ++v) entities.push_back({v, 1});
  for (int e = 0; e < static_cast<int>(mesh.edges.size()); ++e)
    entities.push_back({n_vertices(mesh) + e * (order - 1), order - 1});
  return entities;
}

/// Entities of a triangle in the order of the reference element.
std::array<int, 6> entities_of_triangle(const Mesh& mesh, int triangle) {
  const auto& vertices = mesh.triangles[at(triangle)];
  const auto& edges = mesh.triangle_edges[at(triangle)];
  const int n = n_vertices(mesh);
  return {vertices[0], vertices[1], vertices[2], n + edges[0], n + edges[1], n + edges[2]};
}

/// Appends the numbers of a triangle's unknowns. Those inside it are new.
/// @param n_inner  of each component.
void number_triangle(const Mesh& mesh, int order, int triangle, const std::array<int, 3>& n_inner,
                     SheetNumbering& sheet) {
  auto& [n_components, nodes, numbers] = sheet;
  const bool below = is_below_the_axis(mesh, triangle);
  const auto& corners = mesh.triangles[at(triangle)];
  for (int c = 0; c < n_components; ++c) {
    for (const int corner : corners) numbers.of_element.push_back(sheet.unknown(corner, c, below));
    for (std::size_t e = 0; e < 3; ++e) {
      const int edge = mesh.triangle_edges[at(triangle)][e];
      const bool is_forward = mesh.edges[at(edge)][0] == corners[e];
      const int first = n_vertices(mesh) + edge * (order - 1);
      for (int i = 0; i < order - 1; ++i)
        numbers.of_element.push_back(sheet.unknown(first + (is_forward ? i : order - 2 - i), c, below));
    }
    for (int i = 0; i < n_inner[at(c)]; ++i) numbers.of_element.push_back(numbers.n_unknowns++);
  }
}

/// The list of groups of a triangle, to be filled.
class GroupList {
 public:
  explicit GroupList(Numbering::Groups& groups) : groups_(&groups) {}
  void add(int group) { (*groups_)[n_++] = group; }

 private:
  Numbering::Groups* groups_;
  std::size_t n_ = 0;
};

/// Numbers all triangles, and gives a group to the inside of each.
/// @return the first of these groups, by triangle; -1 where nothing is inside.
std::vector<int> number_triangles(const Mesh& mesh, int order, const std::array<int, 3>& n_inner,
                                  SheetNumbering& sheet) {
  auto& numbers = sheet.numbers;
  numbers.of_element.reserve(mesh.triangles.size() * at(numbers.n_local));
  std::vector<int> inner(mesh.triangles.size(), -1);
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    const int first = numbers.n_unknowns;
    number_triangle(mesh, order, t, n_inner, sheet);
    if (numbers.n_unknowns == first) continue;
    inner[at(t)] = static_cast<int>(numbers.groups.size());
    numbers.groups.push_back({first, numbers.n_unknowns - first});
  }
  return inner;
}

Numbering::Groups no_groups() {
  Numbering::Groups groups{};
  groups.fill(-1);
  return groups;
}

}  // namespace

std::vector<int> nodes_of_edge(const Mesh& mesh, int order, int edge) {
  std::vector<int> nodes{mesh.edges[at(edge)][0]};
  for (int i = 0; i < order - 1; ++i) nodes.push_back(n_vertices(mesh) + edge * (order - 1) + i);
  nodes.push_back(mesh.edges[at(edge)][1]);
  return nodes;
}

SheetNumbering number_membrane(const Mesh& mesh, const ReferenceElement& element) {
  const int order = element.order();
  const auto held = nodes_on(mesh, order, Side::kFar);
  SheetNumbering sheet{2, std::vector<SheetNumbering::Node>(at(n_nodes(mesh, order))), {}};
  auto& numbers = sheet.numbers;
  numbers.n_local = 2 * element.n_lagrange();
  numbers.n_unknowns = 2 * n_nodes(mesh, order);
  for (const auto& [first, n] : entities_of(mesh, order)) {
    const bool is_held = held[at(first)] != 0;
    for (int node = first; node < first + n; ++node) {
      const int y = is_held ? -1 : 2 * node + 1;
      sheet.nodes[at(node)] = {is_held ? -1 : 2 * node, y, y, -1};
    }
    numbers.groups.push_back({2 * first, is_held ? 0 : 2 * n});
  }
  const int n_inner = element.n_lagrange() - element.n_boundary();
  const auto inner = number_triangles(mesh, order, {n_inner, n_inner, 0}, sheet);
  numbers.groups_of.assign(mesh.triangles.size(), no_groups());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    GroupList groups(numbers.groups_of[at(t)]);
    for (const int entity : entities_of_triangle(mesh, t)) groups.add(entity);
    if (inner[at(t)] >= 0) groups.add(inner[at(t)]);
  }
  return sheet;
}

SheetNumbering number_bending(const Mesh& mesh, const ReferenceElement& element, const std::vector<int>& triangles) {
  const int order = element.order();
  const auto cracked = nodes_on(mesh, order, Side::kCrack);
  SheetNumbering sheet{3, std::vector<SheetNumbering::Node>(at(n_nodes(mesh, order))), {}};
  auto& numbers = sheet.numbers;
  numbers.n_local = element.n_lagrange() + 2 * element.n_rotation();
  const auto entities = entities_of(mesh, order);
  std::vector<int> above(entities.size(), -1);  // group of theta_y on a crack; the one below it follows
  std::vector<Numbering::Group> split;
  for (std::size_t entity = 0; entity < entities.size(); ++entity) {
    // On a crack theta_y follows apart, above and below.
    const auto& [first, n] = entities[entity];
    const bool is_cracked = cracked[at(first)] != 0;
    const int stride = is_cracked ? 2 : 3;
    const int start = numbers.n_unknowns;
    for (int i = 0; i < n; ++i) {
      const int w = start + stride * i;
      const int theta_y = is_cracked ? start + 2 * n + i : w + 2;
      sheet.nodes[at(first + i)] = {w, w + 1, theta_y, is_cracked ? theta_y + n : theta_y};
    }
    numbers.groups.push_back({start, stride * n});
    numbers.n_unknowns += (is_cracked ? 4 : 3) * n;
    if (!is_cracked) continue;
    above[entity] = static_cast<int>(entities.size() + split.size());
    split.push_back({start + 2 * n, n});
    split.push_back({start + 3 * n, n});
  }
  numbers.groups.insert(numbers.groups.end(), split.begin(), split.end());
  const int n_bubbles = element.n_rotation() - element.n_boundary();
  const auto inner =
      number_triangles(mesh, order, {element.n_lagrange() - element.n_boundary(), n_bubbles, n_bubbles}, sheet);
  numbers.groups_of.assign(mesh.triangles.size(), no_groups());
  for (const int t : triangles) {
    GroupList groups(numbers.groups_of[at(t)]);
    for (const int entity : entities_of_triangle(mesh, t)) {
      groups.add(entity);
      if (above[at(entity)] >= 0) groups.add(above[at(entity)] + (is_below_the_axis(mesh, t) ? 1 : 0));
    }
    groups.add(inner[at(t)]);
  }
  return sheet;
}

}  // namespace brash::plate
