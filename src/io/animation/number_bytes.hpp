#pragma once

#include "sim/model/vector.hpp"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <iterator>
#include <string>

namespace drape::io::animation {

/// Appends the bytes of a number in the given order.
template <typename Number>
void appendBytes(std::string& bytes, Number value, std::endian order = std::endian::little) {
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &value, sizeof(Number));
  if (order != std::endian::native) {
    std::reverse(raw.begin(), raw.end());
  }
  bytes.append(raw.data(), raw.size());
}

/// Appends three coordinates in single precision.
inline void appendBytes(std::string& bytes, const Vec3& point, std::endian order = std::endian::little) {
  for (const double coordinate : point) {
    appendBytes(bytes, static_cast<float>(coordinate), order);
  }
}

/// Appends a number as the shortest text that is the same number in single precision.
inline void appendFloat(std::string& text, double value) {
  fmt::format_to(std::back_inserter(text), "{}", static_cast<float>(value) + 0.0F);
}

}  // namespace drape::io::animation
