#pragma once

#include "io/file_mesh.hpp"
#include "io/mesh_import.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace drape::scene {

/// The positions of a cloth that a second file gives it at the start, in the unit and the axes of that file.
/// @param start has the vertices of `mesh`, in the same order  @param mesh of the cloth, with its particles
/// @param particles their number
/// Throws InputError if the file has another number of vertices, or cannot be read.
[[nodiscard]] std::vector<Vec3> startOfFile(const MeshFileSource& start, const io::FileMesh& mesh,
                                            std::size_t particles, const io::ImportWatch& watch);

}  // namespace drape::scene
