// SPDX-License-Identifier: GPL-3.0-or-later
#include "recovery.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "brash/core/contract.hpp"
#include "quadrature.hpp"

namespace brash::plate {

namespace {

/// Fewest elements in a patch on a mesh that ends at the x-axis; twice as many where it covers both sides.
constexpr int kSmallestPatch = 4;

struct Sample {
  Vec2 place{};
  double weight = 0.0;
  std::vector<double> values;
};

/// A vertex on the x-axis and the elements around it.
struct Patch {
  double x = 0.0;
  std::vector<int> triangles;
};

std::vector<std::vector<int>> triangles_of_vertices(const Mesh& mesh) {
  std::vector<std::vector<int>> around(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const int vertex : mesh.triangles[t]) around[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(t));
  }
  return around;
}

std::vector<Patch> patches_on_axis(const Mesh& mesh, double x_last, int smallest) {
  const auto around = triangles_of_vertices(mesh);
  std::vector<std::pair<double, int>> vertices;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    if (mesh.vertices[v].y == 0.0 && mesh.vertices[v].x >= 0.0)
      vertices.emplace_back(mesh.vertices[v].x, static_cast<int>(v));
  }
  std::sort(vertices.begin(), vertices.end());
  std::vector<Patch> patches;
  for (const auto& [x, vertex] : vertices) {
    std::set<int> members(around[static_cast<std::size_t>(vertex)].begin(),
                          around[static_cast<std::size_t>(vertex)].end());
    while (static_cast<int>(members.size()) < smallest && members.size() < mesh.triangles.size()) {
      std::set<int> grown = members;
      for (const int t : members) {
        for (const int corner : mesh.triangles[static_cast<std::size_t>(t)]) {
          grown.insert(around[static_cast<std::size_t>(corner)].begin(),
                       around[static_cast<std::size_t>(corner)].end());
        }
      }
      members = std::move(grown);
    }
    patches.push_back({x, {members.begin(), members.end()}});
    if (x > x_last) break;
  }
  return patches;
}

/// Exponents of y that a quantity of that parity has.
bool has_exponent(Parity parity, int j) { return parity == Parity::kNone || (j % 2 == 0) == (parity == Parity::kEven); }

/// Coefficients of x^0 .. x^degree at y = 0 of the polynomial fitted to value number `which` of the samples.
Eigen::VectorXd fit_on_axis(const std::vector<Sample>& samples, std::size_t which, double x0, double scale, int degree,
                            Parity parity) {
  std::vector<std::pair<int, int>> exponents;
  for (int j = 0; j <= degree; ++j) {
    if (!has_exponent(parity, j)) continue;
    for (int i = 0; i + j <= degree; ++i) exponents.emplace_back(i, j);
  }
  const auto n_samples = static_cast<Eigen::Index>(samples.size());
  Eigen::MatrixXd matrix(n_samples, static_cast<Eigen::Index>(exponents.size()));
  Eigen::VectorXd right(n_samples);
  for (Eigen::Index s = 0; s < n_samples; ++s) {
    const auto& sample = samples[static_cast<std::size_t>(s)];
    const double weight = std::sqrt(sample.weight);
    right(s) = weight * sample.values[which];
    for (std::size_t c = 0; c < exponents.size(); ++c) {
      matrix(s, static_cast<Eigen::Index>(c)) = weight * std::pow((sample.place.x - x0) / scale, exponents[c].first) *
                                                std::pow(sample.place.y / scale, exponents[c].second);
    }
  }
  const Eigen::VectorXd all = matrix.colPivHouseholderQr().solve(right);
  Eigen::VectorXd on_axis = Eigen::VectorXd::Zero(degree + 1);
  for (std::size_t c = 0; c < exponents.size(); ++c) {
    if (exponents[c].second == 0) on_axis(exponents[c].first) = all(static_cast<Eigen::Index>(c));
  }
  return on_axis;
}

double evaluate(const Eigen::VectorXd& coefficients, double x) {
  double value = 0.0;
  for (Eigen::Index i = coefficients.size() - 1; i >= 0; --i) value = value * x + coefficients(i);
  return value;
}

