#pragma once

#include <cstddef>
#include <cstdint>

namespace drape {

/// Coordinates of vertices, one array each.
template <typename T>
struct Coordinates {
  T* x;
  T* y;
  T* z;
};

/// Takes x y z x y z ... apart, and puts them together again.
void splitCoordinates(const double* from, std::size_t count, const Coordinates<float>& to);
void splitCoordinates(const double* from, std::size_t count, const Coordinates<double>& to);
void joinCoordinates(const Coordinates<float>& from, std::size_t count, double* to);
void joinCoordinates(const Coordinates<double>& from, std::size_t count, double* to);

/// The sum of the bit patterns of so many numbers, modulo 2^64: a change of any one number shows.
[[nodiscard]] std::uint64_t sumOfBits(const double* values, std::size_t count);

}  // namespace drape
