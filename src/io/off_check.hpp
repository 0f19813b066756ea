#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// An OFF file reduced to positions and faces.
struct OffText {
  std::string text;      ///< a plain OFF file
  int facesSkipped = 0;  ///< faces of fewer than three corners, left out
  std::vector<std::string> warnings;
};

/// Checks an OFF file (plainText) and reduces it: colours, normals and texture coordinates are left out. Throws
/// InputError with the line when it is cut off, binary or four-dimensional, has a coordinate that is not a finite
/// number, or a face with a vertex that does not exist.
/// Source: Geomview manual, "OFF Files".
[[nodiscard]] OffText checkOff(std::string_view text);

}  // namespace drape::io
