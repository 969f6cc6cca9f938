// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "element.hpp"
#include "mesh.hpp"
#include "substructures.hpp"

namespace brash::plate {

/// The unknowns of a sheet: numbers on the nodes, where loads act, and on the triangles.
struct SheetNumbering {
  /// Components of a node, the last one again as it is below a crack; -1 where held at zero.
  using Node = std::array<int, 4>;

  int n_components = 0;
  std::vector<Node> nodes;  ///< vertices, then order - 1 nodes an edge
  Numbering numbers;

  int unknown(int node, int component, bool below) const {
    return nodes[static_cast<std::size_t>(node)]
                [static_cast<std::size_t>(below && component + 1 == n_components ? n_components : component)];
  }
};

/// Plane stress: components x and y, held on the edges tagged kFar.
SheetNumbering number_membrane(const Mesh& mesh, const ReferenceElement& element);

/// Components w, theta_x, theta_y. Below the edges tagged kCrack, which lie on the x-axis, theta_y has numbers of its
/// own.
///
/// @param triangles  those that bend.
SheetNumbering number_bending(const Mesh& mesh, const ReferenceElement& element, const std::vector<int>& triangles);

/// Nodes of an edge, end to end.
std::vector<int> nodes_of_edge(const Mesh& mesh, int order, int edge);

}  // namespace brash::plate
