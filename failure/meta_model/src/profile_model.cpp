// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/meta_model/profile_model.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "profile_impl.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Modes are kept until the rest has this part of the variance; its root is the relative error they leave.
constexpr double kVarianceLeft = 1e-6;
/// Stations nearer than this over l_c are one station.
constexpr double kSameStation = 1e-9;
/// Shear under mu2 <= 0.3 counts less than the stresses under N.
constexpr double kTangentialShare = 0.3;
/// How far the deviation of ln(h) reaches compared with the other features': bending depends little on it.
constexpr double kThicknessLength = 4.0;
/// Solved geometries for each term of the quadratic part. With one, the model is a quadratic that passes through all.
constexpr Index kPointsPerTerm = 2;

double interpolate_at(const std::vector<double>& x, const std::vector<double>& y, double at) {
  const auto above = std::lower_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y.front();
  if (above == x.end()) return y.back();
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

/// A component of a profile and its factor besides the shape's scale.
struct Component {
  std::vector<double> Profiles::*values;
  double share;
};
constexpr std::array<Component, kBendingComponents> kBending{
    {{&Profiles::bending_xx, 1.0}, {&Profiles::bending_yy, 1.0}}};
constexpr std::array<Component, kInPlaneComponents> kInPlane{
    {{&Profiles::first_xx, 1.0}, {&Profiles::first_yy, 1.0}, {&Profiles::rest_xx, 1.0}, {&Profiles::rest_yy, 1.0}}};
constexpr std::array<Component, kMembraneComponents> kMembrane{
    {{&Profiles::normal_xx, 1.0}, {&Profiles::normal_yy, 1.0}, {&Profiles::tangential_xy, kTangentialShare}}};

template <std::size_t N>
VectorXd values_of(const Profiles& p, const std::array<Component, N>& components, const std::vector<double>& station,
                   const std::vector<double>& scale) {
  VectorXd values(static_cast<Index>(N * station.size()));
  Index n = 0;
  for (const Component& component : components) {
    const std::vector<double>& y = p.*component.values;
    BRASH_EXPECTS(y.size() == p.station.size(), y.size(), p.station.size());
    for (std::size_t i = 0; i < station.size(); ++i) {
      values(n++) = component.share * scale[i] * interpolate_at(p.station, y, station[i]);
    }
  }
  return values;
}

std::array<Geometry, 2> range_of(std::span<const ProfileSample> samples) {
  Geometry low = samples.front().geometry, high = low;
  for (const ProfileSample& s : samples) {
    const Geometry& g = s.geometry;
    low = {std::min(low.b_lc, g.b_lc), std::min(low.c_lc, g.c_lc), std::min(low.theta, g.theta),
           std::min(low.h_lc, g.h_lc)};
    high = {std::max(high.b_lc, g.b_lc), std::max(high.c_lc, g.c_lc), std::max(high.theta, g.theta),
            std::max(high.h_lc, g.h_lc)};
  }
  return {low, high};
}

/// Ten digits keep the interpolation, in which large weights cancel, to 1e-5, and the model file small.
double to_ten_digits(double value) { return std::stod(fmt::format("{:.9e}", value)); }
/// Five are more than the modes that are left out leave.
double to_five_digits(double value) { return std::stod(fmt::format("{:.4e}", value)); }

/// Principal modes of the centred columns of `values`, largest first.
MatrixXd principal_modes(const MatrixXd& values) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(values * values.transpose());
  const VectorXd& variance = solver.eigenvalues();  // increasing
  const double total = variance.sum();
  double left = total;
  Index n = 0;
  while (n < variance.size() && left > kVarianceLeft * total) left -= variance[variance.size() - 1 - n++];
  return solver.eigenvectors().rightCols(n).rowwise().reverse().unaryExpr(&to_five_digits);
}

