// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/profile_model.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "brash/core/constants.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "profile_impl.hpp"

namespace brash::meta_model {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using Index = Eigen::Index;

/// Weights of the components in the modes: their share of the stress at mu1 = 0.5, mu2 = 0.3, h/l_c = 0.1.
constexpr std::array<double, kProfileComponents> kShare{30.0, 30.0, 1.0, 1.0, 0.3};
/// Modes are kept until the rest has this part of the variance; its root is the relative error they leave.
constexpr double kVarianceLeft = 2e-7;
/// Solved geometries nearer than this (in deviations of the features) are one point to the interpolation.
constexpr double kSamePoint = 1e-5;
/// Stations nearer than this over l_c are one station.
constexpr double kSameStation = 1e-9;
/// Keeps the logarithm of the depth finite; the depth below which profiles hardly depend on it.
constexpr double kDepthShift = 0.1;

Vector3d features_of(const Geometry& g) {
  return {std::log(g.b_lc + kDepthShift), std::log(g.c_lc),
          std::log1p(2.0 * g.b_lc * std::tan(0.5 * g.theta) / g.c_lc)};
}

/// Stations that follow the geometry: dense at the tip and behind the base line, x = b always among them.
std::vector<double> stations_of(double b, double reach) {
  std::vector<double> x;
  for (int i = 0; i < kStationsBefore; ++i) x.push_back(b * std::pow(double(i) / kStationsBefore, 1.5));
  for (int i = 0; i < kStationsBehind; ++i) x.push_back(b + (reach - b) * std::pow(i / (kStationsBehind - 1.0), 2));
  return x;
}

double interpolate(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::lower_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

std::array<const std::vector<double>*, kProfileComponents> components_of(const Profiles& p) {
  return {&p.bending_xx, &p.bending_yy, &p.normal_xx, &p.normal_yy, &p.tangential_xy};
}

/// The weighted profile of a sample on the stations that follow its geometry.
VectorXd values_of(const ProfileSample& sample, double reach) {
  const std::vector<double> x = stations_of(sample.geometry.b_lc, reach);
  const auto components = components_of(sample.profiles);
  VectorXd values(kProfileValues);
  for (int k = 0; k < kProfileComponents; ++k) {
    BRASH_EXPECTS(components[k]->size() == sample.profiles.station.size(), k, components[k]->size());
    for (int i = 0; i < kProfileStations; ++i) {
      values[k * kProfileStations + i] = kShare[k] * interpolate(sample.profiles.station, *components[k], x[i]);
    }
  }
  return values;
}

double cube(double r) { return r * r * r; }

/// Distances to the power 3, shape=(n_centres,).
VectorXd kernels(const MatrixXd& centres, const Vector3d& at) {
  return (centres.colwise() - at).colwise().norm().unaryExpr(&cube);
}

std::array<Geometry, 2> range_of(std::span<const ProfileSample> samples) {
  Geometry low = samples.front().geometry, high = low;
  for (const ProfileSample& s : samples) {
    const Geometry& g = s.geometry;
    low = {std::min(low.b_lc, g.b_lc), std::min(low.c_lc, g.c_lc), std::min(low.theta, g.theta)};
    high = {std::max(high.b_lc, g.b_lc), std::max(high.c_lc, g.c_lc), std::max(high.theta, g.theta)};
  }
  return {low, high};
}

/// Indices of samples that differ from all before them; at b = 0 samples of different theta are the same problem.
std::vector<Index> distinct(const MatrixXd& features) {
  std::vector<Index> kept;
  for (Index i = 0; i < features.cols(); ++i) {
    const bool same = std::any_of(kept.begin(), kept.end(),
                                  [&](Index j) { return (features.col(i) - features.col(j)).norm() < kSamePoint; });
    if (!same) kept.push_back(i);
  }
  return kept;
}

/// Weights and linear part of the interpolation of `coefficients`, shape=(n_centres, n_modes).
MatrixXd solve_interpolation(const MatrixXd& centres, const MatrixXd& coefficients) {
  const Index n = centres.cols(), p = kGeometryInputs + 1;
  MatrixXd system = MatrixXd::Zero(n + p, n + p);
  for (Index i = 0; i < n; ++i) system.col(i).head(n) = kernels(centres, centres.col(i));
  system.block(n, 0, 1, n).setOnes();
  system.block(n + 1, 0, kGeometryInputs, n) = centres;
  system.topRightCorner(n, p) = system.bottomLeftCorner(p, n).transpose();
  MatrixXd right = MatrixXd::Zero(n + p, coefficients.cols());
  right.topRows(n) = coefficients;
  return system.partialPivLu().solve(right);
}

/// Six digits are more than the interpolation holds, and they keep the model file small.
double to_six_digits(double value) { return std::stod(fmt::format("{:.5e}", value)); }

/// Principal modes of the centred columns of `values`, largest first.
MatrixXd principal_modes(const MatrixXd& values) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(values * values.transpose());
  const VectorXd& variance = solver.eigenvalues();  // increasing
  const double total = variance.sum();
  double left = total;
  Index n = 0;
  while (n < variance.size() && left > kVarianceLeft * total) left -= variance[variance.size() - 1 - n++];
  return solver.eigenvectors().rightCols(n).rowwise().reverse();
}

}  // namespace

