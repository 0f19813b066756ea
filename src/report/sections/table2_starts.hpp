#pragma once

#include "report/sections/set_ups.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace drape {

/// How a run of the paper's Table 2 could have begun: it does not say.
struct Table2Start {
  std::string name;      ///< as in report.json
  std::string help;      ///< in words
  SetUp setUp;           ///< flat and at rest, or what the rest begins with
  bool hanging = false;  ///< it has come to rest upright and is tilted about its pins by `tilt`
  double swing = 0.0;    ///< how long it has been in motion before, by the reference [s]
};

/// By how much a hanging cloth is tilted [degrees].
inline constexpr double startTilt = 20.0;

[[nodiscard]] const std::vector<Table2Start>& table2Starts();

/// The cloth's time step in the paper's runs and that of its reference, explicit Euler [s].
inline constexpr const char* paperStep = "1/150";
inline constexpr const char* paperReferenceStep = "1/30000";

/// The settings of the reference for a scene.
[[nodiscard]] Settings paperReferenceSettings(const Scene& scene);

/// The scene with that start, under these settings ("key=value").
/// @param checkStop is called at each step and may throw
[[nodiscard]] std::shared_ptr<const Scene> buildStart(const Table2Start& start, int resolution,
                                                      const std::vector<std::string>& settings,
                                                      const std::function<void()>& checkStop);

}  // namespace drape
