// SPDX-License-Identifier: GPL-3.0-or-later
#include <polyclipping/clipper.hpp>
#include <stdexcept>

#include "peers.hpp"

// Clipper 6 on the kernel's own grid.
namespace brash::benchmarks {

namespace {

ClipperLib::Path path_of(const geometry::Ring& ring) {
  ClipperLib::Path path;
  for (const geometry::Point p : ring) path.emplace_back(p.x, p.y);
  return path;
}

Loops difference(const std::vector<geometry::Polygon>& ice, const geometry::Ring& region) {
  ClipperLib::Clipper clipper;
  for (const geometry::Polygon& polygon : ice) {
    clipper.AddPath(path_of(polygon.outline), ClipperLib::ptSubject, true);
    for (const geometry::Ring& hole : polygon.holes) clipper.AddPath(path_of(hole), ClipperLib::ptSubject, true);
  }
  clipper.AddPath(path_of(region), ClipperLib::ptClip, true);
  ClipperLib::Paths rest;
  if (!clipper.Execute(ClipperLib::ctDifference, rest, ClipperLib::pftNonZero, ClipperLib::pftNonZero)) {
    throw std::runtime_error("Execute failed");
  }
  Loops loops;
  for (const ClipperLib::Path& path : rest) {
    std::vector<Vec2>& loop = loops.emplace_back();
    for (const ClipperLib::IntPoint& p : path) loop.push_back(metres(geometry::Point::of_units(p.X, p.Y)));
  }
  return loops;
}

const Registration kRegistration("Clipper 6.4", difference);

}  // namespace

}  // namespace brash::benchmarks
