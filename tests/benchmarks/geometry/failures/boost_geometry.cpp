// SPDX-License-Identifier: GPL-3.0-or-later
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "peers.hpp"

// Boost.Geometry in doubles.
namespace brash::benchmarks {

namespace {

namespace bg = boost::geometry;
using BoostPoint = bg::model::d2::point_xy<double>;
using BoostPolygon = bg::model::polygon<BoostPoint, false, false>;
using BoostPolygons = bg::model::multi_polygon<BoostPolygon>;

void append(const geometry::Ring& from, BoostPolygon::ring_type& to) {
  for (const geometry::Point p : from) to.emplace_back(metres(p).x, metres(p).y);
}

void append(const BoostPolygon::ring_type& from, Loops& to) {
  std::vector<Vec2>& loop = to.emplace_back();
  for (const BoostPoint& p : from) loop.push_back({p.x(), p.y()});
}

Loops difference(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  BoostPolygons sheet;
  for (const geometry::Polygon& polygon : ice) {
    BoostPolygon& to = sheet.emplace_back();
    append(polygon.outline, to.outer());
    for (const geometry::Ring& hole : polygon.holes) append(hole, to.inners().emplace_back());
  }
  BoostPolygon cutter;
  append(region, cutter.outer());
  if (!bg::is_valid(sheet) || !bg::is_valid(cutter)) throw Refused("is_valid");
  BoostPolygons rest;
  bg::difference(sheet, cutter, rest);
  Loops loops;
  for (const BoostPolygon& polygon : rest) {
    append(polygon.outer(), loops);
    for (const auto& inner : polygon.inners()) append(inner, loops);
  }
  return loops;
}

const Registration kRegistration("Boost.Geometry, double", difference);

}  // namespace

}  // namespace brash::benchmarks
