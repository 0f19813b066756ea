#include "report/sections/stability_rule.hpp"

namespace drape {

std::string stabilityState(const StabilityFigures& figures) {
  // Written so that what is not a number explodes.
  if (!figures.finite || !(figures.energyGain <= explodingGain)) {
    return "explodes";
  }
  if (figures.energyGain > rattlingGain) {
    return "rattles";
  }
  return figures.motionKept < frozenMotion ? "frozen" : "calm";
}

}  // namespace drape
