#pragma once

#include "io/file_mesh.hpp"
#include "io/point_cache_import.hpp"
#include "sim/contact/bodies/body.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace drape::scene {

/// Which vertex of a file moves each vertex of the mesh that was read from it, in which vertices at one place are one.
struct VertexMatch {
  std::vector<int> fileVertex;  ///< one per vertex of the mesh
  int parted = 0;               ///< vertices of the file that leave the one at the same place, whose way they follow
};

/// @param vertices of the mesh  @param cache for all vertices of the file. Throws InputError when no vertex of the file
/// is at the place of one of the mesh.
[[nodiscard]] VertexMatch vertexMatchOf(const io::FileMesh& file, std::size_t vertices, const io::PointCache& cache);

/// A mesh that follows a vertex cache, in straight lines between its frames. It rests in the first frame before, and in
/// the last one after the cache. With `loop` the first frame follows the last after the mean time between two frames,
/// or at once where the last frame equals the first.
/// @param scale of the cache's coordinates [m]
[[nodiscard]] std::shared_ptr<const sim::contact::MeshShape> cachedMesh(std::vector<Triangle> triangles,
                                                                        const io::PointCache& cache,
                                                                        const VertexMatch& match, double scale,
                                                                        bool loop);

}  // namespace drape::scene
