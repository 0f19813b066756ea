#pragma once

#include "sim/cloth_model.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// The largest force by which a hand should pull at a point of a cloth [N], from what the material there bears: the
/// force that stretches the springs around the point by about a fifth. It is no less than a quarter of the cloth's
/// weight, so that a hand moves cloth that its own weight already stretches by more.
/// @param triangle that is held  @param barycentric where it is held; sums to 1
[[nodiscard]] double maxAttachmentForce(const ClothModel& model, const StepParameters& parameters, int triangle,
                                        const Vec3& barycentric);

}  // namespace drape
