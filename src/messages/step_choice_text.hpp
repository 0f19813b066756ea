#pragma once

#include "sim/adaptive/step_choice.hpp"
#include "text/sentence.hpp"

namespace drape::messages {

/// The choice as text: "stiff cloth: 12 explicit substeps, 0.4 ms of 16 ms".
/// @param fabric the name of the fabric whose stretch stiffness is lowered; empty for springs
/// @param seconds computing time of the step [s]  @param available computing time for real time [s]; both 0 if unknown
[[nodiscard]] text::Sentence inWords(const sim::adaptive::StepChoice& choice, const text::Sentence& fabric,
                                     double seconds = 0.0, double available = 0.0);

}  // namespace drape::messages
