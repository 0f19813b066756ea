#pragma once

#include "report/sections/set_ups.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace drape::report::sections {

/// A possible start of a run of the paper's Table 2; the paper does not give it.
struct Table2Start {
  std::string name;      ///< as in report.json
  std::string help;      ///< description
  SetUp setUp;           ///< flat and at rest, or the basis of the start
  bool hanging = false;  ///< whether it has come to rest upright and is rotated about its pins by `tilt`
  double swing = 0.0;    ///< duration of the motion before the start, with the reference [s]
};

/// The rotation of a hanging cloth [degrees].
inline constexpr double startTilt = 20.0;

[[nodiscard]] const std::vector<Table2Start>& table2Starts();

/// The time steps of the paper's runs and of their reference, explicit Euler [s].
inline constexpr const char* paperStep = "1/150";
inline constexpr const char* paperReferenceStep = "1/30000";

/// The settings of the reference for a scene.
[[nodiscard]] settings::Settings paperReferenceSettings(const scene::Scene& scene);

/// The scene with that start and these settings ("key=value").
/// @param checkStop is called at each step and may throw
[[nodiscard]] std::shared_ptr<const scene::Scene> buildStart(const Table2Start& start, int resolution,
                                                             const std::vector<std::string>& settings,
                                                             const std::function<void()>& checkStop);

}  // namespace drape::report::sections
