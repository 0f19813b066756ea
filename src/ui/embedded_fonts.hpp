#pragma once

#include "embed/embedded_file.hpp"

#include <span>

namespace drape::ui {

/// The fonts of the panels, embedded at build time.
[[nodiscard]] std::span<const EmbeddedFile> embeddedFonts();

}  // namespace drape::ui
