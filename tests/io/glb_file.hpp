#pragma once

#include <bit>
#include <cstdint>
#include <string>

namespace drape::io {

/// The four bytes of a number, the lowest first.
inline std::string littleEndian(std::uint32_t number) {
  std::string bytes;
  for (unsigned shift = 0; shift < 32U; shift += 8U) {
    bytes += static_cast<char>(number >> shift & 0xffU);
  }
  return bytes;
}
inline std::string littleEndian(float number) {
  return littleEndian(std::bit_cast<std::uint32_t>(number));
}

/// A glTF document as binary glTF.
/// @param data of its first buffer; a multiple of 4 bytes; empty: the file has only the document
inline std::string glbFile(std::string document, const std::string& data = {}) {
  document.resize((document.size() + 3) / 4 * 4, ' ');
  const auto chunk = [](const std::string& kind, const std::string& bytes) {
    return littleEndian(static_cast<std::uint32_t>(bytes.size())) + kind + bytes;
  };
  const std::string chunks =
      chunk("JSON", document) + (data.empty() ? std::string() : chunk(std::string("BIN\0", 4), data));
  constexpr std::uint32_t headerSize = 12;
  return "glTF" + littleEndian(2U) + littleEndian(headerSize + static_cast<std::uint32_t>(chunks.size())) + chunks;
}

}  // namespace drape::io
