#pragma once

#include "io/mesh_import.hpp"
#include "settings/settings.hpp"
#include "text/sentence.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// An alternative reading of a mesh file: a setting and its value.
struct ReadingAlternative {
  std::string key;    ///< "unit" or "up"
  std::string value;  ///< "m", "y"
};

/// The unit and the up axis with which a mesh file was read.
struct MeshReading {
  std::string unit = "m";  ///< a word or a number, as in the setting
  double metresPerUnit = 1.0;
  bool unitGuessed = false;
  std::string up = "y";  ///< as in the setting
  bool upGuessed = false;
  std::array<double, 3> size{};                  ///< resulting width, height and depth [m]
  std::vector<ReadingAlternative> alternatives;  ///< the likeliest first; for guesses and implausible sizes only

  /// Whether the user should check it: something was guessed, or the size is not that of a garment.
  [[nodiscard]] bool needsReview() const { return !alternatives.empty(); }
};

/// The factor for the coordinates of an imported file: metres per unit of the setting, or 1 when the unit is to be
/// guessed.
[[nodiscard]] double metresPerUnitOf(const settings::Settings::Mesh& settings);

/// Takes unit and up axis from the settings, or for "auto" from the file format, or else guesses them. Scales and
/// rotates the mesh, which was imported with metresPerUnitOf(settings).
[[nodiscard]] MeshReading readUpright(const settings::Settings::Mesh& settings, io::ImportedMesh& mesh);

/// The rotation from the named axis ("z", "-y") to y: axis times angle [rad].
[[nodiscard]] Vec3 rotationToY(std::string_view up);

/// "Read as centimetres, z up: 0.77 m tall."
[[nodiscard]] text::Sentence inWords(const MeshReading& reading);

}  // namespace drape::scene
