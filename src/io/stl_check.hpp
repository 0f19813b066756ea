#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// An STL file that contains what it announces.
struct StlBytes {
  std::string_view bytes;             ///< of a binary file what is before the end of its last triangle
  std::vector<std::string> warnings;  ///< that the file contains more than it announces
};

/// Walks through an STL file and throws InputError when it does not contain what it announces: when it is cut off, has
/// a coordinate that is not a finite number, or a line that STL does not define. It is binary when its size fits the
/// number of triangles in its header, or when it does not begin with "solid". `text` is the file as plainText, and
/// `bytes` the file itself. The parsing library stops at long names and at normals that are no numbers, so a file of
/// text is written anew into `storage`, without both. Source: 3D Systems, StereoLithography Interface Specification,
/// 1989.
[[nodiscard]] StlBytes checkStl(std::string_view text, std::string_view bytes, std::string& storage);

}  // namespace drape::io
