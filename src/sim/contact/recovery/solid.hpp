#pragma once

#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/recovery/mesh_rays.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace drape::sim::contact {

/// The passage of a ray through a body from a point outside.
struct Passage {
  double enter = 0.0;  ///< distance from the point to the entry [m]
  NearPoint exit;      ///< where it leaves the body
};

/// A body with an inside, at the start of the pass and in the body's frame. The functions return surface points. The
/// gap of a closest point is its signed distance, negative for points inside, and its normal points outwards. For exits
/// along a direction the gap is minus the distance to the exit, and the normal is the direction.
class Solid {
 public:
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  Solid(Solid&&) = delete;
  Solid& operator=(Solid&&) = delete;
  virtual ~Solid() = default;

  [[nodiscard]] virtual bool contains(const Vec3& point) = 0;
  /// The closest surface point of a point inside.
  [[nodiscard]] virtual NearPoint nearestExit(const Vec3& point) = 0;
  /// The closest surface point of a point outside.
  [[nodiscard]] virtual NearPoint nearestSurface(const Vec3& point) = 0;
  /// The exit from a point inside along a unit vector.
  [[nodiscard]] virtual NearPoint exitAlong(const Vec3& point, const Vec3& direction) = 0;
  /// The first passage from a point outside along a unit vector, if there is one.
  [[nodiscard]] virtual std::optional<Passage> passageAlong(const Vec3& point, const Vec3& direction) = 0;
};

/// A closed mesh.
class MeshSolid final : public Solid {
 public:
  explicit MeshSolid(const MeshInStep& mesh) : mesh_(mesh), nearest_(mesh) {}

  /// By the winding numbers along two rays, and a third if these disagree because of rounding at the surface.
  [[nodiscard]] bool contains(const Vec3& point) override;
  [[nodiscard]] NearPoint nearestExit(const Vec3& point) override;
  [[nodiscard]] NearPoint nearestSurface(const Vec3& point) override;
  [[nodiscard]] NearPoint exitAlong(const Vec3& point, const Vec3& direction) override;
  [[nodiscard]] std::optional<Passage> passageAlong(const Vec3& point, const Vec3& direction) override;

 private:
  [[nodiscard]] NearestMeshPoint nearestTo(const Vec3& point);
  [[nodiscard]] NearPoint exitAt(const Crossing& crossing, const Vec3& direction) const;
  void findCrossings(const Vec3& point, const Vec3& direction);

  const MeshInStep& mesh_;
  NearestSearch nearest_;
  NearestMeshPoint last_;            // result of the last search; successive points are close to each other
  std::vector<Crossing> crossings_;  // by distance
};

/// A capsule, or a sphere if both ends of its segment are equal.
class CapsuleSolid final : public Solid {
 public:
  CapsuleSolid(std::array<Vec3, 2> core, double radius) : core_(std::move(core)), radius_(radius) {}

  [[nodiscard]] bool contains(const Vec3& point) override;
  [[nodiscard]] NearPoint nearestExit(const Vec3& point) override;
  [[nodiscard]] NearPoint nearestSurface(const Vec3& point) override { return nearestExit(point); }
  [[nodiscard]] NearPoint exitAlong(const Vec3& point, const Vec3& direction) override;
  [[nodiscard]] std::optional<Passage> passageAlong(const Vec3& point, const Vec3& direction) override;

 private:
  [[nodiscard]] Vec3 fromCore(const Vec3& point) const;
  /// The distance along the direction at which the surface is crossed, between one inside and one outside [m].
  [[nodiscard]] double surfaceBetween(const Vec3& point, const Vec3& direction, double in, double out);

  std::array<Vec3, 2> core_;  // [m]
  double radius_;             // [m]
};

}  // namespace drape::sim::contact
