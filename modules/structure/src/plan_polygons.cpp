// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <polyclipping/clipper.hpp>

#include "mesh_sections.hpp"

namespace brash::structure {
namespace {

namespace cl = ClipperLib;

/// Side of the grid on which outlines are united [m]. It is a multiple of the side of the geometry's grid, so rounding
/// to that one moves no vertex.
constexpr double kGrid = 1.0 / (1 << 20);
/// A mitre reaches so far, in insets; corners are sharp, insets are thin.
constexpr double kMitre = 4.0;

/// Appends the vertices of an open chain that its chords pass farther than `tolerance` by (Douglas and Peucker, 1973),
/// without its last one.
void simplify(const Outline& ring, std::size_t first, std::size_t last, double tolerance, Outline& kept) {
  const Vec2 from = ring[first], along = ring[last % ring.size()] - from;
  const double length = norm(along);
  double farthest = tolerance;
  std::size_t split = first;
  for (std::size_t i = first + 1; i < last; ++i) {
    const Vec2 arm = ring[i] - from;
    const double away = length > 0.0 ? std::abs(cross(along, arm)) / length : norm(arm);
    if (away > farthest) farthest = away, split = i;
  }
  if (split == first) {
    kept.push_back(from);
    return;
  }
  simplify(ring, first, split, tolerance, kept);
  simplify(ring, split, last, tolerance, kept);
}

/// A ring through some of its vertices, among them the one with the least and the one with the largest x.
Outline simplified(Outline ring, double tolerance) {
  if (ring.size() < 4) return ring;
  std::rotate(ring.begin(), std::ranges::min_element(ring, {}, &Vec2::x), ring.end());
  const auto middle = static_cast<std::size_t>(std::ranges::max_element(ring, {}, &Vec2::x) - ring.begin());
  Outline kept;
  if (middle > 0) simplify(ring, 0, middle, tolerance, kept);
  simplify(ring, middle, ring.size(), tolerance, kept);
  return kept;
}

/// On the grid about a grid point near the regions: small numbers keep the clipper's arithmetic short.
class Grid {
 public:
  explicit Grid(const std::vector<Loops>& regions) {
    for (const Loops& region : regions)
      if (!region.empty()) {
        origin_ = {std::round(region.front().front().x), std::round(region.front().front().y)};
        return;
      }
  }

  cl::Paths paths(const Loops& loops, double tolerance) const {
    cl::Paths paths;
    for (const Outline& loop : loops) {
      cl::Path path;
      for (const Vec2 v : simplified(loop, tolerance))
        path.emplace_back(std::llround((v.x - origin_.x) / kGrid), std::llround((v.y - origin_.y) / kGrid));
      paths.push_back(std::move(path));
    }
    return paths;
  }
  Outline outline(const cl::Path& path) const {
    Outline outline;
    for (const cl::IntPoint p : path)
      outline.push_back({origin_.x + kGrid * static_cast<double>(p.X), origin_.y + kGrid * static_cast<double>(p.Y)});
    return outline;
  }

 private:
  Vec2 origin_{};
};

cl::Paths combined(cl::ClipType how, const cl::Paths& one, const cl::Paths& other = {}) {
  cl::Clipper clipper;
  clipper.StrictlySimple(true);
  clipper.AddPaths(one, cl::ptSubject, true);
  clipper.AddPaths(other, cl::ptClip, true);
  cl::Paths result;
  clipper.Execute(how, result, cl::pftPositive, cl::pftPositive);
  return result;
}

/// The outlines without holes. Without its holes an outline may cover another one.
std::vector<Outline> outlines_of(cl::Paths paths, const Grid& grid, double least_area) {
  const auto n_holes = std::erase_if(paths, [](const cl::Path& path) { return !cl::Orientation(path); });
  if (n_holes > 0 && paths.size() > 1) paths = combined(cl::ctUnion, paths);
  std::vector<Outline> outlines;
  for (const cl::Path& path : paths)
    if (path.size() >= 3 && cl::Area(path) * kGrid * kGrid > least_area) outlines.push_back(grid.outline(path));
  return outlines;
}

}  // namespace

std::vector<Outline> united(const std::vector<Loops>& regions, double tolerance) {
  const Grid grid(regions);
  cl::Paths all;
  for (const Loops& region : regions)
    for (cl::Path& path : grid.paths(region, tolerance)) all.push_back(std::move(path));
  return outlines_of(combined(cl::ctUnion, all), grid, tolerance * tolerance);
}

std::vector<Outline> common(const std::vector<Loops>& regions, double tolerance, double inset) {
  if (regions.empty()) return {};
  const Grid grid(regions);
  cl::Paths shared = combined(cl::ctUnion, grid.paths(regions.front(), tolerance));
  for (std::size_t i = 1; i < regions.size() && !shared.empty(); ++i)
    shared = combined(cl::ctIntersection, shared, grid.paths(regions[i], tolerance));
  if (inset > 0.0) {
    cl::ClipperOffset offset(kMitre);
    offset.AddPaths(shared, cl::jtMiter, cl::etClosedPolygon);
    cl::Paths moved;
    offset.Execute(moved, -inset / kGrid);
    shared = combined(cl::ctUnion, moved);
  }
  return outlines_of(std::move(shared), grid, tolerance * tolerance);
}

}  // namespace brash::structure
