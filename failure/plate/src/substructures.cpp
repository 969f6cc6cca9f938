// SPDX-License-Identifier: GPL-3.0-or-later
#include "substructures.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace brash::plate {

namespace {

/// Parts of so many triangles are not halved any more: the fronts of single triangles cost more to add up.
constexpr int kSmallest = 2;

/// Directions across which a set of triangles is halved.
constexpr std::array<Vec2, 4> kDirections{{{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}};

/// The order of elimination: part after part. The unknowns that part p eliminates have the ranks `first[p]` to
/// `first[p + 1] - 1`.
struct Ranks {
  std::vector<int> of_unknown;  ///< -1 where no triangle has it
  std::vector<int> first;
};

Ranks rank(const Dissection& dissection, const Numbering& numbering) {
  const auto n = static_cast<std::size_t>(numbering.n_unknowns);
  std::vector<int> first_place(n, std::numeric_limits<int>::max());
  std::vector<int> last_place(n, -1);
  const auto& order = dissection.order();
  for (std::size_t place = 0; place < order.size(); ++place) {
    const int* unknowns = numbering.element(order[place]);
    for (int i = 0; i < numbering.n_local; ++i) {
      if (unknowns[i] < 0) continue;
      const auto u = static_cast<std::size_t>(unknowns[i]);
      first_place[u] = std::min(first_place[u], static_cast<int>(place));
      last_place[u] = static_cast<int>(place);
    }
  }
  // The smallest part that holds all triangles of an unknown eliminates it.
  const auto& parts = dissection.parts();
  std::vector<int> eliminating(n, -1);
  Ranks ranks{std::vector<int>(n, -1), std::vector<int>(parts.size() + 1, 0)};
  for (std::size_t u = 0; u < n; ++u) {
    if (last_place[u] < 0) continue;
    int p = static_cast<int>(parts.size()) - 1;
    for (;;) {
      const auto& part = parts[static_cast<std::size_t>(p)];
      if (part.left < 0) break;
      const int middle = parts[static_cast<std::size_t>(part.left)].to;
      if (first_place[u] < middle && last_place[u] >= middle) break;
      p = last_place[u] < middle ? part.left : part.right;
    }
    eliminating[u] = p;
    ++ranks.first[static_cast<std::size_t>(p) + 1];
  }
  for (std::size_t p = 0; p < parts.size(); ++p) ranks.first[p + 1] += ranks.first[p];
  std::vector<int> next(ranks.first.begin(), ranks.first.end() - 1);
  for (std::size_t u = 0; u < n; ++u) {
    if (eliminating[u] >= 0) ranks.of_unknown[u] = next[static_cast<std::size_t>(eliminating[u])]++;
  }
  return ranks;
}

/// The unknowns of a part by rank: those that it eliminates, then those that it shares with triangles outside it.
struct Front {
  int first = 0;
  int n_eliminated = 0;
  std::vector<int> rest;   ///< ascending
  std::size_t factor = 0;  ///< its columns of the factor, shape=(n_eliminated + rest.size(), n_eliminated)
};

using Block = Eigen::Map<Eigen::MatrixXd>;
using ConstBlock = Eigen::Map<const Eigen::MatrixXd>;

/// Symbolic and numerical factorisation. What a part leaves for its whole lies on a stack, because halves come just
/// before their whole.
class Elimination {
 public:
  Elimination(const Dissection& dissection, const Numbering& numbering, const ElementStiffness& stiffness)
      : dissection_(&dissection),
        numbering_(&numbering),
        stiffness_(&stiffness),
        ranks_(rank(dissection, numbering)),
        fronts_(dissection.parts().size()),
        place_(static_cast<std::size_t>(numbering.n_unknowns)),
        element_(numbering.n_local, numbering.n_local) {
    std::size_t top = 0;
    std::size_t highest = 0;
    std::size_t factor = 0;
    for (std::size_t p = 0; p < fronts_.size(); ++p) {
      build(p);
      Front& front = fronts_[p];
      front.factor = factor;
      factor += (static_cast<std::size_t>(front.n_eliminated) + front.rest.size()) *
                static_cast<std::size_t>(front.n_eliminated);
      top += front.rest.size() * front.rest.size();
      highest = std::max(highest, top);
      const auto& part = dissection.parts()[p];
      if (part.left < 0) continue;
      for (const int half : {part.left, part.right}) {
        const std::size_t n = fronts_[static_cast<std::size_t>(half)].rest.size();
        top -= n * n;
      }
    }
    factor_.resize(factor);
    stack_.resize(highest);
  }

  bool factorise() {
    for (std::size_t p = 0; p < fronts_.size(); ++p) {
      if (!eliminate(p)) return false;
    }
    return true;
  }

  void substitute(Eigen::MatrixXd& load) const {
    Eigen::MatrixXd ranked(ranks_.first.back(), load.cols());
    const auto& rank_of = ranks_.of_unknown;
    for (std::size_t u = 0; u < rank_of.size(); ++u) {
      if (rank_of[u] >= 0) ranked.row(rank_of[u]) = load.row(static_cast<Eigen::Index>(u));
    }
    for (const Front& front : fronts_) forward(front, ranked);
    for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) backward(*front, ranked);
    for (std::size_t u = 0; u < rank_of.size(); ++u) {
      if (rank_of[u] >= 0) load.row(static_cast<Eigen::Index>(u)) = ranked.row(rank_of[u]);
    }
  }

 private:
  void build(std::size_t p) {
    const auto& part = dissection_->parts()[p];
    Front& front = fronts_[p];
    front.first = ranks_.first[p];
    front.n_eliminated = ranks_.first[p + 1] - front.first;
    if (part.left < 0) {
      for (int i = part.from; i < part.to; ++i) {
        const int* unknowns = numbering_->element(dissection_->order()[static_cast<std::size_t>(i)]);
        for (int j = 0; j < numbering_->n_local; ++j) {
          if (unknowns[j] >= 0) front.rest.push_back(ranks_.of_unknown[static_cast<std::size_t>(unknowns[j])]);
        }
      }
      std::sort(front.rest.begin(), front.rest.end());
      front.rest.erase(std::unique(front.rest.begin(), front.rest.end()), front.rest.end());
    } else {
      const auto& left = fronts_[static_cast<std::size_t>(part.left)].rest;
      const auto& right = fronts_[static_cast<std::size_t>(part.right)].rest;
      front.rest.reserve(left.size() + right.size());
      std::set_union(left.begin(), left.end(), right.begin(), right.end(), std::back_inserter(front.rest));
    }
    // Its own come first, because all others belong to a whole above it.
    front.rest.erase(front.rest.begin(), front.rest.begin() + front.n_eliminated);
  }

  bool eliminate(std::size_t p) {
    const auto& part = dissection_->parts()[p];
    const Front& front = fronts_[p];
    const auto rest = static_cast<Eigen::Index>(front.rest.size());
    const Eigen::Index k = front.n_eliminated;
    for (Eigen::Index i = 0; i < k; ++i) place_[static_cast<std::size_t>(front.first + i)] = static_cast<int>(i);
    for (std::size_t i = 0; i < front.rest.size(); ++i) {
      place_[static_cast<std::size_t>(front.rest[i])] = static_cast<int>(i) + front.n_eliminated;
    }
    Block own(factor_.data() + front.factor, k + rest, k);
    std::fill_n(stack_.begin() + static_cast<std::ptrdiff_t>(top_), rest * rest, 0.0);
    Block left(stack_.data() + top_, rest, rest);
    std::size_t below = top_;
    if (part.left < 0) {
      for (int i = part.from; i < part.to; ++i) {
        add_element(dissection_->order()[static_cast<std::size_t>(i)], own, left);
      }
    } else {
      for (const int half : {part.right, part.left})
        below = add_half(fronts_[static_cast<std::size_t>(half)], below, own, left);
    }
    if (k > 0) {
      auto pivot = own.topRows(k);
      Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(pivot);
      if (cholesky.info() != Eigen::Success) return false;
      if (rest > 0) {
        auto coupling = own.bottomRows(rest);
        pivot.triangularView<Eigen::Lower>().transpose().solveInPlace<Eigen::OnTheRight>(coupling);
        left.selfadjointView<Eigen::Lower>().rankUpdate(coupling, -1.0);
      }
    }
    if (below < top_)
      std::copy_n(stack_.begin() + static_cast<std::ptrdiff_t>(top_), rest * rest,
                  stack_.begin() + static_cast<std::ptrdiff_t>(below));
    top_ = below + static_cast<std::size_t>(rest * rest);
    return true;
  }

  void add_element(int triangle, Block& own, Block& left) {
    (*stiffness_)(triangle, element_);
    const int* unknowns = numbering_->element(triangle);
    rows_.resize(static_cast<std::size_t>(numbering_->n_local));
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      rows_[i] = unknowns[i] < 0
                     ? -1
                     : place_[static_cast<std::size_t>(ranks_.of_unknown[static_cast<std::size_t>(unknowns[i])])];
    }
    const auto k = static_cast<int>(own.cols());
    for (int j = 0; j < numbering_->n_local; ++j) {
      const int column = rows_[static_cast<std::size_t>(j)];
      if (column < 0) continue;
      double* target = column < k ? &own(0, column) : &left(0, column - k) - k;
      for (int i = 0; i < numbering_->n_local; ++i) {
        const int row = rows_[static_cast<std::size_t>(i)];
        if (row >= column) target[row] += element_(i, j);
      }
    }
  }

