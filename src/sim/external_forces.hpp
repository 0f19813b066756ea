#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/step_parameters.hpp"

#include <array>
#include <cstddef>

namespace drape {

/// Gravity and air on a vertex [N]. Every method evaluates the air at the start of a step.
[[nodiscard]] Vec3 gravityAndAir(const ClothModel& model, const StepParameters& parameters, const ClothState& state,
                                 std::size_t vertex);

/// The force of the attachment at the corners of its triangle.
struct AttachmentForce {
  std::array<std::size_t, 3> vertices{};  ///< the triangle's corners
  Vec3 weights = Vec3::Zero();            ///< of the corners, summing to 1
  Vec3 force = Vec3::Zero();              ///< on the attached point [N]; corner c gets weights[c] of it
  Vec3 velocity = Vec3::Zero();           ///< of the attached point [m/s]
  double stiffness = 0.0;  ///< |force| over the distance to the target [N/m]; smaller if the force is bounded
};

[[nodiscard]] AttachmentForce attachmentForce(const ClothModel& model, const Attachment& attachment,
                                              const ClothState& state);

}  // namespace drape
