// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"

namespace brash::floes {
namespace {

constexpr int kDirections = 12;
/// In each direction; odd, so that one section halves a symmetric floe. Between two sections a moment may be missed: at
/// most a sixth of the largest under a point load in the middle half of a free floe.
constexpr int kSectionsEach = 17;

/// Integrals over a part of the plan.
struct Moments {
  double area = 0.0;  ///< [m2]
  Vec2 first{};       ///< of r [m3]
  Vec2 second{};      ///< of dot(normal, r) r [m4]

  /// Adds the triangle from the origin to a, b.
  void add(Vec2 normal, Vec2 a, Vec2 b) {
    const double twice = cross(a, b), at_a = dot(normal, a), at_b = dot(normal, b);
    area += twice / 2.0;
    first += twice / 6.0 * (a + b);
    second += twice / 24.0 * (at_a * a + at_b * b + (at_a + at_b) * (a + b));
  }
};

/// The ice beyond a line, and the length of the line in the ice.
struct Beyond {
  Moments moments;
  double width = 0.0;  ///< [m]
};

/// Adds the part of a ring beyond a section's line. It comes back along the line, from where it leaves to where it
/// enters: both parts of that way are taken from the line's foot.
void add_ring(Beyond& beyond, const std::vector<Vec2>& ring, Vec2 normal, double offset) {
  const Vec2 along = perpendicular(normal), foot = offset * normal;
  Vec2 a = ring.back();
  double height_a = dot(normal, a) - offset;
  for (const Vec2 b : ring) {
    const double height_b = dot(normal, b) - offset;
    const bool begins = height_a > 0.0, ends = height_b > 0.0;
    if (begins && ends) beyond.moments.add(normal, a, b);
    if (begins != ends) {
      const double place = dot(along, a) + height_a / (height_a - height_b) * dot(along, b - a);
      const Vec2 crossing = foot + place * along;
      beyond.moments.add(normal, begins ? a : foot, crossing);
      beyond.moments.add(normal, crossing, begins ? foot : b);
      beyond.width += begins ? place : -place;
    }
    a = b;
    height_a = height_b;
  }
}

Beyond beyond(const Prism& floe, Vec2 normal, double offset) {
  Beyond result;
  for (const std::vector<Vec2>& ring : floe.rings) add_ring(result, ring, normal, offset);
  return result;
}

/// Squared radius of gyration of the thickness: a rotation about an axis in the plane moves the faces against each
/// other.
double gyration(double thickness) { return thickness * thickness / 12.0; }

Section section_of(const Prism& floe, Vec2 normal, double offset) {
  const auto [ice, width] = beyond(floe, normal, offset);
  return {.normal = normal,
          .offset = offset,
          .width = width,
          .spread = width >= floe.thickness ? 1.0 / (width * floe.thickness) : 0.0,
          .area = ice.area,
          .swing = cross(ice.first, normal),
          .lever = dot(normal, ice.first) - offset * ice.area,
          .levers = ice.second - offset * ice.first + gyration(floe.thickness) * ice.area * normal};
}

/// Least and largest way of the plan along a direction [m].
std::pair<double, double> extent_along(const Prism& floe, Vec2 direction) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const Vec2 vertex : floe.rings.front()) {
    lower = std::min(lower, dot(direction, vertex));
    upper = std::max(upper, dot(direction, vertex));
  }
  return {lower, upper};
}

}  // namespace

Sections::Sections(const Prism& floe) : thickness_(floe.thickness) {
  constexpr double kBeforeAll = -1e9;  // a line with the whole floe beyond it
  const Moments along_x = beyond(floe, {1.0, 0.0}, kBeforeAll).moments;
  const Moments along_y = beyond(floe, {0.0, 1.0}, kBeforeAll).moments;
  area_ = along_x.area;
  second_ = {along_x.second.x, along_y.second.y};
  for (int i = 0; i < kDirections; ++i) {
    const double angle = kPi * i / kDirections;
    const Vec2 normal{std::cos(angle), std::sin(angle)};
    const auto [lower, upper] = extent_along(floe, normal);
    const double room = upper - lower - 2.0 * thickness_;
    if (room < 0.0) continue;
    for (int j = 0; j < kSectionsEach; ++j)
      sections_.push_back(section_of(floe, normal, lower + thickness_ + room * j / (kSectionsEach - 1)));
  }
}

std::vector<SectionLoad> Sections::loads(std::span<const PointForce> forces) const {
  Vec3 force;
  Vec2 tilting;  // first moment of the forces across the plate
  double turning = 0.0;
  for (const PointForce& f : forces) {
    force += f.force;
    tilting += f.force.z * plan(f.point) - f.point.z * plan(f.force);
    turning += cross(plan(f.point), plan(f.force));
  }
  // The inertia per area: across the plate lift + slope . r, in its plane drift + turn z x r.
  const double rotary = gyration(thickness_) * area_;
  const double lift = -force.z / area_, turn = -turning / (second_.x + second_.y);
  const Vec2 slope{-tilting.x / (second_.x + rotary), -tilting.y / (second_.y + rotary)};
  const Vec2 drift = -plan(force) / area_;

  std::vector<SectionLoad> loads;
  loads.reserve(sections_.size());
  for (const Section& s : sections_)
    loads.push_back(
        {.moment = lift * s.lever + dot(slope, s.levers), .thrust = s.area * dot(drift, s.normal) + turn * s.swing});
  for (std::size_t first = 0; first < sections_.size(); first += kSectionsEach) {
    const Vec2 normal = sections_[first].normal;
    for (const PointForce& f : forces) {
      const double place = dot(normal, plan(f.point)), pull = dot(normal, plan(f.force));
      for (std::size_t i = first; i < first + kSectionsEach && place > sections_[i].offset; ++i) {
        loads[i].moment += (place - sections_[i].offset) * f.force.z - f.point.z * pull;
        loads[i].thrust += pull;
      }
    }
  }
  return loads;
}

double Sections::tension(std::size_t i, const SectionLoad& load) const {
  return sections_[i].spread * (6.0 / thickness_ * std::abs(load.moment) + load.thrust);
}

}  // namespace brash::floes
