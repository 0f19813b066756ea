#pragma once

#include "report/blocks.hpp"

#include <string>
#include <string_view>

namespace drape::report {

/// The style sheet of the pictures, for a light and a dark background and for print. A page with several pictures
/// contains it once.
[[nodiscard]] std::string_view svgStyle();

/// A picture as an SVG element without style.
[[nodiscard]] std::string svgOf(const Plot& plot);
[[nodiscard]] std::string svgOf(const StateMap& map);
[[nodiscard]] std::string svgOf(const Drawing& drawing);

/// A picture as a separate file.
[[nodiscard]] std::string svgFile(std::string_view svg);

}  // namespace drape::report
