// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a mesh and makes it closed: polygon soup, orientation, holes, crossings, shells.
// CGAL 6 deprecates the form of triangulate_hole that CGAL 5.5 has.
#define CGAL_NO_DEPRECATION_WARNINGS
#include "brash/structure/mesh_file.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polygon_mesh_processing/stitch_borders.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <sstream>

#include "triangle_mesh.hpp"

namespace brash::structure {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;

/// Triangles of the largest mesh. It takes about 2 GB to repair it.
constexpr std::size_t kMostTriangles = 4'000'000;
/// Extent of the largest hole that is filled, over the mesh's extent: a lost triangle, and not an open deck.
constexpr double kSmallHole = 0.01;
/// Places that a message lists.
constexpr std::size_t kMostPlaces = 5;
/// How far apart vertices of an open mesh may lie to become one, over the mesh's extent: round-off of the program that
/// wrote it, then of numbers with 24 bits, then of numbers with six digits. Tried in this order.
constexpr std::array kNearlyEqual{0.0, 1e-9, 1e-7, 1e-6};
/// A shell of less volume than this share of its box is not a body.
constexpr double kFlatShell = 1e-9;

struct Soup {
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> polygons;
};

MeshError unreadable(const std::string& kind, const std::string& why) {
  return {fmt::format("is not in the format {}: {}", kind, why), "a mesh in STL, OBJ, PLY or OFF whose name ends so",
          "export it again, or correct the ending of its name"};
}

/// Whether the lines of a PLY header follow the format; CGAL's reader (5.5) relies on a property's element.
bool has_ply_header(const std::string& bytes) {
  std::istringstream lines(bytes);
  bool has_element = false;
  for (std::string line, word; std::getline(lines, line); word.clear()) {
    std::istringstream(line) >> word;
    if (word == "end_header") return has_element;
    has_element = has_element || word == "element";
    const bool may_stand = word == "ply" || word == "format" || word == "comment" || word == "obj_info" ||
                           word == "element" || (word == "property" && has_element);
    if (!may_stand) return false;
  }
  return false;
}

/// An OBJ text as CGAL's readers need it: continued lines joined, corners between blanks (5.5), no line elements, which
/// have no area (5.5), and no comments, which a backslash does not continue (6.0).
std::string plain_obj(const std::string& bytes) {
  std::string text, line;
  const auto keep_line = [&] {
    std::replace(line.begin(), line.end(), '\t', ' ');
    if (!line.starts_with("l ") && !line.starts_with('#')) text += line + '\n';
    line.clear();
  };
  std::istringstream lines(bytes);
  for (std::string part; std::getline(lines, part);) {
    if (part.ends_with('\r')) part.pop_back();
    const bool is_continued = part.ends_with('\\') && !part.starts_with('#');
    if (is_continued) part.back() = ' ';
    line += part;
    if (!is_continued) keep_line();
  }
  if (!line.empty()) keep_line();
  return text;
}

bool read_soup(std::istream& stream, const std::string& kind, Soup& soup) {
  if (kind == "stl") return CGAL::IO::read_STL(stream, soup.points, soup.polygons);
  if (kind == "obj") return CGAL::IO::read_OBJ(stream, soup.points, soup.polygons);
  if (kind == "ply") return CGAL::IO::read_PLY(stream, soup.points, soup.polygons);
  return CGAL::IO::read_OFF(stream, soup.points, soup.polygons);
}

/// The faces of a file as triangles; a face of more corners is divided from its first one.
tl::expected<Soup, MeshError> soup_of(const std::string& bytes, const std::string& kind) {
  Soup soup;
  try {
    std::istringstream stream(kind == "obj" ? plain_obj(bytes) : bytes);
    if (kind == "ply" && !has_ply_header(bytes)) return tl::unexpected(unreadable(kind, "its header is not whole"));
    if (!read_soup(stream, kind, soup)) return tl::unexpected(unreadable(kind, "its text does not follow the format"));
  } catch (const std::exception&) {
    return tl::unexpected(unreadable(kind, "its numbers make no mesh"));
  }
  Soup triangles{std::move(soup.points), {}};
  for (const auto& polygon : soup.polygons) {
    if (polygon.size() < 3) return tl::unexpected(unreadable(kind, "a face has fewer than three corners"));
    if (std::ranges::any_of(polygon, [&](std::size_t i) { return i >= triangles.points.size(); }))
      return tl::unexpected(unreadable(kind, "a face names a vertex that is not there"));
    for (std::size_t i = 2; i < polygon.size(); ++i)
      triangles.polygons.push_back({polygon[0], polygon[i - 1], polygon[i]});
  }
  if (triangles.polygons.empty()) return tl::unexpected(unreadable(kind, "it has no faces"));
  if (triangles.polygons.size() > kMostTriangles)
    return tl::unexpected(MeshError{fmt::format("has {} triangles", triangles.polygons.size()),
                                    fmt::format("at most {}", kMostTriangles), "make the mesh coarser"});
  const auto is_finite = [](const Point& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  };
  if (!std::ranges::all_of(triangles.points, is_finite))
    return tl::unexpected(unreadable(kind, "a coordinate is not finite"));
  return triangles;
}

std::string place(Vec3 p) { return fmt::format("({:.6g}, {:.6g}, {:.6g})", p.x, p.y, p.z); }
Vec3 vec(const Point& p) { return {p.x(), p.y(), p.z()}; }

Box box_of(const SurfaceMesh& mesh) {
  Box box;
  for (const auto v : mesh.vertices()) box.add(vec(mesh.point(v)));
  return box;
}

/// Joins every vertex with the first one within `distance` of it. @return how many vertices that takes away.
int join_near(Soup& soup, double distance) {
  if (distance == 0.0) return 0;
  using Cell = std::array<long long, 3>;
  const auto cell_of = [&](const Point& p) {
    return Cell{std::llround(p.x() / distance), std::llround(p.y() / distance), std::llround(p.z() / distance)};
  };
  std::map<Cell, std::vector<std::size_t>> kept;
  std::set<Point> places;
  std::vector<std::size_t> joined(soup.points.size());
  for (std::size_t i = 0; i < soup.points.size(); ++i) {
    const Point& p = soup.points[i];
    const Cell cell = cell_of(p);
    places.insert(p);
    joined[i] = i;
    for (int k = 0; k < 27 && joined[i] == i; ++k) {
      const auto near = kept.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
      if (near == kept.end()) continue;
      const auto is_near = [&](std::size_t j) { return norm(vec(soup.points[j]) - vec(p)) <= distance; };
      const auto first = std::ranges::find_if(near->second, is_near);
      if (first != near->second.end()) joined[i] = *first;
    }
    if (joined[i] == i) kept[cell].push_back(i);
  }
  for (auto& polygon : soup.polygons)
    for (std::size_t& corner : polygon) corner = joined[corner];
  std::set<Point> left;
  for (const std::size_t i : joined) left.insert(soup.points[i]);
  return static_cast<int>(places.size() - left.size());
}

/// The edges in which three faces or more meet.
struct Crowded {
  std::size_t n = 0;
  Box box;  ///< of the first one
};

Crowded crowded_edges(const Soup& soup) {
  std::map<std::pair<std::size_t, std::size_t>, int> n_faces;
  for (const auto& polygon : soup.polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      ++n_faces[std::minmax(polygon[i], polygon[i + 1 == polygon.size() ? 0 : i + 1])];
  Crowded crowded;
  for (const auto& [ends, n] : n_faces) {
    if (n < 3) continue;
    if (crowded.n++ == 0)
      for (const std::size_t i : {ends.first, ends.second}) crowded.box.add(vec(soup.points[i]));
  }
  return crowded;
}

/// A surface that may have holes, and the repairs that made it.
struct Surface {
  SurfaceMesh mesh;
  std::vector<bool> turned;  ///< of each face, whether it faces the other way than in the soup
  MeshReport report;
  std::size_t n_open = 0;  ///< edges with a face on one side only
  Crowded crowded;
};

MeshError no_surface(const Crowded& crowded) {
  const std::string what =
      crowded.n > 0 ? fmt::format("has {} edge{} in which three faces or more meet, one from {} to {}", crowded.n,
                                  crowded.n == 1 ? "" : "s", place(crowded.box.least), place(crowded.box.most))
                    : std::string("has faces that form no surface: none has an area, or they cannot be turned alike");
  return {what, "a surface that parts inside from outside, two faces at each edge",
          "remove inner decks and faces that two parts share, or unite the parts, in a program for meshes"};
}

/// One surface from a soup, all faces of a shell turned alike.
/// @param distance  within which vertices become one.
tl::expected<Surface, MeshError> surface_of(Soup soup, double distance) {
  Surface result;
  MeshReport& report = result.report;
  std::vector<bool>& turned = result.turned;
  report.n_read = static_cast<int>(soup.polygons.size());
  report.n_joined = join_near(soup, distance);
  pmp::repair_polygon_soup(soup.points, soup.polygons);
  report.n_dropped = report.n_read - static_cast<int>(soup.polygons.size());
  result.crowded = crowded_edges(soup);
  std::vector<std::array<Point, 3>> before;
  for (const auto& p : soup.polygons) before.push_back({soup.points[p[0]], soup.points[p[1]], soup.points[p[2]]});
  pmp::orient_polygon_soup(soup.points, soup.polygons);
  for (std::size_t i = 0; i < before.size(); ++i) {
    const auto& polygon = soup.polygons[i];
    const auto first = std::ranges::find(polygon, before[i][0], [&](std::size_t v) { return soup.points[v]; });
    const auto next = first + 1 == polygon.end() ? polygon.begin() : first + 1;
    turned.push_back(soup.points[*next] != before[i][1]);
  }
  if (soup.polygons.empty() || !pmp::is_polygon_soup_a_polygon_mesh(soup.polygons))
    return tl::unexpected(no_surface(result.crowded));
  SurfaceMesh& mesh = result.mesh;
  pmp::polygon_soup_to_polygon_mesh(soup.points, soup.polygons, mesh);
  pmp::stitch_borders(mesh);
  for (const auto h : mesh.halfedges()) result.n_open += mesh.is_border(h) ? 1 : 0;
  return result;
}

/// The surface with the fewest open edges. Vertices become one only where that closes some.
tl::expected<Surface, MeshError> closest_surface(const Soup& soup) {
  Box box;
  for (const Point& p : soup.points) box.add(vec(p));
  tl::expected<Surface, MeshError> best;
  for (const double share : kNearlyEqual) {
    auto made = surface_of(soup, share * box.extent());
    if (share == 0.0 || (made && (!best || made->n_open < best->n_open))) best = std::move(made);
    if (best && best->n_open == 0) break;
  }
  return best;
}

/// Fills small holes; the others are an error.
tl::expected<void, MeshError> close_holes(Surface& surface) {
  SurfaceMesh& mesh = surface.mesh;
  MeshReport& report = surface.report;
  std::vector<SurfaceMesh::Halfedge_index> cycles;
  pmp::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  if (cycles.empty()) return {};
  const double whole = box_of(mesh).extent();
  std::vector<std::string> places;
  std::size_t n_open = 0;
  for (const auto cycle : cycles) {
    Box box;
    std::size_t n_edges = 0;
    for (const auto h : CGAL::halfedges_around_face(cycle, mesh)) {
      box.add(vec(mesh.point(mesh.target(h))));
      ++n_edges;
    }
    std::vector<SurfaceMesh::Face_index> filling;
    if (box.extent() <= kSmallHole * whole) pmp::triangulate_hole(mesh, cycle, std::back_inserter(filling));
    if (!filling.empty()) {
      ++report.n_holes_filled;
      continue;
    }
    if (++n_open <= kMostPlaces)
      places.push_back(fmt::format("one of {} edges from {} to {}", n_edges, place(box.least), place(box.most)));
  }
  if (n_open == 0) return {};
  if (surface.crowded.n > 0) return tl::unexpected(no_surface(surface.crowded));
  return tl::unexpected(
      MeshError{fmt::format("is open: {} hole{}, {}{}", n_open, n_open == 1 ? "" : "s", fmt::join(places, ", "),
                            n_open > kMostPlaces ? ", and more" : ""),
                fmt::format("a closed surface; holes up to {:g} % of its size are filled", 100.0 * kSmallHole),
                "close it in the program that made it: an open deck with a deck, and an edge that ends within "
                "another one by dividing that edge there"});
}

tl::expected<void, MeshError> refuse_crossings(const SurfaceMesh& mesh) {
  std::vector<std::pair<SurfaceMesh::Face_index, SurfaceMesh::Face_index>> crossings;
  pmp::self_intersections(mesh, std::back_inserter(crossings));
  if (crossings.empty()) return {};
  std::vector<std::string> places;
  for (const auto& [one, other] : crossings) {
    Box box;
    for (const auto v : CGAL::vertices_around_face(mesh.halfedge(one), mesh)) box.add(vec(mesh.point(v)));
    const std::string here = place(box.middle());
    if (std::ranges::find(places, here) == places.end()) places.push_back(here);
    if (places.size() == kMostPlaces) break;
  }
  return tl::unexpected(MeshError{
      fmt::format("crosses itself in {} pairs of triangles, near {}", crossings.size(), fmt::join(places, ", ")),
      "a surface that parts inside from outside", "unite its parts in the program that made it"});
}

/// The same triangles as plain arrays.
TriangleMesh plain(const SurfaceMesh& mesh) {
  TriangleMesh result;
  std::vector<int> number(mesh.num_vertices());
  for (const auto v : mesh.vertices()) {
    number[v] = static_cast<int>(result.vertices.size());
    result.vertices.push_back(vec(mesh.point(v)));
  }
  for (const auto f : mesh.faces()) {
    auto h = mesh.halfedge(f);
    std::array<int, 3> triangle{};
    for (int& corner : triangle) {
      corner = number[mesh.target(h)];
      h = mesh.next(h);
    }
    result.triangles.push_back(triangle);
  }
  return result;
}

SurfaceMesh surface(const TriangleMesh& mesh) {
  SurfaceMesh result;
  for (const Vec3 v : mesh.vertices) result.add_vertex(Point(v.x, v.y, v.z));
  using Vertex = SurfaceMesh::Vertex_index;
  for (const auto& [a, b, c] : mesh.triangles)
    result.add_face(Vertex(static_cast<unsigned>(a)), Vertex(static_cast<unsigned>(b)),
                    Vertex(static_cast<unsigned>(c)));
  return result;
}

/// Whether each shell lies inside another one. Shells do not cross, so that one vertex shows it.
std::vector<bool> are_inside(const std::vector<TriangleMesh>& shells) {
  std::vector<bool> inside(shells.size(), false);
  if (shells.size() < 2) return inside;
  for (std::size_t outer = 0; outer < shells.size(); ++outer) {
    const SurfaceMesh around = surface(shells[outer]);
    const CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel> side(around);
    for (std::size_t i = 0; i < shells.size(); ++i) {
      const Vec3 v = shells[i].vertices.front();
      if (i != outer && side(Point(v.x, v.y, v.z)) == CGAL::ON_BOUNDED_SIDE) inside[i] = true;
    }
  }
  return inside;
}

/// Turns each shell outwards by its signed volume, and leaves out the shells inside others.
tl::expected<TriangleMesh, MeshError> outer_shells(TriangleMesh mesh, std::vector<bool>& turned, MeshReport& report) {
  const auto [shell_of, n_shells] = shells_of(mesh);
  std::vector<TriangleMesh> shells;
  std::vector<bool> inwards;
  for (int s = 0; s < n_shells; ++s) {
    shells.push_back(part_of(mesh, [&, &of = shell_of](std::size_t t) { return of[t] == s; }));
    const Box box = box_around(shells.back().vertices);
    const Vec3 size = box.size();
    const double volume = signed_volume(shells.back());
    if (std::abs(volume) <= kFlatShell * size.x * size.y * size.z)
      return tl::unexpected(MeshError{fmt::format("has a shell without a volume near {}", place(box.middle())),
                                      "closed bodies", "take the shell out"});
    inwards.push_back(volume < 0.0);
  }
  const std::vector<bool> inside = are_inside(shells);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto shell = static_cast<std::size_t>(shell_of[t]);
    if (inwards[shell]) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    if (t < turned.size() && !inside[shell] && turned[t] != inwards[shell]) ++report.n_turned;
  }
  report.n_inner_shells = static_cast<int>(std::ranges::count(inside, true));
  report.n_shells = n_shells - report.n_inner_shells;
  if (report.n_inner_shells == 0) return mesh;
  return part_of(mesh, [&, &of = shell_of](std::size_t t) { return !inside[static_cast<std::size_t>(of[t])]; });
}

}  // namespace

tl::expected<ReadMesh, MeshError> read_mesh(const std::string& bytes, const std::string& kind) {
  auto soup = soup_of(bytes, kind);
  if (!soup) return tl::unexpected(soup.error());
  auto surface = closest_surface(*soup);
  if (!surface) return tl::unexpected(surface.error());
  if (auto closed = close_holes(*surface); !closed) return tl::unexpected(closed.error());
  if (auto simple = refuse_crossings(surface->mesh); !simple) return tl::unexpected(simple.error());
  MeshReport report = surface->report;
  auto outer = outer_shells(plain(surface->mesh), surface->turned, report);
  if (!outer) return tl::unexpected(outer.error());
  report.n_triangles = static_cast<int>(outer->triangles.size());
  return ReadMesh{std::move(*outer), report};
}

}  // namespace brash::structure
