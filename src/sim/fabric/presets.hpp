#pragma once

#include "sim/fabric/material.hpp"

#include <span>
#include <string_view>

namespace drape::sim::fabric {

/// Friction coefficients of a fabric [-].
struct FabricFriction {
  double selfStatic = 0.0;   ///< of layers of the fabric that hold each other
  double selfKinetic = 0.0;  ///< of a layer that slides on another one
  double skin = 0.0;         ///< on dry skin, kinetic
};

/// A fabric with a name.
struct MaterialPreset {
  std::string_view name;   ///< in scene files and on the command line
  std::string_view title;  ///< on the panel
  double density = 0.0;    ///< mass per area [kg/m^2]
  Material material;
  /// Of the fabric itself [m]. Nothing is computed from it: the moduli contain it, and contact keeps the distance
  /// cloth_thickness, which must be larger.
  double thickness = 0.0;
  FabricFriction friction;
  std::string_view source;  ///< where the numbers come from; "estimate" marks those that were not measured on one cloth
};

/// All presets. A new preset is one row.
[[nodiscard]] std::span<const MaterialPreset> presetTable();

/// The friction of a fabric on skin over that of cotton [-]. The bodies of scenes have the friction of cotton.
[[nodiscard]] double skinFrictionRatio(const FabricFriction& friction);

/// The preset with that name, or nullptr.
[[nodiscard]] const MaterialPreset* findPreset(std::string_view name);

}  // namespace drape::sim::fabric
