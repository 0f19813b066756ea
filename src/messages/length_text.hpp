#pragma once

#include "text/sentence.hpp"

#include <string>

namespace drape::messages {

/// Two significant digits, without an exponent.
[[nodiscard]] std::string brief(double value);

/// A length with two significant digits in a fitting unit: "about 0.2 mm", "below 1 nm".
/// @param metres [m], at least 0
[[nodiscard]] text::Sentence lengthInWords(double metres);

}  // namespace drape::messages
