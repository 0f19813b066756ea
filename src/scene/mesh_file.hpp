#pragma once

#include "scene/scene.hpp"

#include <string>

namespace drape::scene {

/// Adds the place in the scene file to a message, if there is one.
[[nodiscard]] std::string placed(const std::string& where, const std::string& message);

/// The rule of the settings for vertices far from all others.
[[nodiscard]] io::OutlierRule outlierRule(const settings::Settings& settings);

/// Reads a mesh, from a file or a built-in one. Throws InputError, whose message starts with the place in the scene
/// file that names the mesh.
[[nodiscard]] io::ImportedMesh readMesh(const MeshFileSource& source, const io::ImportOptions& options);

/// The mesh that an export writes where there is no file, or where it does not have all triangles of the cloth: vertex
/// by vertex that for drawing.
[[nodiscard]] std::shared_ptr<const io::FileMesh> fileMeshOf(const io::ImportedMesh& mesh);

}  // namespace drape::scene
