#pragma once

#include "sim/contact/bodies/body.hpp"

#include <span>
#include <string_view>

namespace drape::settings {

/// One property of a body's surface, declared once. The panel and the scene files read it here.
struct SurfaceField {
  std::string_view key;    ///< in scene files
  std::string_view title;  ///< on the panel
  std::string_view unit;
  double sim::contact::SurfaceProperties::*value;
  double min;
  double max;
  double sliderMax;  ///< upper end of the slider; larger values can be typed
  bool logarithmic;  ///< whether the slider is logarithmic
  std::string_view help;
};

/// All properties, in the order of the panel.
[[nodiscard]] std::span<const SurfaceField> surfaceFields();

/// `surface` with another value of one property. Static friction is never less than kinetic friction: a change of one
/// may also move the other.
[[nodiscard]] sim::contact::SurfaceProperties withSurfaceValue(sim::contact::SurfaceProperties surface,
                                                               const SurfaceField& field, double value);

/// Throws UsageError with property and range when a value is out of range.
void requireAllowed(const sim::contact::SurfaceProperties& surface);

}  // namespace drape::settings
