#pragma once

#include <string_view>

namespace drape {

/// A file that was put into the program when it was built.
struct EmbeddedFile {
  std::string_view name;   ///< path below the folder it was taken from, with forward slashes
  std::string_view bytes;  ///< its content
};

}  // namespace drape
