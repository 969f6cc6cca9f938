// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesh.hpp"

namespace brash::plate {

/// A nested dissection of the triangles of a mesh: they are divided again and again, along short cuts.
class Dissection {
 public:
  /// A set of triangles: `order[from]` to `order[to - 1]`, with two halves unless it is among the smallest.
  struct Part {
    int from = 0;
    int to = 0;
    int left = -1;
    int right = -1;
  };

  explicit Dissection(const Mesh& mesh);

  const std::vector<int>& order() const { return lists_.front(); }
  /// Halves before their whole.
  const std::vector<Part>& parts() const { return parts_; }

 private:
  static constexpr std::size_t kLists = 5;
  /// Where a list is cut, and how many edges of the mesh that cuts.
  struct Cut {
    int at = 0;
    int n_edges = 0;
  };

  int dissect(int from, int to);
  int divide(int from, int to);
  void find_shared_edges(int from, int to);
  Cut best_cut(const std::vector<int>& list, int from, int to);

  const Mesh* mesh_;
  std::array<std::vector<int>, kLists> lists_;  ///< the triangles of each part, sorted along different coordinates
  std::vector<Part> parts_;
  std::vector<char> is_shared_;  ///< whether two triangles of the present part have an edge
  std::vector<char> is_open_;    ///< whether an edge has one triangle before the present place
  std::vector<char> is_first_;   ///< whether a triangle is in the first half
  std::vector<int> second_;      ///< the second half of a list
};

}  // namespace brash::plate
