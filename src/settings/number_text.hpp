#pragma once

#include <optional>
#include <string_view>

namespace drape {

/// What a text says: a number or a fraction such as 1/150; nothing where it is neither.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

}  // namespace drape