  /// Adds what a half left, which ends at `end` of the stack, and says where it began.
  std::size_t add_half(const Front& half, std::size_t end, Block& own, Block& left) {
    const std::size_t n = half.rest.size();
    const std::size_t begin = end - n * n;
    rows_.resize(n);
    for (std::size_t i = 0; i < n; ++i) rows_[i] = place_[static_cast<std::size_t>(half.rest[i])];
    const auto k = static_cast<int>(own.cols());
    for (std::size_t j = 0; j < n; ++j) {
      const int column = rows_[j];
      double* target = column < k ? &own(0, column) : &left(0, column - k) - k;
      const double* source = stack_.data() + begin + j * n;
      for (std::size_t i = j; i < n; ++i) target[rows_[i]] += source[i];
    }
    return begin;
  }

  void forward(const Front& front, Eigen::MatrixXd& load) const {
    const auto rest = static_cast<Eigen::Index>(front.rest.size());
    const Eigen::Index k = front.n_eliminated;
    if (k == 0) return;
    const ConstBlock factor(factor_.data() + front.factor, k + rest, k);
    auto own = load.middleRows(front.first, k);
    factor.topRows(k).triangularView<Eigen::Lower>().solveInPlace(own);
    const Eigen::MatrixXd update = factor.bottomRows(rest) * own;
    for (Eigen::Index i = 0; i < rest; ++i) load.row(front.rest[static_cast<std::size_t>(i)]) -= update.row(i);
  }

