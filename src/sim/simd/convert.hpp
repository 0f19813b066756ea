#pragma once

#include <cstddef>
#include <cstdint>

namespace drape::sim::simd {

/// Coordinates of vertices, one array for each coordinate.
template <typename T>
struct Coordinates {
  T* x;
  T* y;
  T* z;
};

/// Converts between interleaved coordinates x y z x y z ... and one array for each coordinate.
void splitCoordinates(const double* from, std::size_t count, const Coordinates<float>& to);
void splitCoordinates(const double* from, std::size_t count, const Coordinates<double>& to);
void joinCoordinates(const Coordinates<float>& from, std::size_t count, double* to);
void joinCoordinates(const Coordinates<double>& from, std::size_t count, double* to);

/// The sum of the bit patterns of the numbers, modulo 2^64. It changes when any one number changes.
[[nodiscard]] std::uint64_t sumOfBits(const double* values, std::size_t count);

}  // namespace drape::sim::simd
