#pragma once

#include <string>

namespace drape {

/// What a run under gravity from rest, without damping and air, comes to. Nothing gives it energy.
struct StabilityFigures {
  bool finite = true;
  double energyGain = 0.0;  ///< largest rise of the total energy above the start's after any step, in m g D [-]
  double motionKept = 1.0;  ///< of the motion of a run with small steps [-]
};

/// A rise of the energy by more than this is an explosion; m g D is what the cloth could fall by its own diagonal D.
inline constexpr double explodingGain = 10.0;
/// A rise by more than this is seen as rattling.
inline constexpr double rattlingGain = 0.05;
/// A motion that keeps less than this is frozen.
inline constexpr double frozenMotion = 0.5;

/// "explodes": not finite, or the gain is above explodingGain. "rattles": above rattlingGain. "frozen": keeps less than
/// frozenMotion. Else "calm".
[[nodiscard]] std::string stabilityState(const StabilityFigures& figures);

}  // namespace drape
