#pragma once

#include "render/image.hpp"

namespace drape::render {

/// The difference of two pictures.
struct ImageDifference {
  bool sameSize = false;
  int pixels = 0;   ///< number with a channel that differs by more than the tolerance
  int largest = 0;  ///< largest difference of a channel, 0 to 255
};

/// Compares two pictures; pictures of different size are not compared pixel by pixel. A processor without fused
/// multiply-add changes a few pixels by one step of 255. Differences up to `tolerance` per channel do not count.
[[nodiscard]] ImageDifference compareImages(const Image& a, const Image& b, int tolerance = 0);

/// A picture of the differences: the first picture in pale grey, with differing pixels in red. The first picture itself
/// when the sizes differ.
[[nodiscard]] Image differencePicture(const Image& a, const Image& b, int tolerance = 0);

}  // namespace drape::render
