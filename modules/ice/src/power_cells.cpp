// SPDX-License-Identifier: GPL-3.0-or-later
#include "power_cells.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"

namespace brash::ice {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel, CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, CGAL::Regular_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Regular_triangulation_2<Kernel, Structure>;

/// Below this number of sites all pairs are neighbours: a triangulation of a few may have no face.
constexpr std::size_t kFew = 16;
constexpr std::size_t kBorder = static_cast<std::size_t>(-1);

using Neighbours = std::vector<std::vector<std::size_t>>;

Neighbours neighbours_of(const std::vector<Site>& sites) {
  Neighbours result(sites.size());
  if (sites.size() <= kFew) {
    for (std::size_t i = 0; i < sites.size(); ++i)
      for (std::size_t j = 0; j < sites.size(); ++j)
        if (i != j) result[i].push_back(j);
    return result;
  }
  std::vector<std::pair<Triangulation::Weighted_point, std::size_t>> points;
  for (std::size_t i = 0; i < sites.size(); ++i)
    points.emplace_back(
        Triangulation::Weighted_point(Kernel::Point_2(sites[i].place.x, sites[i].place.y), sites[i].weight), i);
  const Triangulation triangulation(points.begin(), points.end());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
    const std::size_t a = edge->first->vertex(Triangulation::cw(edge->second))->info();
    const std::size_t b = edge->first->vertex(Triangulation::ccw(edge->second))->info();
    result[a].push_back(b);
    result[b].push_back(a);
  }
  for (std::vector<std::size_t>& list : result) std::ranges::sort(list);
  return result;
}

/// A cell, with the site beyond each side.
struct Cell {
  std::vector<Vec2> ring;
  std::vector<std::size_t> beyond;  ///< of the side from a vertex to the next
};

/// Keeps the part of a cell where dot(normal, x) <= bound.
void clip(Cell& cell, Vec2 normal, double bound, std::size_t site) {
  Cell kept;
  const std::size_t n = cell.ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = cell.ring[i], b = cell.ring[(i + 1) % n];
    const double at_a = dot(normal, a) - bound, at_b = dot(normal, b) - bound;
    const auto crossing = [&] { return a + (at_a / (at_a - at_b)) * (b - a); };
    if (at_a <= 0.0) {
      kept.ring.push_back(a);
      kept.beyond.push_back(cell.beyond[i]);
      if (at_b <= 0.0) continue;
      kept.ring.push_back(crossing());
      kept.beyond.push_back(site);
    } else if (at_b < 0.0) {
      kept.ring.push_back(crossing());
      kept.beyond.push_back(cell.beyond[i]);
    }
  }
  cell = std::move(kept);
}

Cell cell_of(const Domain& domain, const std::vector<Site>& sites, std::size_t i,
             const std::vector<std::size_t>& neighbours) {
  const double half = 0.5 * domain.width;
  Cell cell{{{0.0, -half}, {domain.length, -half}, {domain.length, half}, {0.0, half}},
            std::vector<std::size_t>(4, kBorder)};
  const Site& own = sites[i];
  for (const std::size_t j : neighbours) {
    const Site& other = sites[j];
    const Vec2 way = other.place - own.place;
    const double bound = dot(way, own.place) + 0.5 * (dot(way, way) + own.weight - other.weight);
    clip(cell, way, bound, j);
  }
  return cell;
}

std::vector<Cell> diagram(const Domain& domain, const std::vector<Site>& sites) {
  const Neighbours neighbours = neighbours_of(sites);
  std::vector<Cell> cells;
  cells.reserve(sites.size());
  for (std::size_t i = 0; i < sites.size(); ++i) cells.push_back(cell_of(domain, sites, i, neighbours[i]));
  return cells;
}

/// Area of each cell less the wanted one, over the wanted one.
struct Misfit {
  Eigen::VectorXd areas;  ///< [m2]
  double largest = 0.0;   ///< of their sizes over the wanted areas [-]
  double least = 1.0;     ///< least area over the wanted one [-]
};

