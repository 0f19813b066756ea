#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape {

/// Garments and the bodies that wear them are between these sizes [m].
inline constexpr double smallestGarment = 0.2;
inline constexpr double largestGarment = 2.5;

/// A unit of length in which mesh files are written.
struct LengthUnit {
  std::string_view word;    ///< as the setting `unit` names it: "cm"
  std::string_view plural;  ///< "centimetres"
  double metres = 1.0;
};

/// Metres per unit of a value of the setting `unit` other than "auto": a word, or a number such as "0.0254".
[[nodiscard]] double metresPerUnit(std::string_view unit);

/// The value of the setting `unit` for a length: a word where there is one, else the number.
[[nodiscard]] std::string wordForUnit(double metres);

/// What a value of the setting `unit` is called in a sentence: "centimetres", or "units of 0.03 m".
[[nodiscard]] std::string unitInWords(std::string_view unit);

/// In which unit a mesh was written.
struct UnitGuess {
  std::string unit = "m";
  std::vector<std::string> others;  ///< the other units in which it has the size of a garment, likeliest first
};

/// Guesses the unit from the largest extent of the bounding box, which is in the file's unit. Of the units that make a
/// garment of it (0.2 to 2.5 m) the likeliest is taken: T-shirts are about 0.75 m, dresses 1.2 m, bodies 1.7 m, and
/// files in metres and centimetres are more common than others. When there is none, the unit that comes nearest.
[[nodiscard]] UnitGuess guessUnit(double largestExtent);

}  // namespace drape
