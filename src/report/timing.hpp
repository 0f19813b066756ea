#pragma once

#include "scene/scene.hpp"
#include "sim/stepper.hpp"

#include <functional>
#include <vector>

namespace drape {

/// Seconds of the wall clock that a call takes.
[[nodiscard]] double secondsOf(const std::function<void()>& call);

/// The value below which that share of the values lies (nearest rank); not a number when there are none.
[[nodiscard]] double quantileOf(std::vector<double> values, double share);
[[nodiscard]] double medianOf(std::vector<double> values);

/// b of the power law y = a x^b that fits best, by least squares of the logarithms; not a number for fewer than two
/// points.
[[nodiscard]] double fittedExponent(const std::vector<double>& x, const std::vector<double>& y);

/// Times steps one by one, as the programs take them.
struct StepTiming {
  double setupSeconds = 0.0;        ///< by how much the first step took longer than the others' median [s]
  std::vector<double> stepSeconds;  ///< of each later step [s]
  double memoryBytes = 0.0;         ///< that the solver holds; not a number where the system does not tell
  bool finite = true;               ///< false when the cloth blew up; it was then put back to its start
};

struct TimingBudget {
  double seconds = 0.3;  ///< no step is begun after this
  int leastSteps = 5;    ///< but so many are always taken ...
  int mostSteps = 2000;  ///< ... and no more than these
};

/// @param checkStop is called before each step and may throw
[[nodiscard]] StepTiming timeSteps(const Scene& scene, const Settings& settings, const TimingBudget& budget,
                                   const std::function<void()>& checkStop);

}  // namespace drape
