// SPDX-License-Identifier: GPL-3.0-or-later
#include "substructures.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

namespace brash::plate {

namespace {

/// Parts of so many triangles are not halved any more: the fronts of single triangles cost more to add up.
constexpr int kSmallest = 2;

/// Directions across which a set of triangles is halved.
constexpr std::array<Vec2, 4> kDirections{{{1.0, 0.0}, {0.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}};

/// The unknowns of a part: those that it eliminates, then those that it shares with triangles outside it.
struct Front {
  std::vector<int> unknowns;
  int n_eliminated = 0;
  std::size_t factor = 0;  ///< its columns of the factor, shape=(unknowns.size(), n_eliminated)
};

/// Symbolic factorisation: the fronts of all parts, and the memory that the numbers need.
class Fronts {
 public:
  Fronts(const Dissection& dissection, const Numbering& numbering)
      : first_(static_cast<std::size_t>(numbering.n_unknowns), std::numeric_limits<int>::max()),
        last_(static_cast<std::size_t>(numbering.n_unknowns), -1),
        seen_(static_cast<std::size_t>(numbering.n_unknowns), -1) {
    const auto& order = dissection.order();
    for (std::size_t place = 0; place < order.size(); ++place) {
      const int* unknowns = numbering.element(order[place]);
      for (int i = 0; i < numbering.n_local; ++i) {
        if (unknowns[i] < 0) continue;
        const auto u = static_cast<std::size_t>(unknowns[i]);
        first_[u] = std::min(first_[u], static_cast<int>(place));
        last_[u] = static_cast<int>(place);
      }
    }
    const auto& parts = dissection.parts();
    all_.resize(parts.size());
    for (std::size_t p = 0; p < parts.size(); ++p) build(dissection, numbering, p);
  }

  const Front& of(std::size_t part) const { return all_[part]; }
  std::size_t factor_size() const { return factor_size_; }
  std::size_t largest() const { return largest_; }

 private:
  void build(const Dissection& dissection, const Numbering& numbering, std::size_t p) {
    const auto& part = dissection.parts()[p];
    candidates_.clear();
    const auto add = [&](int unknown) {
      if (unknown < 0 || seen_[static_cast<std::size_t>(unknown)] == static_cast<int>(p)) return;
      seen_[static_cast<std::size_t>(unknown)] = static_cast<int>(p);
      candidates_.push_back(unknown);
    };
    if (part.left < 0) {
      for (int i = part.from; i < part.to; ++i) {
        const int* unknowns = numbering.element(dissection.order()[static_cast<std::size_t>(i)]);
        std::for_each(unknowns, unknowns + numbering.n_local, add);
      }
    } else {
      for (const int half : {part.left, part.right}) {
        const Front& front = all_[static_cast<std::size_t>(half)];
        std::for_each(front.unknowns.begin() + front.n_eliminated, front.unknowns.end(), add);
      }
    }
    Front& front = all_[p];
    front.unknowns.reserve(candidates_.size());
    const auto is_inside = [&](int u) {
      return first_[static_cast<std::size_t>(u)] >= part.from && last_[static_cast<std::size_t>(u)] < part.to;
    };
    std::copy_if(candidates_.begin(), candidates_.end(), std::back_inserter(front.unknowns), is_inside);
    front.n_eliminated = static_cast<int>(front.unknowns.size());
    std::remove_copy_if(candidates_.begin(), candidates_.end(), std::back_inserter(front.unknowns), is_inside);
    front.factor = factor_size_;
    factor_size_ += front.unknowns.size() * static_cast<std::size_t>(front.n_eliminated);
    largest_ = std::max(largest_, front.unknowns.size());
  }

  std::vector<Front> all_;
  std::vector<int> first_, last_, seen_;  ///< of each unknown: first and last place in the order; last part that saw it
  std::vector<int> candidates_;
  std::size_t factor_size_ = 0;
  std::size_t largest_ = 0;
};

using Block = Eigen::Map<Eigen::MatrixXd>;

/// The numbers: fronts live on a stack, because halves come just before their whole.
class Elimination {
 public:
  Elimination(const Dissection& dissection, const Numbering& numbering, const ElementStiffness& stiffness)
      : dissection_(&dissection),
        numbering_(&numbering),
        stiffness_(&stiffness),
        fronts_(dissection, numbering),
        factor_(fronts_.factor_size()),
        place_(static_cast<std::size_t>(numbering.n_unknowns)),
        element_(numbering.n_local, numbering.n_local) {}

  bool factorise() {
    for (std::size_t p = 0; p < dissection_->parts().size(); ++p) {
      if (!eliminate(p)) return false;
    }
    return true;
  }

  void substitute(Eigen::MatrixXd& load) const {
    const std::size_t n_parts = dissection_->parts().size();
    for (std::size_t p = 0; p < n_parts; ++p) forward(p, load);
    for (std::size_t p = n_parts; p-- > 0;) backward(p, load);
  }

 private:
  bool eliminate(std::size_t p) {
    const auto& part = dissection_->parts()[p];
    const Front& front = fronts_.of(p);
    const auto n = static_cast<Eigen::Index>(front.unknowns.size());
    const Eigen::Index k = front.n_eliminated;
    for (Eigen::Index i = 0; i < n; ++i)
      place_[static_cast<std::size_t>(front.unknowns[static_cast<std::size_t>(i)])] = static_cast<int>(i);
    if (work_.size() < static_cast<std::size_t>(n * n)) work_.resize(static_cast<std::size_t>(n * n));
    std::fill_n(work_.begin(), n * n, 0.0);
    Block matrix(work_.data(), n, n);
    if (part.left < 0) {
      for (int i = part.from; i < part.to; ++i) add_element(dissection_->order()[static_cast<std::size_t>(i)], matrix);
    } else {
      add_half(part.right, matrix);
      add_half(part.left, matrix);
    }
    if (k > 0) {
      auto pivot = matrix.topLeftCorner(k, k);
      Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> cholesky(pivot);
      if (cholesky.info() != Eigen::Success) return false;
      if (n > k) {
        auto below = matrix.bottomLeftCorner(n - k, k);
        pivot.triangularView<Eigen::Lower>().transpose().template solveInPlace<Eigen::OnTheRight>(below);
        matrix.bottomRightCorner(n - k, n - k).selfadjointView<Eigen::Lower>().rankUpdate(below, -1.0);
      }
      std::copy_n(matrix.data(), n * k, factor_.begin() + static_cast<std::ptrdiff_t>(front.factor));
    }
    // The rest, packed by columns of its lower triangle.
    for (Eigen::Index j = k; j < n; ++j) stack_.insert(stack_.end(), &matrix(j, j), &matrix(j, j) + (n - j));
    return true;
  }

  void add_element(int triangle, Block& matrix) {
    (*stiffness_)(triangle, element_);
    const int* unknowns = numbering_->element(triangle);
    for (int j = 0; j < numbering_->n_local; ++j) {
      if (unknowns[j] < 0) continue;
      const int column = place_[static_cast<std::size_t>(unknowns[j])];
      for (int i = 0; i < numbering_->n_local; ++i) {
        if (unknowns[i] < 0) continue;
        const int row = place_[static_cast<std::size_t>(unknowns[i])];
        if (row >= column) matrix(row, column) += element_(i, j);
      }
    }
  }

  /// Takes what a half left on top of the stack.
  void add_half(int half, Block& matrix) {
    const Front& front = fronts_.of(static_cast<std::size_t>(half));
    const auto n = front.unknowns.size() - static_cast<std::size_t>(front.n_eliminated);
    rows_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      rows_[i] = place_[static_cast<std::size_t>(front.unknowns[i + static_cast<std::size_t>(front.n_eliminated)])];
    }
    const std::size_t start = stack_.size() - n * (n + 1) / 2;
    const double* entry = stack_.data() + start;
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t i = j; i < n; ++i, ++entry) {
        const auto [column, row] = std::minmax(rows_[i], rows_[j]);
        matrix(row, column) += *entry;
      }
    }
    stack_.resize(start);
  }

