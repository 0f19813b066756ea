#pragma once

#include "fabrics/look.hpp"
#include "sim/fabric/material.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace drape::fabrics {

/// Friction coefficients of a fabric [-].
struct Friction {
  double selfStatic = 0.0;   ///< of layers of the fabric that hold each other
  double selfKinetic = 0.0;  ///< of a layer that slides on another one
  double skin = 0.0;         ///< on dry skin, kinetic
};

/// Drape coefficients of fabrics of this kind in Cusick's drape test.
struct DrapeRange {
  double lower = 0.0;    ///< [%]
  double upper = 100.0;  ///< [%]
  bool estimated = false;
  std::string_view source;  ///< where the range comes from
};

/// A fabric with a name: all that the program knows about it.
struct Preset {
  std::string_view name;   ///< in scene files and on the command line
  std::string_view title;  ///< on the panel
  double density = 0.0;    ///< mass per area [kg/m^2]
  sim::fabric::Material material;
  /// Of the fabric itself [m]. Nothing is computed from it: the moduli contain it, and contact keeps the distance
  /// cloth_thickness, which must be larger.
  double thickness = 0.0;
  Friction friction;
  std::string_view source;  ///< where the numbers come from; "estimate" marks those that were not measured on one cloth
  std::optional<DrapeRange> drape = {};  ///< empty: no range is known
  Look look = {};
};

/// All presets. A new preset is one row.
[[nodiscard]] std::span<const Preset> presetTable();

/// The friction of a fabric on skin over that of cotton [-]. The bodies of scenes have the friction of cotton.
[[nodiscard]] double skinFrictionRatio(const Friction& friction);

/// The preset with that name, or nullptr.
[[nodiscard]] const Preset* findPreset(std::string_view name);

}  // namespace drape::fabrics
