#pragma once

#include "sim/contact/closest_features/nearest_search.hpp"
#include "sim/contact/recovery/mesh_rays.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace drape {

/// A ray's way through a body from a point outside.
struct Passage {
  double enter = 0.0;  ///< from the point [m]
  NearPoint exit;      ///< where it leaves again
};

/// A body that has an inside, where the cloth's step begins, in the body's frame. What lies inside has a negative gap
/// to the points of the surface that are given back, and their normals lead out.
class Solid {
 public:
  Solid() = default;
  Solid(const Solid&) = delete;
  Solid& operator=(const Solid&) = delete;
  Solid(Solid&&) = delete;
  Solid& operator=(Solid&&) = delete;
  virtual ~Solid() = default;

  [[nodiscard]] virtual bool contains(const Vec3& point) = 0;
  /// The point of the surface that is nearest to a point inside, and the same for one outside: the normal leads out.
  [[nodiscard]] virtual NearPoint nearestExit(const Vec3& point) = 0;
  [[nodiscard]] virtual NearPoint nearestSurface(const Vec3& point) = 0;
  /// Where one comes out from a point inside along a unit vector.
  [[nodiscard]] virtual NearPoint exitAlong(const Vec3& point, const Vec3& direction) = 0;
  /// Where one first comes through it from a point outside along a unit vector, if one meets it.
  [[nodiscard]] virtual std::optional<Passage> passageAlong(const Vec3& point, const Vec3& direction) = 0;
};

/// A closed mesh.
class MeshSolid final : public Solid {
 public:
  explicit MeshSolid(const MeshInStep& mesh) : mesh_(mesh), nearest_(mesh) {}

  /// By the winding numbers along two rays, and a third where these do not agree (rounding at the surface).
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
  NearestMeshPoint last_;            // where to look first: points come in their neighbourhoods
  std::vector<Crossing> crossings_;  // by their ways
};

/// All that is nearer than a radius to a segment or, where its ends are one, to a point: a capsule or a sphere.
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
  /// Between a way along the direction where one is inside and another where one is not: where one comes through [m].
  [[nodiscard]] double surfaceBetween(const Vec3& point, const Vec3& direction, double in, double out);

  std::array<Vec3, 2> core_;  // [m]
  double radius_;             // [m]
};

}  // namespace drape
