// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>

#include "brash/structure/hull.hpp"

namespace brash::structure {

/// Whether a mesh seems to be turned in a way that its user did not mean.
struct Bearing {
  std::string doubt;   ///< a sentence; empty: it does not
  std::string remedy;  ///< the key that turns it
};

/// What is known of a mesh after it was read: its repairs, its size and how well the contacts see it.
struct MeshReport {
  int n_read = 0;            ///< triangles in the file
  int n_joined = 0;          ///< vertices that lay so close to another one that both are one
  int n_dropped = 0;         ///< of these without area, or there twice
  int n_turned = 0;          ///< that faced inwards
  int n_holes_filled = 0;    ///< small ones
  int n_inner_shells = 0;    ///< shells inside another one, left out
  int n_shells = 0;          ///< that are the hull
  int n_triangles = 0;       ///< of these shells
  int n_parts = 0;           ///< convex bodies that represent the hull in contacts with floes
  double parts_error = 0.0;  ///< their volume beyond the hull's and short of it, over the hull's volume [-]
  Vec3 size{};               ///< in the water as its pose says [m]
  Bearing bearing{};         ///< in the water as its pose says
};

/// Why a mesh is not a hull. Places are in the file's own coordinates.
struct MeshError {
  std::string what;
  std::string allowed;
  std::string remedy;
};

/// A closed mesh from the bytes of a file, after its repair; coordinates and unit are the file's.
///
/// Equal vertices become one, triangles without area go, all triangles turn outwards, shells inside others go, and
/// small holes are filled. Vertices within a millionth of the extent become one too, where that closes the mesh. The
/// repairs are counted. Larger holes, edges with three faces and faces that cross each other are errors with places.
/// @param kind  "stl", "obj", "ply" or "off".
struct ReadMesh {
  TriangleMesh mesh;
  MeshReport report;  ///< without parts and size
};
tl::expected<ReadMesh, MeshError> read_mesh(const std::string& bytes, const std::string& kind);

/// Reads, repairs and places the mesh of a file. make_hull() then has it at hand.
/// @throws InputError when the file cannot be read at all.
tl::expected<MeshReport, MeshError> examine(const model::Mesh& mesh);

}  // namespace brash::structure
