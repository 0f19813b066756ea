#pragma once

#include "sim/contact/bodies/body.hpp"
#include "sim/contact/closest_features/near_point.hpp"
#include "sim/contact/constraints/cloth_in_body.hpp"
#include "sim/contact/constraints/contact_constraint.hpp"

namespace drape::sim::contact {

/// Distances that contact keeps between the cloth and a body.
struct ContactOffsets {
  double contactOffset = 0.0;  ///< distance of the vertices of the cloth [m]
  /// Distance of the edges and faces of the cloth [m]. It is less than that of the vertices, so that on smooth surfaces
  /// contacts of vertices suffice.
  double edgeOffset = 0.0;
  double minimumSeparation = 0.0;  ///< minimum distance, enforced by separating planes [m]
  double separationStep = 0.0;     ///< increase per step of a positive distance that is too small [m]
  /// Decrease per step of the depth of cloth inside the body [m]; up to four times as much where it is deep.
  double recoveryStep = 0.0;

  /// Contacts that the predicted positions satisfy are added too, if the point starts or ends within this distance
  /// beyond the required one [m]. 0: they are not added.
  double listMargin = 0.0;

  /// Decrease per step of the depth of cloth that is as deep as this [m].
  [[nodiscard]] double recoveryStepAt(double depth) const;
};

/// Creates the constraints of one body in one step: contacts (ContactConstraint) and separating planes
/// (SeparatingPlane). The input is in the body's frame, the constraints are in the world frame at the end of the step.
class ConstraintBuilder {
 public:
  /// @param index of the body in the step  @param friction factor on the friction of the body [-]
  ConstraintBuilder(const BodyStep& step, int index, const ContactOffsets& offsets, double friction = 1.0)
      : step_(step), index_(index), offsets_(offsets), friction_(friction) {}

  [[nodiscard]] const ContactOffsets& offsets() const { return offsets_; }
  [[nodiscard]] const BodyStep& step() const { return step_; }

  /// Adds a contact that keeps a point of triangle t at the distance `wanted` from a point of the body [m], unless the
  /// predicted position satisfies it. If the point is closer at the start, its distance need only grow by a bounded
  /// step.
  /// @param weights barycentric coordinates of the point in the triangle  @param near the point of the body
  void addContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const NearPoint& near, double wanted,
                  Candidates& candidates) const;

  /// Adds a separating plane for each vertex of triangle t that could reach it.
  /// @param height maximum of normal . x over the body at the end of the step, in the body's frame [m]
  /// @param gap between triangle and body at the start of the pass [m]
  void addPlanes(const ClothInBody& cloth, std::size_t t, const Vec3& normal, double height, double gap,
                 Candidates& candidates) const;

  /// Adds a separating plane for one vertex. @param height, gap as for addPlanes, with the vertex as the triangle
  void addPlane(int vertex, const Vec3& normal, double height, double gap, Candidates& candidates) const;

 private:
  const BodyStep& step_;
  int index_;
  ContactOffsets offsets_;
  double friction_;
};

}  // namespace drape::sim::contact
