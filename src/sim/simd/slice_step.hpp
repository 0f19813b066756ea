#pragma once

#include "sim/cloth_model.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// The parameters of a step in the precision T, without an attachment.
template <typename T>
[[nodiscard]] SliceStep<T> sliceStepOf(const StepParameters& parameters);

/// Adds the attachment to an implicit step, at the cloth's present state: the force minus h times its stiffness times
/// the velocity of the attached point, and the stiffness. Both are distributed by the weights of the corners.
template <typename T>
void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<T>& cloth,
                   SliceStep<T>& step);

/// Applies the attachment's implicit impulse J to the velocities of its corners: J = h k (target - p - h/2 u') with
/// u' = u + W J. p is the attached point, u its velocity and W its inverse mass, the sum of w_i^2 / m_i. J is bounded
/// like the force. It is stable for any stiffness, so the attachment does not change the limit of an explicit step.
template <typename T>
void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                            SlicedCloth<T>& cloth);

}  // namespace drape
