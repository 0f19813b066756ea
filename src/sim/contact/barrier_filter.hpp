#pragma once

#include "sim/contact/touch.hpp"

#include <functional>
#include <span>
#include <vector>

namespace drape {

/// Brings every vertex to the right side of all its barriers, and no farther from where it is safe than was searched.
class BarrierFilter {
 public:
  /// Where a vertex is safe from a body: where the body carries the start of the step, or the result of the last pass.
  using BaseOf = std::function<Vec3(int body, int vertex)>;

  /// Changes `positions`. A vertex without a place that suits all its barriers is left where it violates them least.
  /// @param bodies how many there are  @param room no vertex ends farther than this from any of its bases [m]
  /// @param targets the positions before contact: a vertex that is still there has not left the place that was searched
  /// @return how many vertices found no such place
  int apply(std::span<const Barrier> barriers, std::span<const double> inverseMass, std::span<const double> room,
            int bodies, const BaseOf& baseOf, std::span<const Vec3> targets, std::span<Vec3> positions);

  /// The farthest that the last call moved a vertex [m].
  [[nodiscard]] double farthest() const { return farthest_; }

 private:
  void project(std::span<const Barrier> barriers, std::span<const double> inverseMass, std::span<Vec3> positions);
  bool retreat(std::span<const Barrier> barriers, double room, int bodies, const BaseOf& baseOf, int vertex,
               Vec3& position) const;

  double farthest_ = 0.0;
  std::vector<int> offenders_;
  std::vector<Vec3> before_;
};

}  // namespace drape
