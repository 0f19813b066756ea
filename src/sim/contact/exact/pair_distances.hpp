#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace drape::sim::contact {

/// Pairs of features of one kind (vertex and triangle, or two edges), as one array for each of their four vertices.
class PairLanes {
 public:
  void clear() { size_ = 0; }

  /// The vertices are in the order of PairVertices.
  void add(const std::array<int, 4>& vertices) {
    if (size_ == vertices_[0].size()) {
      for (std::vector<std::int32_t>& part : vertices_) {
        part.resize(2 * size_ + minSize);
      }
    }
    for (std::size_t k = 0; k < 4; ++k) {
      vertices_[k][size_] = vertices[k];
    }
    ++size_;
  }

  /// Pads the arrays to whole vectors. Padding has valid vertices.
  void pad();

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const std::int32_t* vertices(std::size_t k) const { return vertices_[k].data(); }

 private:
  static constexpr std::size_t minSize = 64;

  std::size_t size_ = 0;
  std::array<std::vector<std::int32_t>, 4> vertices_;  // longer than `size_`
};

/// The separations of pairs at the start and at the end of a step, along the normal of the closest points at the start.
/// One entry a pair and padding.
struct Approach {
  std::vector<double> start;  ///< [m]
  std::vector<double> end;    ///< [m]
};

// The functions below use the widest vector instructions of the machine. Their results can differ by rounding from one
// instruction set to another, so they only serve to choose pairs, which are then computed by gapOf and
// separationInStep.

/// Computes lower bounds of the distances of pairs [m]: the separations along the normals of the closest points. They
/// equal the distances, except for rounding, if these are not near 0 and the pair has no sliver.
/// @param edges whether the pairs are of edges  @param distances the result, one entry a pair and padding
void measureDistances(bool edges, PairLanes& pairs, const Vec3* positions, std::vector<double>& distances);

/// Computes the separations of pairs at the start and at the end of a step. @param start, end positions [m]
void measureApproach(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, Approach& approach);

/// Computes how near the closest points at the start of a step come [m]: the smaller one of their distance at the start
/// and their distance at the end along the normal at the start. Infinity if a closest point of two edges is an end, so
/// that they are no contact (findPairContacts). 0 if rounding may move the closest points far: for edges that are
/// nearly parallel, and for slivers.
void measureContactGaps(bool edges, PairLanes& pairs, const Vec3* start, const Vec3* end, std::vector<double>& gaps);

}  // namespace drape::sim::contact
