#pragma once

#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/cloth_model.hpp"
#include "sim/simd/jacobi_options.hpp"
#include "sim/simd/sliced_cloth.hpp"

namespace drape::sim::simd {

/// The parameters of a step in the precision T, without an attachment.
template <typename T>
[[nodiscard]] SliceStep<T> sliceStepOf(const CommonParameters& parameters, const JacobiOptions& jacobi);

/// Adds the attachment to an implicit step, at the cloth's present state: the force minus h times its stiffness times
/// the velocity of the attached point, and the stiffness. Both are distributed by the weights of the corners.
template <typename T>
void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<T>& cloth,
                   SliceStep<T>& step);

/// Applies the attachment's implicit impulse (AttachmentSpring::implicitImpulse) to the velocities of its corners. It
/// is stable for any stiffness, so the attachment does not change the limit of an explicit step.
template <typename T>
void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                            SlicedCloth<T>& cloth);

}  // namespace drape::sim::simd
