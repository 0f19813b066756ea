#pragma once

#include "sim/model/vector.hpp"

#include <span>

namespace drape::sim {

/// The axis-aligned box around some points; empty (Eigen's isEmpty()) when there are none.
[[nodiscard]] inline Eigen::AlignedBox3d boundsOf(std::span<const Vec3> points) {
  Eigen::AlignedBox3d box;
  std::size_t done = 0;
  // The coordinates of four points fill vector registers, those of one point do not.
  using Four = Eigen::Array<double, 3, 4>;
  if (points.size() >= 4) {
    Four low = Eigen::Map<const Four>(points[0].data());
    Four high = low;
    for (done = 4; done + 4 <= points.size(); done += 4) {
      const Four next = Eigen::Map<const Four>(points[done].data());
      low = low.min(next);
      high = high.max(next);
    }
    box = Eigen::AlignedBox3d(Vec3(low.rowwise().minCoeff()), Vec3(high.rowwise().maxCoeff()));
  }
  for (; done < points.size(); ++done) {
    box.extend(points[done]);
  }
  return box;
}

}  // namespace drape::sim
