#include "app/used_files.hpp"

#include "messages/error.hpp"

#include <system_error>
#include <utility>
#include <variant>

namespace drape::app {
namespace {

/// An absolute name without symbolic links.
std::string absoluteName(const std::filesystem::path& file) {
  std::error_code error;
  const auto name = std::filesystem::weakly_canonical(std::filesystem::absolute(file, error), error);
  return (error ? file : name).string();
}

bool isDevice(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error);
}

}  // namespace

UsedFiles::UsedFiles(const scene::Scene& scene) {
  const scene::SceneDescription& description = scene.description;
  const auto readMesh = [this](const scene::MeshFileSource& mesh) {
    if (!mesh.builtIn) {
      read(mesh.path);
    }
  };
  read(description.parts.scene);
  for (const scene::ClothDescription& cloth : description.cloths) {
    if (const auto* mesh = std::get_if<scene::MeshFileSource>(&cloth.source)) {
      readMesh(*mesh);
    }
    if (cloth.start) {
      readMesh(*cloth.start);
    }
  }
  for (const scene::BodyDescription& body : description.bodies) {
    for (const scene::MeshFileSource& mesh : body.meshes) {
      readMesh(mesh);
    }
    if (body.cache) {
      read(body.cache->path);
    }
  }
  if (description.stand) {
    readMesh(description.stand->mesh);
  }
}

void UsedFiles::read(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_regular_file(file, error)) {
    users_.emplace(absoluteName(file), "read by this command");
  }
}

void UsedFiles::write(const std::filesystem::path& file, std::string_view option) {
  if (file.empty() || isDevice(file)) {
    return;
  }
  const auto [user, isNew] = users_.emplace(absoluteName(file), "also written by " + std::string(option));
  if (!isNew) {
    throw messages::UsageError(std::string(option) + " " + file.string() + ": this file is " + user->second +
                               "; give another name");
  }
}

}  // namespace drape::app
