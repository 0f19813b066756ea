#pragma once

#include "sim/model/vector.hpp"

namespace drape::sim::contact {

/// A rigid transformation: a point p of the local frame is at rotation * p + position.
struct Pose {
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  Vec3 position = Vec3::Zero();  ///< [m]

  bool operator==(const Pose&) const = default;

  [[nodiscard]] Vec3 toWorld(const Vec3& local) const { return isIdentity() ? local : rotation * local + position; }
  [[nodiscard]] Vec3 toLocal(const Vec3& world) const {
    return isIdentity() ? world : rotation.conjugate() * (world - position);
  }

 private:
  /// Many bodies stand at the origin. Their positions need no arithmetic.
  [[nodiscard]] bool isIdentity() const {
    return rotation.w() == 1.0 && rotation.vec().isZero(0.0) && position.isZero(0.0);
  }
};

}  // namespace drape::sim::contact
