#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace drape::render {

/// 8-bit RGB, rows from top to bottom.
struct Image {
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  std::vector<std::uint8_t> rgb;
};

/// Throws InputError with the file and the reason.
void writePng(const Image& image, const std::filesystem::path& file);
[[nodiscard]] Image readPng(const std::filesystem::path& file);

}  // namespace drape::render
