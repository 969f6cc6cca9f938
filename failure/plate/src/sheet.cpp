// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/plate/sheet.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <mutex>
#include <numbers>
#include <utility>

#include "brash/core/contract.hpp"
#include "brash/core/interruption.hpp"
#include "fem.hpp"
#include "profiles.hpp"
#include "quadrature.hpp"
#include "sheet_domain.hpp"
#include "sheet_fem.hpp"
#include "sheet_recovery.hpp"

namespace brash::plate {

namespace {

/// If an edge cannot be meshed, it is simplified this much more, so many times.
constexpr double kCoarser = 2.5;
constexpr int kAttempts = 3;
/// A line may start outside the ice by this much, over l_c: the edge is simplified.
constexpr double kOutside = 0.05;
/// Rings of points on which a patch load acts.
constexpr int kPatchRings = 3;
constexpr int kPatchSpokes = 12;

double seconds_since(std::clock_t start) { return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC; }

/// A place in a triangle.
struct Spot {
  int triangle = 0;
  double xi = 0.0;
  double eta = 0.0;
};

/// The place if it lies in the triangle, to within rounding.
std::optional<Spot> spot_in(const Mesh& mesh, int triangle, Vec2 place) {
  constexpr double kRounding = 1e-9;
  const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
  const Vec2 origin = mesh.vertices[static_cast<std::size_t>(corners[0])];
  const Vec2 u = mesh.vertices[static_cast<std::size_t>(corners[1])] - origin;
  const Vec2 v = mesh.vertices[static_cast<std::size_t>(corners[2])] - origin;
  const double area2 = cross(u, v);
  const double xi = cross(place - origin, v) / area2;
  const double eta = cross(u, place - origin) / area2;
  if (xi < -kRounding || eta < -kRounding || xi + eta > 1.0 + kRounding) return std::nullopt;
  return Spot{triangle, xi, eta};
}

/// Finds the triangles of a mesh that hold a place.
class Locator {
 public:
  explicit Locator(const Mesh& mesh) : mesh_(&mesh) {
    boxes_.reserve(mesh.triangles.size());
    for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
      const auto& corners = mesh.triangles[static_cast<std::size_t>(t)];
      const Vec2 a = mesh.vertices[static_cast<std::size_t>(corners[0])];
      const Vec2 b = mesh.vertices[static_cast<std::size_t>(corners[1])];
      const Vec2 c = mesh.vertices[static_cast<std::size_t>(corners[2])];
      boxes_.push_back({t, std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}),
                        std::max({a.y, b.y, c.y})});
    }
  }

  /// Knows only the triangles on a stretch.
  Locator on(Vec2 from, Vec2 to) const {
    Locator result = *this;
    std::erase_if(result.boxes_, [&](const Box& box) {
      return !box.touches(std::min(from.x, to.x), std::max(from.x, to.x), std::min(from.y, to.y),
                          std::max(from.y, to.y));
    });
    return result;
  }

  /// Every one: two where the place lies on an edge.
  std::vector<Spot> at(Vec2 place) const {
    std::vector<Spot> spots;
    for (const Box& box : boxes_) {
      if (!box.touches(place.x, place.x, place.y, place.y)) continue;
      if (const auto spot = spot_in(*mesh_, box.triangle, place)) spots.push_back(*spot);
    }
    return spots;
  }

 private:
  /// Around a triangle.
  struct Box {
    int triangle = 0;
    double left = 0.0, right = 0.0, low = 0.0, high = 0.0;

    bool touches(double from_x, double to_x, double from_y, double to_y) const {
      constexpr double kMargin = 1e-6;
      return to_x >= left - kMargin && from_x <= right + kMargin && to_y >= low - kMargin && from_y <= high + kMargin;
    }
  };

  const Mesh* mesh_;
  std::vector<Box> boxes_;
};

struct MeshedSheet {
  SheetEdge edge;
  SheetDomain domain;
  Mesh mesh;
};

tl::expected<MeshedSheet, std::string> mesh_once(const LoadedSheet& sheet, const SheetSizes& sizes,
                                                 EdgeTolerance tolerance) {
  auto edge = simplified_edge(sheet, tolerance);
  if (!edge) return tl::unexpected(edge.error());
  auto domain = domain_of(sheet, *edge, sizes);
  if (!domain) return tl::unexpected(domain.error());
  auto mesh = mesh_domain(domain->domain, sizes.most_vertices);
  if (!mesh) return tl::unexpected(mesh.error());
  return MeshedSheet{std::move(*edge), std::move(*domain), std::move(*mesh)};
}

tl::expected<MeshedSheet, std::string> mesh_sheet(const LoadedSheet& sheet, const SheetSizes& sizes) {
  EdgeTolerance tolerance = sizes.tolerance;
  for (int attempt = 1;; ++attempt) {
    auto meshed = mesh_once(sheet, sizes, tolerance);
    if (meshed || attempt == kAttempts) return meshed;
    tolerance.near *= kCoarser;
    tolerance.at_any_price = true;
  }
}

