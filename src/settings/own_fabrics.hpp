#pragma once

#include "sim/fabric/material.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace drape::settings {

struct Settings;

/// A fabric that the user named and saved.
struct OwnFabric {
  std::string name;
  std::string basedOn;             ///< the preset whose look it has; empty: the preset with the most similar values
  std::string source;              ///< where the numbers come from, in the user's words
  double density = 0.0;            ///< mass per area [kg/m^2]
  sim::fabric::Material material;  ///< moduli and damping

  friend bool operator==(const OwnFabric&, const OwnFabric&) = default;
};

/// The user's fabrics. Settings share the list, and it never changes. Null: there are none.
using OwnFabrics = std::shared_ptr<const std::vector<OwnFabric>>;

/// The value of material.preset for values that belong to no preset.
inline constexpr std::string_view noPreset = "custom";

/// The mark after the name of a fabric whose values were changed, in material.preset: "cotton, changed".
inline constexpr std::string_view changedMark = ", changed";

inline constexpr std::size_t longestFabricName = 40;  ///< [bytes]

/// The keys of the settings that a fabric consists of: "fabric.stretch_warp" and so on, with "fabric.density".
[[nodiscard]] std::span<const std::string_view> fabricValueKeys();

/// The keys of the settings that a fabric brings besides its values, and that may be changed without changing it.
[[nodiscard]] std::span<const std::string_view> fabricFrictionKeys();

/// What is wrong with the name of an own fabric and what to do, in one sentence. Empty for a good name.
[[nodiscard]] std::string problemWithFabricName(std::string_view name);

/// The own fabric with that name, or nullptr.
[[nodiscard]] const OwnFabric* findOwnFabric(const OwnFabrics& fabrics, std::string_view name);

/// The list with one more fabric, which replaces one of the same name.
[[nodiscard]] OwnFabrics withOwnFabric(const OwnFabrics& fabrics, OwnFabric fabric);

/// `fabrics` and then those of `more`, which replace fabrics of the same name.
[[nodiscard]] OwnFabrics joined(const OwnFabrics& fabrics, const OwnFabrics& more);

/// The fabric that the settings have, under a new name. It is based on the fabric that was chosen last.
[[nodiscard]] OwnFabric fabricOf(const Settings& settings, std::string_view name);

/// Throws UsageError when the name is bad, when a value is out of the range of its setting, or when the values exclude
/// each other. The message begins with the name of the fabric.
void requireAllowed(const OwnFabric& fabric);

/// Throws UsageError when a value of the fabric of these settings is out of its range, or when the values exclude each
/// other.
void requireFabricValues(const Settings& settings);

/// Sets the friction of cloth on cloth and on bodies to that of the preset with this name, if there is one.
void useFriction(Settings& settings, std::string_view preset);

/// All values of a fabric at once, and the friction of the preset that it is based on. Single values could pass through
/// combinations that are refused.
void useFabric(Settings& settings, const OwnFabric& fabric);

}  // namespace drape::settings