/// Samples where the features are the same are the same problem: the first of each.
///
/// @param features  shape=(n_features, n_samples)
/// @throws InputError if the quadratic part would leave nothing, or little, to the distances.
std::vector<Index> enough_points(const MatrixXd& features) {
  std::vector<Index> kept = distinct_points(features);
  const Index fewest = kPointsPerTerm * n_polynomial_terms(n_varying(features));
  if (static_cast<Index>(kept.size()) < fewest) {
    throw InputError(Complaint{
        "the database", fmt::format("has {} solved geometries that differ", kept.size()),
        fmt::format("at least {}, {} for each term of the quadratic part of the interpolation", fewest, kPointsPerTerm),
        "raise `geometries` in the plan"});
  }
  return kept;
}

FieldModel fit_field(const MatrixXd& features, const MatrixXd& values, const VectorXd& lengths) {
  const std::vector<Index> kept = enough_points(features);
  MatrixXd centred = values(Eigen::all, kept);
  FieldModel field;
  field.mean = centred.rowwise().mean().unaryExpr(&to_five_digits);
  centred.colwise() -= field.mean;
  field.modes = principal_modes(centred);
  field.coefficients = interpolate(features(Eigen::all, kept), field.modes.transpose() * centred, lengths);
  field.coefficients.weights = field.coefficients.weights.unaryExpr(&to_ten_digits).eval();
  return field;
}

/// The same for values that need no modes.
Interpolant fit_values(const MatrixXd& features, const MatrixXd& values, const VectorXd& lengths) {
  const std::vector<Index> kept = enough_points(features);
  Interpolant interpolant = interpolate(features(Eigen::all, kept), values(Eigen::all, kept), lengths);
  interpolant.weights = interpolant.weights.unaryExpr(&to_ten_digits).eval();
  return interpolant;
}

/// Evaluates a field and writes its components into `p`.
template <std::size_t N>
void add_components(const FieldModel& field, const VectorXd& features, const std::array<Component, N>& components,
                    const std::vector<double>& scale, Profiles& p) {
  const VectorXd values = field.mean + field.modes * field.coefficients(features);
  Index n = 0;
  for (const Component& component : components) {
    std::vector<double>& y = p.*component.values;
    for (const double s : scale) y.push_back(values(n++) / (component.share * s));
  }
}

/// Stations fall together where b is (nearly) 0: the last one is enough.
void drop_equal_stations(Profiles& p) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < p.station.size(); ++i) {
    if (i + 1 == p.station.size() || p.station[i + 1] - p.station[i] >= kSameStation) kept.push_back(i);
  }
  for (auto* values : {&p.station, &p.bending_xx, &p.bending_yy, &p.normal_xx, &p.normal_yy, &p.tangential_xy,
                       &p.first_xx, &p.first_yy, &p.rest_xx, &p.rest_yy}) {
    if (values->empty()) continue;
    for (std::size_t i = 0; i < kept.size(); ++i) (*values)[i] = (*values)[kept[i]];
    values->resize(kept.size());
  }
}

}  // namespace

ProfileModel::ProfileModel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
ProfileModel::ProfileModel(ProfileModel&&) noexcept = default;
ProfileModel& ProfileModel::operator=(ProfileModel&&) noexcept = default;
ProfileModel::~ProfileModel() = default;

