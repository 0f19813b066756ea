#pragma once

#include "sim/model/vector.hpp"

#include <span>
#include <vector>

namespace drape::sim {

/// The mean distance by which a start is displaced to see how fast differences grow [m].
inline constexpr double testDisplacement = 1e-6;

/// The accuracy of a motion over a short time, from two copies that started in the same state: a reference with finer
/// steps, and a second one like the first whose start was displaced by `testDisplacement`.
struct Accuracy {
  double time = 0.0;     ///< simulated time at the end [s]
  double seconds = 0.0;  ///< duration of the compared motion [s]
  double error = 0.0;    ///< mean distance between the motion and the reference at the end [m]
  double spread = 0.0;   ///< mean distance between the two references at the end [m]
};

/// Whether the error can be known. It cannot where tiny differences grow to a visible size that is no longer small
/// compared to the error: then every reference differs from every other by as much.
[[nodiscard]] bool isErrorKnown(const Accuracy& accuracy);

/// Displaces each vertex that is not pinned in a pseudo-random direction, so that the mean displacement of these
/// vertices is `testDisplacement`. The same mesh gives the same displacements.
/// @param pinned one entry a vertex  @param positions one a vertex [m]
void displaceForTest(const std::vector<bool>& pinned, std::span<Vec3> positions);

}  // namespace drape::sim