  void backward(const Front& front, Eigen::MatrixXd& load) const {
    const auto rest = static_cast<Eigen::Index>(front.rest.size());
    const Eigen::Index k = front.n_eliminated;
    if (k == 0) return;
    const ConstBlock factor(factor_.data() + front.factor, k + rest, k);
    Eigen::MatrixXd known(rest, load.cols());
    for (Eigen::Index i = 0; i < rest; ++i) known.row(i) = load.row(front.rest[static_cast<std::size_t>(i)]);
    auto own = load.middleRows(front.first, k);
    own.noalias() -= factor.bottomRows(rest).transpose() * known;
    factor.topRows(k).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
  }

  const Dissection* dissection_;
  const Numbering* numbering_;
  const ElementStiffness* stiffness_;
  Ranks ranks_;
  std::vector<Front> fronts_;
  std::vector<double> factor_;
  std::vector<double> stack_;
  std::size_t top_ = 0;
  std::vector<int> place_;  ///< of a rank in the present front
  std::vector<int> rows_;
  Eigen::MatrixXd element_;
};

}  // namespace

Dissection::Dissection(const Mesh& mesh, std::vector<int> triangles)
    : order_(std::move(triangles)), side_of_edge_(mesh.edges.size(), 0) {
  centres_.reserve(mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    centres_.push_back(mesh.vertices[static_cast<std::size_t>(t[0])] + mesh.vertices[static_cast<std::size_t>(t[1])] +
                       mesh.vertices[static_cast<std::size_t>(t[2])]);
  }
  parts_.reserve(2 * order_.size());
  if (!order_.empty()) dissect(mesh, 0, static_cast<int>(order_.size()));
}

int Dissection::dissect(const Mesh& mesh, int from, int to) {
  Part part{from, to};
  if (to - from > kSmallest) {
    halve(mesh, from, to);
    part.left = dissect(mesh, from, (from + to) / 2);
    part.right = dissect(mesh, (from + to) / 2, to);
  }
  parts_.push_back(part);
  return static_cast<int>(parts_.size()) - 1;
}

/// Orders the triangles so that few edges join the first half and the second.
void Dissection::halve(const Mesh& mesh, int from, int to) {
  const auto begin = order_.begin() + from;
  const auto middle = order_.begin() + (from + to) / 2;
  const auto end = order_.begin() + to;
  std::vector<int> best;
  int fewest = std::numeric_limits<int>::max();
  for (const Vec2 direction : kDirections) {
    std::nth_element(begin, middle, end, [&](int a, int b) {
      const double there = dot(centres_[static_cast<std::size_t>(a)], direction);
      const double here = dot(centres_[static_cast<std::size_t>(b)], direction);
      return there < here || (there == here && a < b);
    });
    for (auto it = begin; it != middle; ++it) {
      for (const int edge : mesh.triangle_edges[static_cast<std::size_t>(*it)])
        side_of_edge_[static_cast<std::size_t>(edge)] = 1;
    }
    int cut = 0;
    for (auto it = middle; it != end; ++it) {
      for (const int edge : mesh.triangle_edges[static_cast<std::size_t>(*it)])
        cut += side_of_edge_[static_cast<std::size_t>(edge)];
    }
    for (auto it = begin; it != middle; ++it) {
      for (const int edge : mesh.triangle_edges[static_cast<std::size_t>(*it)])
        side_of_edge_[static_cast<std::size_t>(edge)] = 0;
    }
    if (cut >= fewest) continue;
    fewest = cut;
    best.assign(begin, end);
  }
  std::copy(best.begin(), best.end(), begin);
}

bool solve_by_parts(const Dissection& dissection, const Numbering& numbering, const ElementStiffness& stiffness,
                    Eigen::MatrixXd& load) {
  Elimination elimination(dissection, numbering, stiffness);
  if (!elimination.factorise()) return false;
  elimination.substitute(load);
  return true;
}

}  // namespace brash::plate
