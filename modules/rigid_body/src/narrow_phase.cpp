// SPDX-License-Identifier: GPL-3.0-or-later
#include "narrow_phase.hpp"

#include <BulletCollision/NarrowPhaseCollision/btGjkPairDetector.h>
#include <BulletCollision/NarrowPhaseCollision/btPointCollector.h>

#include <cmath>

namespace brash::rigid_body {
namespace {

/// GJK/EPA is believed over the best face only where its way out is shorter by more than this share: its own
/// round-off (1e-9 and less in double precision) must not tilt the normal of a face contact.
constexpr double kShorter = 1e-6;

}  // namespace

/// The direction of the shortest way out of the overlap: GJK with EPA, held against the faces of both parts.
///
/// EPA alone can end early on large flat hulls, so its direction counts by the depth that it really gives. What is left
/// to it are contacts of two edges, whose direction is no face's.
Vec3 NarrowPhase::direction(const PartPair& pair, const Overlap& overlap) {
  const Part& a = *pair.first;
  const Part& b = *pair.second;
  btGjkPairDetector detector(&a.hull, &b.hull, &simplex_, &epa_);
  btGjkPairDetector::ClosestPointInput input;
  input.m_transformA = to_bullet(a.body->pose);
  input.m_transformB = to_bullet(b.body->pose);
  btPointCollector closest;
  detector.getClosestPoints(input, closest, nullptr);
  if (!closest.m_hasResult) return overlap.face_normal;
  const Vec3 found = from_bullet(closest.m_normalOnBInWorld);
  const double length = norm(found);
  if (!(length > 0.5)) return overlap.face_normal;
  const double depth = depth_along(a.now, b.now, found / length);
  return depth < (1.0 - kShorter) * overlap.face_depth ? found / length : overlap.face_normal;
}

bool NarrowPhase::find(const PartPair& pair) {
  const Overlap& overlap = finder_.find(pair.first->now, pair.second->now);
  if (overlap.vertices.size() < 4) return false;
  normal = direction(pair, overlap);
  patch = finder_.project(normal);
  return patch.n_points > 0;
}

}  // namespace brash::rigid_body
