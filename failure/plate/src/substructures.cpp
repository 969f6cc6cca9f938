// SPDX-License-Identifier: GPL-3.0-or-later
#include "substructures.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <memory>

#include "dense_front.hpp"

namespace brash::plate {

namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The groups in the order of elimination, which is their rank: part after part. Part p eliminates the ranks `first[p]`
/// to `first[p + 1] - 1`.
struct Ranks {
  std::vector<int> of_group;  ///< -1 where no triangle has it
  std::vector<int> first;
  std::vector<Numbering::Group> groups;  ///< by rank
};

/// The smallest part that holds all triangles between two places of the order.
int smallest_part(const Dissection& dissection, int first_place, int last_place) {
  const auto& parts = dissection.parts();
  int p = static_cast<int>(parts.size()) - 1;
  while (parts[at(p)].left >= 0) {
    const auto& part = parts[at(p)];
    const int middle = parts[at(part.left)].to;
    if (first_place < middle && last_place >= middle) break;
    p = last_place < middle ? part.left : part.right;
  }
  return p;
}

Ranks rank(const Dissection& dissection, const Numbering& numbering) {
  const std::size_t n = numbering.groups.size();
  std::vector<int> by_place;  // groups in the order in which triangles meet them: then neighbours have near ranks
  std::vector<int> first_place(n, -1);
  std::vector<int> last_place(n, -1);
  const auto& order = dissection.order();
  for (std::size_t place = 0; place < order.size(); ++place) {
    for (const int group : numbering.groups_of[at(order[place])]) {
      if (group < 0) break;
      if (first_place[at(group)] < 0) {
        first_place[at(group)] = static_cast<int>(place);
        by_place.push_back(group);
      }
      last_place[at(group)] = static_cast<int>(place);
    }
  }
  Ranks ranks{std::vector<int>(n, -1), std::vector<int>(dissection.parts().size() + 1, 0), {}};
  std::vector<int> eliminating(n, -1);
  for (const int group : by_place) {
    eliminating[at(group)] = smallest_part(dissection, first_place[at(group)], last_place[at(group)]);
    ++ranks.first[at(eliminating[at(group)] + 1)];
  }
  for (std::size_t p = 0; p + 1 < ranks.first.size(); ++p) ranks.first[p + 1] += ranks.first[p];
  ranks.groups.resize(by_place.size());
  std::vector<int> next(ranks.first.begin(), ranks.first.end() - 1);
  for (const int group : by_place) {
    const int r = next[at(eliminating[at(group)])]++;
    ranks.of_group[at(group)] = r;
    ranks.groups[at(r)] = numbering.groups[at(group)];
  }
  return ranks;
}

/// The system of a part. Its members are ranks: the groups that it eliminates, then those that it shares with triangles
/// outside it, ascending.
struct Front {
  int from = 0, rest = 0, to = 0;  ///< members [from, rest) and [rest, to)
  int n_own = 0, n_rest = 0;       ///< unknowns
  std::size_t factor = 0;          ///< where its columns of the factor begin

  int height() const { return n_own + n_rest + 1; }
  std::size_t size_of_left() const { return at(n_rest + 1) * at(n_rest); }
};

/// A stretch of unknowns of one front that lie together in another.
struct Run {
  int from = 0;
  int to = 0;
  int length = 0;
};

class Elimination {
 public:
  Elimination(const Dissection& dissection, const Numbering& numbering, const ElementStiffness& stiffness,
              std::vector<double>& load)
      : dissection_(&dissection),
        numbering_(&numbering),
        stiffness_(&stiffness),
        load_(&load),
        ranks_(rank(dissection, numbering)),
        fronts_(dissection.parts().size()),
        place_(at(numbering.n_unknowns)),
        element_(numbering.n_local, numbering.n_local) {
    std::size_t factor = 0;
    std::vector<std::size_t> needed(fronts_.size(), 0);  // of the workspace
    for (std::size_t p = 0; p < fronts_.size(); ++p) {
      build(p);
      fronts_[p].factor = factor;
      factor += at(fronts_[p].height()) * at(fronts_[p].n_own);
      const auto& part = dissection.parts()[p];
      needed[p] = fronts_[p].size_of_left();
      if (part.left >= 0) needed[p] += std::max(needed[at(part.left)], needed[at(part.right)]);
    }
    factor_.reset(new double[factor]);  // not set to 0
    workspace_.reset(new double[needed.empty() ? 0 : needed.back()]);
  }

