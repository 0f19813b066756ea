#pragma once

#include "scene/scene.hpp"
#include "sim/model/vector.hpp"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <utility>

namespace drape::render {

/// A ray in world space.
struct Ray {
  Vec3 origin;     ///< [m]
  Vec3 direction;  ///< unit length
};

/// Limits of the camera, which keep the cloth in view.
struct CameraBounds {
  Eigen::AlignedBox3d focalPoints;  ///< of the focal point [m]
  double lowest = 0.0;              ///< minimum height of the camera [m]
  double maxDistance = 400.0;       ///< maximum distance to the focal point [m]
};

/// The bounds for things in `box` [m] on a ground at that height [m]. They always include `pose`, since the author of a
/// scene may choose any view.
[[nodiscard]] CameraBounds boundsFor(const Eigen::AlignedBox3d& box, double groundHeight,
                                     const scene::CameraPose& pose);

/// A camera that orbits its focal point, with a perspective or an orthographic projection; y is up. Both projections
/// show the focal point at the same size.
class Camera {
 public:
  Camera() = default;
  explicit Camera(scene::CameraPose pose) : pose_(std::move(pose)) {}

  [[nodiscard]] const scene::CameraPose& pose() const { return pose_; }
  void moveTo(const scene::CameraPose& pose) { pose_ = pose; }

  [[nodiscard]] bool isOrthographic() const { return pose_.isOrthographic; }
  void useOrthographic(bool orthographic) { pose_.isOrthographic = orthographic; }

  /// The position of the eye in homogeneous coordinates: (x, y, z, 1) [m] in perspective, (x, y, z, 0) as the vector to
  /// an eye at infinity.
  [[nodiscard]] Eigen::Vector4f eye() const;

  /// Turns around the focal point [rad]: positive yaw moves the camera to its right, positive pitch upwards. It stops
  /// near the poles, so that up stays up.
  void orbit(double yaw, double pitch);
  /// Moves camera and focal point in the view plane by fractions of the view's height (right, up).
  void pan(double right, double up);
  /// Multiplies the distance to the focal point; clamped to 1 cm .. 100 m.
  void zoom(double factor);
  /// Looks at another point, with the same direction and distance.
  void recentre(const Vec3& focalPoint);
  /// Moves the camera into the bounds by the smallest change: first the focal point, then the distance, then the
  /// height, by turning around the focal point.
  void keepWithin(const CameraBounds& bounds);
  /// Looks from a side (1: front, 3: right, 7: top as in other 3D programs) at the same focal point and distance.
  enum class Side { Front, Right, Top };
  void lookFrom(Side side);
  /// Keeps the direction and moves the camera so that the box [m] fills the view with a small margin.
  void frame(const Vec3& min, const Vec3& max, double aspect);

  [[nodiscard]] Eigen::Matrix4f viewMatrix() const;
  [[nodiscard]] Eigen::Matrix4f projectionMatrix(double aspect) const;

  /// The ray through a pixel; (0, 0) is the top left corner of the viewport, in pixels.
  [[nodiscard]] Ray rayThrough(double x, double y, int width, int height) const;
  /// The position of a point in the picture, in pixels from the top left corner. For a point behind the camera the
  /// result is far outside.
  [[nodiscard]] Vec2 project(const Vec3& point, int width, int height) const;
  /// The point on the ray through a pixel at the depth of `reference`.
  [[nodiscard]] Vec3 pointAtDepthOf(const Vec3& reference, double x, double y, int width, int height) const;

 private:
  /// Half the height of the view at the focal point [m].
  [[nodiscard]] double halfHeight() const;

  scene::CameraPose pose_;
};

}  // namespace drape::render
