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
#include <utility>

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

Vec2 to_vec(const Kernel::Point_2& point) { return {point.x(), point.y()}; }

/// The wanted size of elements: the least of many. Most sources are too far off to count, which is found out without a
/// root or a quotient.
class SizeField {
 public:
  explicit SizeField(const Domain& domain) : largest_(domain.largest_size) {
    for (const SizeSource& source : domain.sizes)
      sources_.push_back({source, 0.5 * (source.from + source.to),
                          source.gradation * 0.5 * norm(source.to - source.from) * kRounding});
    std::sort(sources_.begin(), sources_.end(),
              [](const Source& a, const Source& b) { return a.source.size < b.source.size; });
  }

  double at(Vec2 place) {
    double size = largest_;
    if (!sources_.empty()) size = std::min(size, sources_[last_].size_at(place));
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      const Source& source = sources_[i];
      const double growth = (size - source.source.size) * kRounding;
      if (growth <= 0.0) break;
      if (source.is_beyond(place, growth)) continue;
      const double here = source.size_at(place);
      if (here >= size) continue;
      size = here;
      last_ = i;
    }
    return size;
  }

 private:
  static constexpr double kRounding = 1.0 + 1e-9;

  struct Source {
    SizeSource source;
    Vec2 middle;
    double growth_to_end;  ///< from the middle to an end

    double size_at(Vec2 place) const {
      return source.size + source.gradation * norm(way_from(source.from, source.to, place));
    }
    /// Whether the source's size grows by more than that before it is at the place, by a circle around the source.
    bool is_beyond(Vec2 place, double growth) const {
      const double most = growth + growth_to_end;
      return source.gradation * source.gradation * dot(place - middle, place - middle) > most * most;
    }
  };

  double largest_;
  std::vector<Source> sources_;  ///< the smallest first
  std::size_t last_ = 0;         ///< that decided at another place, probably near
};

/// CGAL's mesh criteria with a size that varies in the plane.
class GradedCriteria : public CGAL::Delaunay_mesh_criteria_2<Triangulation> {
 public:
  using Base = CGAL::Delaunay_mesh_criteria_2<Triangulation>;

  explicit GradedCriteria(SizeField& sizes) : Base(kAspectBound), sizes_(&sizes) {}

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
    explicit Is_bad(SizeField& sizes) : sizes_(&sizes) {}

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
      quality = {sine * sine, edges[2] / sizes_->at((a + b + c) / 3.0)};
      return (*this)(quality);
    }

   private:
    SizeField* sizes_;
  };

  Is_bad is_bad_object() const { return Is_bad(*sizes_); }

 private:
  SizeField* sizes_;
};

std::size_t segment_at(const Domain& domain, Vec2 middle) {
  constexpr double kRounding = 1.0 + 1e-9;
  std::size_t nearest = 0;
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < domain.segments.size(); ++i) {
    const Vec2 way = way_from(domain.segments[i].from, domain.segments[i].to, middle);
    if (dot(way, way) > best * best * kRounding) continue;
    const double distance = norm(way);
    if (distance < best) {
      best = distance;
      nearest = i;
    }
  }
  return nearest;
}

/// Numbers the edges of a mesh in the order in which they come.
class EdgeNumbers {
 public:
  explicit EdgeNumbers(Mesh& mesh) : mesh_(&mesh) {}

  /// @return the number, and whether the edge is new.
  std::pair<int, bool> number(const std::array<int, 2>& ends) {
    first_.resize(mesh_->vertices.size(), -1);
    int& first = first_[static_cast<std::size_t>(ends[0])];
    for (int edge = first; edge >= 0; edge = next_[static_cast<std::size_t>(edge)]) {
      if (mesh_->edges[static_cast<std::size_t>(edge)][1] == ends[1]) return {edge, false};
    }
    next_.push_back(first);
    first = static_cast<int>(mesh_->edges.size());
    mesh_->edges.push_back(ends);
    return {first, true};
  }

 private:
  Mesh* mesh_;
  std::vector<int> first_;  ///< the last edge that came with this lower vertex; -1: none
  std::vector<int> next_;   ///< the edge before with the same lower vertex
};

Mesh extract(const Domain& domain, Triangulation& triangulation) {
  Mesh mesh;
  for (auto vertex : triangulation.finite_vertex_handles()) vertex->info() = -1;
  EdgeNumbers edges(mesh);
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
      const auto [id, is_new] = edges.number(ends);
      ids[i] = id;
      if (!is_new) continue;
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

tl::expected<Mesh, std::string> mesh_domain(const Domain& domain, std::size_t max_vertices) {
  try {
    Triangulation triangulation;
    for (const auto& segment : domain.segments) {
      triangulation.insert_constraint({segment.from.x, segment.from.y}, {segment.to.x, segment.to.y});
    }
    SizeField sizes(domain);
    CGAL::Delaunay_mesher_2<Triangulation, GradedCriteria> mesher(triangulation, GradedCriteria(sizes));
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
