#pragma once

#include "sim/adaptive/step_choice.hpp"
#include "text/sentence.hpp"

namespace drape::messages {

/// The choice as text: "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms".
/// @param seconds computing time of the step [s]  @param available computing time for real time [s]; both 0 if unknown
[[nodiscard]] text::Sentence inWords(const sim::adaptive::StepChoice& choice, double seconds = 0.0,
                                     double available = 0.0);

}  // namespace drape::messages
