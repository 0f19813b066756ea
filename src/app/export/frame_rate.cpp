#include "app/export/frame_rate.hpp"

#include "messages/error.hpp"
#include "settings/settings_table.hpp"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iostream>

namespace drape::app {
namespace {

/// How far the number of steps in a frame may be from a whole number, since users type rounded time steps.
constexpr double tolerance = 1e-4;

bool isWhole(double steps) {
  return std::round(steps) >= 1.0 && std::abs(steps - std::round(steps)) <= tolerance * steps;
}

/// The number of steps of at most that length in a frame.
double enoughSteps(double rate, double timeStep) {
  return std::max(1.0, std::ceil(1.0 / (rate * timeStep) - tolerance));
}

}  // namespace

double fittingTimeStep(double rate, double timeStep) {
  return isWhole(1.0 / (rate * timeStep)) ? timeStep : 1.0 / (rate * enoughSteps(rate, timeStep));
}

std::function<void(settings::Settings&)> fitTimeStep(double rate, std::span<const std::string> changes) {
  const auto setsTimeStep = [](const std::string& change) { return settings::keyOf(change) == "time_step"; };
  if (std::ranges::any_of(changes, setsTimeStep)) {
    return {};
  }
  return [rate](settings::Settings& settings) {
    double& timeStep = settings.step.timeStep;
    if (const double fitting = fittingTimeStep(rate, timeStep); fitting != timeStep) {
      timeStep = fitting;
      std::cerr << fmt::format(
          "note: the time step is 1/{:.6g} s, so that {:.6g} frames a second are whole numbers of steps\n",
          1.0 / fitting, rate);
    }
  };
}

int stepsPerFrame(double rate, double timeStep) {
  const double steps = 1.0 / (rate * timeStep);
  if (!isWhole(steps)) {
    throw messages::UsageError(
        fmt::format("a frame of 1/{:.6g} s is {:.4g} time steps, not a whole number; use --set time_step=1/{:.6g} or "
                    "another --rate",
                    rate, steps, rate * enoughSteps(rate, timeStep)));
  }
  return static_cast<int>(std::lround(steps));
}

}  // namespace drape::app
