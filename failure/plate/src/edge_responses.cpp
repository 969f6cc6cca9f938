// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/plate/edge_responses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "axis_moments.hpp"
#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "domains.hpp"
#include "fem.hpp"
#include "production_sizes.hpp"
#include "profiles.hpp"
#include "recovery.hpp"
#include "vibration.hpp"
#include "water.hpp"

namespace brash::plate {

namespace {

constexpr double kPoisson = 0.3;
/// First and last time of the responses over sqrt(l_c / g), for a mass ratio of kUsualMass.
constexpr double kFirstTime = 0.03;
constexpr double kLastTime = 10.0;
constexpr int kTimes = 33;
/// The membrane's sheet, clamped there: it adds 0.4 p c / R.
constexpr double kMembraneReach = 2000.0;

WedgePlate wedge_of(const EdgeGeometry& g) {
  return {.depth = g.depth, .contact_length = g.contact_length, .angle = g.angle};
}

/// The mesh with a crack in place of the centre line.
Mesh split_mesh(Mesh mesh) {
  for (auto& tagged : mesh.tagged)
    if (tagged.side == Side::kSymmetryY) tagged.side = Side::kCrack;
  return mesh;
}

/// The deflection of B.
double at_tip(const Mesh& mesh, const Eigen::MatrixXd& local) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 v = mesh.vertices[static_cast<std::size_t>(mesh.triangles[t][i])];
      if (v.x == 0.0 && v.y == 0.0) return local(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(t));
    }
  }
  BRASH_EXPECTS(false, mesh.vertices.size());
  return 0.0;
}

std::vector<double> to_vector(const Eigen::VectorXd& values) { return {values.begin(), values.end()}; }

}  // namespace

struct MovingEdge::Impl {
  WedgePlate outline;
  EdgeOptions options;
  Mesh mesh, split;
  std::unique_ptr<WaterUnderSheet> water;
  std::vector<double> station;
  std::vector<double> axis_normal;
  double edge_normal = 0.0;
};

