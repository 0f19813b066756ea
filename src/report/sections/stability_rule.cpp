#include "report/sections/stability_rule.hpp"

namespace drape::report::sections {

std::string stabilityState(const StabilityFigures& figures) {
  // In this form a NaN counts as an explosion.
  if (!figures.finite || !(figures.energyGain <= explodingGain)) {
    return "explodes";
  }
  if (figures.energyGain > rattlingGain) {
    return "rattles";
  }
  return figures.motionKept < frozenMotion ? "frozen" : "calm";
}

}  // namespace drape::report::sections
