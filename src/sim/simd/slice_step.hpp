#pragma once

#include "sim/cloth_model.hpp"
#include "sim/simd/sliced_cloth.hpp"
#include "sim/step_parameters.hpp"

namespace drape {

/// The parameters of a step in its own precision, without a hand.
template <typename T>
[[nodiscard]] SliceStep<T> sliceStepOf(const StepParameters& parameters);

/// Puts the hand's pull at the cloth's present place into an implicit step: the force less h times its stiffness times
/// the held point's velocity, and the stiffness, shared by the corners' weights.
template <typename T>
void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<T>& cloth,
                   SliceStep<T>& step);

/// Changes the velocities of the corners of the hand's triangle by its impulse J on the held point p, from where the
/// point ends: J = h k (target - p - h/2 u'), u' = u + W J, with u the point's velocity and W its inverse mass, the sum
/// of w_i^2 / m_i. J is bounded like the force. Stable for any stiffness of the hand, so that an explicit step's own
/// limit stays what it is.
template <typename T>
void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                            SlicedCloth<T>& cloth);

}  // namespace drape
