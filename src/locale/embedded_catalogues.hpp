#pragma once

#include "embed/embedded_file.hpp"

#include <span>

namespace drape::locale {

/// The files of assets/locale, embedded at build time.
[[nodiscard]] std::span<const EmbeddedFile> embeddedCatalogues();

}  // namespace drape::locale
