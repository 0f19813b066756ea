#pragma once

#include "io/file_mesh.hpp"
#include "scene/mesh_placement.hpp"
#include "scene/pattern_uvs.hpp"
#include "settings/settings_table.hpp"
#include "sim/model/cloth_model.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace drape::scene {

/// A setting that one cloth of a scene has for itself.
struct OwnSetting {
  const settings::SettingInfo* info = nullptr;  ///< never null
  settings::SettingValue value;                 ///< within the range of the setting
};

/// An open border of a cloth, or a part of it, that is sewn to an elastic band, as at a waist.
struct ElasticBand {
  std::vector<int> vertices;  ///< of the border, in order. Counted from the cloth's first one
  double length = 1.0;        ///< the band's rest length over that of the border [-]
  bool isClosed = true;       ///< whether it goes from the last vertex back to the first one
};

/// A cloth of a scene: its vertices and triangles in the model of the scene, and what it has for itself.
struct ClothPart {
  std::string name;  ///< unique in the scene; empty if the scene has one cloth
  int firstVertex = 0;
  int vertexCount = 0;
  int firstTriangle = 0;
  int triangleCount = 0;
  int firstRenderVertex = 0;  ///< of io::RenderMesh
  int renderVertexCount = 0;
  PatternUvs uvs;  ///< of its triangles, counted from its first one
  std::vector<ElasticBand> bands;
  std::vector<OwnSetting> own;               ///< in the order in which they are assigned
  std::shared_ptr<const io::FileMesh> file;  ///< the mesh that was opened; its particles count from `firstVertex`
  MeshPlacement placement;                   ///< of that mesh
  MeshPlacement startPlacement;              ///< of a file with its start, which has its own size
  double scale = 1.0;                        ///< of the rest shape, by the placement of the cloth [-]
};

/// The only cloth of a model.
[[nodiscard]] ClothPart wholeCloth(const sim::ClothModel& model, PatternUvs uvs = {});

/// The cloth with a vertex of the model. @param cloths all of them
[[nodiscard]] const ClothPart& clothWith(int vertex, std::span<const ClothPart> cloths);

/// The settings that count for a cloth: those of the scene with its own.
[[nodiscard]] settings::Settings settingsOf(std::span<const OwnSetting> own, settings::Settings scene);

/// Whether a cloth can have this setting for itself: its mesh, its mass, its stiffness and its fabric, but not the
/// model and the rest shape of the material, which all cloths share.
[[nodiscard]] bool mayDifferByCloth(const settings::SettingInfo& info);

}  // namespace drape::scene