  /// Replaces the load by the solution.
  bool solve() {
    if (fronts_.empty()) return true;
    if (!factorise(static_cast<int>(fronts_.size()) - 1, workspace_.get())) return false;
    std::vector<double> unknowns;
    for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) substitute_back(*front, unknowns);
    return true;
  }

 private:
  void build(std::size_t p) {
    const auto& part = dissection_->parts()[p];
    Front& front = fronts_[p];
    front.from = static_cast<int>(members_.size());
    if (part.left < 0) {
      for (int i = part.from; i < part.to; ++i) {
        for (const int group : numbering_->groups_of[at(dissection_->order()[at(i)])]) {
          if (group < 0) break;
          members_.push_back(ranks_.of_group[at(group)]);
        }
      }
      std::sort(members_.begin() + front.from, members_.end());
      members_.erase(std::unique(members_.begin() + front.from, members_.end()), members_.end());
    } else {
      const Front& left = fronts_[at(part.left)];
      const Front& right = fronts_[at(part.right)];
      union_.clear();
      std::set_union(members_.begin() + left.rest, members_.begin() + left.to, members_.begin() + right.rest,
                     members_.begin() + right.to, std::back_inserter(union_));
      members_.insert(members_.end(), union_.begin(), union_.end());
    }
    // Its own come first, because all others belong to a whole above it.
    front.rest = front.from + ranks_.first[p + 1] - ranks_.first[p];
    front.to = static_cast<int>(members_.size());
    for (int i = front.from; i < front.rest; ++i) front.n_own += group(i).size;
    for (int i = front.rest; i < front.to; ++i) front.n_rest += group(i).size;
  }

  const Numbering::Group& group(int member) const { return ranks_.groups[at(members_[at(member)])]; }

  /// Factorises a part and all below it. Its remainder comes to `left`, with the workspace behind.
  bool factorise(int p, double* left) {
    const Front& front = fronts_[at(p)];
    const auto& part = dissection_->parts()[at(p)];
    double* own = factor_.get() + front.factor;
    std::fill_n(own, at(front.height()) * at(front.n_own), 0.0);
    for (int j = 0; j < front.n_rest; ++j)  // the lower triangle
      std::fill(left + at(j) * at(front.n_rest + 1) + j, left + at(j + 1) * at(front.n_rest + 1), 0.0);
    add_load(front, own);
    if (part.left < 0) {
      add_triangles(part, front, own, left);
    } else {
      double* below = left + front.size_of_left();
      for (const int half : {part.left, part.right}) {
        if (!factorise(half, below)) return false;
        add_half(fronts_[at(half)], below, front, own, left);
      }
    }
    return eliminate(own, front.n_own, left, front.n_rest);
  }

  void add_load(const Front& front, double* own) const {
    const int height = front.height();
    double* target = own + height - 1;
    for (int i = front.from; i < front.rest; ++i) {
      const auto& [first, size] = group(i);
      for (int j = 0; j < size; ++j, target += height) *target = (*load_)[at(first + j)];
    }
  }

  void add_triangles(const Dissection::Part& part, const Front& front, double* own, double* left) {
    int place = 0;
    for (int i = front.from; i < front.to; ++i) {
      const auto& [first, size] = group(i);
      for (int j = 0; j < size; ++j) place_[at(first + j)] = place++;
    }
    for (int i = part.from; i < part.to; ++i) {
      const int triangle = dissection_->order()[at(i)];
      if (numbering_->groups_of[at(triangle)].front() >= 0) add_triangle(triangle, front, own, left);
    }
  }

