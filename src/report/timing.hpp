#pragma once

#include "scene/scene.hpp"
#include "sim/stepping/stepper.hpp"

#include <functional>
#include <vector>

namespace drape::report {

/// The duration of a call by the wall clock [s].
[[nodiscard]] double secondsOf(const std::function<void()>& call);

/// The quantile of the values at this share (nearest rank); not a number without values.
[[nodiscard]] double quantileOf(std::vector<double> values, double share);
[[nodiscard]] double medianOf(std::vector<double> values);

/// The exponent b of the power law y = a x^b, by least squares of the logarithms; not a number for fewer than two
/// points.
[[nodiscard]] double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

/// The durations of single steps, taken as the programs take them.
struct StepTiming {
  double setupSeconds = 0.0;        ///< duration of the first step minus the median of the others [s]
  std::vector<double> stepSeconds;  ///< of each later step [s]
  double memoryBytes = 0.0;         ///< of the solver; not a number when unknown
  bool finite = true;               ///< false when the cloth blew up; it was then reset to its start
};

struct TimingBudget {
  double seconds = 0.3;  ///< no step starts after this
  int minSteps = 5;      ///< minimum number of steps ...
  int maxSteps = 2000;   ///< ... and maximum
};

/// @param checkStop is called before each step and may throw
[[nodiscard]] StepTiming timeSteps(const scene::Scene& scene, const settings::Settings& settings,
                                   const TimingBudget& budget, const std::function<void()>& checkStop);

}  // namespace drape::report
