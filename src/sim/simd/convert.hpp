#pragma once

#include <cstddef>

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

}  // namespace drape
