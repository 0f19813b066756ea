#pragma once

#include "sim/measures/error_sources.hpp"
#include "text/sentence.hpp"

namespace drape::messages {

/// Where most of the error comes from, in one sentence: "Most of the error comes from the mesh: about 3 mm after
/// 0.5 s".
[[nodiscard]] text::Sentence inWords(const sim::ErrorSources& sources);

}  // namespace drape::messages
