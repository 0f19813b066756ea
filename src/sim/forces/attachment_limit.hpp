#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/model/cloth_model.hpp"

namespace drape::sim {

/// The maximum force of an attachment [N]: the force that stretches the cloth around its point by about a fifth, an
/// estimate for a fabric. It is at least a quarter of the weight of the cloth, so that an attachment moves cloth that
/// its own weight stretches more.
[[nodiscard]] double maxAttachmentForce(const ClothModel& model, const CommonParameters& parameters,
                                        const AttachmentEnds& ends);

}  // namespace drape::sim
