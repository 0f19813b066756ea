#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/contact/contact_stage.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape {

/// Finds out when a cloth has come to rest, and leaves it there until something changes.
///
/// It has come to rest when in a whole second none of its vertices left the place where it was by more than a tenth
/// of the tolerance, or a thousandth of an edge. Only cloth that loses energy to damping or drag does, with no hand on
/// it, and every piece of which pins or bodies hold: a piece without pins must lie against a body in the direction
/// in which its weight and the air push it. Then its velocities are set to zero, and it rests
/// for as long as its state and all that acts on it are what they were, to the last bit: settings, pins, masses,
/// bodies.
class RestWatch {
 public:
  /// Whether the cloth is at rest and there is nothing to do in the step that begins. What it learnt it leaves in the
  /// state's memory.
  [[nodiscard]] bool holds(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                           ClothState& state);

 private:
  /// What of a model matters here.
  struct Facts {
    std::vector<std::vector<std::size_t>> freePieces;  // that no pin holds
    double meanEdge = 0.0;                             // [m]
    std::uint64_t mark = 0;                            // of masses, pins and springs
  };

  [[nodiscard]] static Facts factsOf(const ClothModel& model);
  [[nodiscard]] static bool canRest(const Facts& facts, const StepParameters& parameters, const StepInputs& inputs);
  [[nodiscard]] bool isCarried(const ClothModel& model, const Facts& facts, const StepParameters& parameters,
                               const StepInputs& inputs, const ClothState& state);
  [[nodiscard]] static std::uint64_t markOf(const Facts& facts, const StepParameters& parameters,
                                            const StepInputs& inputs);

  ModelCache<Facts> facts_;
  ContactStage contact_;  // of the trial that asks what carries the cloth
};

}  // namespace drape
