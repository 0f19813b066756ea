#pragma once

#include "report/blocks.hpp"

#include <string>

namespace drape::report {

/// A table for a terminal, with fitting columns: the first aligned left, numbers aligned right.
[[nodiscard]] std::string plainText(const TextTable& table);

}  // namespace drape::report
