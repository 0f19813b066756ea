#pragma once

#include "scene/mesh_reading.hpp"
#include "scene/scene.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace drape::scene {

struct PinGroup;

/// Reads the mesh of a stand. Adds its warnings to `warnings`, except for built-in meshes. Throws InputError.
[[nodiscard]] std::optional<Decor> readStand(const std::optional<StandDescription>& stand,
                                             const settings::Settings& settings, const io::ImportWatch& watch,
                                             std::vector<std::string>& warnings);

/// A body in metres with y up, when its files have another unit or other axes.
/// @param metresPerUnit, up of the cloth's file, for bodies that are read like it
[[nodiscard]] BodyDescription inMetres(BodyDescription body, double metresPerUnit, const std::string& up);

/// The bodies of a scene.
struct BuiltBodies {
  std::shared_ptr<std::vector<sim::contact::Body>> bodies;  ///< those of the description, its stand, its ground
  std::vector<std::vector<io::ClipFacts>> clips;            ///< Scene::clips
};

/// Reads and builds the bodies of a scene. Throws InputError.
/// @param reading of the cloth's file, for bodies with the same unit and axes  @param groundHeight [m]
/// @param warnings those of the bodies' meshes are appended
[[nodiscard]] BuiltBodies buildBodies(const SceneDescription& description, const std::optional<MeshReading>& reading,
                                      const std::optional<Decor>& stand, double groundHeight,
                                      const settings::Settings& settings, const io::ImportWatch& watch,
                                      std::vector<std::string>& warnings);

/// Attaches a group of pins to its body. @param bodies of BuiltBodies
void carryPins(const SceneDescription& description, const PinGroup& group, const sim::ClothState& start,
               std::vector<sim::contact::Body>& bodies);

}  // namespace drape::scene
