#pragma once

#include "scene/scene.hpp"
#include "scene/sewing.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace drape::scene {

/// A body of a running scene, as the user left it.
struct BodyNow {
  bool on = true;
  Vec3 shift = Vec3::Zero();  ///< relative to its own motion [m]
  sim::contact::SurfaceProperties surface;
  std::optional<figure::FigureOptions> figure = std::nullopt;  ///< of a figure; empty: as in the scene
};

/// What a user changed about a running scene.
struct SceneNow {
  settings::Settings settings;
  std::vector<bool> pinned;                         ///< one per vertex of the model
  std::vector<PinPath> pinPaths;                    ///< of pins that move without a body
  std::vector<BodyNow> bodies;                      ///< one per body of the scene, or none: they are as in the scene
  std::optional<CameraPose> camera = std::nullopt;  ///< the present view; empty: as in the scene
  std::optional<Sewing> sewing = std::nullopt;      ///< seams and elastic bands; empty: as in the scene
  /// The files with the starts of the cloths, one per cloth; none: as in the scene.
  std::vector<std::optional<MeshFileSource>> starts = {};
};

/// A scene as it was built, without changes.
[[nodiscard]] SceneNow unchanged(const Scene& scene);

/// A scene file, and what it cannot contain.
struct WrittenScene {
  std::string text;                   ///< TOML (docs/guide/scenes.md)
  std::vector<text::Sentence> notes;  ///< one sentence each, for the user
};

/// Writes a scene with the user's changes as a scene file. It opens to the same start, settings and bits of motion. It
/// contains the fabrics of the user that the scene uses. Throws InputError when the file would have other settings.
/// @param folder of the file; absolute. Names of mesh files are relative to it where they lie below it
[[nodiscard]] WrittenScene writeScene(const Scene& scene, const SceneNow& now, const std::filesystem::path& folder);

}  // namespace drape::scene
