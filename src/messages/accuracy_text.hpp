#pragma once

#include "sim/measures/accuracy.hpp"
#include "text/sentence.hpp"

namespace drape::messages {

/// The result of a check of the error as text: "about 0.2 mm after 0.2 s", or why the error cannot be known.
[[nodiscard]] text::Sentence inWords(const sim::Accuracy& accuracy);

}  // namespace drape::messages
