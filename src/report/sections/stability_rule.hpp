#pragma once

#include <string>

namespace drape::report::sections {

/// The results of a run under gravity from rest, without damping and air. There is no external energy.
struct StabilityFigures {
  bool finite = true;
  double energyGain = 0.0;  ///< largest rise of the total energy above its start value after any step, in m g D [-]
  double motionKept = 1.0;  ///< relative to the motion of a run with small steps [-]
};

/// A larger rise of the energy is an explosion; m g D is the energy of a fall by the cloth's diagonal D.
inline constexpr double explodingGain = 10.0;
/// A larger rise is visible as rattling.
inline constexpr double rattlingGain = 0.05;
/// A smaller motion counts as frozen.
inline constexpr double frozenMotion = 0.5;

/// "explodes": not finite, or the gain is above explodingGain. "rattles": above rattlingGain. "frozen": motion below
/// frozenMotion. Otherwise "calm".
[[nodiscard]] std::string stabilityState(const StabilityFigures& figures);

}  // namespace drape::report::sections
