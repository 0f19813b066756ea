#pragma once

#include <optional>
#include <string_view>

namespace drape {

/// Parses a number or a fraction such as 1/150. Empty for any other text.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace drape
