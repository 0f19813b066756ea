#include "compare_images.hpp"

#include <algorithm>
#include <cstdlib>

namespace drape::render {
namespace {

/// Largest difference over the channels of the pixel that starts at `offset`.
int pixelDifference(const Image& a, const Image& b, std::size_t offset) {
  int largest = 0;
  for (std::size_t channel = offset; channel < offset + 3; ++channel) {
    largest = std::max(largest, std::abs(int{a.rgb[channel]} - int{b.rgb[channel]}));
  }
  return largest;
}

bool haveSameSize(const Image& a, const Image& b) {
  return a.width == b.width && a.height == b.height && a.rgb.size() == b.rgb.size();
}

}  // namespace

ImageDifference compareImages(const Image& a, const Image& b, int tolerance) {
  ImageDifference difference;
  difference.sameSize = haveSameSize(a, b);
  if (!difference.sameSize) {
    return difference;
  }
  for (std::size_t offset = 0; offset + 2 < a.rgb.size(); offset += 3) {
    const int largest = pixelDifference(a, b, offset);
    difference.largest = std::max(difference.largest, largest);
    difference.pixels += largest > tolerance ? 1 : 0;
  }
  return difference;
}

Image differencePicture(const Image& a, const Image& b, int tolerance) {
  Image picture = a;
  if (!haveSameSize(a, b)) {
    return picture;
  }
  for (std::size_t offset = 0; offset + 2 < a.rgb.size(); offset += 3) {
    const int grey = (int{a.rgb[offset]} + int{a.rgb[offset + 1]} + int{a.rgb[offset + 2]}) / 3;
    const auto pale = static_cast<std::uint8_t>(192 + grey / 4);
    const bool differs = pixelDifference(a, b, offset) > tolerance;
    picture.rgb[offset] = differs ? std::uint8_t{220} : pale;
    picture.rgb[offset + 1] = differs ? std::uint8_t{20} : pale;
    picture.rgb[offset + 2] = differs ? std::uint8_t{30} : pale;
  }
  return picture;
}

}  // namespace drape::render
