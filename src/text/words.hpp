#pragma once

#include <string>

namespace drape::text {

/// The text with its ASCII letters in lower case.
[[nodiscard]] std::string lowerCase(std::string text);

}  // namespace drape::text
