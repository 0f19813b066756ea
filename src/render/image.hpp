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
  int pixels = 0;   ///< that differ in any channel by more than the tolerance
  int largest = 0;  ///< largest difference of a channel, 0 to 255
};

/// Compares two pictures; pictures of different size are not compared pixel by pixel. A processor without fused
/// multiply-add moves a few pixels by one step of 255: `tolerance` is the difference of a channel that does not count.
[[nodiscard]] ImageDifference compareImages(const Image& a, const Image& b, int tolerance = 0);

/// A picture that shows where two pictures of the same size differ: the first one in pale grey, pixels that differ by
/// more than the tolerance in red. The first one itself when the sizes differ.
[[nodiscard]] Image differencePicture(const Image& a, const Image& b, int tolerance = 0);

}  // namespace drape