std::vector<EdgeForce> edge_forces(const LoadedSheet& sheet, const SheetEdge& edge, const Mesh& mesh) {
  std::vector<EdgeForce> forces;
  for (const TaggedEdge& tagged : mesh.tagged) {
    if (tagged.side != Side::kTip) continue;
    const auto i = static_cast<std::size_t>(tagged.segment);
    EdgeForce force{.edge = tagged.edge, .outward = perpendicular(normalized(edge.points[i + 1] - edge.points[i]))};
    for (std::size_t l = 0; l < edge.loads.size(); ++l) {
      const auto [first, last] = edge.loads[l];
      if (i < first || i >= last) continue;
      double length = 0.0;
      for (std::size_t j = first; j < last; ++j) length += norm(edge.points[j + 1] - edge.points[j]);
      const EdgeLoad& load = sheet.edge_loads[l];
      force.in_plane += load.in_plane / length;
      force.out_of_plane += load.out_of_plane / length;
      force.moment += load.moment / length;
    }
    forces.push_back(force);
  }
  return forces;
}

/// Points of equal share over the disc of a patch load, those in the ice.
tl::expected<std::vector<PointForce>, std::string> point_forces(const LoadedSheet& sheet, const Locator& locator) {
  std::vector<PointForce> forces;
  for (const PatchLoad& load : sheet.patch_loads) {
    std::vector<Spot> spots;
    const int rings = load.radius > 0.0 ? kPatchRings : 1;
    const int spokes = load.radius > 0.0 ? kPatchSpokes : 1;
    for (int ring = 0; ring < rings; ++ring) {
      const double radius = load.radius * std::sqrt((ring + 0.5) / rings);
      for (int spoke = 0; spoke < spokes; ++spoke) {
        const double angle = 2.0 * std::numbers::pi * (spoke + 0.5 * (ring % 2)) / spokes;
        const auto found = locator.at(load.at + radius * Vec2{std::cos(angle), std::sin(angle)});
        if (!found.empty()) spots.push_back(found.front());
      }
    }
    if (spots.empty()) return tl::unexpected(std::string("a patch load lies off the ice"));
    for (const Spot& spot : spots) {
      forces.push_back({spot.triangle, spot.xi, spot.eta, load.out_of_plane / static_cast<double>(spots.size())});
    }
  }
  return forces;
}

std::vector<int> bending_triangles(const Mesh& mesh, const SheetDomain& domain, double reach) {
  std::vector<int> triangles;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    Vec2 centre;
    for (const int corner : mesh.triangles[static_cast<std::size_t>(t)]) {
      centre += mesh.vertices[static_cast<std::size_t>(corner)] / 3.0;
    }
    const auto is_near = [&](const Segment& s) { return distance_to_stretch(centre, s.from, s.to) < reach; };
    if (std::any_of(domain.focus.begin(), domain.focus.end(), is_near)) triangles.push_back(t);
  }
  return triangles;
}

/// Where a line from a place is in the ice: from `enter` to `leave`.
struct Reach {
  double enter = 0.0;
  double leave = 0.0;
};

Reach reach_of(const Mesh& mesh, const Locator& locator, Vec2 from, Vec2 direction, double length) {
  std::vector<double> crossings;
  for (const TaggedEdge& tagged : mesh.tagged) {
    if (tagged.side == Side::kCrack || tagged.side == Side::kInterior) continue;
    const auto& ends = mesh.edges[static_cast<std::size_t>(tagged.edge)];
    const Vec2 a = mesh.vertices[static_cast<std::size_t>(ends[0])] - from;
    const Vec2 b = mesh.vertices[static_cast<std::size_t>(ends[1])] - from;
    const double left = cross(direction, a);
    const double right = cross(direction, b);
    if ((left > 0.0) == (right > 0.0)) continue;
    crossings.push_back(dot(direction, a) + (dot(direction, b) - dot(direction, a)) * left / (left - right));
  }
  std::sort(crossings.begin(), crossings.end());
  double start = 0.0;
  for (const double crossing : crossings) {
    if (crossing <= start + 1e-9) continue;
    const double end = std::min(crossing, length);
    if (!locator.at(from + 0.5 * (start + end) * direction).empty()) return {start, end};
    if (crossing > kOutside || crossing >= length) break;
    start = crossing;
  }
  return {};
}

std::optional<std::string> fault_of(const LoadedSheet& sheet) {
  const auto finite = [](Vec2 v) { return std::isfinite(v.x) && std::isfinite(v.y); };
  if (sheet.edge_loads.empty() && sheet.patch_loads.empty()) return "there is no load";
  for (const EdgeLoad& load : sheet.edge_loads) {
    if (!finite(load.from) || !finite(load.to) || !finite(load.in_plane) || !std::isfinite(load.out_of_plane) ||
        !std::isfinite(load.moment)) {
      return "a load is not finite";
    }
  }
  for (const PatchLoad& load : sheet.patch_loads) {
    if (!finite(load.at) || !std::isfinite(load.radius) || !std::isfinite(load.out_of_plane))
      return "a load is not finite";
  }
  return std::nullopt;
}

}  // namespace

