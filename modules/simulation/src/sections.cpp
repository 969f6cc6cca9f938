// SPDX-License-Identifier: GPL-3.0-or-later
#include "sections.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "brash/core/constants.hpp"

namespace brash::simulation {
namespace {

constexpr int kDirections = 12;
/// In each direction; odd, so that one of them halves a symmetric floe. Between two of them a moment may be missed: at
/// most a tenth of the largest under a point load.
constexpr int kSectionsEach = 9;

/// Adds the triangle from the origin to a, b to what lies beyond a section.
void add_triangle(Section& section, Vec2 a, Vec2 b) {
  const double twice = cross(a, b);
  const double at_a = dot(section.normal, a), at_b = dot(section.normal, b);
  section.area += twice / 2.0;
  section.first += twice / 6.0 * (a + b);
  section.second += twice / 24.0 * (at_a * a + at_b * b + (at_a + at_b) * (a + b));
}

/// Adds the part of a ring beyond a section. Its crossings close it along the section's line.
void add_ring(Section& section, const std::vector<Vec2>& ring) {
  const Vec2 along = perpendicular(section.normal);
  const Vec2 foot = section.offset * section.normal;
  Vec2 a = ring.back();
  double height_a = dot(section.normal, a) - section.offset;
  for (const Vec2 b : ring) {
    const double height_b = dot(section.normal, b) - section.offset;
    const bool begins = height_a > 0.0, ends = height_b > 0.0;
    if (begins && ends) {
      add_triangle(section, a, b);
    } else if (begins != ends) {
      const double place = dot(along, a) + height_a / (height_a - height_b) * dot(along, b - a);
      const Vec2 crossing = foot + place * along;
      // Beyond the section the ring comes back along the line, from where it leaves to where it enters: both parts of
      // that way are taken from the line's foot.
      if (begins) {
        add_triangle(section, a, crossing);
        add_triangle(section, crossing, foot);
      } else {
        add_triangle(section, foot, crossing);
        add_triangle(section, crossing, b);
      }
      section.width += begins ? place : -place;
    }
    a = b;
    height_a = height_b;
  }
}

Section section_of(const Prism& floe, Vec2 normal, double offset) {
  Section section{.normal = normal, .offset = offset};
  for (const std::vector<Vec2>& ring : floe.rings) add_ring(section, ring);
  return section;
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
  constexpr double kBeforeAll = -1e9;  // a section with the whole floe beyond it
  const Section along_x = section_of(floe, {1.0, 0.0}, kBeforeAll), along_y = section_of(floe, {0.0, 1.0}, kBeforeAll);
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
  // The inertia per area: across the plate lift + slope . r, in its plane drift + turn z x r. Rotation about an axis in
  // the plane also moves the faces against each other, as a squared radius of gyration.
  const double gyration = thickness_ * thickness_ / 12.0;
  const double lift = -force.z / area_, turn = -turning / (second_.x + second_.y);
  const Vec2 slope{-tilting.x / (second_.x + gyration * area_), -tilting.y / (second_.y + gyration * area_)};
  const Vec2 drift = -plan(force) / area_;

  std::vector<SectionLoad> loads;
  loads.reserve(sections_.size());
  for (const Section& s : sections_) {
    SectionLoad load{.moment = lift * (dot(s.normal, s.first) - s.offset * s.area) +
                               dot(slope, s.second - s.offset * s.first) + gyration * s.area * dot(slope, s.normal),
                     .thrust = s.area * dot(drift, s.normal) + turn * cross(s.first, s.normal)};
    for (const PointForce& f : forces) {
      const double arm = dot(s.normal, plan(f.point)) - s.offset;
      if (arm <= 0.0) continue;
      const double pull = dot(s.normal, plan(f.force));
      load.moment += arm * f.force.z - f.point.z * pull;
      load.thrust += pull;
    }
    loads.push_back(load);
  }
  return loads;
}

double Sections::tension(std::size_t i, const SectionLoad& load) const {
  const double width = sections_[i].width;
  if (width <= 0.0) return 0.0;
  return (6.0 * std::abs(load.moment) / thickness_ + load.thrust) / (width * thickness_);
}

}  // namespace brash::simulation