/// Fits every quantity (its parity given) on every patch and blends; shape=(n_stations, n_quantities).
template <typename SampleAt>
std::vector<std::vector<double>> recover(const Field& field, const std::vector<double>& stations,
                                         const std::vector<Parity>& parities, const SampleAt& sample_at) {
  const int smallest = parities.front() == Parity::kNone ? 2 * kSmallestPatch : kSmallestPatch;
  const auto patches = patches_on_axis(field.mesh(), stations.back(), smallest);
  BRASH_EXPECTS(patches.size() >= 2 && patches.back().x >= stations.back(), patches.size(), stations.back());
  const auto rule = triangle_rule(field.order() + 1);

  std::vector<double> scales;
  std::vector<std::vector<Eigen::VectorXd>> fits;
  for (const auto& patch : patches) {
    std::vector<Sample> samples;
    double scale = 0.0;
    for (const int t : patch.triangles) {
      const Vec2 origin = field.place(t, 0.0, 0.0);
      const double area2 = cross(field.place(t, 1.0, 0.0) - origin, field.place(t, 0.0, 1.0) - origin);
      for (const auto& point : rule) {
        const Vec2 place = field.place(t, point.xi, point.eta);
        samples.push_back({place, point.weight * area2, sample_at(t, point.xi, point.eta)});
        scale = std::max(scale, norm(place - Vec2{patch.x, 0.0}));
      }
    }
    scales.push_back(scale);
    auto& fit = fits.emplace_back();
    for (std::size_t q = 0; q < parities.size(); ++q) {
      fit.push_back(fit_on_axis(samples, q, patch.x, scale, field.order(), parities[q]));
    }
  }

  std::vector<std::vector<double>> result;
  std::size_t right = 1;
  for (const double x : stations) {
    while (patches[right].x < x) ++right;
    const double share = (x - patches[right - 1].x) / (patches[right].x - patches[right - 1].x);
    auto& row = result.emplace_back();
    for (std::size_t q = 0; q < parities.size(); ++q) {
      row.push_back((1.0 - share) * evaluate(fits[right - 1][q], (x - patches[right - 1].x) / scales[right - 1]) +
                    share * evaluate(fits[right][q], (x - patches[right].x) / scales[right]));
    }
  }
  return result;
}

}  // namespace

std::vector<Tensor2> recover_tensor(const Field& field, const std::vector<double>& stations, Parity parity) {
  Parity cross_parity = parity;
  if (parity == Parity::kEven) cross_parity = Parity::kOdd;
  if (parity == Parity::kOdd) cross_parity = Parity::kEven;
  const auto rows = recover(field, stations, {parity, parity, cross_parity}, [&](int t, double xi, double eta) {
    const Tensor2 value = field.tensor(t, xi, eta);
    return std::vector<double>{value.xx, value.yy, value.xy};
  });
  std::vector<Tensor2> result;
  for (const auto& row : rows) result.push_back({row[0], row[1], row[2]});
  return result;
}

std::vector<double> recover_deflection(const Field& field, const std::vector<double>& stations, Parity parity) {
  const auto rows = recover(field, stations, {parity}, [&](int t, double xi, double eta) {
    return std::vector<double>{field.deflection(t, xi, eta)};
  });
  std::vector<double> result;
  for (const auto& row : rows) result.push_back(row[0]);
  return result;
}

std::optional<Tensor2> tensor_at(const Field& field, Vec2 place) {
  for (std::size_t i = 0; i < field.mesh().triangles.size(); ++i) {
    const int t = static_cast<int>(i);
    const Vec2 origin = field.place(t, 0.0, 0.0);
    const Vec2 u = field.place(t, 1.0, 0.0) - origin;
    const Vec2 v = field.place(t, 0.0, 1.0) - origin;
    const double area2 = cross(u, v);
    const double xi = cross(place - origin, v) / area2;
    const double eta = cross(u, place - origin) / area2;
    if (xi >= 0.0 && eta >= 0.0 && xi + eta <= 1.0) return field.tensor(t, xi, eta);
  }
  return std::nullopt;
}

double largest_principal(const Tensor2& t) { return 0.5 * (t.xx + t.yy) + std::hypot(0.5 * (t.xx - t.yy), t.xy); }
double smallest_principal(const Tensor2& t) { return 0.5 * (t.xx + t.yy) - std::hypot(0.5 * (t.xx - t.yy), t.xy); }

}  // namespace brash::plate