  void add_triangle(int triangle, const Front& front, double* own, double* left) {
    (*stiffness_)(triangle, element_);
    const int* unknowns = numbering_->element(triangle);
    local_.assign(at(front.height()), -1);
    for (int i = 0; i < numbering_->n_local; ++i) {
      if (unknowns[i] >= 0) local_[at(place_[at(unknowns[i])])] = i;
    }
    rows_.clear();
    for (int place = 0; place < front.height(); ++place) {
      if (local_[at(place)] >= 0) rows_.emplace_back(place, local_[at(place)]);
    }
    for (std::size_t j = 0; j < rows_.size(); ++j) {
      double* target = column(front, own, left, rows_[j].first);
      const double* source = &element_(0, rows_[j].second);
      for (std::size_t i = j; i < rows_.size(); ++i) target[rows_[i].first] += source[rows_[i].second];
    }
  }

  /// Where the row 0 of a column of a front would be.
  static double* column(const Front& front, double* own, double* left, int j) {
    if (j < front.n_own) return own + static_cast<std::ptrdiff_t>(j) * front.height();
    return left + static_cast<std::ptrdiff_t>(j - front.n_own) * (front.n_rest + 1) - front.n_own;
  }

  static void add(const double* __restrict from, double* __restrict to, int n) {
    for (int i = 0; i < n; ++i) to[i] += from[i];
  }

  /// Adds to a front what its half left.
  void add_half(const Front& half, const double* source, const Front& front, double* own, double* left) {
    find_runs(half, front);
    for (std::size_t k = 0; k + 1 < runs_.size(); ++k) {
      for (int j = 0; j < runs_[k].length; ++j, source += half.n_rest + 1) {
        double* target = column(front, own, left, runs_[k].to + j);
        add(source + runs_[k].from + j, target + runs_[k].to + j, runs_[k].length - j);
        for (std::size_t l = k + 1; l < runs_.size(); ++l)
          add(source + runs_[l].from, target + runs_[l].to, runs_[l].length);
      }
    }
  }

  /// The runs of what a half left within its whole; the last one is the right-hand side.
  void find_runs(const Front& half, const Front& front) {
    runs_.clear();
    int i = front.from;
    int from = 0;
    int to = 0;
    for (int k = half.rest; k < half.to; ++k, ++i) {
      for (; members_[at(i)] != members_[at(k)]; ++i) to += group(i).size;
      const int size = group(k).size;
      if (!runs_.empty() && runs_.back().to + runs_.back().length == to)
        runs_.back().length += size;
      else
        runs_.push_back({from, to, size});
      from += size;
      to += size;
    }
    runs_.push_back({from, front.height() - 1, 1});
  }

  void substitute_back(const Front& front, std::vector<double>& unknowns) {
    if (front.n_own == 0) return;
    unknowns.resize(at(front.height()));
    double* value = unknowns.data() + front.n_own;
    for (int i = front.rest; i < front.to; ++i) {
      const auto& [first, size] = group(i);
      value = std::copy_n(load_->data() + first, size, value);
    }
    substitute(factor_.get() + front.factor, front.n_own, front.n_rest, unknowns.data());
    value = unknowns.data();
    for (int i = front.from; i < front.rest; ++i) {
      const auto& [first, size] = group(i);
      std::copy_n(value, size, load_->data() + first);
      value += size;
    }
  }

  const Dissection* dissection_;
  const Numbering* numbering_;
  const ElementStiffness* stiffness_;
  std::vector<double>* load_;
  Ranks ranks_;
  std::vector<Front> fronts_;
  std::vector<int> members_;  ///< ranks of the groups of all fronts
  std::unique_ptr<double[]> factor_;
  std::unique_ptr<double[]> workspace_;
  std::vector<int> place_;                 ///< of an unknown in the present front
  std::vector<int> local_;                 ///< the unknown of the present triangle at each place; -1: none
  std::vector<std::pair<int, int>> rows_;  ///< of the present triangle: places, ascending, and local unknowns
  std::vector<int> union_;
  std::vector<Run> runs_;
  Eigen::MatrixXd element_;
};

}  // namespace

bool solve_by_parts(const Dissection& dissection, const Numbering& numbering, const ElementStiffness& stiffness,
                    std::vector<double>& load) {
  return Elimination(dissection, numbering, stiffness, load).solve();
}

}  // namespace brash::plate
