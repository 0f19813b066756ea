#pragma once

#include "io/mesh_import.hpp"
#include "settings/settings.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// Another way to read a mesh file: a setting and the value that it would have.
struct ReadingAlternative {
  std::string key;    ///< "unit" or "up"
  std::string value;  ///< "m", "y"
};

/// In which unit a mesh file was read and which of its axes was taken to point up.
struct MeshReading {
  std::string unit = "m";  ///< a word or a number, as the setting has it
  double metresPerUnit = 1.0;
  bool unitGuessed = false;
  std::string up = "y";  ///< as the setting has it
  bool upGuessed = false;
  std::array<double, 3> size{};                  ///< width, height and depth that it has so [m]
  std::vector<ReadingAlternative> alternatives;  ///< the likeliest first; those of what was guessed or looks wrong

  /// True when a user should look at it: something was guessed, or the size is not that of a garment.
  [[nodiscard]] bool asks() const { return !alternatives.empty(); }
};

/// By what the coordinates of a file are multiplied when it is imported: metres per unit where the settings name a
/// unit, 1 where it is to be guessed.
[[nodiscard]] double metresPerUnitOf(const Settings::Mesh& settings);

/// Takes unit and up axis from the settings, or where those leave it open ("auto") from what the format prescribes, or
/// guesses it. Scales and turns the mesh, which comes as it was imported with metresPerUnitOf(settings).
[[nodiscard]] MeshReading readUpright(const Settings::Mesh& settings, ImportedMesh& mesh);

/// The rotation that turns the named axis ("z", "-y") to y: axis times angle [rad].
[[nodiscard]] Vec3 rotationToY(std::string_view up);

/// "Read as centimetres, z up: 0.77 m tall."
[[nodiscard]] std::string inWords(const MeshReading& reading);

}  // namespace drape
