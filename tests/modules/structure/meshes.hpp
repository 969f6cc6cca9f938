// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes with known volumes, and their files.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <sstream>
#include <string>

#include "brash/core/constants.hpp"
#include "brash/structure/hull.hpp"
#include "mesh_hull.hpp"

namespace brash::structure::test {

inline TriangleMesh box(Vec3 a, Vec3 b) {
  return {{{a.x, a.y, a.z},
           {b.x, a.y, a.z},
           {b.x, b.y, a.z},
           {a.x, b.y, a.z},
           {a.x, a.y, b.z},
           {b.x, a.y, b.z},
           {b.x, b.y, b.z},
           {a.x, b.y, b.z}},
          {{0, 2, 1},
           {0, 3, 2},
           {4, 5, 6},
           {4, 6, 7},
           {0, 1, 5},
           {0, 5, 4},
           {1, 2, 6},
           {1, 6, 5},
           {2, 3, 7},
           {2, 7, 6},
           {3, 0, 4},
           {3, 4, 7}}};
}

/// A sphere about `centre` with 4 n^2 triangles or so, its vertices on the sphere.
inline TriangleMesh sphere(Vec3 centre, double radius, int n) {
  TriangleMesh mesh;
  const auto at = [&](double polar, double around) {
    return centre +
           radius * Vec3{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around), -std::cos(polar)};
  };
  mesh.vertices.push_back(at(0.0, 0.0));
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) mesh.vertices.push_back(at(kPi * i / n, kPi * j / n));
  mesh.vertices.push_back(at(kPi, 0.0));
  const auto index = [&](int i, int j) { return 1 + (i - 1) * 2 * n + j % (2 * n); };
  const int top = static_cast<int>(mesh.vertices.size()) - 1;
  for (int j = 0; j < 2 * n; ++j) {
    mesh.triangles.push_back({0, index(1, j + 1), index(1, j)});
    mesh.triangles.push_back({top, index(n - 1, j), index(n - 1, j + 1)});
    for (int i = 1; i + 1 < n; ++i) {
      mesh.triangles.push_back({index(i, j), index(i, j + 1), index(i + 1, j + 1)});
      mesh.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i + 1, j)});
    }
  }
  return mesh;
}

/// A ring of `n` prisms with `m` sides, whose section has a radius of `small` and runs `large` from the axis z.
inline TriangleMesh torus(double large, double small, int n, int m) {
  TriangleMesh mesh;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      const double around = 2.0 * kPi * i / n, section = 2.0 * kPi * j / m, r = large + small * std::cos(section);
      mesh.vertices.push_back({r * std::cos(around), r * std::sin(around), small * std::sin(section)});
      const int next = (i + 1) % n * m, above = (j + 1) % m;
      mesh.triangles.push_back({i * m + j, next + j, next + above});
      mesh.triangles.push_back({i * m + j, next + above, i * m + above});
    }
  return mesh;
}

inline TriangleMesh joined(TriangleMesh one, const TriangleMesh& other) {
  const int first = static_cast<int>(one.vertices.size());
  one.vertices.insert(one.vertices.end(), other.vertices.begin(), other.vertices.end());
  for (const auto& [a, b, c] : other.triangles) one.triangles.push_back({first + a, first + b, first + c});
  return one;
}

/// A prism with a ring of the plan, counter-clockwise, as section. Its caps are fans from the first vertex, which sees
/// all the others.
inline TriangleMesh prism(const Outline& ring, double bottom, double top) {
  TriangleMesh mesh;
  const int n = static_cast<int>(ring.size());
  for (const double z : {bottom, top})
    for (const Vec2 v : ring) mesh.vertices.push_back({v.x, v.y, z});
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  for (int i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  return mesh;
}

inline std::string off(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << mesh.vertices.size() << ' ' << mesh.triangles.size() << " 0\n";
  for (const Vec3 v : mesh.vertices) text << v.x << ' ' << v.y << ' ' << v.z << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

inline std::string obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  for (const Vec3 v : mesh.vertices) text << "v " << v.x << ' ' << v.y << ' ' << v.z << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  return text.str();
}

inline std::string ply(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(17);
  text << "ply\nformat ascii 1.0\nelement vertex " << mesh.vertices.size()
       << "\nproperty double x\nproperty double y\nproperty double z\nelement face " << mesh.triangles.size()
       << "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3 v : mesh.vertices) text << v.x << ' ' << v.y << ' ' << v.z << '\n';
  for (const auto& [a, b, c] : mesh.triangles) text << "3 " << a << ' ' << b << ' ' << c << '\n';
  return text.str();
}

inline std::string ascii_stl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text.precision(9);
  text << "solid hull\n";
  for (const auto& triangle : mesh.triangles) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int i : triangle) {
      const Vec3 v = mesh.vertices[static_cast<std::size_t>(i)];
      text << "vertex " << v.x << ' ' << v.y << ' ' << v.z << '\n';
    }
    text << "endloop\nendfacet\n";
  }
  text << "endsolid hull\n";
  return text.str();
}

inline std::string binary_stl(const TriangleMesh& mesh) {
  std::string bytes(80, ' ');
  const auto append = [&](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& triangle : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(0.0F);
    for (const int i : triangle) {
      const Vec3 v = mesh.vertices[static_cast<std::size_t>(i)];
      for (const double x : {v.x, v.y, v.z}) append(static_cast<float>(x));
    }
    append(std::uint16_t{0});
  }
  return bytes;
}

inline MeshHull hull(const TriangleMesh& mesh) {
  return MeshHull(std::make_shared<const MeshBody>(mesh, MeshReport{}));
}

inline double area(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  return 0.5 * twice;
}

inline double area(const std::vector<Outline>& outlines) {
  double sum = 0.0;
  for (const Outline& outline : outlines) sum += area(outline);
  return sum;
}

}  // namespace brash::structure::test
