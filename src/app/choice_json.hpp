#pragma once

#include "sim/adaptive/step_choice.hpp"
#include "text/sentence.hpp"

#include <nlohmann/json.hpp>
#include <optional>

namespace drape::app {

/// The choices of a solver such as `auto`; null for others. @param fabric as of messages::inWords
[[nodiscard]] nlohmann::ordered_json toJson(const std::optional<sim::adaptive::StepChoice>& choice,
                                            const text::Sentence& fabric);

}  // namespace drape::app
