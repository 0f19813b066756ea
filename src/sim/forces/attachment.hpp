#pragma once

#include "sim/model/vector.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace drape::sim {

struct ClothModel;
struct ClothState;

/// The ends of an attachment's spring: a point of the cloth, and the target to which the spring pulls it.
struct AttachmentEnds {
  int triangle = 0;                 ///< index into ClothModel::triangles
  Vec3 barycentric = Vec3::Zero();  ///< weights of the triangle's corners, summing to 1
  Vec3 target = Vec3::Zero();       ///< [m]
};

/// The law of an attachment's spring: linear up to a maximum force, then constant. An offset is the vector from the
/// attached point to the target [m].
struct AttachmentSpring {
  double stiffness = 0.0;  ///< [N/m]
  double maxForce = 0.0;   ///< the force never exceeds this [N]

  /// Whether the maximum bounds the force at that distance to the target [m].
  [[nodiscard]] bool isSaturated(double distance) const { return stiffness * distance > maxForce; }

  /// The force on the attached point [N].
  [[nodiscard]] Vec3 force(const Vec3& offset) const;

  /// |force| over the distance to the target [N/m].
  [[nodiscard]] double secantStiffness(const Vec3& offset) const;

  /// The derivative of the force by the offset [N/m]. It is the second derivative of the energy.
  [[nodiscard]] Mat3 forceDerivative(const Vec3& offset) const;

  /// The energy at that distance to the target [J]: quadratic, then linear where the force is bounded.
  [[nodiscard]] double energy(double distance) const;

  /// An impulse on the attached point that is implicit in time: J = h k (target - p - h/2 u') with u' = u + W J. p is
  /// the attached point and u its velocity. J is bounded like the force. It is stable for any stiffness.
  /// @param offset target - p - h/2 u [m]  @param inverseMass W, the sum of w_c^2 / m_c [1/kg]
  [[nodiscard]] Vec3 implicitImpulse(double timeStep, const Vec3& offset, double inverseMass) const;
};

/// An attachment of the cloth, as by the mouse: a spring from a point on a triangle to a target, with a bounded force.
struct Attachment : AttachmentEnds, AttachmentSpring {};

/// The corners of the attached triangle. w_c is the weight of corner c in the attached point.
struct AttachedCorners {
  std::array<std::size_t, 3> vertices{};  ///< the triangle's corners
  Vec3 weights = Vec3::Zero();            ///< w_c, summing to 1

  /// Calls visit(vertex, weight) for each corner.
  template <typename Visit>
  void forEach(const Visit& visit) const {
    for (std::size_t c = 0; c < 3; ++c) {
      visit(vertices[c], weights[static_cast<Eigen::Index>(c)]);
    }
  }

  /// The value at the attached point: the sum of w_c value(vertex).
  template <typename Value>
  [[nodiscard]] Vec3 interpolated(const Value& value) const {
    Vec3 sum = Vec3::Zero();
    forEach([&](std::size_t vertex, double weight) { sum += weight * value(vertex); });
    return sum;
  }

  /// The same for values that are stored one a vertex: the attached point for positions, its velocity for velocities.
  [[nodiscard]] Vec3 interpolatedFrom(const std::vector<Vec3>& values) const {
    return interpolated([&](std::size_t vertex) -> const Vec3& { return values[vertex]; });
  }

  /// `from` minus the value at the attached point, subtracted corner by corner. Rounding differs from that of
  /// `from - interpolated(value)`.
  template <typename Value>
  [[nodiscard]] Vec3 subtracted(Vec3 from, const Value& value) const {
    forEach([&](std::size_t vertex, double weight) { from -= weight * value(vertex); });
    return from;
  }

  /// w_c of that vertex; nothing if it is not a corner.
  [[nodiscard]] std::optional<double> weightOf(std::size_t vertex) const;

  /// The corner nearest to the attached point.
  [[nodiscard]] std::size_t nearestVertex() const;
};

[[nodiscard]] AttachedCorners attachedCorners(const ClothModel& model, const AttachmentEnds& ends);

/// The displacement of the attached point between two states [m].
[[nodiscard]] Vec3 attachedPointMotion(const AttachedCorners& corners, const ClothState& before,
                                       const ClothState& after);

/// Additions of the attachment to the diagonal of a matrix that has one row a vertex.
struct AttachmentDiagonal {
  std::array<std::size_t, 3> vertices{};  ///< the corners of its triangle
  Vec3 additions = Vec3::Zero();          ///< h^2 w_c times its stiffness [kg]
};

/// The force of the attachment at the corners of its triangle. Implicit methods lump the stiffness on the corners.
struct AttachmentForce : AttachedCorners {
  Vec3 force = Vec3::Zero();     ///< on the attached point [N]; corner c gets w_c of it
  Vec3 velocity = Vec3::Zero();  ///< of the attached point [m/s]
  double stiffness = 0.0;        ///< |force| over the distance to the target [N/m]; smaller if the force is bounded

  /// The force when the attached point has moved on for the time h: force - h stiffness velocity [N].
  [[nodiscard]] Vec3 implicitForce(double timeStep) const { return force - timeStep * stiffness * velocity; }

  [[nodiscard]] AttachmentDiagonal diagonal(double timeStep) const {
    return {vertices, timeStep * timeStep * stiffness * weights};
  }
};

/// @param point the attached point [m]  @param velocity of it [m/s]
[[nodiscard]] AttachmentForce attachmentForce(const AttachedCorners& corners, const Attachment& attachment,
                                              const Vec3& point, const Vec3& velocity);
[[nodiscard]] AttachmentForce attachmentForce(const ClothModel& model, const Attachment& attachment,
                                              const ClothState& state);

/// The attachment as XPBD's constraint p - target = 0 of three components, with p the attached point, of compliance one
/// over the attachment's stiffness. Its multiplier is h^2 times the force on p, which is bounded.
class AttachmentConstraint {
 public:
  /// One correction. Returns the displacement of each corner [m].
  /// @param offset target - p [m]  @param inverseMasses of the corners [1/kg]; 0 where pinned
  [[nodiscard]] std::array<Vec3, 3> correct(const AttachmentSpring& spring, const AttachedCorners& corners,
                                            double timeStep, const Vec3& offset, const Vec3& inverseMasses);

 private:
  Vec3 multiplier_ = Vec3::Zero();  // lambda [N s^2], zero when a step begins
};

}  // namespace drape::sim