struct SheetSolution::Impl {
  Mesh mesh;
  SheetFields fields;
  SheetTimes times;
  mutable std::mutex mutex;
  mutable std::optional<SheetRecovery> recovery;
  std::optional<Locator> locator;

  SheetState state(const std::vector<Spot>& spots) const {
    SheetState sum;
    for (const Spot& spot : spots) {
      const SheetState state = recovery->at(spot.triangle, spot.xi, spot.eta);
      const double share = 1.0 / static_cast<double>(spots.size());
      sum.moment = sum.moment + share * state.moment;
      sum.membrane = sum.membrane + share * state.membrane;
      sum.deflection += share * state.deflection;
    }
    return sum;
  }
};

SheetSolution::SheetSolution(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {}
SheetSolution::SheetSolution(SheetSolution&&) noexcept = default;
SheetSolution& SheetSolution::operator=(SheetSolution&&) noexcept = default;
SheetSolution::~SheetSolution() = default;

int SheetSolution::n_elements() const { return static_cast<int>(impl_->mesh.triangles.size()); }
const SheetTimes& SheetSolution::times() const { return impl_->times; }

LineProfile SheetSolution::along(Vec2 from, Vec2 direction, double length, int n_stations) const {
  BRASH_EXPECTS(norm(direction) > 0.0 && length > 0.0 && n_stations >= 2, length, n_stations);
  direction = normalized(direction);
  const std::lock_guard lock(impl_->mutex);
  const Reach reach = reach_of(impl_->mesh, *impl_->locator, from, direction, length);
  LineProfile profile;
  if (reach.leave <= reach.enter) return profile;
  const Locator locator = impl_->locator->on(from, from + reach.leave * direction);
  for (int i = 0; i < n_stations; ++i) {
    const double station = reach.leave * i / (n_stations - 1);
    auto spots = locator.at(from + std::max(reach.enter, station) * direction);
    if (spots.empty()) continue;
    profile.station.push_back(station);
    profile.state.push_back(impl_->state(spots));
  }
  return profile;
}

std::optional<SheetState> SheetSolution::at(Vec2 place) const {
  const std::lock_guard lock(impl_->mutex);
  const auto spots = impl_->locator->at(place);
  if (spots.empty()) return std::nullopt;
  return impl_->state(spots);
}

std::vector<SheetPlace> SheetSolution::at_nodes(const std::function<bool(Vec2)>& wanted) const {
  const std::lock_guard lock(impl_->mutex);
  return impl_->recovery->at_nodes(wanted);
}

tl::expected<SheetSolution, PlateError> solve(const LoadedSheet& sheet) {
  look_for_interruption();
  BRASH_EXPECTS(sheet.thickness > 0.0, sheet.thickness);
  BRASH_EXPECTS(sheet.poisson_ratio >= 0.0 && sheet.poisson_ratio < 0.5, sheet.poisson_ratio);
  const auto failed = [](const std::string& what) { return tl::unexpected(PlateError{what}); };
  if (const auto fault = fault_of(sheet)) return failed(*fault);

  auto impl = std::make_unique<SheetSolution::Impl>();
  const SheetSizes sizes = sizes_of(sheet.accuracy);
  auto start = std::clock();
  auto meshed = mesh_sheet(sheet, sizes);
  if (!meshed) return failed(meshed.error());
  impl->mesh = std::move(meshed->mesh);
  const auto on_edge = edge_forces(sheet, meshed->edge, impl->mesh);
  impl->locator.emplace(impl->mesh);
  const auto inside = point_forces(sheet, *impl->locator);
  if (!inside) return failed(inside.error());
  impl->times.mesh = seconds_since(start);

  start = std::clock();
  impl->fields = {
      sizes.membrane_order, sizes.bending_order, sheet.poisson_ratio, sheet.split, sizes.smallest_patch, {}, {}};
  const Dissection dissection(impl->mesh);
  impl->fields.membrane =
      solve_sheet_membrane(impl->mesh, dissection, sizes.membrane_order, sheet.poisson_ratio, on_edge);
  impl->times.membrane = seconds_since(start);

  start = std::clock();
  const double h = effective_thickness(Theory::kReissnerMindlin, sheet.thickness);
  auto bending = solve_sheet_bending(impl->mesh, dissection, sizes.bending_order,
                                     {.poisson_ratio = sheet.poisson_ratio,
                                      .shear_stiffness = shear_stiffness(sheet.poisson_ratio, h),
                                      .triangles = bending_triangles(impl->mesh, meshed->domain, sizes.bending_reach),
                                      .membrane = sheet.second_order ? &impl->fields.membrane : nullptr,
                                      .membrane_order = sizes.membrane_order},
                                     on_edge, *inside);
  if (!bending)
    return tl::unexpected(PlateError{"bending: the stiffness is not positive definite", sheet.second_order});
  impl->fields.bending = std::move(*bending);
  impl->times.bending = seconds_since(start);
  impl->recovery.emplace(impl->mesh, impl->fields);
  return SheetSolution(std::move(impl));
}

}  // namespace brash::plate
