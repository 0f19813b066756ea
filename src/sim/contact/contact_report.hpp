#pragma once

#include "sim/vector.hpp"

namespace drape {

/// What contact found and did in a step.
struct ContactReport {
  int bodyContacts = 0;         ///< places where the cloth was kept out of a body
  int selfContacts = 0;         ///< places where the cloth was kept apart from itself
  int overlaps = 0;             ///< triangles of the cloth that were inside a body when the step began
  double deepestOverlap = 0.0;  ///< of these [m]
  int squeezed = 0;             ///< vertices that could not be kept out of all bodies at once
  double bodySeconds = 0.0;     ///< what bodies cost, by the clock [s]
  double selfSeconds = 0.0;     ///< what self-collision cost, by the clock [s]
};

/// A place where the cloth touches something, to be drawn.
struct ContactPoint {
  Vec3 point = Vec3::Zero();    ///< [m]
  Vec3 normal = Vec3::UnitY();  ///< towards the side where the cloth is kept
};

}  // namespace drape
