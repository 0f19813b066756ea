#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/closest_features/near_point.hpp"
#include "sim/contact/constraints/cloth_in_body.hpp"
#include "sim/contact/constraints/contact_constraint.hpp"

namespace drape {

/// How near the cloth may come.
struct ContactOffsets {
  double contactOffset = 0.0;  ///< distance at which vertices of the cloth are stopped [m]
  double edgeOffset = 0.0;  ///< the same of its edges and faces: nearer, so that on what is smooth vertices suffice [m]
  double minimumSeparation = 0.0;  ///< distance that it never falls below [m]
  double separationStep = 0.0;     ///< how far what is nearer than that goes away in a step [m]
  double recoveryStep =
      0.0;  ///< how far what is inside comes out in a step, or up to four times that where it is deep [m]

  /// How far something that is that deep inside comes out in a step [m].
  [[nodiscard]] double recoveryStepAt(double depth) const;
};

/// What is near one body in one step, written down in the world's frame.
class ConstraintBuilder {
 public:
  /// @param index of the body among the step's
  ConstraintBuilder(const BodyStep& step, int index, const ContactOffsets& offsets)
      : step_(step), index_(index), offsets_(offsets) {}

  [[nodiscard]] const ContactOffsets& offsets() const { return offsets_; }
  [[nodiscard]] const BodyStep& step() const { return step_; }

  /// A point of triangle t is to stay `wanted` away from a point of the body [m]; nothing is added if it will anyway. A
  /// point that already is nearer goes out gently.
  void addContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const NearPoint& near, double wanted,
                  Candidates& candidates) const;

  /// Keeps the vertices of triangle t above a plane, those that could come near it.
  /// @param height of the body's highest point over the plane through the frame's origin, at the end of the step [m]
  /// @param gap between triangle and body at the base [m]
  void addPlanes(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                 Candidates& candidates) const;

  /// Keeps one vertex there.
  void addPlane(int vertex, const Vec3& normal, double height, double gap, Candidates& candidates) const;

 private:
  const BodyStep& step_;
  int index_;
  ContactOffsets offsets_;
};

}  // namespace drape
