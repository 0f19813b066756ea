#pragma once

#include "text/sentence.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::scene {

/// The range of sizes of garments and of the bodies that wear them [m].
inline constexpr double smallestGarment = 0.2;
inline constexpr double largestGarment = 2.5;

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
  std::vector<std::string> others;  ///< other units that give the size of a garment, likeliest first
};

/// Guesses the unit from the largest extent of the bounding box in file units. It takes the likeliest of the units that
/// give a garment of 0.2 to 2.5 m: T-shirts have about 0.75 m, dresses 1.2 m, bodies 1.7 m, and metres and centimetres
/// are the most common units. If no unit fits, it takes the closest one.
[[nodiscard]] UnitGuess guessUnit(double largestExtent);

}  // namespace drape::scene
