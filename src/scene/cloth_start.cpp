#include "scene/cloth_start.hpp"

#include "messages/error.hpp"
#include "scene/mesh_file.hpp"

#include <fmt/core.h>
#include <algorithm>

namespace drape::scene {

std::vector<Vec3> startOfFile(const MeshFileSource& start, const io::FileMesh& mesh, std::size_t particles,
                              const io::ImportWatch& watch) {
  io::ImportOptions options;
  options.use = io::MeshUse::Body;  // the number of pieces and open borders do not matter
  options.keepsFile = true;
  options.watch.stop = watch.stop;
  const io::ImportedMesh read = readMesh(start, options);
  if (read.file->positions.size() != mesh.positions.size()) {
    throw messages::InputError(placed(
        start.where, fmt::format("{} has {} vertices, and the mesh of the cloth {}. The start needs the vertices "
                                 "of the mesh, in its order.",
                                 start.path, read.file->positions.size(), mesh.positions.size())));
  }
  std::vector<Vec3> positions(particles);
  std::vector<bool> isKnown(particles, false);
  for (std::size_t v = 0; v < mesh.particle.size(); ++v) {
    if (const int particle = mesh.particle[v]; particle >= 0) {
      positions[particle] = read.file->positions[v];
      isKnown[particle] = true;
    }
  }
  if (std::ranges::find(isKnown, false) != isKnown.end()) {
    throw messages::InputError(placed(start.where,
                                      "the vertices of the mesh cannot be found in its file, so it takes no start. "
                                      "Export the mesh as OBJ."));
  }
  return positions;
}

}  // namespace drape::scene
