// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <set>

#include "brash/core/contract.hpp"
#include "brash/core/error.hpp"
#include "edge_impl.hpp"
#include "profile_shape.hpp"

namespace brash::meta_model {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Modes are kept until the rest has this part of the variance; its root is the relative error they leave.
constexpr double kVarianceLeft = 1e-6;
/// But not more: the next ones hold what mesh and Krylov space leave.
constexpr Index kMostModes = 75;
/// Principal shapes and histories of the moments.
constexpr Index kShapes = 20;
/// How far a grid of two thicknesses, which is linear in them, continues so for thicker ice, over its width.
constexpr double kBeyond = 1.5;
/// Keeps the logarithm of the depth finite; about half the thickness, below which responses hardly depend on it.
constexpr double kDepthShift = 0.05;
/// Contacts wider than this over l_c answer more and more as a strip.
constexpr double kWide = 4.0;
/// Moments along the edge at B are of this order in c: c / (1 + kEdgeSpread c).
constexpr double kEdgeSpread = 2.0;
/// Moments on the axis fall as 1 / (1 + kAxisSpread c) against the moments of a beam.
constexpr double kAxisSpread = 0.65;
/// Moments before this time over sqrt(l_c / g) count less: plate theory and mesh end there.
constexpr double kTrusted = 0.1;

/// Coordinates in which the responses change evenly. The angle counts as the width that it gives the base line.
double depth_coordinate(double b_lc) { return std::log(b_lc + kDepthShift); }
double angle_coordinate(double theta, double b_lc, double c_lc) {
  return std::log1p((1.0 + b_lc / c_lc) * std::tan(0.5 * theta));
}
double width_coordinate(double c_lc) { return std::log(c_lc / (1.0 + c_lc / kWide)); }

double edge_scale(const EdgeGeometry& g) { return (1.0 + kEdgeSpread * g.contact_length) / g.contact_length; }

ProfileShape shape_of_edge(const EdgeGeometry& g, double reach) {
  ProfileShape shape =
      shape_of({g.depth, g.contact_length, g.angle, g.thickness}, reach, kEdgeStationsBefore, kEdgeStationsBehind);
  for (double& factor : shape.bending) factor *= 1.0 + kAxisSpread * g.contact_length;
  return shape;
}

double interpolate_at(const std::vector<double>& x, const double* y, double at) {
  const auto above = std::lower_bound(x.begin(), x.end(), at);
  if (above == x.begin()) return y[0];
  if (above == x.end()) return y[x.size() - 1];
  const auto i = static_cast<std::size_t>(above - x.begin());
  return y[i - 1] + (y[i] - y[i - 1]) * (at - x[i - 1]) / (x[i] - x[i - 1]);
}

/// Three decimals of modes of order 1.
double to_three_decimals(double value) { return std::round(1e3 * value) / 1e3; }
double to_four_decimals(double value) { return std::round(1e4 * value) / 1e4; }
double to_five_digits(double value) { return std::stod(fmt::format("{:.4e}", value)); }

GridField fit_field(const MatrixXd& values) {
  GridField field;
  field.mean = values.rowwise().mean().unaryExpr(&to_five_digits);
  const MatrixXd centred = values.colwise() - field.mean;
  // The modes of the smaller Gram matrix.
  const Eigen::BDCSVD<MatrixXd> svd(centred, Eigen::ComputeThinU);
  const VectorXd variance = svd.singularValues().cwiseAbs2();
  double left = variance.sum();
  const double least = kVarianceLeft * left;
  Index n = 0;
  while (n < std::min(variance.size(), kMostModes) && left > least) left -= variance(n++);
  const MatrixXd modes =
      (svd.matrixU().leftCols(n) * std::sqrt(static_cast<double>(values.rows()))).unaryExpr(&to_three_decimals);
  field.modes = modes.cast<float>();
  // The best coefficients for the rounded modes.
  field.coefficients = modes.colPivHouseholderQr().solve(centred).unaryExpr(&to_four_decimals);
  return field;
}

/// The largest principal directions of the columns of `values`, orthonormal.
MatrixXd principal_directions(const MatrixXd& values, Index n) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(values * values.transpose());
  return solver.eigenvectors().rightCols(std::min(n, values.rows())).rowwise().reverse().unaryExpr(&to_five_digits);
}

