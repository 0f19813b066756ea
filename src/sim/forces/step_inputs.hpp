#pragma once

#include "sim/forces/attachment.hpp"
#include "sim/forces/substep_contact.hpp"
#include "sim/model/vector.hpp"

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

namespace drape::sim {

namespace contact {
struct BodyStep;
}

/// Thrown out of a step when StepInputs::stop requests a stop. `auto` and `newton` throw it with the state as it was at
/// the start of the substep; the step is lost.
struct StepStopped {};

/// The displacement of a pin over a step.
struct MovedPin {
  int vertex = 0;
  Vec3 by = Vec3::Zero();  ///< [m]
};

/// External actions on the cloth during one step.
struct StepInputs {
  std::optional<Attachment> attachment;
  const std::vector<contact::BodyStep>* bodies = nullptr;  ///< over this step (sim/contact/bodies/body.hpp); null: none
  /// Pins that move without a body, each at constant velocity. Null: none; pins that are released do not move. A solver
  /// gets all pins that move, in its frame of reference (SolverInfo::resolvesContacts).
  const std::vector<MovedPin>* movedPins = nullptr;
  /// Contacts that act in every substep (SolverInfo::resolvesContacts). The solver stores their impulses in
  /// them. Null: none.
  std::vector<SubstepContact>* contacts = nullptr;
  Vec3 frameVelocity = Vec3::Zero();  ///< of the frame of reference in which the solver works [m/s]
  /// Methods whose steps may take seconds check it now and then and throw StepStopped.
  std::stop_token stop = {};
  /// Called at the same points, to show progress or to check a deadline. An exception that it throws ends the step like
  /// StepStopped. Null if not needed.
  const std::function<void()>* onProgress = nullptr;
};

/// Ends the step if a stop is requested, and reports progress.
inline void checkStop(const StepInputs& inputs) {
  if (inputs.stop.stop_requested()) {
    throw StepStopped();
  }
  if (inputs.onProgress != nullptr) {
    (*inputs.onProgress)();
  }
}

}  // namespace drape::sim
