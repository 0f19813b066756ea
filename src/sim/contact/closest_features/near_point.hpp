#pragma once

#include "sim/model/vector.hpp"

#include <limits>

namespace drape::sim::contact {

/// A point on the surface of a body that is close to a point of the cloth, in the body's frame.
struct NearPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< signed distance at the start of the pass [m]
  Vec3 normal = Vec3::UnitY();                           ///< towards the cloth
  Vec3 startPoint = Vec3::Zero();                        ///< the point at the start of the step [m]
  Vec3 endPoint = Vec3::Zero();                          ///< the point at the end of the step [m]
  double depth = 0.0;  ///< for a point inside: maximum depth of the connected part of the cloth inside the body [m]
};

}  // namespace drape::sim::contact
