#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::sim::contact {

/// Pairs of features of one kind, vertex and triangle or two edges, as one array for each of their four vertices.
class PairLanes {
 public:
  void clear() { size_ = 0; }

  /// The vertices are in the order of PairVertices.
  void add(const std::array<int, 4>& vertices) {
    for (std::size_t k = 0; k < 4; ++k) {
      vertices_[k].resize(size_);  // removes the padding
      vertices_[k].push_back(vertices[k]);
    }
    ++size_;
  }

  /// Pads the arrays to whole vectors.
  void pad();

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::int32_t* vertices(std::size_t k) const { return vertices_[k].data(); }

 private:
  std::size_t size_ = 0;
  std::array<std::vector<std::int32_t>, 4> vertices_;
};

/// The result of measureApproach, one entry a pair and padding.
struct Approach {
  std::vector<double> distance;    ///< at the start [m]
  std::vector<double> separation;  ///< at the end, along the normal of the closest points at the start [m]
};

// The functions below use the widest vector instructions of the machine. Their results can differ by rounding from one
// instruction set to another, so they only serve to choose pairs for the exact computation.

/// The distances of pairs [m].
/// @param edges whether the pairs are of edges  @param distances gets one entry a pair and padding
void measureDistances(bool edges, PairLanes& pairs, const Vec3* positions, std::vector<double>& distances);

/// The distances at the start of a step and the separations at its end, see separationAlong.
void measureApproach(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, Approach& approach);

}  // namespace drape::sim::contact
