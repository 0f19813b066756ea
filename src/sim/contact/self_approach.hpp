#pragma once

namespace drape::sim::contact {

/// How the cloth comes into contact with itself in a step.
struct SelfApproach {
  bool isNear = false;
  /// The largest motion of two features in contact relative to each other, with the present velocities [m]; 0 with the
  /// hash.
  double motion = 0.0;
};

}  // namespace drape::sim::contact
