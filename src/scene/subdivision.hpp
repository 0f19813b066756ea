#pragma once

#include "io/mesh_import.hpp"

#include <span>
#include <vector>

namespace drape::scene {

/// The most triangles of a mesh after subdivision.
inline constexpr int maxSubdividedTriangles = 4'000'000;

/// A vertex in the middle of two others.
struct Midpoint {
  int vertex = 0;
  int a = 0, b = 0;  ///< the ends of its edge
};

/// A mesh whose triangles were divided into four.
struct SubdividedMesh {
  io::ImportedMesh mesh;
  std::vector<Midpoint> midpoints;  ///< of the cloth, in the order in which they were made
};

/// Divides each triangle into four at the middles of its sides, `times` times. The shape stays the same. The vertices
/// of the mesh keep their numbers; the middles follow. Exports of this mesh write all its triangles. Throws InputError
/// for more than `maxSubdividedTriangles`.
[[nodiscard]] SubdividedMesh subdivided(io::ImportedMesh mesh, int times);

/// Adds the middle of each edge whose ends are both in a set of vertices.
/// @param vertices ascending or not; the middles are appended
void addMidpoints(std::span<const Midpoint> midpoints, std::vector<int>& vertices);

}  // namespace drape::scene
