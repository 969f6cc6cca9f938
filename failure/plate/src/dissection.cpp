// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissection.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <utility>

namespace brash::plate {

namespace {

/// Parts of so many triangles are not divided any more: the fronts of single triangles cost more to add up.
constexpr int kSmallest = 2;
/// Least share of the smaller half. Cuts in the middle would be a third longer in work; less than 0.2 is worse again.
constexpr double kLeastShare = 0.3;
/// Parts of so many triangles are cut across x or y, the first two lists: others seldom help there.
constexpr int kSimple = 16;
constexpr std::size_t kPlainLists = 2;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Coordinates along which the triangles are sorted; small elements lie around the origin.
double coordinate(std::size_t list, Vec2 place) {
  switch (list) {
    case 0:
      return place.x;
    case 1:
      return place.y;
    case 2:
      return place.x + place.y;
    case 3:
      return place.x - place.y;
    default:
      return dot(place, place);
  }
}

}  // namespace

Dissection::Dissection(const Mesh& mesh)
    : mesh_(&mesh), is_shared_(mesh.edges.size(), 0), is_open_(mesh.edges.size(), 0), is_first_(mesh.triangles.size()) {
  const std::size_t n = mesh.triangles.size();
  std::vector<std::pair<double, int>> sorted(n);
  for (std::size_t list = 0; list < kLists; ++list) {
    for (int t = 0; t < static_cast<int>(n); ++t)
      sorted[at(t)] = {coordinate(list, place_in(mesh, t, 1.0 / 3.0, 1.0 / 3.0)), t};
    std::sort(sorted.begin(), sorted.end());
    lists_[list].reserve(n);
    for (const auto& [place, triangle] : sorted) lists_[list].push_back(triangle);
  }
  parts_.reserve(2 * n);
  if (n > 0) dissect(0, static_cast<int>(n));
}

int Dissection::dissect(int from, int to) {
  Part part{from, to};
  if (to - from > kSmallest) {
    const int middle = divide(from, to);
    part.left = dissect(from, middle);
    part.right = dissect(middle, to);
  }
  parts_.push_back(part);
  return static_cast<int>(parts_.size()) - 1;
}

/// Divides a part along the shortest cut. In every list the first half comes first.
/// @return where the second half begins.
int Dissection::divide(int from, int to) {
  find_shared_edges(from, to);
  Cut best{0, std::numeric_limits<int>::max()};
  const std::vector<int>* along = nullptr;
  for (const auto& list : lists_) {
    if (to - from <= kSimple && &list == &lists_[kPlainLists]) break;
    const Cut cut = best_cut(list, from, to);
    if (cut.n_edges >= best.n_edges) continue;
    best = cut;
    along = &list;
  }
  for (int i = from; i < to; ++i) is_first_[at((*along)[at(i)])] = i < best.at ? 1 : 0;
  for (auto& list : lists_) {
    second_.clear();
    auto first = list.begin() + from;
    for (int i = from; i < to; ++i) {
      const int triangle = list[at(i)];
      if (is_first_[at(triangle)] != 0)
        *first++ = triangle;
      else
        second_.push_back(triangle);
    }
    std::copy(second_.begin(), second_.end(), first);
  }
  return best.at;
}

/// Marks the edges that two triangles of a part share.
void Dissection::find_shared_edges(int from, int to) {
  const auto edges_of = [&](int i) -> const auto& { return mesh_->triangle_edges[at(lists_.front()[at(i)])]; };
  for (int i = from; i < to; ++i) {
    for (const int edge : edges_of(i)) {
      is_shared_[at(edge)] = is_open_[at(edge)];
      is_open_[at(edge)] = 1;
    }
  }
  for (int i = from; i < to; ++i) {
    for (const int edge : edges_of(i)) is_open_[at(edge)] = 0;
  }
}

Dissection::Cut Dissection::best_cut(const std::vector<int>& list, int from, int to) {
  const int n = to - from;
  const int least = std::max(1, static_cast<int>(kLeastShare * n));
  Cut best{0, std::numeric_limits<int>::max()};
  int n_open = 0;
  for (int place = from + 1; place <= to; ++place) {
    // A shared edge is open between its two triangles. Without branches, which nobody could foretell.
    for (const int edge : mesh_->triangle_edges[at(list[at(place - 1)])]) {
      const int is_shared = is_shared_[at(edge)];
      n_open += is_shared * (1 - 2 * is_open_[at(edge)]);
      is_open_[at(edge)] ^= static_cast<char>(is_shared);
    }
    if (place - from < least || to - place < least) continue;
    const int off = std::abs(2 * place - from - to);
    if (n_open < best.n_edges || (n_open == best.n_edges && off < std::abs(2 * best.at - from - to)))
      best = {place, n_open};
  }
  return best;
}

}  // namespace brash::plate