/// Writes moments, shape=(kEdgeStations, n_times + 1) one after the other, in principal shapes and histories.
MatrixXd condense(const MatrixXd& moments, MatrixXd& stations, MatrixXd& times) {
  const Index n_times = moments.rows() / kEdgeStations, n = moments.cols();
  MatrixXd of_times(n_times, kEdgeStations * n);
  for (Index i = 0; i < n; ++i)
    of_times.middleCols(i * kEdgeStations, kEdgeStations) = moments.col(i).reshaped(kEdgeStations, n_times).transpose();
  stations = principal_directions(moments.reshaped(kEdgeStations, n_times * n), kShapes);
  times = principal_directions(of_times, kShapes);
  MatrixXd result(stations.cols() * times.cols(), n);
  for (Index i = 0; i < n; ++i)
    result.col(i) = (stations.transpose() * moments.col(i).reshaped(kEdgeStations, n_times) * times).eval().reshaped();
  return result;
}

std::vector<double> distinct(std::span<const EdgeSample> samples, double EdgeGeometry::*member) {
  std::set<double> values;
  for (const EdgeSample& s : samples) values.insert(s.geometry.*member);
  return {values.begin(), values.end()};
}

[[noreturn]] void refuse(const std::string& what) {
  throw InputError(Complaint{"the database", what, "every geometry of its grid solved",
                             "compute it again with a plan as experiments/failure_database/edge.toml"});
}

/// The sample at every point of the grid; a straight edge is used for all angles.
std::vector<const EdgeSample*> samples_on_grid(std::span<const EdgeSample> samples,
                                               const std::array<std::vector<double>, kEdgeAxes>& grid, bool has_split) {
  std::vector<const EdgeSample*> result;
  for (const bool split : {false, true}) {
    if (split && !has_split) break;
    for (const double b : grid[0]) {
      for (const double theta : grid[1]) {
        for (const double c : grid[2]) {
          for (const double h : grid[3]) {
            const auto found = std::find_if(samples.begin(), samples.end(), [&](const EdgeSample& s) {
              const EdgeGeometry& g = s.geometry;
              return g.depth == b && g.contact_length == c && g.thickness == h && g.split == split &&
                     (g.angle == theta || b == 0.0);
            });
            if (found == samples.end())
              refuse(fmt::format("has no solution at b/l_c = {}, c/l_c = {}, theta = {} rad, h/l_c = {}, split = {}", b,
                                 c, theta, h, split));
            result.push_back(&*found);
          }
        }
      }
    }
  }
  return result;
}

double weight_at(double time) { return std::min(1.0, time / kTrusted); }

/// @param time  for plate::kUsualMass.
VectorXd moments_of(const EdgeSample& s, const ProfileShape& shape, const std::vector<double>& time) {
  const EdgeResponses& r = s.responses;
  const std::size_t n_times = r.time.size();
  VectorXd values(static_cast<Index>((n_times + 1) * shape.station.size()));
  Index n = 0;
  for (std::size_t i = 0; i <= n_times; ++i) {
    const double* xx = i < n_times ? r.axis_moment_at(i) : r.static_axis_moment.data();
    const double weight = i < n_times ? weight_at(time[i]) : 1.0;
    for (std::size_t k = 0; k < shape.station.size(); ++k)
      values(n++) = weight * shape.bending[k] * interpolate_at(r.station, xx, shape.station[k]);
  }
  return values;
}

VectorXd motion_of(const EdgeSample& s) {
  const EdgeResponses& r = s.responses;
  const auto n_times = static_cast<Index>(r.time.size());
  VectorXd values(2 * n_times + 2);
  for (Index i = 0; i < n_times; ++i) {
    values(i) = r.deflection[static_cast<std::size_t>(i)] / r.static_deflection;
    values(n_times + i) = edge_scale(s.geometry) * r.edge_moment[static_cast<std::size_t>(i)];
  }
  values(2 * n_times) = edge_scale(s.geometry) * r.static_edge_moment;
  values(2 * n_times + 1) = std::log(r.static_deflection);
  return values;
}

VectorXd membrane_of(const EdgeSample& s, const ProfileShape& shape) {
  VectorXd values(static_cast<Index>(shape.station.size()) + 1);
  for (std::size_t k = 0; k < shape.station.size(); ++k)
    values(static_cast<Index>(k)) =
        shape.membrane[k] * interpolate_at(s.responses.station, s.responses.axis_normal.data(), shape.station[k]);
  values(values.size() - 1) = s.responses.edge_normal;
  return values;
}

/// Stations fall together where b is (nearly) 0: the last one counts.
std::vector<std::size_t> distinct_stations(const std::vector<double>& station) {
  constexpr double kSameStation = 1e-9;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < station.size(); ++i)
    if (i + 1 == station.size() || station[i + 1] - station[i] >= kSameStation) kept.push_back(i);
  return kept;
}

