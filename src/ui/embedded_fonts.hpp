#pragma once

#include "sim/embedded_file.hpp"

#include <span>

namespace drape {

/// The typefaces of the panels, embedded when the program is built.
[[nodiscard]] std::span<const EmbeddedFile> embeddedFonts();

}  // namespace drape
