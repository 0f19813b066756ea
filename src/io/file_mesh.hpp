#pragma once

#include "sim/model/vector.hpp"

#include <vector>

namespace drape::io {

/// A mesh as its file has it: all vertices and polygons, in the order of the file, in its unit and axes. The cloth has
/// fewer vertices, since vertices at the same place are one there. An export writes this mesh, so that it fits the file
/// vertex by vertex.
struct FileMesh {
  std::vector<Vec3> positions;  ///< in the file's unit
  /// The cloth's vertex at the place of each vertex; -1 for those of no triangle of the cloth. Filled by weldMesh.
  std::vector<int> particle;
  std::vector<Vec2> uvs;      ///< texture coordinates in the order of the file; empty when it has none
  std::vector<int> faceEnds;  ///< of each polygon: the index in `corners` after its last corner
  std::vector<int> corners;   ///< indices into `positions`
  std::vector<int>
      uvCorners;  ///< indices into `uvs` in the order of `corners`; -1: none. Empty when there are no `uvs`

  [[nodiscard]] int firstCorner(std::size_t face) const { return face == 0 ? 0 : faceEnds[face - 1]; }

  /// Ends a polygon whose corners were added. Fewer than three corners are removed again.
  void endFace();
};

/// For each vertex of the file, the index of the nearest point of the mesh that a library read from it, or -1 where
/// none is at that place. Libraries read in single precision, so "at that place" allows for its rounding.
[[nodiscard]] std::vector<int> verticesInLibrary(const FileMesh& file, const std::vector<Vec3>& points);

}  // namespace drape::io
