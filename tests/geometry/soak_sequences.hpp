// SPDX-License-Identifier: GPL-3.0-or-later
// Random and adversarial sequences of cuts, from a seed: the same on every machine.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "brash/geometry/ice_sheet.hpp"
#include "shapes.hpp"

namespace brash::geometry::soak {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double uniform(double low, double high) { return low + (high - low) * shapes::uniform(engine_); }
  int below(int n) { return static_cast<int>(engine_() % static_cast<std::uint64_t>(n)); }
  bool one_in(int n) { return below(n) == 0; }
  double log_uniform(double low, double high) { return low * std::pow(high / low, uniform(0.0, 1.0)); }
  template <typename T>
  const T& of(const std::vector<T>& values) {
    return values[static_cast<std::size_t>(below(static_cast<int>(values.size())))];
  }
  std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
};

struct Event {
  Ring region;
  std::vector<Crack> cracks;
};

inline Ring moved(Ring ring, Point by) {
  for (Point& p : ring) p = p + by;
  return ring;
}

/// The point, or one of its eight neighbours on the grid.
inline Point nudged(Random& random, Point p) {
  const auto x = random.below(3) - 1;
  return p + Point::of_units(x, random.below(3) - 1);
}

/// One to five components of 3 to 64 sides, ragged, round or square, each with up to three holes, 16 m apart.
inline std::vector<Polygon> make_sheet(Random& random) {
  std::vector<Polygon> sheet;
  const int n = 1 + random.below(5);
  for (int i = 0; i < n; ++i) {
    const Vec2 centre{16.0 * i, 16.0 * random.below(2)};
    Polygon& part = sheet.emplace_back();
    const double radius = random.uniform(3.0, 7.0);
    switch (random.below(3)) {
      case 0:
        part.outline = disc(centre, radius, 3 + random.below(62), random.uniform(0.0, 6.0));
        break;
      case 1:
        part.outline = shapes::box(centre.x - 4.0, centre.y - 4.0, centre.x + 4.0, centre.y + 4.0);
        break;
      default:
        for (const Point p : shapes::star(random.engine(), 8 + random.below(40), 0.6)) {
          part.outline.push_back(snap(centre + 7.0 * metres(p)));
        }
    }
    // A disc of three sides holds half its radius, so the holes stay inside whatever the outline is.
    const int holes = random.below(4);
    for (int k = 0; k < holes; ++k) {
      const Vec2 at = centre + 0.8 * Vec2{std::cos(2.1 * k), std::sin(2.1 * k)};
      part.holes.push_back(shapes::reversed(disc(at, random.uniform(0.05, 0.5), 3 + random.below(10))));
    }
  }
  return sheet;
}

/// Draws the next event from the sheet's polygons (which may be some events old) and from the events before.
class Events {
 public:
  Event next(Random& random, const std::vector<Polygon>& ice) {
    Event event;
    const int kind = random.below(20);
    if (kind < 12 || past_.empty()) {
      event = crack_event(random, ice);
    } else if (kind < 14) {
      // Again, or one unit beside.
      event.region = moved(random.of(past_), random.one_in(2) ? Point{} : nudged(random, Point{}));
    } else if (kind < 16) {
      event.region = beside_edge(random, ice);
    } else if (kind < 18) {
      event.region = through_vertices(random, ice);
    } else if (kind < 19) {
      event.region = star_cutter(random, ice);
    } else {
      // A whole part, or all of it but a unit.
      const Ring& outline = random.of(ice).outline;
      event.region = moved(outline, random.one_in(2) ? Point{} : nudged(random, Point{}));
      if (outline.size() > 24 || !random.one_in(4)) event = crack_event(random, ice);
    }
    if (event.region.size() < 3 || signed_area(event.region) <= ExactArea{}) event = crack_event(random, ice);
    while (event.cracks.empty() && random.one_in(3)) event.cracks.push_back(any_crack(random, event.region, ice));
    past_.push_back(event.region);
    if (past_.size() > 8) past_.erase(past_.begin());
    return event;
  }

 private:
  static const Ring& any_ring(Random& random, const std::vector<Polygon>& ice) {
    const Polygon& polygon = random.of(ice);
    return polygon.holes.empty() || random.one_in(2) ? polygon.outline : random.of(polygon.holes);
  }

