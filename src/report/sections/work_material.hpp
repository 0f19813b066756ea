#pragma once

#include <optional>
#include <string>
#include <vector>

namespace drape::report::sections {

/// The material of a cloth for the comparison of methods: springs of one stiffness, or a fabric by its preset.
struct WorkMaterial {
  std::string name;                   ///< of springs "springs", of a fabric its preset: "cotton"
  std::string title;                  ///< "10 N/m" or "cotton"
  std::optional<double> stiffness;    ///< of springs [N/m]
  std::vector<std::string> settings;  ///< "key=value"

  [[nodiscard]] bool isFabric() const { return !stiffness.has_value(); }
};

/// @param stiffness [N/m], as in a setting
[[nodiscard]] inline WorkMaterial springsOf(const std::string& stiffness) {
  return {"springs", stiffness + " N/m", std::stod(stiffness), {"stiffness=" + stiffness}};
}

/// With the density and the damping of the preset.
[[nodiscard]] inline WorkMaterial fabricOf(const std::string& preset) {
  return {preset,
          preset,
          std::nullopt,
          {"material.model=fabric", "material.preset=" + preset, "fabric.own_density=on", "auto.strain=0"}};
}

}  // namespace drape::report::sections
