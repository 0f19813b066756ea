#pragma once

#include "sim/contact/bodies/body.hpp"

#include <vector>

namespace drape {

/// What bodies do in a part of a step: places linear in time between the step's ends, rotations along the great circle.
class BodyParts {
 public:
  /// The bodies from one share of the step to another, 0 being its start and 1 its end. Good until the next call.
  [[nodiscard]] const std::vector<BodyStep>& between(const std::vector<BodyStep>& whole, double from, double to);

 private:
  std::vector<BodyStep> parts_;
  std::vector<std::vector<Vec3>> startVertices_;  // of meshes that move in themselves
  std::vector<std::vector<Vec3>> endVertices_;
};

}  // namespace drape
