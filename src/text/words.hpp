#pragma once

#include <string>

namespace drape {

/// The text with its ASCII letters in lower case.
[[nodiscard]] std::string lowerCase(std::string text);

}  // namespace drape
