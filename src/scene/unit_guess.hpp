#pragma once

#include "io/mesh_import.hpp"
#include "text/sentence.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// The range of sizes of garments and of the bodies that wear them [m].
inline constexpr double smallestGarment = 0.2;
inline constexpr double largestGarment = 2.5;

/// The range of the largest extent of a person [m].
inline constexpr double smallestPerson = 0.9;
inline constexpr double largestPerson = 2.2;

/// A unit of length of mesh files.
struct LengthUnit {
  std::string_view word;    ///< the value of the setting `unit`: "cm"
  std::string_view plural;  ///< "centimetres"
  double metres = 1.0;
};

/// Metres per unit of a value of the setting `unit` other than "auto": a word, or a number such as "0.0254".
[[nodiscard]] double metresPerUnit(std::string_view unit);

/// The value of the setting `unit` for a length: a word if there is one, otherwise the number.
[[nodiscard]] std::string wordForUnit(double metres);

/// The unit in a sentence: "centimetres", or "units of 0.03 m".
[[nodiscard]] text::Sentence unitInWords(std::string_view unit);

/// A guess of the unit of a mesh.
struct UnitGuess {
  std::string unit = "m";
  std::vector<std::string> others;  ///< other units that give a usual size, likeliest first
  bool isUsual = false;             ///< whether the unit gives the size of a garment, or for a body that of a person
};

/// Guesses the unit from the largest extent of the bounding box in file units. It takes the likeliest of the units that
/// give a garment of 0.2 to 2.5 m: T-shirts have about 0.75 m, dresses 1.2 m, bodies 1.7 m, and metres and centimetres
/// are the most common units. A body is compared with persons alone: adults have about 1.7 m, children 1.1 m. If no
/// unit fits, it takes the closest one.
[[nodiscard]] UnitGuess guessUnit(double largestExtent, io::MeshUse use = io::MeshUse::Cloth);

}  // namespace drape::scene
