// SPDX-License-Identifier: GPL-3.0-or-later
#include "narrow_phase.hpp"

#include <algorithm>
#include <cmath>

namespace brash::rigid_body {
namespace {

/// A separating axis of two edges counts only if its depth is below the depth of the best face by more than this share.
/// An edge of one part that lies all but in a face of the other must not tilt the normal of a face contact.
constexpr double kShorter = 1e-6;

/// How far beyond a surface the search for a continuing part looks [m]: many times the gap that rounding leaves between
/// parts of one solid (1e-9), far below any part.
constexpr double kBeyond = 1e-6;

/// A face whose normal has more than this along z is not a side of a sheet [-].
constexpr double kOutOfPlane = 1e-6;

bool any_contains(std::span<const Part* const> parts, Vec3 point) {
  return std::any_of(parts.begin(), parts.end(), [&](const Part* part) {
    return std::all_of(part->now.planes.begin(), part->now.planes.end(),
                       [&](const Plane& plane) { return dot(plane.normal, point) < plane.offset; });
  });
}

/// Whether moving the first part by `normal` out of the overlap leads it into a part beside the second, or the second
/// into a part beside the first: looks just beyond the overlap on either side.
bool leads_on(const Overlap& overlap, Vec3 normal, std::span<const Part* const> beside_first,
              std::span<const Part* const> beside_second) {
  Vec3 centre{};
  for (const Vec3& v : overlap.vertices) centre += v;
  centre = centre / static_cast<double>(overlap.vertices.size());
  double lowest = 0.0;
  double highest = 0.0;
  for (const Vec3& v : overlap.vertices) {
    lowest = std::min(lowest, dot(normal, v - centre));
    highest = std::max(highest, dot(normal, v - centre));
  }
  return any_contains(beside_second, centre + (highest + kBeyond) * normal) ||
         any_contains(beside_first, centre + (lowest - kBeyond) * normal);
}

}  // namespace

/// The separating axis of least depth through a face that is a surface of its body. If there is none (deep inside a
/// solid of many parts), the axis of least depth through any face.
SeparatingAxis NarrowPhase::best_face(const Beside& beside) {
  const Overlap& overlap = finder_.last();
  const auto shorter = [](const SeparatingAxis& a, const SeparatingAxis& b) { return a.depth < b.depth; };
  const SeparatingAxis shortest = *std::min_element(overlap.axes.begin(), overlap.axes.end(), shorter);
  if (beside.none() || !leads_on(overlap, shortest.normal, beside.first, beside.second)) return shortest;
  // Few are tried before one leads out, so they are ordered as they are asked for, the first of equals first.
  axes_ = overlap.axes;
  for (auto rest = axes_.begin(); rest != axes_.end(); ++rest) {
    const auto next = std::min_element(rest, axes_.end(), shorter);
    std::rotate(rest, next, next + 1);
    if (!leads_on(overlap, rest->normal, beside.first, beside.second)) return *rest;
  }
  return shortest;
}

/// The direction of the separating axis of least depth that ends at a surface: through a face of either part or from
/// edge to edge.
Vec3 NarrowPhase::direction(const Beside& beside) {
  const SeparatingAxis face = best_face(beside);
  for (const SeparatingAxis& axis :
       edge_axes_.find(finder_, pair_.first->now, pair_.second->now, (1.0 - kShorter) * face.depth))
    if (beside.none() || !leads_on(finder_.last(), axis.normal, beside.first, beside.second)) return axis.normal;
  return face.normal;
}

bool NarrowPhase::overlap(const PartPair& pair) {
  pair_ = pair;
  return finder_.find(pair.first->now, pair.second->now).vertices.size() >= 4;
}

bool NarrowPhase::find_contact(const Beside& beside) {
  normal = direction(beside);
  patch = finder_.project(normal);
  return patch.n_points > 0;
}

bool NarrowPhase::find_contact_in_plane(const Beside& beside) {
  axes_ = finder_.last().axes;
  std::erase_if(axes_, [](const SeparatingAxis& axis) { return std::abs(axis.normal.z) > kOutOfPlane; });
  std::stable_sort(axes_.begin(), axes_.end(),
                   [](const SeparatingAxis& a, const SeparatingAxis& b) { return a.depth < b.depth; });
  const auto surface = std::find_if(axes_.begin(), axes_.end(), [&](const SeparatingAxis& axis) {
    return !leads_on(finder_.last(), axis.normal, beside.first, beside.second);
  });
  if (surface == axes_.end()) return false;
  normal = normalized(Vec3{surface->normal.x, surface->normal.y, 0.0});
  patch = finder_.project(normal);
  return patch.n_points > 0;
}

}  // namespace brash::rigid_body
