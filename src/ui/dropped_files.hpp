#pragma once

#include "scene/scene.hpp"
#include "ui/found_file.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace drape::ui {

/// How a body moves, as the user chooses it.
struct MotionChoice {
  bool isChosen = false;            ///< false: the only clip of its file, if there is one, or the first if it must move
  std::optional<std::string> clip;  ///< absent: it stands
};

/// Files that were dropped on the window together, by kind.
struct DroppedFiles {
  std::vector<std::string> scenes;
  std::vector<std::string> meshes;
  std::vector<std::string> caches = {};  ///< vertex caches, which move a body
  std::vector<std::string> others;       ///< none of these, by their endings
  /// The only dropped one, where the others are in the window already. It can be opened alone too. Else empty.
  std::string alone = {};
  /// How the meshes that are in the window already are read, one for each of `meshes`; the others are "auto". Empty:
  /// all are.
  std::vector<scene::ReadingChoice> readings = {};
  std::vector<MotionChoice> motions = {};  ///< the same for their motions
};

/// The answers of the user about dropped files.
struct DropChoices {
  std::size_t cloth = 0;                       ///< index of the mesh that is the cloth, see partsWithCloth()
  std::vector<scene::ReadingChoice> readings;  ///< one for each mesh
  std::vector<MotionChoice> motions;           ///< one for each mesh
};

/// Sorts files by their endings; the order within each kind stays.
[[nodiscard]] DroppedFiles sortDropped(const std::vector<std::string>& files);

/// A mesh that is dropped alone may go with what is in the window: a body with the garment that was opened from a file,
/// or a garment with the body of the scene or with a figure with bones that was opened as a cloth. Then the result has
/// both, and the user must say what to do.
[[nodiscard]] DroppedFiles joinedWith(const scene::Scene& present, DroppedFiles files);

/// The same where the name of the mesh does not say that it is a body: what the user must say if the mesh turns out to
/// be closed or to have bones. Empty where there is no garment without a body in the window.
[[nodiscard]] std::optional<DroppedFiles> joinedIfBody(const scene::Scene& present, DroppedFiles files);

/// The next step for dropped files.
struct DropDecision {
  std::optional<scene::SceneParts> open;  ///< opened at once; empty: none
  bool ask = false;                       ///< whether the user must say which mesh is the cloth
  text::Sentence notice;                  ///< which files are not opened, and why; or empty
};

/// One scene or one mesh is opened at once; of several scenes the last one. For several meshes, or a mesh with a scene,
/// the user must say which one is the cloth.
[[nodiscard]] DropDecision decide(const DroppedFiles& files);

/// The parts when the mesh with that index is the cloth and the others are bodies; an index beyond the meshes takes the
/// cloth of the scene and makes bodies of all of them.
[[nodiscard]] scene::SceneParts partsWithCloth(const DroppedFiles& files, std::size_t cloth);

/// The choices before the user answers: the likely cloth, and the readings of the files.
[[nodiscard]] DropChoices firstChoices(const DroppedFiles& files);

/// How each mesh is read by these choices, as far as it is known: a body that is no person as the cloth is.
[[nodiscard]] std::vector<std::optional<scene::MeshReading>> readingsBy(const DroppedFiles& files,
                                                                        const DropChoices& choices,
                                                                        std::span<const FoundFile> found);

/// The clip that moves the i-th mesh by these choices, as far as it is known; absent: it stands, or it is the cloth.
[[nodiscard]] std::optional<std::string> clipBy(const DroppedFiles& files, const DropChoices& choices, std::size_t i,
                                                std::span<const FoundFile> found);

/// The parts by these choices. The files are read as readingsBy() says, so that the user gets what is shown.
[[nodiscard]] scene::SceneParts partsBy(const DroppedFiles& files, const DropChoices& choices,
                                        std::span<const FoundFile> found);

/// The index of the mesh that is most likely the cloth: the first without a name of a body. With a dropped scene it is
/// the index after the meshes, since the scene has a cloth.
[[nodiscard]] std::size_t likelyCloth(const DroppedFiles& files);

/// The file's name without its folder.
[[nodiscard]] std::string shortName(const std::string& file);

/// The same for several files. Where two have the same name, the folder follows: "coat.obj (summer)".
[[nodiscard]] std::vector<std::string> distinctNames(const std::vector<std::string>& files);

}  // namespace drape::ui
