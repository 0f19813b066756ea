#pragma once

#include "report/blocks.hpp"

#include <string>

namespace drape::report::testing {

/// A plot with this number of lines "0", "1", ..., and those of `auto` after them.
inline Plot manyCurves(int count) {
  Plot plot{"name", "title", {"x", Scale::Linear}, {"y", Scale::Linear}, {}};
  for (int i = 0; i < count; ++i) {
    plot.curves.push_back({std::to_string(i), {{0.0, 1.0 * i}, {1.0, 1.0 * i}}});
  }
  for (const char* label : {"auto, cost", "auto, float, cost"}) {
    plot.curves.push_back({label, {{0.0, -1.0}, {1.0, -1.0}}});
  }
  return plot;
}

}  // namespace drape::report::testing
