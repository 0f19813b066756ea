#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products
#include <array>
#include <vector>

namespace drape {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Three vertex indices, counter-clockwise when seen from the front.
using Triangle = std::array<int, 3>;

}  // namespace drape
