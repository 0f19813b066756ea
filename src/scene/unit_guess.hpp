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

/// The range of the largest extent of a torso without legs, such as a dress form [m].
inline constexpr double smallestTorso = 0.4;
inline constexpr double largestTorso = 1.1;

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
  bool isUsual = false;  ///< whether it gives the size of a garment, or for a body that of a person or a torso
};

/// Whether a body is a torso without legs. Persons fill 0.01 to 0.03 of the cube around them, also those who sit; a
/// ball fills 0.5. @param fullness its volume over the cube of its largest extent [-]
[[nodiscard]] bool isTorso(double fullness);

/// Guesses the unit from the largest extent of the bounding box in file units. It takes the likeliest of the units that
/// give a garment of 0.2 to 2.5 m: T-shirts have about 0.75 m, dresses 1.2 m, bodies 1.7 m, and metres and centimetres
/// are the most common units. A body is compared with persons: adults have about 1.7 m, children 1.1 m. A torso without
/// legs has about 0.75 m. If no unit fits, it takes the closest one. @param fullness of a body, see isTorso; 0: not
/// known
[[nodiscard]] UnitGuess guessUnit(double largestExtent, io::MeshUse use = io::MeshUse::Cloth, double fullness = 0.0);

}  // namespace drape::scene