/// @param weights  of the points from `first` on.
VectorXd evaluate(const GridField& field, const VectorXd& weights, Index first) {
  const VectorXd coefficients = field.coefficients.middleCols(first, weights.size()) * weights;
  return field.mean + (field.modes * coefficients.cast<float>()).cast<double>();
}

}  // namespace

EdgeResponseModel::EdgeResponseModel(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
EdgeResponseModel::EdgeResponseModel(EdgeResponseModel&&) noexcept = default;
EdgeResponseModel& EdgeResponseModel::operator=(EdgeResponseModel&&) noexcept = default;
EdgeResponseModel::~EdgeResponseModel() = default;

void EdgeResponseModel::Impl::prepare() {
  const auto axis = [](const std::vector<double>& points, auto coordinate) {
    std::vector<double> coordinates;
    for (const double point : points) coordinates.push_back(coordinate(point));
    return GridAxis(coordinates);
  };
  width = axis(grid[2], width_coordinate);
  thickness = GridAxis(grid[3]);
  depth = axis(grid[0], depth_coordinate);
  for (const double b : grid[0])
    for (const double c : grid[2])
      angle.push_back(axis(grid[1], [b, c](double theta) { return angle_coordinate(theta, b, c); }));
  range[0] = {grid[0].front(), grid[2].front(), grid[1].front(), 0.0, grid[3].front(), false};
  range[1] = {grid[0].back(), grid[2].back(), grid[1].back(), 0.0, grid[3].back(), has_split};
}

VectorXd EdgeResponseModel::Impl::outline_weights(const EdgeGeometry& g) const {
  const VectorXd of_b = depth.weights(depth_coordinate(g.depth)),
                 of_c = width.weights(width_coordinate(g.contact_length));
  VectorXd weights(static_cast<Index>(n_outlines()));
  for (std::size_t i = 0; i < grid[0].size(); ++i) {
    for (std::size_t j = 0; j < grid[2].size(); ++j) {
      const VectorXd of_theta =
          angle[i * grid[2].size() + j].weights(angle_coordinate(g.angle, grid[0][i], grid[2][j]));
      for (std::size_t k = 0; k < grid[1].size(); ++k)
        weights(static_cast<Index>((i * grid[1].size() + k) * grid[2].size() + j)) =
            of_b(static_cast<Index>(i)) * of_c(static_cast<Index>(j)) * of_theta(static_cast<Index>(k));
    }
  }
  return weights;
}

EdgeResponseModel EdgeResponseModel::fit(std::span<const EdgeSample> samples, const std::string& data_sha256) {
  if (samples.empty()) refuse("has no solved geometry");
  if (std::ranges::any_of(samples, [](const EdgeSample& s) { return s.geometry.depth < 0.0; }))
    throw InputError(Complaint{"the database", "has bays (b < 0)", "b >= 0, where responses interpolate",
                               "give the plan b_lc from 0 on; `--model fem` solves a bay"});
  auto impl = std::make_unique<Impl>();
  impl->grid = {distinct(samples, &EdgeGeometry::depth), distinct(samples, &EdgeGeometry::angle),
                distinct(samples, &EdgeGeometry::contact_length), distinct(samples, &EdgeGeometry::thickness)};
  impl->has_split = std::ranges::any_of(samples, [](const EdgeSample& s) { return s.geometry.split; });
  impl->data_sha256 = data_sha256;
  const EdgeSample& first = samples.front();
  const double factor =
      std::sqrt((first.geometry.mass_ratio + plate::kMassShift) / (plate::kUsualMass + plate::kMassShift));
  for (const double t : first.responses.time) impl->time.push_back(to_five_digits(t / factor));
  impl->reach = first.responses.station.back() - first.geometry.depth;
  for (const EdgeSample& s : samples) {
    impl->reach = std::min(impl->reach, s.responses.station.back() - s.geometry.depth);
    if (s.responses.time.size() != impl->time.size()) refuse("has series of several lengths");
  }
  impl->reach = std::floor(1e6 * impl->reach) / 1e6;
  impl->prepare();

  const auto points = samples_on_grid(samples, impl->grid, impl->has_split);
  const auto n = static_cast<Index>(points.size()), n_thicknesses = static_cast<Index>(impl->grid[3].size());
  const auto n_times = static_cast<Index>(impl->time.size());
  MatrixXd moments((n_times + 1) * kEdgeStations, n), motion(2 * n_times + 2, n);
  MatrixXd membrane(kEdgeStations + 1, static_cast<Index>(impl->n_outlines()));
  for (Index i = 0; i < n; ++i) {
    const EdgeSample& s = *points[static_cast<std::size_t>(i)];
    // A straight edge has the shape of its angle's limit.
    const ProfileShape shape = shape_of_edge(s.geometry, impl->reach);
    moments.col(i) = moments_of(s, shape, impl->time);
    motion.col(i) = motion_of(s);
    if (i % n_thicknesses == 0 && i / n_thicknesses < membrane.cols())
      membrane.col(i / n_thicknesses) = membrane_of(s, shape);
  }
  impl->moments = fit_field(condense(moments, impl->stations, impl->times));
  impl->motion = fit_field(motion);
  impl->membrane = fit_field(membrane);
  return EdgeResponseModel(std::move(impl));
}

EdgeResponses EdgeResponseModel::at(const EdgeGeometry& g) const {
  const Impl& m = *impl_;
  BRASH_EXPECTS(clamp(g) == g && g.mass_ratio > 0.0, g.depth, g.contact_length, g.angle, g.thickness);
  BRASH_EXPECTS(!g.split || m.has_split);
  const VectorXd of_outlines = m.outline_weights(g), h = m.thickness.weights(g.thickness);
  const VectorXd weights = (h * of_outlines.transpose()).reshaped();
  const Index first = g.split ? weights.size() : 0;

  const ProfileShape shape = shape_of_edge(g, m.reach);
  const std::vector<std::size_t> kept = distinct_stations(shape.station);
  const MatrixXd moments = m.stations *
                           evaluate(m.moments, weights, first).reshaped(m.stations.cols(), m.times.cols()) *
                           m.times.transpose();
  const VectorXd motion = evaluate(m.motion, weights, first), membrane = evaluate(m.membrane, of_outlines, 0);
  const auto n_times = static_cast<Index>(m.time.size());
  const double factor = std::sqrt((g.mass_ratio + plate::kMassShift) / (plate::kUsualMass + plate::kMassShift));
  EdgeResponses r;
  r.static_deflection = std::exp(motion(2 * n_times + 1));
  r.static_edge_moment = motion(2 * n_times) / edge_scale(g);
  for (Index i = 0; i < n_times; ++i) {
    r.time.push_back(factor * m.time[static_cast<std::size_t>(i)]);
    r.deflection.push_back(motion(i) * r.static_deflection);
    r.edge_moment.push_back(motion(n_times + i) / edge_scale(g));
  }
  r.axis_moment.reserve(static_cast<std::size_t>(n_times) * kept.size());
  for (Index i = 0; i < n_times; ++i)
    for (const std::size_t k : kept)
      r.axis_moment.push_back(moments(static_cast<Index>(k), i) /
                              (weight_at(m.time[static_cast<std::size_t>(i)]) * shape.bending[k]));
  for (const std::size_t k : kept) {
    r.station.push_back(shape.station[k]);
    r.static_axis_moment.push_back(moments(static_cast<Index>(k), n_times) / shape.bending[k]);
    r.axis_normal.push_back(membrane(static_cast<Index>(k)) / shape.membrane[k]);
  }
  r.edge_normal = membrane(kEdgeStations);
  return r;
}

RangeCheck EdgeResponseModel::check(const EdgeGeometry& g) const {
  const auto& [low, high] = impl_->range;
  return {.below = g.depth < low.depth || g.contact_length < low.contact_length || g.angle < low.angle ||
                   g.thickness<low.thickness, .above = g.depth> high.depth || g.contact_length > high.contact_length ||
                   g.angle > high.angle || g.thickness > high.thickness};
}

EdgeGeometry EdgeResponseModel::clamp(const EdgeGeometry& g) const {
  const auto& [low, high] = impl_->range;
  EdgeGeometry result = g;
  result.depth = std::clamp(g.depth, low.depth, high.depth);
  result.contact_length = std::clamp(g.contact_length, low.contact_length, high.contact_length);
  result.angle = std::clamp(g.angle, low.angle, high.angle);
  const double beyond = impl_->grid[3].size() == 2 ? kBeyond * (high.thickness - low.thickness) : 0.0;
  result.thickness = std::clamp(g.thickness, low.thickness, high.thickness + beyond);
  return result;
}

const std::array<EdgeGeometry, 2>& EdgeResponseModel::range() const { return impl_->range; }
int EdgeResponseModel::n_modes() const {
  return static_cast<int>(impl_->moments.modes.cols() + impl_->motion.modes.cols() + impl_->membrane.modes.cols());
}

}  // namespace brash::meta_model
