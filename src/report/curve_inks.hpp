#pragma once

#include "report/blocks.hpp"
#include "report/svg_ink.hpp"

#include <string_view>
#include <vector>

namespace drape::report {

/// The appearance of a curve.
struct CurveInk {
  Ink ink = Ink::Text;
  int variant = 0;  ///< 0, 1, ... where several curves have the same ink: another dash and another marker
};

/// The appearance of each curve of a plot. At most `maxHighlighted` lines have a colour: those of `auto`, which always
/// have the same one, then the most important others. The other lines are grey.
[[nodiscard]] std::vector<CurveInk> curveInks(const Plot& plot);

/// Whether a label names `auto`: "auto" or "auto, float, cost".
[[nodiscard]] bool isOfAuto(std::string_view label);

}  // namespace drape::report