ProfileModel::ProfileModel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProfileModel::ProfileModel(ProfileModel&&) noexcept = default;
ProfileModel& ProfileModel::operator=(ProfileModel&&) noexcept = default;
ProfileModel::~ProfileModel() = default;

ProfileModel ProfileModel::fit(std::span<const ProfileSample> samples, double thickness_over_lc,
                               const std::string& data_sha256) {
  constexpr std::size_t kFewest = 10;
  if (samples.size() < kFewest) {
    throw InputError(fmt::format("{} solved geometries, at least {} are needed; raise `geometries` in the plan",
                                 samples.size(), kFewest));
  }
  auto impl = std::make_unique<Impl>();
  impl->range = range_of(samples);
  impl->thickness_over_lc = thickness_over_lc;
  impl->data_sha256 = data_sha256;
  impl->reach = samples.front().profiles.station.back();
  for (const ProfileSample& s : samples) impl->reach = std::min(impl->reach, s.profiles.station.back());

  const auto n = static_cast<Index>(samples.size());
  MatrixXd features(kGeometryInputs, n);
  for (Index i = 0; i < n; ++i) features.col(i) = features_of(samples[static_cast<std::size_t>(i)].geometry);
  impl->offset = features.rowwise().mean();
  impl->factor = ((features.colwise() - impl->offset).rowwise().squaredNorm() / double(n)).cwiseSqrt();
  BRASH_EXPECTS((impl->factor.array() > 0.0).all());
  features = impl->factor.cwiseInverse().asDiagonal() * (features.colwise() - impl->offset);

  const std::vector<Index> kept = distinct(features);
  impl->centres = features(Eigen::all, kept);
  MatrixXd values(kProfileValues, static_cast<Index>(kept.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    values.col(static_cast<Index>(i)) = values_of(samples[static_cast<std::size_t>(kept[i])], impl->reach);
  }
  impl->mean = values.rowwise().mean();
  values.colwise() -= impl->mean;
  impl->modes = principal_modes(values);
  const MatrixXd solution = solve_interpolation(impl->centres, (impl->modes.transpose() * values).transpose());
  impl->weights = solution.topRows(values.cols()).transpose().unaryExpr(&to_six_digits);
  impl->linear = solution.bottomRows(kGeometryInputs + 1).transpose();
  impl->modes = impl->modes.unaryExpr(&to_six_digits).eval();
  return ProfileModel(std::move(impl));
}

Profiles ProfileModel::predict(const Geometry& geometry) const {
  BRASH_EXPECTS(check(geometry).inside(), geometry.b_lc, geometry.c_lc, geometry.theta);
  const Vector3d at = (features_of(geometry) - impl_->offset).cwiseQuotient(impl_->factor);
  const VectorXd coefficients = impl_->weights * kernels(impl_->centres, at) + impl_->linear.col(0) +
                                impl_->linear.rightCols(kGeometryInputs) * at;
  const VectorXd values = impl_->mean + impl_->modes * coefficients;

  // Stations fall together where b is (nearly) 0: one of them is enough.
  const std::vector<double> x = stations_of(geometry.b_lc, impl_->reach);
  Profiles p;
  const std::array<std::vector<double>*, kProfileComponents> components{&p.bending_xx, &p.bending_yy, &p.normal_xx,
                                                                        &p.normal_yy, &p.tangential_xy};
  for (int i = 0; i < kProfileStations; ++i) {
    if (i + 1 < kProfileStations && x[i + 1] - x[i] < kSameStation) continue;
    p.station.push_back(x[i]);
    for (int k = 0; k < kProfileComponents; ++k) components[k]->push_back(values[k * kProfileStations + i] / kShare[k]);
  }
  return p;
}

RangeCheck ProfileModel::check(const Geometry& g) const {
  const auto& [low, high] = impl_->range;
  return {.below = g.b_lc < low.b_lc || g.c_lc < low.c_lc || g.theta<low.theta, .above = g.b_lc> high.b_lc ||
                   g.c_lc > high.c_lc || g.theta > high.theta};
}

Geometry ProfileModel::clamp(const Geometry& g) const {
  const auto& [low, high] = impl_->range;
  BRASH_EXPECTS(!std::isnan(g.b_lc) && !std::isnan(g.c_lc) && !std::isnan(g.theta));
  return {std::clamp(g.b_lc, low.b_lc, high.b_lc), std::clamp(g.c_lc, low.c_lc, high.c_lc),
          std::clamp(g.theta, low.theta, high.theta)};
}

double ProfileModel::thickness_over_lc() const { return impl_->thickness_over_lc; }
int ProfileModel::n_modes() const { return static_cast<int>(impl_->modes.cols()); }

}  // namespace brash::meta_model
