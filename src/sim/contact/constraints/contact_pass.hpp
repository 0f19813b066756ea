#pragma once

#include "sim/contact/broad_phase/cloth_step.hpp"
#include "sim/contact/broad_phase/prepared_cloth.hpp"
#include "sim/contact/constraints/near_bodies.hpp"
#include "sim/model/workers.hpp"

#include <vector>

namespace drape::sim::contact {

/// A pass of body contact: one search and one correction (BodyContact).
struct ContactPass {
  const ClothStep& step;
  const PreparedCloth& cloth;
  NearBodies& bodies;
  const std::vector<Vec3>* previous;  ///< result of the pass before; null in the first, which starts from `step.start`
  Workers& workers;

  /// Whether the pass starts from positions at the end of the step, so that bodies no longer move in it.
  [[nodiscard]] bool atEnd() const { return previous != nullptr; }
};

}  // namespace drape::sim::contact
