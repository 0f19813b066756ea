#pragma once

#include "sim/contact/bodies/motion.hpp"
#include "sim/contact/bodies/pose.hpp"
#include "sim/vector.hpp"

#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace drape {

/// The half-space y <= 0. What is drawn of it is a square.
struct PlaneShape {
  double halfSize = 1.0;  ///< of the drawn square [m]
};
/// Around the origin.
struct SphereShape {
  double radius = 0.5;  ///< [m]
};
/// All that is nearer than the radius to the segment from (0, -halfLength, 0) to (0, halfLength, 0).
struct CapsuleShape {
  double radius = 0.1;      ///< [m]
  double halfLength = 0.5;  ///< [m]
};
/// Around the origin, along the axes.
struct BoxShape {
  Vec3 half = Vec3::Constant(0.5);  ///< half of its extents [m]
};
/// A triangle mesh, closed or not: the cloth is kept out of its triangles.
struct MeshShape {
  std::vector<Vec3> positions;      ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
  /// The positions at equal distances in time, when the mesh moves in itself; empty: it does not. `positions` is the
  /// first of them.
  std::vector<std::vector<Vec3>> frames;
  double frameTime = 1.0 / 30.0;  ///< from one frame to the next [s]
  bool loop = false;              ///< after the last frame comes the first one
};

using BodyShape = std::variant<PlaneShape, SphereShape, CapsuleShape, BoxShape, std::shared_ptr<const MeshShape>>;

/// A vertex of the cloth that goes along with a body while it is pinned.
struct CarriedPin {
  int vertex = 0;
  int anchor = -1;  ///< of a mesh that moves in itself the vertex whose motion it shares; -1: none
};

/// How a body meets cloth.
struct SurfaceProperties {
  double staticFriction = 0.5;   ///< of cloth on it, at rest [-]
  double kineticFriction = 0.4;  ///< of cloth on it, sliding [-]; what is above the static one counts as that
  double thickness = 0.002;      ///< the cloth is kept that far away, and half of its own thickness [m]

  bool operator==(const SurfaceProperties&) const = default;
};

/// A solid thing that the cloth meets. It pushes the cloth and does not feel it.
struct Body {
  std::string name;
  BodyShape shape = SphereShape{};
  BodyMotion motion;
  SurfaceProperties surface;  ///< at first
  bool drawn = true;
  std::vector<CarriedPin> pins;  ///< what it carries along
};

/// Where a body is when a step begins and when it ends. Cloth that rests on it goes along.
struct BodyStep {
  const Body* body = nullptr;
  Pose start;
  Pose end;
  std::span<const Vec3> startVertices;  ///< of a mesh, in its own frame [m]; empty for other shapes
  std::span<const Vec3> endVertices;    ///< the same at the end of the step
  SurfaceProperties surface;
};

/// A body's surface as it is drawn, in its own frame. A sphere's or a capsule's lies within the true one, so what does
/// not touch the true one does not touch what is drawn.
struct BodySurface {
  std::vector<Vec3> positions;      ///< [m]
  std::vector<Triangle> triangles;  ///< counter-clockwise from outside
};

[[nodiscard]] BodySurface surfaceOf(const BodyShape& shape);

/// Where a body takes something that it carries: what is at `place` [m] when the step begins is there when it ends.
[[nodiscard]] Vec3 carriedBy(const BodyStep& body, const CarriedPin& pin, const Vec3& place);

}  // namespace drape
