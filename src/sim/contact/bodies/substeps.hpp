#pragma once

#include "sim/contact/bodies/body.hpp"

#include <vector>

namespace drape::sim::contact {

/// The motion of bodies in a contact substep: positions are interpolated linearly, rotations by slerp.
class BodySubsteps {
 public:
  /// The motion from one fraction of the step to another; 0 is its start, 1 its end. Valid until the next call.
  /// @param whole the motion over the step
  [[nodiscard]] const std::vector<BodyStep>& between(const std::vector<BodyStep>& whole, double from, double to);

 private:
  std::vector<BodyStep> parts_;
  std::vector<std::vector<Vec3>> startVertices_;  // of deforming meshes
  std::vector<std::vector<Vec3>> endVertices_;
};

}  // namespace drape::sim::contact