MovingEdge::MovingEdge(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MovingEdge::MovingEdge(MovingEdge&&) noexcept = default;
MovingEdge& MovingEdge::operator=(MovingEdge&&) noexcept = default;
MovingEdge::~MovingEdge() = default;

int MovingEdge::n_elements() const { return static_cast<int>(impl_->mesh.triangles.size()); }

tl::expected<MovingEdge, PlateError> MovingEdge::prepare(const EdgeGeometry& outline, const EdgeOptions& options) {
  look_for_interruption();
  BRASH_EXPECTS(std::isfinite(outline.depth) && outline.contact_length > 0.0, outline.depth, outline.contact_length);
  BRASH_EXPECTS(outline.angle >= 0.0 && outline.angle < std::numbers::pi, outline.angle);
  auto impl = std::make_unique<Impl>();
  impl->outline = wedge_of(outline);
  impl->options = options;
  const double scale = options.scale > 0.0 ? options.scale : 1.0;
  const double reach = options.reach > 0.0 ? options.reach : kMovingReach;
  auto mesh = mesh_domain(half_of_moving_plate(impl->outline, reach, scale));
  if (!mesh) return tl::unexpected(PlateError{mesh.error()});
  impl->mesh = std::move(*mesh);
  impl->split = split_mesh(impl->mesh);
  impl->water = std::make_unique<WaterUnderSheet>(impl->mesh, kOrder);
  impl->station = stations_of(impl->outline);

  const auto wide = mesh_domain(half_of_moving_plate(impl->outline, kMembraneReach, scale));
  if (!wide) return tl::unexpected(PlateError{wide.error()});
  const auto membrane = solve_membrane(*wide, kOrder, {kPoisson, {{1.0, 0.0}}, false});
  if (!membrane) return tl::unexpected(PlateError{"membrane, normal load: " + membrane.error()});
  const auto normal = recover_tensor(membrane->front(), impl->station, Parity::kEven);
  for (const Tensor2& t : normal) impl->axis_normal.push_back(t.xx);
  impl->edge_normal = normal.front().yy;
  return MovingEdge(std::move(impl));
}

tl::expected<EdgeResponses, PlateError> MovingEdge::respond(const EdgeGeometry& geometry) const {
  look_for_interruption();
  BRASH_EXPECTS(geometry.thickness > 0.0 && geometry.mass_ratio > 0.0, geometry.thickness, geometry.mass_ratio);
  const Impl& m = *impl_;
  const Mesh& mesh = geometry.split ? m.split : m.mesh;
  const double h = effective_thickness(Theory::kReissnerMindlin, geometry.thickness);
  const auto plate = BendingSystem::factorise(mesh, kOrder, {kPoisson, shear_stiffness(kPoisson, h), 1.0, {}});
  if (!plate) return tl::unexpected(PlateError{"bending: " + plate.error()});
  const AxisMoments moments_of(mesh, kOrder, kPoisson, m.station, geometry.split ? Parity::kNone : Parity::kEven);
  const auto n_stations = static_cast<Eigen::Index>(m.station.size());
  // Deflection of B and moments xx, yy on the axis.
  const auto outputs_of = [&](const Eigen::MatrixXd& local) {
    Eigen::VectorXd outputs(1 + 2 * n_stations);
    outputs << at_tip(mesh, local), moments_of(local);
    return outputs;
  };
  const Vibration vibration = reduce(mesh, kOrder, *plate, *m.water, geometry.mass_ratio, outputs_of,
                                     m.options.n_vectors > 0 ? m.options.n_vectors : kVibrationVectors);

  EdgeResponses result;
  result.station = m.station;
  const double factor = std::sqrt((geometry.mass_ratio + kMassShift) / (kUsualMass + kMassShift));
  for (int i = 0; i < kTimes; ++i) {
    const double t = factor * kFirstTime * std::pow(kLastTime / kFirstTime, i / (kTimes - 1.0));
    const Eigen::VectorXd values = vibration.ramp(t);
    result.time.push_back(t);
    result.deflection.push_back(values(0));
    result.edge_moment.push_back(values(1 + n_stations));
    for (Eigen::Index s = 0; s < n_stations; ++s) result.axis_moment.push_back(values(1 + s));
  }
  const Eigen::VectorXd at_rest = vibration.at_rest_outputs();
  result.static_deflection = at_rest(0);
  result.static_edge_moment = at_rest(1 + n_stations);
  result.static_axis_moment = to_vector(at_rest.segment(1, n_stations));
  result.axis_normal = m.axis_normal;
  result.edge_normal = m.edge_normal;
  return result;
}

tl::expected<EdgeResponses, PlateError> solve(const EdgeGeometry& geometry, const EdgeOptions& options) {
  const auto edge = MovingEdge::prepare(geometry, options);
  if (!edge) return tl::unexpected(edge.error());
  return edge->respond(geometry);
}

SeriesWeights series_weights(const std::vector<double>& time, double t) {
  const std::size_t n = time.size();
  BRASH_EXPECTS(n >= 4 && t >= 0.0, n, t);
  if (t <= time.front()) return {0, {t / time.front(), 0.0, 0.0, 0.0}, 0.0};
  if (t >= time.back()) return {n - 4, {0.0, 0.0, 0.0, time.back() / t}, 1.0 - time.back() / t};
  const double step = std::log(time.back() / time.front()) / static_cast<double>(n - 1);
  const double place = std::log(t / time.front()) / step;
  const std::size_t first = std::clamp<std::size_t>(static_cast<std::size_t>(place), 1, n - 3) - 1;
  // Lagrange's cubic on four points a unit apart.
  const double x = place - static_cast<double>(first);
  return {first,
          {-(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0, 0.5 * x * (x - 2.0) * (x - 3.0), -0.5 * x * (x - 1.0) * (x - 3.0),
           x * (x - 1.0) * (x - 2.0) / 6.0},
          0.0};
}

}  // namespace brash::plate