ProfileModel ProfileModel::fit(std::span<const ProfileSample> samples, const std::string& data_sha256) {
  if (samples.empty()) {
    throw InputError(Complaint{"the database", "has no solved geometry", "geometries that were solved",
                               "the database's `error` says why they were not"});
  }
  if (std::ranges::any_of(samples, [](const ProfileSample& s) { return s.geometry.b_lc < 0.0; })) {
    throw InputError(Complaint{"the database", "has bays (b < 0)", "b >= 0, where profiles interpolate",
                               "give the plan b_lc from 0 on, or train a network"});
  }
  auto impl = std::make_unique<Impl>();
  impl->range = range_of(samples);
  impl->data_sha256 = data_sha256;
  const auto reach_of = [](const ProfileSample& s) { return s.profiles.station.back() - s.geometry.b_lc; };
  impl->reach = reach_of(samples.front());
  for (const ProfileSample& s : samples) impl->reach = std::min(impl->reach, reach_of(s));

  const auto n = static_cast<Index>(samples.size());
  MatrixXd of_bending(bending_features({}).size(), n), of_membrane(membrane_features({}).size(), n);
  MatrixXd bending(kBendingComponents * kProfileStations, n), membrane(kMembraneComponents * kProfileStations, n);
  MatrixXd in_plane(kInPlaneComponents * kProfileStations, n), buckling(1, n);
  for (Index i = 0; i < n; ++i) {
    const ProfileSample& s = samples[static_cast<std::size_t>(i)];
    const ProfileShape shape = shape_of(s.geometry, impl->reach);
    of_bending.col(i) = bending_features(s.geometry);
    of_membrane.col(i) = membrane_features(s.geometry);
    bending.col(i) = values_of(s.profiles, kBending, shape.station, shape.bending);
    in_plane.col(i) = values_of(s.profiles, kInPlane, shape.station, shape.bending);
    buckling(0, i) = std::log(s.profiles.buckling_load);
    membrane.col(i) = values_of(s.profiles, kMembrane, shape.station, shape.membrane);
  }
  VectorXd lengths = VectorXd::Ones(of_bending.rows());
  lengths.tail(1).setConstant(kThicknessLength);
  impl->bending = fit_field(of_bending, bending, lengths);
  impl->in_plane = fit_field(of_bending, in_plane, lengths);
  impl->buckling = fit_values(of_bending, buckling, lengths);
  impl->membrane = fit_field(of_membrane, membrane, VectorXd::Ones(of_membrane.rows()));
  return ProfileModel(std::move(impl));
}

Profiles ProfileModel::predict(const Geometry& geometry, bool with_in_plane_terms) const {
  BRASH_EXPECTS(check(geometry).inside(), geometry.b_lc, geometry.c_lc, geometry.theta, geometry.h_lc);
  const ProfileShape shape = shape_of(geometry, impl_->reach);
  Profiles p;
  p.station = shape.station;
  add_components(impl_->bending, bending_features(geometry), kBending, shape.bending, p);
  if (with_in_plane_terms) {
    add_components(impl_->in_plane, bending_features(geometry), kInPlane, shape.bending, p);
    p.buckling_load = std::exp(impl_->buckling(bending_features(geometry))(0));
  }
  add_components(impl_->membrane, membrane_features(geometry), kMembrane, shape.membrane, p);
  drop_equal_stations(p);
  return p;
}

RangeCheck ProfileModel::check(const Geometry& g) const {
  const auto& [low, high] = impl_->range;
  return {.below = g.b_lc < low.b_lc || g.c_lc < low.c_lc || g.theta < low.theta ||
                   g.h_lc<low.h_lc, .above = g.b_lc> high.b_lc || g.c_lc > high.c_lc || g.theta > high.theta ||
                   g.h_lc > high.h_lc};
}

Geometry ProfileModel::clamp(const Geometry& g) const {
  const auto& [low, high] = impl_->range;
  BRASH_EXPECTS(!std::isnan(g.b_lc) && !std::isnan(g.c_lc) && !std::isnan(g.theta) && !std::isnan(g.h_lc));
  return {std::clamp(g.b_lc, low.b_lc, high.b_lc), std::clamp(g.c_lc, low.c_lc, high.c_lc),
          std::clamp(g.theta, low.theta, high.theta), std::clamp(g.h_lc, low.h_lc, high.h_lc)};
}

const std::array<Geometry, 2>& ProfileModel::range() const { return impl_->range; }
const std::string& ProfileModel::data_sha256() const { return impl_->data_sha256; }
int ProfileModel::n_modes() const {
  return static_cast<int>(impl_->bending.modes.cols() + impl_->in_plane.modes.cols() + impl_->membrane.modes.cols());
}

}  // namespace brash::meta_model
