#pragma once

namespace drape::sim::contact {

/// How the cloth comes into contact with itself in a step, see ContactStage::approachOfItself.
struct SelfApproach {
  bool isNear = false;  ///< it may come into contact
  /// The largest motion in the step of two features in contact relative to each other, with the velocities at the start
  /// [m]; 0 with the hash.
  double motion = 0.0;
};

}  // namespace drape::sim::contact
