#include "scene/mesh_file.hpp"

#include "messages/error.hpp"
#include "scene/builtin_meshes.hpp"

namespace drape::scene {

std::string placed(const std::string& where, const std::string& message) {
  return where.empty() ? message : where + ": " + message;
}

io::OutlierRule outlierRule(const settings::Settings& settings) {
  return settings.mesh.outliers == "leave_out" ? io::OutlierRule::LeaveOut : io::OutlierRule::Refuse;
}

io::ImportedMesh readMesh(const MeshFileSource& source, const io::ImportOptions& options) {
  try {
    return source.builtIn ? io::importMeshFromMemory(source.path, builtinMesh(source.path), options)
                          : io::importMesh(source.path, options);
  } catch (const messages::InputError& error) {
    throw messages::InputError(placed(source.where, error.what()));
  }
}

std::shared_ptr<const io::FileMesh> fileMeshOf(const io::ImportedMesh& mesh) {
  auto file = std::make_shared<io::FileMesh>();
  for (const int particle : mesh.render.particle) {
    file->positions.push_back(mesh.cloth.positions[particle]);
  }
  file->particle = mesh.render.particle;
  file->uvs = mesh.render.uvs;
  for (const Triangle& triangle : mesh.render.triangles) {
    file->corners.insert(file->corners.end(), triangle.begin(), triangle.end());
    file->endFace();
  }
  file->uvCorners = file->corners;
  return file;
}

}  // namespace drape::scene
