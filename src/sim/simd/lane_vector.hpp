#pragma once

#include "sim/model/vector.hpp"
#include "sim/simd/sliced_cloth.hpp"

namespace drape::sim::simd {

/// The vector at a permuted index, in double.
template <typename T>
[[nodiscard]] Vec3 laneVector(const LaneVectors<T>& vectors, int index) {
  return {static_cast<double>(vectors.x.data()[index]), static_cast<double>(vectors.y.data()[index]),
          static_cast<double>(vectors.z.data()[index])};
}

/// Stores a vector at a permuted index, rounded to the precision of T.
template <typename T>
void setLaneVector(LaneVectors<T>& vectors, int index, const Vec3& value) {
  vectors.set(static_cast<std::size_t>(index), static_cast<T>(value.x()), static_cast<T>(value.y()),
              static_cast<T>(value.z()));
}

}  // namespace drape::sim::simd
