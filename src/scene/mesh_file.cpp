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

}  // namespace drape::scene
