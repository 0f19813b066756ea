#pragma once

#include "io/file_mesh.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// Walks through a PLY file and throws InputError when it does not contain what its header announces: when it is cut
/// off, has a coordinate that is not a finite number, or a face with a vertex that does not exist. The parsing library
/// crashes on such files, stalls, or makes up vertices. Returns the file in a form that the library does not misread.
/// `text` is the file as plainText, and `bytes` the file itself, which counts when it is binary.
struct PlyBytes {
  std::string_view bytes;             ///< the file; points into what was given, or into `storage`
  std::vector<std::string> warnings;  ///< that the file may be cut off, or contains more than it announces
  FileMesh mesh;                      ///< without `particle`; texture coordinates only where the vertices have them
};
[[nodiscard]] PlyBytes checkPly(std::string_view text, std::string_view bytes, std::string& storage);

}  // namespace drape::io
