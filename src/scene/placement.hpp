#pragma once

#include "sim/contact/bodies/pose.hpp"
#include "sim/model/vector.hpp"

#include <vector>

namespace drape::scene {

/// Where a cloth, or a body with its whole motion, is put in the scene: every point is scaled and rotated about the
/// origin of the scene, then moved. The default leaves it where it is.
struct Placement {
  Vec3 position = Vec3::Zero();  ///< added last [m]
  Vec3 rotation = Vec3::Zero();  ///< axis times angle [degrees]
  double scale = 1.0;            ///< [-]

  [[nodiscard]] bool isNone() const;
  /// Rotation and position.
  [[nodiscard]] sim::contact::Pose pose() const;
  [[nodiscard]] Vec3 applied(const Vec3& point) const { return pose().toWorld(scale * point); }
  [[nodiscard]] std::vector<Vec3> applied(std::vector<Vec3> points) const;

  bool operator==(const Placement&) const = default;
};

/// The range of the scale [-].
inline constexpr double minPlacementScale = 0.01;
inline constexpr double maxPlacementScale = 100.0;

/// The placement with another rotation and scale that leaves a point where it is. The result has at most six decimal
/// places, so that it is short in a scene file.
/// @param point before any placement [m]  @param rotation of the scene [rad]
[[nodiscard]] Placement turnedAbout(const Placement& placement, const Vec3& point, const Eigen::Quaterniond& rotation);
[[nodiscard]] Placement scaledAbout(const Placement& placement, const Vec3& point, double scale);
/// The placement that brings a point to a place [m]. @param point before any placement [m]
[[nodiscard]] Placement movedTo(const Placement& placement, const Vec3& point, const Vec3& place);
/// The placement with that rotation, axis times angle [degrees], that leaves a point where it is.
[[nodiscard]] Placement withRotation(const Placement& placement, const Vec3& point, const Vec3& degrees);

}  // namespace drape::scene
