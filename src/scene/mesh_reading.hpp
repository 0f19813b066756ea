#pragma once

#include "io/mesh_import.hpp"
#include "settings/settings.hpp"
#include "text/sentence.hpp"

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// What the unit or the up axis of a mesh file follows from.
enum class ReadingReason {
  Chosen,     ///< the user or the scene file states it
  Format,     ///< the file format prescribes it
  Shape,      ///< guessed: the size is that of a garment or a person, or the shape shows which side is up
  LikeCloth,  ///< guessed: that of the cloth, since neither size nor shape of the body show it
  Unknown     ///< guessed: the most common one, since neither size nor shape show it
};

[[nodiscard]] constexpr bool isGuess(ReadingReason reason) {
  return reason != ReadingReason::Chosen && reason != ReadingReason::Format;
}

/// How the user wants a mesh file to be read: values of the settings `unit` and `up`. "auto" takes what the format
/// prescribes, or else a guess.
struct ReadingChoice {
  std::string unit = "auto";
  std::string up = "auto";

  bool operator==(const ReadingChoice&) const = default;
};

/// An alternative reading of a mesh file: a setting and its value.
struct ReadingAlternative {
  std::string key;    ///< "unit" or "up"
  std::string value;  ///< "m", "y"
};

/// The unit and the up axis with which a mesh file was read.
struct MeshReading {
  std::string unit = "m";  ///< a word or a number, as in the setting
  double metresPerUnit = 1.0;
  ReadingReason unitReason = ReadingReason::Chosen;
  std::string up = "y";  ///< as in the setting
  ReadingReason upReason = ReadingReason::Chosen;
  std::array<double, 3> size{};                  ///< resulting width, height and depth [m]
  std::vector<ReadingAlternative> alternatives;  ///< the likeliest first; for guesses and implausible sizes only

  /// Whether the user should check it: something was guessed, or the size is not that of a garment.
  [[nodiscard]] bool needsReview() const { return !alternatives.empty(); }
};

/// The factor for the coordinates of an imported file: metres per unit of the setting, or 1 when the unit is to be
/// guessed.
[[nodiscard]] double metresPerUnitOf(const settings::Settings::Mesh& settings);

/// What the reading of a mesh follows from.
struct ReadingEvidence {
  io::FormatFacts format;
  Vec3 extent = Vec3::Zero();  ///< of the box around it, in the axes and the unit of the file
  /// The up axis by its shape; empty where the shape does not show it. Called only if it decides.
  std::function<std::string()> upOfShape;
  double fullness = 0.0;  ///< of a body, see fullnessOf; 0: not known
};

/// The up axis by the shape of a mesh: "y" or "z". Empty where the shape does not show it.
[[nodiscard]] std::string upOfShape(const sim::ClothMesh& mesh);

/// The volume of a body over the cube of its largest extent [-]. Holes count as if they were closed.
[[nodiscard]] double fullnessOf(const sim::ClothMesh& mesh);

/// Takes unit and up axis from the choice, or for "auto" from the file format, or else guesses them. The size of a flat
/// sheet is that of anything, so its unit is Unknown. @param use a body is compared with persons
[[nodiscard]] MeshReading readingOf(const ReadingEvidence& evidence, const ReadingChoice& choice, io::MeshUse use);

/// Reads a mesh by the settings `unit` and `up`. Scales and rotates it; it was imported with metresPerUnitOf(settings).
[[nodiscard]] MeshReading readUpright(const settings::Settings::Mesh& settings, io::ImportedMesh& mesh,
                                      io::MeshUse use = io::MeshUse::Cloth);

/// The rotation from the named axis ("z", "-y") to y: axis times angle [rad].
[[nodiscard]] Vec3 rotationToY(std::string_view up);

/// "Read as centimetres, z up: 0.77 m tall."
[[nodiscard]] text::Sentence inWords(const MeshReading& reading);

}  // namespace drape::scene
