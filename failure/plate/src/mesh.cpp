// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_mesh_criteria_2.h>
#include <CGAL/Delaunay_mesh_face_base_2.h>
#include <CGAL/Delaunay_mesher_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <map>

namespace brash::plate {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Delaunay_mesh_face_base_2<Kernel>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// Smallest squared sine of an angle that needs no further refinement: 20.7 degrees, for which the mesher terminates.
constexpr double kAspectBound = 0.125;

/// From the nearest point of a segment to a place.
Vec2 way_from(Vec2 from, Vec2 to, Vec2 place) {
  const Vec2 along = to - from;
  const double length2 = dot(along, along);
  const double s = length2 > 0.0 ? std::clamp(dot(place - from, along) / length2, 0.0, 1.0) : 0.0;
  return place - from - s * along;
}

double distance_to(Vec2 place, Vec2 from, Vec2 to) { return norm(way_from(from, to, place)); }

Vec2 to_vec(const Kernel::Point_2& point) { return {point.x(), point.y()}; }

/// CGAL's mesh criteria with a size that varies in the plane.
class GradedCriteria : public CGAL::Delaunay_mesh_criteria_2<Triangulation> {
 public:
  using Base = CGAL::Delaunay_mesh_criteria_2<Triangulation>;

  explicit GradedCriteria(const Domain& domain) : Base(kAspectBound), domain_(&domain) {}

  /// Size first: elements that are too long, the longest relative to the wanted size first, then sharp ones.
  struct Quality {
    double sine2 = 0.0;
    double excess = 0.0;

    bool operator<(const Quality& other) const {
      if (excess > 1.0 || other.excess > 1.0) return excess > other.excess;
      return sine2 < other.sine2;
    }
  };

  class Is_bad {
   public:
    explicit Is_bad(const Domain& domain) : domain_(&domain) {}

    CGAL::Mesh_2::Face_badness operator()(const Quality& quality) const {
      if (quality.excess > 1.0) return CGAL::Mesh_2::IMPERATIVELY_BAD;
      return quality.sine2 < kAspectBound ? CGAL::Mesh_2::BAD : CGAL::Mesh_2::NOT_BAD;
    }

    CGAL::Mesh_2::Face_badness operator()(const Triangulation::Face_handle& face, Quality& quality) const {
      const Vec2 a = to_vec(face->vertex(0)->point());
      const Vec2 b = to_vec(face->vertex(1)->point());
      const Vec2 c = to_vec(face->vertex(2)->point());
      std::array<double, 3> edges{norm(b - a), norm(c - b), norm(a - c)};
      std::sort(edges.begin(), edges.end());
      const double area2 = std::abs(cross(b - a, c - a));
      const double sine = area2 / (edges[1] * edges[2]);
      quality = {sine * sine, edges[2] / wanted_size(*domain_, (a + b + c) / 3.0)};
      return (*this)(quality);
    }

   private:
    const Domain* domain_;
  };

  Is_bad is_bad_object() const { return Is_bad(*domain_); }

 private:
  const Domain* domain_;
};

std::size_t segment_at(const Domain& domain, Vec2 middle) {
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < domain.segments.size(); ++i) {
    const double distance = distance_to(middle, domain.segments[i].from, domain.segments[i].to);
    if (distance < best) {
      best = distance;
      nearest = i;
    }
  }
  return nearest;
}

Mesh extract(const Domain& domain, Triangulation& triangulation) {
  Mesh mesh;
  for (auto vertex : triangulation.finite_vertex_handles()) vertex->info() = -1;
  std::map<std::array<int, 2>, int> edge_ids;
  for (auto face : triangulation.finite_face_handles()) {
    if (!face->is_in_domain()) continue;
    std::array<int, 3> corners{};
    for (int i = 0; i < 3; ++i) {
      auto vertex = face->vertex(i);
      if (vertex->info() < 0) {
        vertex->info() = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(to_vec(vertex->point()));
      }
      corners[static_cast<std::size_t>(i)] = vertex->info();
    }
    std::array<int, 3> ids{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::array<int, 2> ends{std::min(corners[i], corners[(i + 1) % 3]),
                                    std::max(corners[i], corners[(i + 1) % 3])};
      const auto [entry, is_new] = edge_ids.try_emplace(ends, static_cast<int>(mesh.edges.size()));
      ids[i] = entry->second;
      if (!is_new) continue;
      mesh.edges.push_back(ends);
      // CGAL's face edge j is opposite to its vertex j.
      if (face->is_constrained((static_cast<int>(i) + 2) % 3)) {
        const Vec2 middle =
            0.5 * (mesh.vertices[static_cast<std::size_t>(ends[0])] + mesh.vertices[static_cast<std::size_t>(ends[1])]);
        const std::size_t segment = segment_at(domain, middle);
        mesh.tagged.push_back({ids[i], domain.segments[segment].side, static_cast<int>(segment)});
      }
    }
    mesh.triangles.push_back(corners);
    mesh.triangle_edges.push_back(ids);
  }
  return mesh;
}

}  // namespace

Vec2 place_in(const Mesh& mesh, int triangle, double xi, double eta) {
  const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
  const Vec2 a = mesh.vertices[static_cast<std::size_t>(corners[0])];
  return a + xi * (mesh.vertices[static_cast<std::size_t>(corners[1])] - a) +
         eta * (mesh.vertices[static_cast<std::size_t>(corners[2])] - a);
}

double wanted_size(const Domain& domain, Vec2 place) {
  constexpr double kRounding = 1.0 + 1e-9;
  double size = domain.largest_size;
  for (const auto& source : domain.sizes) {
    const Vec2 way = way_from(source.from, source.to, place);
    // Most sources are too far off to count: they need no root.
    const double reach = (size - source.size) * kRounding / source.gradation;
    if (reach <= 0.0 || dot(way, way) > reach * reach) continue;
    size = std::min(size, source.size + source.gradation * norm(way));
  }
  return size;
}

tl::expected<Mesh, std::string> mesh_domain(const Domain& domain, std::size_t max_vertices) {
  try {
    Triangulation triangulation;
    for (const auto& segment : domain.segments) {
      triangulation.insert_constraint({segment.from.x, segment.from.y}, {segment.to.x, segment.to.y});
    }
    CGAL::Delaunay_mesher_2<Triangulation, GradedCriteria> mesher(triangulation, GradedCriteria(domain));
    if (max_vertices == 0) {
      mesher.refine_mesh();
    } else {
      mesher.init();
      while (mesher.try_one_step_refine_mesh()) {
        if (triangulation.number_of_vertices() > max_vertices)
          return tl::unexpected(std::string("the outline needs too many elements"));
      }
    }
    Mesh mesh = extract(domain, triangulation);
    if (mesh.triangles.empty()) return tl::unexpected(std::string("the outline encloses nothing"));
    return mesh;
  } catch (const std::exception& error) {
    return tl::unexpected(std::string("meshing failed: ") + error.what());
  }
}

}  // namespace brash::plate
