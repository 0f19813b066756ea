#pragma once

#include "sim/contact/bodies/motion.hpp"
#include "sim/contact/bodies/pose.hpp"
#include "sim/model/vector.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace drape::sim::contact {

/// The half-space y <= 0, drawn as a square.
struct PlaneShape {
  double halfSize = 1.0;  ///< of the drawn square [m]
};
/// Around the origin.
struct SphereShape {
  double radius = 0.5;  ///< [m]
};
/// All points within the radius of the segment from (0, -halfLength, 0) to (0, halfLength, 0).
struct CapsuleShape {
  double radius = 0.1;      ///< [m]
  double halfLength = 0.5;  ///< [m]
};
/// Around the origin, parallel to the axes.
struct BoxShape {
  Vec3 half = Vec3::Constant(0.5);  ///< half of its extents [m]
};
/// The positions of a deforming mesh as a function of time.
class Deformation {
 public:
  Deformation() = default;
  Deformation(const Deformation&) = delete;
  Deformation& operator=(const Deformation&) = delete;
  Deformation(Deformation&&) = delete;
  Deformation& operator=(Deformation&&) = delete;
  virtual ~Deformation() = default;

  /// Writes the positions at that time [s], one for each vertex of the mesh, in its own frame [m]. They are continuous
  /// in time, and depend only on the time.
  virtual void positionsAt(double time, std::vector<Vec3>& positions) const = 0;
};

/// A triangle mesh, closed or open. The cloth may not pass through its triangles.
struct MeshShape {
  std::vector<Vec3> positions;      ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
  /// The positions of a deforming mesh, at equal time intervals; empty for a rigid mesh. `positions` equals the first
  /// frame.
  std::vector<std::vector<Vec3>> frames;
  double frameTime = 1.0 / 30.0;  ///< time between two frames [s]
  bool loop = false;              ///< the frame `loopStart` follows the last one
  std::size_t loopStart = 0;      ///< frames before this one are shown once
  /// Computes the positions at any time instead of `frames`. `positions` equals those at time 0. Null: none.
  std::shared_ptr<const Deformation> deformation = nullptr;

  [[nodiscard]] bool deforms() const { return deformation != nullptr || frames.size() > 1; }
};

using BodyShape = std::variant<PlaneShape, SphereShape, CapsuleShape, BoxShape, std::shared_ptr<const MeshShape>>;

/// A pinned vertex of the cloth that moves with a body.
struct CarriedPin {
  int vertex = 0;
  int anchor = -1;  ///< on a deforming mesh, the vertex whose motion it follows; -1: none
};

/// Contact properties of a body.
struct SurfaceProperties {
  double staticFriction = 0.5;   ///< coefficient of static friction with cloth [-]
  double kineticFriction = 0.4;  ///< coefficient of kinetic friction with cloth [-]; at most the static one
  double thickness = 0.002;      ///< the contact offset is this plus half of the cloth's thickness [m]

  bool operator==(const SurfaceProperties&) const = default;
};

/// A solid that the cloth collides with. The cloth does not act on it.
struct Body {
  std::string name;
  BodyShape shape = SphereShape{};
  BodyMotion motion;
  SurfaceProperties surface;  ///< initial
  bool drawn = true;
  std::vector<CarriedPin> pins;  ///< vertices of the cloth that move with it
};

/// The motion of a body over a step or a contact substep.
struct BodyStep {
  const Body* body = nullptr;
  Pose start;
  Pose end;
  /// The vertices of a mesh at the start of the step, in its own frame [m]; empty for other shapes.
  std::span<const Vec3> startVertices;
  std::span<const Vec3> endVertices;  ///< the same at the end of the step
  SurfaceProperties surface;          ///< at present
};

/// The drawn surface of a body, in its own frame. The drawn surface of a sphere or a capsule lies inside the true one.
/// So cloth that does not intersect the true surface does not intersect the drawn one.
struct BodySurface {
  std::vector<Vec3> positions;      ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
};

[[nodiscard]] BodySurface surfaceOf(const BodyShape& shape);

/// The position at the end of the step of a pin that moves with the body [m]. @param position at the start [m]
[[nodiscard]] Vec3 carriedBy(const BodyStep& body, const CarriedPin& pin, const Vec3& position);

}  // namespace drape::sim::contact
