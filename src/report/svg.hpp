#pragma once

#include "report/blocks.hpp"

#include <string>
#include <string_view>

namespace drape::report {

/// A picture as an SVG element. Its colours are attributes, for a light background; a page may add darkStyle.
[[nodiscard]] std::string svgOf(const Plot& plot);
[[nodiscard]] std::string svgOf(const StateMap& map);
[[nodiscard]] std::string svgOf(const Drawing& drawing);

/// A picture as a separate file, on a white background.
[[nodiscard]] std::string svgFile(std::string_view svg);

}  // namespace drape::report
