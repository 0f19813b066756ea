#pragma once

#include "sim/model/vector.hpp"

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

/// Converts interleaved coordinates x y z x y z ... to one array for each coordinate, relative to an origin.
void splitCoordinates(const double* from, std::size_t count, const Vec3& origin, const Coordinates<float>& to);
void splitCoordinates(const double* from, std::size_t count, const Vec3& origin, const Coordinates<double>& to);
/// The inverse conversion.
void joinCoordinates(const Coordinates<float>& from, std::size_t count, const Vec3& origin, double* to);
void joinCoordinates(const Coordinates<double>& from, std::size_t count, const Vec3& origin, double* to);

/// The sum of the bit patterns of the numbers, modulo 2^64. It changes when any one number changes.
[[nodiscard]] std::uint64_t sumOfBits(const double* values, std::size_t count);

}  // namespace drape::sim::simd
