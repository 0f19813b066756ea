#pragma once

#include "scene/scene.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace drape::scene {

/// A cloth or a body of a scene that has a placement. Stand and ground have none.
struct Placeable {
  enum class Kind { Cloth, Body };
  Kind kind = Kind::Cloth;
  std::size_t index = 0;  ///< into the cloths or the bodies of the description

  bool operator==(const Placeable&) const = default;
};

/// The placements of all cloths and bodies of a scene, and what is read from the files of bodies.
struct Placements {
  std::vector<Placement> cloths;
  std::vector<Placement> bodies;
  /// BodyDescription::reading of each body: another unit or up axis is a change of the user like a placement.
  std::vector<std::optional<ReadingChoice>> readings;
  /// The clip that moves each body (AnimationSource::clip); absent: its file has no animation.
  std::vector<std::optional<std::string>> clips;

  [[nodiscard]] const Placement& of(const Placeable& thing) const&;
  [[nodiscard]] Placement& of(const Placeable& thing) &;
  [[nodiscard]] Placement of(const Placeable& thing) && { return of(thing); }

  bool operator==(const Placements&) const = default;
};

/// Those in force, and those of the scene file.
[[nodiscard]] Placements placementsOf(const SceneDescription& description);
[[nodiscard]] Placements writtenPlacementsOf(const SceneDescription& description);

/// The scene with other placements. Without any reading or clip, the bodies keep theirs. Throws InputError when their
/// number does not fit the scene, or when one is outside its range.
[[nodiscard]] SceneDescription withPlacements(SceneDescription description, const Placements& placements);

/// Whether a placement is within its range: near enough to the origin of the scene, and of a useful scale.
[[nodiscard]] bool isAllowed(const Placement& placement);

/// Every cloth and body, in the order of the description.
[[nodiscard]] std::vector<Placeable> placeablesOf(const SceneDescription& description);

/// "cloth" for the only cloth of a scene, otherwise its name.
[[nodiscard]] std::string nameOf(const SceneDescription& description, const Placeable& thing);

/// Whether it is an infinite plane.
[[nodiscard]] bool isPlane(const SceneDescription& description, const Placeable& thing);

/// Why a placement cannot scale it, as a sentence; empty if it can.
[[nodiscard]] std::string whyNotScaled(const SceneDescription& description, const Placeable& thing);

}  // namespace drape::scene
