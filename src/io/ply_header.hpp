#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace drape::io {

/// A number type of a PLY file.
struct PlyNumber {
  enum class Kind { Signed, Unsigned, Real } kind = Kind::Real;
  std::size_t bytes = 0;  ///< size in a binary file
};

struct PlyProperty {
  std::string name;
  PlyNumber value;
  bool isList = false;
  PlyNumber length;  ///< of a list: the type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

/// The contents of a PLY header.
struct PlyHeader {
  enum class Format { Text, LittleEndian, BigEndian } format = Format::Text;
  std::vector<PlyElement> elements;
  std::size_t size = 0;  ///< start of the data [bytes]
};

/// Reads the header of a PLY file. Throws InputError with the line when it is invalid.
[[nodiscard]] PlyHeader readPlyHeader(std::string_view bytes);

}  // namespace drape::io
