#pragma once

#include <array>
#include <limits>

namespace drape::report::sections {

/// The values of the paper's Table 1, for a square sheet of so many vertices per side [ms].
struct PaperTimes {
  int resolution = 0;
  double update = 0.0;
  double selfCollision = 0.0;
};
inline constexpr std::array paperTimes{PaperTimes{17, 0.5, 0.92}, PaperTimes{33, 1.74, 3.54}};

/// The paper's time of self-collision in a step [s]; not a number if it gives none for that resolution.
[[nodiscard]] inline double paperSelfCollision(int resolution) {
  constexpr double millisecond = 1e-3;
  for (const PaperTimes& paper : paperTimes) {
    if (paper.resolution == resolution) {
      return millisecond * paper.selfCollision;
    }
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace drape::report::sections
