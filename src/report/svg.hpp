#pragma once

#include "report/blocks.hpp"

#include <string>
#include <string_view>

namespace drape {

/// The style sheet of the pictures below, for a light and a dark background and for print. A page that holds several
/// carries it once.
[[nodiscard]] std::string_view svgStyle();

/// A picture as an SVG element without its style.
[[nodiscard]] std::string svgOf(const Plot& plot);
[[nodiscard]] std::string svgOf(const StateMap& map);

/// A picture as a file of its own.
[[nodiscard]] std::string svgFile(std::string_view svg);

}  // namespace drape
