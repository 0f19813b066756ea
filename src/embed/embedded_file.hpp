#pragma once

#include <string_view>

namespace drape {

/// A file embedded in the program at build time.
struct EmbeddedFile {
  std::string_view name;   ///< path relative to its source folder, with forward slashes
  std::string_view bytes;  ///< its content
};

}  // namespace drape
