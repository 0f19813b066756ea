#pragma once

#include "report/blocks.hpp"

#include <string>

namespace drape {

/// A table for a terminal: columns as wide as they need to be, the first to the left, figures to the right.
[[nodiscard]] std::string plainText(const TextTable& table);

}  // namespace drape