Misfit misfit_of(const std::vector<Cell>& cells, std::span<const double> wanted) {
  Misfit misfit{.areas = Eigen::VectorXd(static_cast<Eigen::Index>(cells.size()))};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double area = area_of(cells[i].ring), error = area - wanted[i];
    misfit.areas[static_cast<Eigen::Index>(i)] = error;
    misfit.largest = std::max(misfit.largest, std::abs(error) / wanted[i]);
    misfit.least = std::min(misfit.least, area / wanted[i]);
  }
  return misfit;
}

/// The step of the weights that Newton's method makes: the derivative of an area by the weight of a neighbour is the
/// length of their common side over twice the distance of the sites, negative. (F4)
Eigen::VectorXd newton_step(const std::vector<Site>& sites, const std::vector<Cell>& cells, const Misfit& misfit) {
  const auto n = static_cast<Eigen::Index>(sites.size()) - 1;  // the last weight stays: only differences count
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n + 1);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const Cell& cell = cells[i];
    for (std::size_t s = 0; s < cell.ring.size(); ++s) {
      const std::size_t j = cell.beyond[s];
      if (j == kBorder || j < i) continue;
      const double side = norm(cell.ring[(s + 1) % cell.ring.size()] - cell.ring[s]);
      const double rate = side / (2.0 * norm(sites[j].place - sites[i].place));
      const auto row = static_cast<Eigen::Index>(i), column = static_cast<Eigen::Index>(j);
      diagonal[row] += rate;
      diagonal[column] += rate;
      if (column < n) entries.emplace_back(column, row, -rate);
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) entries.emplace_back(i, i, diagonal[i]);
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  BRASH_EXPECTS(solver.info() == Eigen::Success, n);
  Eigen::VectorXd step(n + 1);
  step << -solver.solve(misfit.areas.head(n)), 0.0;
  return step;
}

}  // namespace

double area_of(std::span<const Vec2> ring) {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) twice += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice;
}

Vec2 centroid_of(std::span<const Vec2> ring) {
  double twice = 0.0;
  Vec2 moment{};
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const double part = cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
    twice += part;
    moment = moment + (part / 3.0) * ((ring[i] - ring[0]) + (ring[i + 1] - ring[0]));
  }
  return ring[0] + (1.0 / twice) * moment;
}

std::vector<std::vector<Vec2>> cells_of_areas(const Domain& domain, std::vector<Site> sites,
                                              std::span<const double> areas) {
  constexpr int kMostSteps = 100;
  constexpr double kShortest = 1e-6;  // of a Newton step
  std::vector<Cell> cells = diagram(domain, sites);
  Misfit misfit = misfit_of(cells, areas);
  const double least = 0.5 * misfit.least;  // no cell may vanish on the way
  BRASH_EXPECTS(least > 0.0, least);
  for (int n = 0; misfit.largest > kAreaError && sites.size() > 1; ++n) {
    BRASH_EXPECTS(n < kMostSteps, misfit.largest);
    const Eigen::VectorXd step = newton_step(sites, cells, misfit);
    for (double share = 1.0;; share *= 0.5) {
      look_for_interruption();
      BRASH_EXPECTS(share > kShortest, misfit.largest);
      std::vector<Site> tried = sites;
      for (std::size_t i = 0; i < tried.size(); ++i) tried[i].weight += share * step[static_cast<Eigen::Index>(i)];
      std::vector<Cell> moved = diagram(domain, tried);
      Misfit then = misfit_of(moved, areas);
      if (then.least < least || then.areas.norm() > (1.0 - 0.5 * share) * misfit.areas.norm()) continue;
      sites = std::move(tried);
      cells = std::move(moved);
      misfit = std::move(then);
      break;
    }
  }
  std::vector<std::vector<Vec2>> rings;
  for (Cell& cell : cells) rings.push_back(std::move(cell.ring));
  return rings;
}

}  // namespace brash::ice
