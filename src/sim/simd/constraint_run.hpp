#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/forces/common_parameters.hpp"
#include "sim/forces/step_inputs.hpp"
#include "sim/model/model_cache.hpp"
#include "sim/simd/constraint_lanes.hpp"
#include "sim/simd/thread_team.hpp"

namespace drape::sim::simd {

/// Runs XPBD steps in float with vector instructions and the threads of the parameters. The state is converted once for
/// all steps; with air, which is evaluated in double, once for each step.
class ConstraintRun {
 public:
  void xpbd(const ClothModel& model, const CommonParameters& parameters, int iterations, const StepInputs& inputs,
            int count, ClothState& state);

 private:
  ThreadTeam team_;
  ModelCache<ConstraintLanes> lanes_;
  AttachmentConstraint attachment_;
};

}  // namespace drape::sim::simd
