#pragma once

#include <string>
#include <string_view>

namespace drape::report {

/// The colours of the pictures. Pictures write them as attributes, which every viewer of SVG understands; a page can
/// add those for a dark background as a style sheet.
enum class Ink {
  Text,
  Faint,   ///< grid lines
  Paper,   ///< background
  Auto,    ///< the curve of `auto`, in every picture
  Curve1,  ///< the other curves that stand out, up to Curve6
  Curve2,
  Curve3,
  Curve4,
  Curve5,
  Curve6,
  Grey,  ///< curves that do not stand out
  Good,  ///< cells of maps, by Tone
  Doubtful,
  Bad,
  Dull,
  None
};

/// The colour on a light background, "#0072b2".
[[nodiscard]] std::string lightColour(Ink ink);

/// The classes of elements with that fill or stroke, for darkStyle.
[[nodiscard]] std::string fillClass(Ink ink);
[[nodiscard]] std::string lineClass(Ink ink);

/// Style rules that replace all colours by those for a dark background.
[[nodiscard]] std::string darkStyle();

}  // namespace drape::report
