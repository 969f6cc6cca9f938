// SPDX-License-Identifier: GPL-3.0-or-later
#include "recovery.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
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

/// A weighted polynomial fit to some samples.
struct Fit {
  std::vector<std::pair<int, int>> exponents;  ///< of x and y
  Eigen::MatrixXd matrix;                      ///< shape=(n_samples, n_exponents)
};

Fit fit_of(const std::vector<Sample>& samples, double x0, double scale, int degree, Parity parity) {
  Fit fit;
  for (int j = 0; j <= degree; ++j) {
    if (!has_exponent(parity, j)) continue;
    for (int i = 0; i + j <= degree; ++i) fit.exponents.emplace_back(i, j);
  }
  const auto n_samples = static_cast<Eigen::Index>(samples.size());
  fit.matrix.resize(n_samples, static_cast<Eigen::Index>(fit.exponents.size()));
  for (Eigen::Index s = 0; s < n_samples; ++s) {
    const auto& sample = samples[static_cast<std::size_t>(s)];
    const double weight = std::sqrt(sample.weight);
    for (std::size_t c = 0; c < fit.exponents.size(); ++c) {
      fit.matrix(s, static_cast<Eigen::Index>(c)) = weight *
                                                    std::pow((sample.place.x - x0) / scale, fit.exponents[c].first) *
                                                    std::pow(sample.place.y / scale, fit.exponents[c].second);
    }
  }
  return fit;
}

/// Coefficients of x^0 .. x^degree at y = 0 of the polynomial fitted to value number `which` of the samples.
Eigen::VectorXd fit_on_axis(const std::vector<Sample>& samples, std::size_t which, double x0, double scale, int degree,
                            Parity parity) {
  const Fit fit = fit_of(samples, x0, scale, degree, parity);
  Eigen::VectorXd right(fit.matrix.rows());
  for (Eigen::Index s = 0; s < right.size(); ++s) {
    const auto& sample = samples[static_cast<std::size_t>(s)];
    right(s) = std::sqrt(sample.weight) * sample.values[which];
  }
  const Eigen::VectorXd all = fit.matrix.colPivHouseholderQr().solve(right);
  Eigen::VectorXd on_axis = Eigen::VectorXd::Zero(degree + 1);
  for (std::size_t c = 0; c < fit.exponents.size(); ++c) {
    if (fit.exponents[c].second == 0) on_axis(fit.exponents[c].first) = all(static_cast<Eigen::Index>(c));
  }
  return on_axis;
}

/// The coefficients of x^0 .. x^degree at y = 0 as sums over the samples of a patch.
struct PatchWeights {
  double scale = 0.0;
  Eigen::MatrixXd of_samples;  ///< shape=(degree + 1, n_samples), triangle by triangle
};

PatchWeights weights_of(const Mesh& mesh, const Patch& patch, const std::vector<TrianglePoint>& rule, int degree,
                        Parity parity) {
  std::vector<Sample> samples;
  PatchWeights result;
  for (const int t : patch.triangles) {
    const auto corner = [&](std::size_t i) {
      return mesh.vertices[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
    };
    const Vec2 u = corner(1) - corner(0), v = corner(2) - corner(0);
    for (const auto& point : rule) {
      const Vec2 place = corner(0) + point.xi * u + point.eta * v;
      samples.push_back({place, point.weight * cross(u, v), {}});
      result.scale = std::max(result.scale, norm(place - Vec2{patch.x, 0.0}));
    }
  }
  const Fit fit = fit_of(samples, patch.x, result.scale, degree, parity);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(fit.matrix.rows(), fit.matrix.rows());
  for (Eigen::Index s = 0; s < right.rows(); ++s) right(s, s) = std::sqrt(samples[static_cast<std::size_t>(s)].weight);
  const Eigen::MatrixXd all = fit.matrix.colPivHouseholderQr().solve(right);
  result.of_samples = Eigen::MatrixXd::Zero(degree + 1, all.cols());
  for (std::size_t c = 0; c < fit.exponents.size(); ++c) {
    if (fit.exponents[c].second == 0)
      result.of_samples.row(fit.exponents[c].first) = all.row(static_cast<Eigen::Index>(c));
  }
  return result;
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

std::vector<std::vector<RecoveryTerm>> recovery_terms(const Mesh& mesh, int order, const std::vector<double>& stations,
                                                      Parity parity) {
  const int smallest = parity == Parity::kNone ? 2 * kSmallestPatch : kSmallestPatch;
  const auto patches = patches_on_axis(mesh, stations.back(), smallest);
  BRASH_EXPECTS(patches.size() >= 2 && patches.back().x >= stations.back(), patches.size(), stations.back());
  const auto rule = triangle_rule(order + 1);
  std::vector<PatchWeights> fits;
  for (const auto& patch : patches) fits.push_back(weights_of(mesh, patch, rule, order, parity));

  std::vector<std::vector<RecoveryTerm>> result;
  std::size_t right = 1;
  for (const double x : stations) {
    while (patches[right].x < x) ++right;
    const double share = (x - patches[right - 1].x) / (patches[right].x - patches[right - 1].x);
    auto& terms = result.emplace_back();
    for (const auto& [i, part] : {std::pair(right - 1, 1.0 - share), std::pair(right, share)}) {
      Eigen::RowVectorXd power(order + 1);
      for (int k = 0; k <= order; ++k) power(k) = part * std::pow((x - patches[i].x) / fits[i].scale, k);
      const Eigen::RowVectorXd weights = power * fits[i].of_samples;
      for (Eigen::Index s = 0; s < weights.size(); ++s) {
        const auto [t, point] = std::div(static_cast<int>(s), static_cast<int>(rule.size()));
        terms.push_back({patches[i].triangles[static_cast<std::size_t>(t)], point, weights(s)});
      }
    }
  }
  return result;
}

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
