#pragma once

#include "scene/scene.hpp"
#include "sim/vector.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>

namespace drape {

/// A ray in world space.
struct Ray {
  Vec3 origin;     ///< [m]
  Vec3 direction;  ///< unit length
};

/// Where a camera may go, so that the cloth does not get out of sight.
struct CameraBounds {
  Eigen::AlignedBox3d focalPoints;  ///< where its focal point may be [m]
  double lowest = 0.0;              ///< height that the camera stays above [m]
  double farthest = 400.0;          ///< from its focal point [m]
};

/// The bounds for looking at things in `box` [m] that stand on a ground at that height [m]. Never so narrow that `pose`
/// is beyond them: a scene's author may look from anywhere.
[[nodiscard]] CameraBounds boundsFor(const Eigen::AlignedBox3d& box, double groundHeight, const CameraPose& pose);

/// An orbiting perspective camera that looks from a pose at its focal point; y is up.
class Camera {
 public:
  Camera() = default;
  explicit Camera(CameraPose pose) : pose_(std::move(pose)) {}

  [[nodiscard]] const CameraPose& pose() const { return pose_; }

  /// Turns around the focal point [rad]: positive yaw carries the camera to its right, positive pitch upwards. It stops
  /// short of the poles, so that up stays up.
  void orbit(double yaw, double pitch);
  /// Moves camera and focal point in the view plane by fractions of the view's height (right, up).
  void pan(double right, double up);
  /// Multiplies the distance to the focal point; clamped to 1 cm .. 100 m.
  void zoom(double factor);
  /// Looks at another point from the same direction and distance.
  void recentre(const Vec3& focalPoint);
  /// Moves the camera the least that brings it within the bounds: focal point, then distance, then height, which is
  /// reached by turning around the focal point.
  void keepWithin(const CameraBounds& bounds);
  /// Looks from a side (1: front, 3: right, 7: top as in other 3D programs) at the same focal point and distance.
  enum class Side { Front, Right, Top };
  void lookFrom(Side side);
  /// Keeps the direction and moves so that the box [m] fills the view, with a little air around it.
  void frame(const Vec3& min, const Vec3& max, double aspect);

  [[nodiscard]] Eigen::Matrix4f viewMatrix() const;
  [[nodiscard]] Eigen::Matrix4f projectionMatrix(double aspect) const;

  /// The ray through a pixel; (0, 0) is the top left corner of the viewport, in pixels.
  [[nodiscard]] Ray rayThrough(double x, double y, int width, int height) const;
  /// Where a point appears, in pixels from the top left corner. A point behind the camera has no place in the picture;
  /// what is returned for it is far outside.
  [[nodiscard]] Vec2 project(const Vec3& point, int width, int height) const;
  /// The point on the ray through a pixel that lies as deep in the view as `reference`.
  [[nodiscard]] Vec3 pointAtDepthOf(const Vec3& reference, double x, double y, int width, int height) const;

 private:
  CameraPose pose_;
};

}  // namespace drape
