#pragma once

#include "sim/contact/bodies/body.hpp"

#include <span>
#include <string_view>

namespace drape {

/// One property of a body's surface, declared once: the panel and the scene files read this.
struct SurfaceField {
  std::string_view key;    ///< as in a scene file
  std::string_view title;  ///< as on the panel
  std::string_view unit;
  double SurfaceProperties::*value;
  double min;
  double max;
  double everyday;   ///< up to which a slider goes
  bool logarithmic;  ///< a slider should move in decades
  std::string_view help;
};

/// In the order in which they are shown.
[[nodiscard]] std::span<const SurfaceField> surfaceFields();

/// Throws UsageError naming property and range when a value is out of it.
void requireAllowed(const SurfaceProperties& surface);

}  // namespace drape
