#pragma once

#include "sim/cloth_model.hpp"
#include "sim/cloth_state.hpp"
#include "sim/model_cache.hpp"
#include "sim/step_parameters.hpp"

#include <cstdint>

namespace drape {

/// Finds out when a cloth has come to rest, and leaves it there until something changes.
///
/// It has come to rest when in a whole second none of its vertices left the place where it was by more than a tenth
/// of the tolerance, or a thousandth of an edge. Only cloth that loses energy to damping or drag does, held by pins
/// or by bodies, with no hand on it. Then its velocities are set to zero, and it rests for as long as its state and
/// all that acts on it are what they were, to the last bit: settings, pins, masses, bodies.
class RestWatch {
 public:
  /// Whether the cloth is at rest and there is nothing to do in the step that begins. What it learnt it leaves in the
  /// state's memory.
  [[nodiscard]] bool holds(const ClothModel& model, const StepParameters& parameters, const StepInputs& inputs,
                           ClothState& state);

 private:
  /// What of a model matters here.
  struct Facts {
    bool held = false;       // every vertex, by springs to a pin
    double meanEdge = 0.0;   // [m]
    std::uint64_t mark = 0;  // of masses, pins and springs
  };

  [[nodiscard]] static Facts factsOf(const ClothModel& model);
  [[nodiscard]] static bool canRest(const Facts& facts, const StepParameters& parameters, const StepInputs& inputs);
  [[nodiscard]] static std::uint64_t markOf(const Facts& facts, const StepParameters& parameters,
                                            const StepInputs& inputs);

  ModelCache<Facts> facts_;
};

}  // namespace drape