  /// A vertex, the middle of an edge, a place on one, or anywhere near; one in four a unit off.
  static Point any_centre(Random& random, const std::vector<Polygon>& ice) {
    const Ring& ring = any_ring(random, ice);
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
    const Vec2 a = metres(ring[i]);
    const Vec2 b = metres(ring[(i + 1) % ring.size()]);
    Point at = ring[i];
    const int kind = random.below(5);
    if (kind == 1) at = snap(0.5 * (a + b));
    if (kind == 2) at = snap(a + random.uniform(0.0, 1.0) * (b - a));
    if (kind == 3) at = snap(a + Vec2{random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)});
    if (kind == 4) at = snap({0.5 * std::round(2.0 * a.x), 0.5 * std::round(2.0 * a.y)});
    return random.one_in(4) ? nudged(random, at) : at;
  }

  /// A disc of 3 to 64 sides with cracks from its centre to its vertices.
  static Event crack_event(Random& random, const std::vector<Polygon>& ice) {
    const Point centre = any_centre(random, ice);
    Event event;
    int sides = 3 + random.below(62);
    double radius = random.log_uniform(0.1, 2.0);
    const int size = random.below(100);
    if (size < 15) {
      // So small that the grid shows; with more sides than that the vertices would fall together.
      radius = random.log_uniform(3.0, 1e6) * kGridUnit;
      if (radius < 100.0 * kGridUnit) sides = 3 + sides % 6;
    } else if (size < 17) {
      radius = random.log_uniform(4.0, 200.0);
    }
    event.region = moved(disc({}, radius, sides, random.one_in(2) ? 0.0 : random.uniform(0.0, 6.0)), centre);
    if (random.one_in(4)) {
      // Tangent: a vertex of the disc on a vertex of the ice.
      const Point touched = random.of(any_ring(random, ice));
      const Point own = random.of(event.region);
      event.region = moved(event.region, touched - own);
    }
    const int n_cracks = random.below(6);
    for (int k = 0; k < n_cracks; ++k) event.cracks.push_back({centre, random.of(event.region)});
    return event;
  }

  /// A quadrilateral that shares an edge with the ice, on either side of it.
  static Ring beside_edge(Random& random, const std::vector<Polygon>& ice) {
    const Ring& ring = any_ring(random, ice);
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
    const Point a = ring[i];
    const Point b = ring[(i + 1) % ring.size()];
    const double width = random.log_uniform(2.0 * kGridUnit, 1.0) * (random.one_in(2) ? 1.0 : -1.0);
    const Vec2 across = width * normalized(perpendicular(metres(b) - metres(a)));
    const Point by = Point::of_units(std::llround(across.x / kGridUnit), std::llround(across.y / kGridUnit));
    Ring region{a, b, b + by, a + by};
    if (signed_area(region) < ExactArea{}) std::reverse(region.begin(), region.end());
    return region;
  }

  /// The triangle of three vertices of the ice, often a sliver.
  static Ring through_vertices(Random& random, const std::vector<Polygon>& ice) {
    const Ring& ring = any_ring(random, ice);
    const auto i = static_cast<std::size_t>(random.below(static_cast<int>(ring.size())));
    Ring region{ring[i], ring[(i + 1) % ring.size()], random.of(ring)};
    if (random.one_in(2)) region[1] = nudged(random, region[1]);
    if (signed_area(region) < ExactArea{}) std::reverse(region.begin(), region.end());
    return region;
  }

  static Ring star_cutter(Random& random, const std::vector<Polygon>& ice) {
    const Point centre = any_centre(random, ice);
    return moved(shapes::star(random.engine(), 5 + random.below(60), 0.1), centre);
  }

  static Crack any_crack(Random& random, const Ring& region, const std::vector<Polygon>& ice) {
    const Point ends[] = {random.of(region), random.of(any_ring(random, ice)), any_centre(random, ice),
                          nudged(random, random.of(region))};
    return {ends[random.below(4)], ends[random.below(4)]};
  }

  std::vector<Ring> past_;
};

}  // namespace brash::geometry::soak
