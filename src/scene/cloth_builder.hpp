#pragma once

#include "scene/mesh_reading.hpp"
#include "scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace drape::scene {

/// Pinned vertices that move together.
struct PinGroup {
  std::vector<int> vertices;
  std::string body;                                               ///< that moves them; empty: none
  std::optional<sim::contact::BodyMotion> motion = std::nullopt;  ///< without a body; empty: they are fixed in space
};

/// The cloths of a scene, joined to one mesh.
struct JoinedCloths {
  sim::ClothMesh mesh;              ///< the rest shape, in the scene, without the placements of the cloths [m]
  std::vector<Vec3> start;          ///< positions at the start [m]; those of pleats differ from the rest shape
  std::vector<Vec3> unplacedStart;  ///< the same without the placements of the cloths [m]
  io::RenderMesh renderMesh;        ///< its triangles are those of `mesh`
  io::MeshSummary summary;          ///< of all cloths
  std::vector<ClothPart> cloths;
  std::vector<PinGroup> pins;          ///< each vertex is in one group at most
  std::optional<MeshReading> reading;  ///< of the first cloth from a mesh file
  bool showsReading = false;           ///< whether that file is not built in

  /// The vertices of all groups of pins, ascending.
  [[nodiscard]] std::vector<int> pinned() const;
};

/// Reads or makes the meshes of all cloths and joins them. Throws InputError, and Cancelled when the watch cancels.
[[nodiscard]] JoinedCloths joinCloths(const SceneDescription& description, const settings::Settings& settings,
                                      const io::ImportWatch& watch);

/// The model of the cloths, with their springs, masses, pins and materials.
[[nodiscard]] std::shared_ptr<const sim::ClothModel> modelOf(const JoinedCloths& joined,
                                                             const settings::Settings& settings);

}  // namespace drape::scene
