#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace drape {

/// 8-bit RGB, rows from top to bottom.
struct Image {
  int width = 0;   ///< [pixels]
  int height = 0;  ///< [pixels]
  std::vector<std::uint8_t> rgb;
};

/// Throws InputError naming the file and the reason.
void writePng(const Image& image, const std::filesystem::path& file);
[[nodiscard]] Image readPng(const std::filesystem::path& file);

/// How two pictures differ.
struct ImageDifference {
  bool sameSize = false;
  int pixels = 0;   ///< that differ in any channel
  int largest = 0;  ///< largest difference of a channel, 0 to 255
};
[[nodiscard]] ImageDifference compareImages(const Image& a, const Image& b);

/// A picture that shows where two pictures of the same size differ: the first one in pale grey, differing pixels in
/// red.
[[nodiscard]] Image differencePicture(const Image& a, const Image& b);

}  // namespace drape
