#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/closest_features/closest_points.hpp"
#include "sim/contact/closest_features/cloth_features.hpp"
#include "sim/contact/constraints/contact_constraint.hpp"

#include <limits>
#include <span>
#include <vector>

namespace drape {

class Overlap;

/// How near the cloth may come.
struct ContactReach {
  double keep = 0.0;   ///< distance at which vertices of the cloth are stopped [m]
  double inner = 0.0;  ///< the same of its edges and faces: nearer, so that on what is smooth vertices suffice [m]
  double guard = 0.0;  ///< distance that it never falls below [m]
  double push = 0.0;   ///< how far what is nearer than that goes away in a step [m]
  double free = 0.0;   ///< how far what is inside comes out in a step, or up to four times that where it is deep [m]

  /// How far something that is that deep inside comes out in a step [m].
  [[nodiscard]] double freedFrom(double depth) const;
};

/// The cloth as a body sees it: in the body's own frame, in which a rigid body stands still.
struct ClothInBody {
  std::span<const Vec3> base;    ///< where nothing meets the body [m]: where the body carries the start of the step
  std::span<const Vec3> target;  ///< where the cloth is about to go [m]
  std::span<const double> room;  ///< no vertex ends farther than this from its base [m]
  std::span<const Triangle> triangles;
  std::span<const OwnedFeatures> owned;
  std::span<const double> inverseMass;  ///< one a vertex [1/kg]; 0: it does not move
  const Overlap* overlap = nullptr;     ///< what of it is inside the body, if something is and it has an inside
};

/// A point of a body that is near to a point of the cloth, in the body's frame.
struct NearPoint {
  double gap = std::numeric_limits<double>::infinity();  ///< at the base [m]
  Vec3 normal = Vec3::UnitY();                           ///< towards the cloth
  Vec3 startPoint = Vec3::Zero();                        ///< where it is when the step begins [m] ...
  Vec3 endPoint = Vec3::Zero();                          ///< ... and when it ends, both in the body's frame
  double depth = 0.0;                                    ///< of all that is inside and hangs together with it [m]
};

[[nodiscard]] inline const Vec3& vectorAt(std::span<const Vec3> points, int i) {
  return points[static_cast<std::size_t>(i)];
}

[[nodiscard]] inline Corners cornersOf(std::span<const Vec3> points, const Triangle& triangle) {
  return {vectorAt(points, triangle[0]), vectorAt(points, triangle[1]), vectorAt(points, triangle[2])};
}

/// A nearest point this far in from the border belongs to the inside [-].
inline constexpr double insideMargin = 1e-3;

[[nodiscard]] inline bool isInside(const Vec3& weights) {
  return (weights.array() > insideMargin).all();
}

[[nodiscard]] inline bool isInside(double along) {
  return along > insideMargin && along < 1.0 - insideMargin;
}

/// The weights of a triangle's corners at corner k, and at a point of the side from corner k to the next.
[[nodiscard]] Vec3 onCorner(std::size_t k);
[[nodiscard]] Vec3 onSide(std::size_t k, double along);

/// What is near one body in one step, written down in the world's frame.
class BodySide {
 public:
  /// @param index of the body among the step's
  BodySide(const BodyStep& step, int index, const ContactReach& reach) : step_(step), index_(index), reach_(reach) {}

  [[nodiscard]] const ContactReach& reach() const { return reach_; }
  [[nodiscard]] const BodyStep& step() const { return step_; }

  /// A point of triangle t is to stay `wanted` away from a point of the body [m]; nothing is added if it will anyway. A
  /// point that already is nearer goes out gently.
  void addTouch(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const NearPoint& near, double wanted,
                Findings& findings) const;

  /// Keeps the vertices of triangle t above a plane, those that could come near it.
  /// @param height of the body's highest point over the plane through the frame's origin, at the end of the step [m]
  /// @param gap between triangle and body at the base [m]
  void addBarriers(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                   Findings& findings) const;

  /// Keeps one vertex there.
  void addBarrier(int vertex, const Vec3& normal, double height, double gap, Findings& findings) const;

 private:
  const BodyStep& step_;
  int index_;
  ContactReach reach_;
};

}  // namespace drape
