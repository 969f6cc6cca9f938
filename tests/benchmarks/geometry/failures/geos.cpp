// SPDX-License-Identifier: GPL-3.0-or-later
#include <geos_c.h>

#include <memory>
#include <stdexcept>

#include "peers.hpp"

// GEOS OverlayNG in doubles.
namespace brash::benchmarks {

namespace {

struct Free {
  void operator()(GEOSGeometry* geometry) const { GEOSGeom_destroy(geometry); }
};
using Geometry = std::unique_ptr<GEOSGeometry, Free>;

GEOSGeometry* ring_of(const geometry::Ring& ring) {
  const auto n = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create(n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) {
    const Vec2 p = metres(ring[i % n]);
    GEOSCoordSeq_setXY(points, i, p.x, p.y);
  }
  return GEOSGeom_createLinearRing(points);
}

GEOSGeometry* polygon_of(const geometry::Polygon& polygon) {
  std::vector<GEOSGeometry*> holes;
  for (const geometry::Ring& hole : polygon.holes) holes.push_back(ring_of(hole));
  return GEOSGeom_createPolygon(ring_of(polygon.outline), holes.data(), static_cast<unsigned>(holes.size()));
}

void append(const GEOSGeometry* ring, bool is_hole, Loops& loops) {
  const GEOSCoordSequence* points = GEOSGeom_getCoordSeq(ring);
  unsigned n = 0;
  GEOSCoordSeq_getSize(points, &n);
  if (n == 0) return;
  char is_ccw = 0;
  GEOSCoordSeq_isCCW(points, &is_ccw);
  std::vector<Vec2>& loop = loops.emplace_back();
  for (unsigned i = 0; i + 1 < n; ++i) {
    Vec2& p = loop.emplace_back();
    GEOSCoordSeq_getXY(points, i, &p.x, &p.y);
  }
  if ((is_ccw != 0) == is_hole) std::vector<Vec2>(loop.rbegin(), loop.rend()).swap(loop);
}

Loops difference(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  static const bool is_ready = (initGEOS(nullptr, nullptr), true);
  (void)is_ready;
  std::vector<GEOSGeometry*> parts;
  for (const geometry::Polygon& polygon : ice) parts.push_back(polygon_of(polygon));
  const Geometry sheet(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())));
  const Geometry cutter(polygon_of({region, {}}));
  const Geometry rest(GEOSDifference(sheet.get(), cutter.get()));
  if (!rest) throw std::runtime_error("GEOSDifference failed");
  Loops loops;
  for (int i = 0; i < GEOSGetNumGeometries(rest.get()); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN(rest.get(), i);
    if (GEOSGeomTypeId(part) != GEOS_POLYGON || GEOSisEmpty(part)) continue;
    append(GEOSGetExteriorRing(part), false, loops);
    for (int k = 0; k < GEOSGetNumInteriorRings(part); ++k) append(GEOSGetInteriorRingN(part, k), true, loops);
  }
  return loops;
}

const Registration kRegistration("GEOS OverlayNG, double", difference);

}  // namespace

}  // namespace brash::benchmarks
