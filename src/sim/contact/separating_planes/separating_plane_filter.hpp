#pragma once

#include "sim/contact/constraints/contact_constraint.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape {

/// Brings every vertex to the right side of all its planes, and no farther from where it is safe than was searched.
class SeparatingPlaneFilter {
 public:
  /// Where a vertex is safe from a body.
  struct Fallback {
    Vec3 start = Vec3::Zero();  ///< where the body carries the start of the step, or the result of the last pass [m]
    Vec3 position =
        Vec3::Zero();  ///< the same, carried along by what of the body is near, where that moves in itself [m]
  };
  using FallbackOf = std::function<Fallback(int body, int vertex)>;

  /// Changes `positions`. A vertex without a place that suits all its planes is left where it violates them least.
  /// @param bodies how many there are  @param remaining no vertex ends farther than this from any of its bases [m]
  /// @param targets the positions before contact: a vertex that is still there has not left the place that was searched
  /// @return how many vertices found no such place
  int apply(std::span<const SeparatingPlane> planes, std::span<const double> inverseMass,
            std::span<const double> displacementBounds, int bodies, const FallbackOf& fallbackOf,
            std::span<const Vec3> predicted, std::span<Vec3> positions);

  /// The farthest that the last call moved a vertex [m].
  [[nodiscard]] double maxCorrection() const { return maxCorrection_; }

 private:
  void sortByVertex(std::span<const SeparatingPlane> planes, std::size_t vertices);
  [[nodiscard]] std::span<const SeparatingPlane> planesOf(std::size_t vertex) const {
    return {sorted_.data() + begin_[vertex], begin_[vertex + 1] - begin_[vertex]};
  }

  double maxCorrection_ = 0.0;
  std::vector<SeparatingPlane> sorted_;  // by vertex, those of one vertex in their own order
  std::vector<std::size_t> begin_;
};

}  // namespace drape