  void forward(std::size_t p, Eigen::MatrixXd& load) const {
    const Front& front = fronts_.of(p);
    const auto n = static_cast<Eigen::Index>(front.unknowns.size());
    const Eigen::Index k = front.n_eliminated;
    if (k == 0) return;
    const Eigen::Map<const Eigen::MatrixXd> factor(factor_.data() + front.factor, n, k);
    Eigen::MatrixXd own = load(Eigen::Map<const Eigen::VectorXi>(front.unknowns.data(), k), Eigen::all);
    factor.topRows(k).triangularView<Eigen::Lower>().solveInPlace(own);
    for (Eigen::Index i = 0; i < k; ++i) load.row(front.unknowns[static_cast<std::size_t>(i)]) = own.row(i);
    const Eigen::MatrixXd rest = factor.bottomRows(n - k) * own;
    for (Eigen::Index i = k; i < n; ++i) load.row(front.unknowns[static_cast<std::size_t>(i)]) -= rest.row(i - k);
  }

  void backward(std::size_t p, Eigen::MatrixXd& load) const {
    const Front& front = fronts_.of(p);
    const auto n = static_cast<Eigen::Index>(front.unknowns.size());
    const Eigen::Index k = front.n_eliminated;
    if (k == 0) return;
    const Eigen::Map<const Eigen::MatrixXd> factor(factor_.data() + front.factor, n, k);
    const Eigen::MatrixXd all = load(Eigen::Map<const Eigen::VectorXi>(front.unknowns.data(), n), Eigen::all);
    Eigen::MatrixXd own = all.topRows(k);
    own.noalias() -= factor.bottomRows(n - k).transpose() * all.bottomRows(n - k);
    factor.topRows(k).triangularView<Eigen::Lower>().transpose().solveInPlace(own);
    for (Eigen::Index i = 0; i < k; ++i) load.row(front.unknowns[static_cast<std::size_t>(i)]) = own.row(i);
  }

  const Dissection* dissection_;
  const Numbering* numbering_;
  const ElementStiffness* stiffness_;
  Fronts fronts_;
  std::vector<double> factor_;
  std::vector<double> stack_;
  std::vector<double> work_;
  std::vector<int> place_;  ///< of an unknown in the present front
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
