// SPDX-License-Identifier: GPL-3.0-or-later
#include "brash/floes/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace brash::floes {
namespace {

/// Pieces of the wetted surface, about: the share of a region then errs by a few per cent.
constexpr double kPieces = 1000.0;
/// Side of the cubes in which places are looked for, over a place's longest side.
constexpr double kCell = 1.0;
/// Share of a length by which rounding may move a place from one side of a floe's face to the other, amply.
constexpr double kRounding = 1e-9;
/// Floes that a worker takes at a time: most are far from the hull.
constexpr std::size_t kFloesAboutHull = 16;

struct Triangle {
  Vec3 a, b, c;
  Vec3 vector_area() const { return 0.5 * cross(b - a, c - a); }
  Vec3 middle() const { return (a + b + c) / 3.0; }
};

/// Calls `visit` with the pieces of a triangle, whose longest sides are halved until none is longer than `longest`.
template <typename Visit>
void divide(const Triangle& t, double longest, const Visit& visit) {
  const double ab = norm(t.b - t.a), bc = norm(t.c - t.b), ca = norm(t.a - t.c);
  if (std::max({ab, bc, ca}) <= longest) return visit(t);
  if (bc > ab && bc >= ca) return divide({t.b, t.c, t.a}, longest, visit);
  if (ca > ab) return divide({t.c, t.a, t.b}, longest, visit);
  const Vec3 half = 0.5 * (t.a + t.b);
  divide({t.a, half, t.c}, longest, visit);
  divide({half, t.b, t.c}, longest, visit);
}

template <typename Visit>
void for_each_triangle(const structure::TriangleMesh& mesh, const Visit& visit) {
  for (const auto& [i, j, k] : mesh.triangles)
    visit(Triangle{mesh.vertices[static_cast<std::size_t>(i)], mesh.vertices[static_cast<std::size_t>(j)],
                   mesh.vertices[static_cast<std::size_t>(k)]});
}

bool is_in(const Prism& prism, Vec3 p) {
  if (std::abs(p.z) > 0.5 * prism.thickness) return false;
  return std::ranges::any_of(prism.parts, [at = plan(p)](const std::vector<Vec2>& part) {
    for (std::size_t i = 0; i < part.size(); ++i)
      if (cross(part[(i + 1) % part.size()] - part[i], at - part[i]) < 0.0) return false;
    return true;
  });
}

/// Of a sphere about the body's origin that holds the prism [m].
double radius(const Prism& prism) {
  double most = 0.0;  // squared
  for (const Vec2 corner : prism.rings.front()) most = std::max(most, dot(corner, corner));
  return (1.0 + kRounding) * std::sqrt(most + 0.25 * prism.thickness * prism.thickness);
}

}  // namespace

Coverage::Coverage(const structure::Hull& hull, const structure::Regions& regions, double thickness) {
  double wetted = 0.0;
  for_each_triangle(hull.mesh(), [&](const Triangle& t) {
    if (t.middle().z < 0.0) wetted += norm(t.vector_area());
  });
  const double longest = std::sqrt(2.0 * wetted / kPieces);
  for_each_triangle(hull.mesh(), [&](const Triangle& whole) {
    divide(whole, longest, [&](const Triangle& t) {
      const Vec3 middle = t.middle();
      const double area = norm(t.vector_area());
      if (!(middle.z < 0.0) || !(area > 0.0)) return;
      const Vec3 outward = t.vector_area() / area;
      const std::size_t region = regions.at(middle, outward);
      if (region >= area_.size()) return;  // legs
      places_.push_back({middle + 0.5 * thickness * outward, area, region});
      area_[region] += area;
      reach_ = std::max(reach_, norm(places_.back().ahead));
    });
  });
  gather_cells(kCell * longest);
}

/// The places in each cube of side `side` [m].
void Coverage::gather_cells(double side) {
  std::map<std::array<double, 3>, std::vector<std::size_t>> cubes;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Vec3 at = places_[i].ahead / side;
    cubes[{std::floor(at.x), std::floor(at.y), std::floor(at.z)}].push_back(i);
  }
  const double radius = (0.5 * std::sqrt(3.0) + kRounding) * side;
  for (auto& [cube, places] : cubes)  // in the order of x
    cells_.push_back({side * (Vec3{cube[0], cube[1], cube[2]} + Vec3{0.5, 0.5, 0.5}), radius, std::move(places)});
}

void Coverage::mark_under(const Prism& prism, const Pose& pose, const Pose& structure, std::vector<char>& marks) const {
  const double size = radius(prism);
  const Vec3 centre = to_body(structure, pose.position);
  if (norm(centre) > reach_ + size) return;
  const Vec3 upwards = rotate(conjugate(structure.rotation), rotate(pose.rotation, {0.0, 0.0, 1.0}));
  const double half = 0.5 * prism.thickness + kRounding * (reach_ + size);
  const auto x = [](const Cell& cell) { return cell.centre.x; };
  const double far = size + cells_.front().radius;
  for (auto at = std::ranges::lower_bound(cells_, centre.x - far, {}, x);
       at != cells_.end() && x(*at) <= centre.x + far; ++at) {
    const Cell& cell = *at;
    const Vec3 to_cell = cell.centre - centre;
    if (std::abs(dot(to_cell, upwards)) > half + cell.radius || dot(to_cell, to_cell) > far * far) continue;
    for (const std::size_t i : cell.places) {
      const Vec3 ahead = places_[i].ahead, apart = ahead - centre;
      if (marks[i] || std::abs(dot(apart, upwards)) > half || dot(apart, apart) > size * size) continue;
      if (is_in(prism, to_body(pose, to_world(structure, ahead)))) marks[i] = 1;
    }
  }
}

CoveredShares Coverage::by(const rigid_body::World& world, const FloePopulation& floes, const Pose& structure) const {
  CoveredShares covered{};
  if (places_.empty()) return covered;
  std::vector<std::vector<char>> marks(static_cast<std::size_t>(world.workers().count()));  // of each worker
  for (std::vector<char>& own : marks) own.resize(places_.size());
  const std::vector<BodyId> bodies = world.floes();
  world.workers().chunks(bodies.size(), kFloesAboutHull, [&](std::size_t begin, std::size_t end, int worker) {
    for (std::size_t i = begin; i < end; ++i)
      mark_under(floes.at(bodies[i]).prism, world.pose(bodies[i]), structure, marks[static_cast<std::size_t>(worker)]);
  });
  for (std::size_t i = 0; i < places_.size(); ++i)
    if (std::ranges::any_of(marks, [i](const std::vector<char>& own) { return own[i] != 0; }))
      covered[places_[i].region] += places_[i].area;
  for (std::size_t region = 0; region < covered.size(); ++region)
    if (area_[region] > 0.0) covered[region] /= area_[region];
  return covered;
}

}  // namespace brash::floes
