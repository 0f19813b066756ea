#pragma once

#include "sim/contact/constraints/constraint_builder.hpp"
#include "sim/contact/recovery/solid.hpp"

namespace drape::sim::contact {

/// Finds contacts and separating planes of a cloth with a plane, a sphere or a capsule in one pass. The closest points
/// have closed forms: on a sphere or a capsule they are those of its segment, moved outwards by the radius.
class PrimitiveSearch {
 public:
  /// @param index of the body in the step  @param friction factor on the friction of the body [-]
  PrimitiveSearch(const BodyStep& step, int index, const ContactOffsets& offsets, double friction = 1.0);

  /// Adds the constraints of triangles begin to end - 1 to `candidates`.
  void search(const ClothInBody& cloth, std::size_t begin, std::size_t end, Candidates& candidates) const;

  /// Signed distance of a position in the body's frame [m]; negative inside.
  [[nodiscard]] double gapAt(const Vec3& position) const;

  /// The sphere or the capsule as a solid, in the body's frame. Requires one of these.
  [[nodiscard]] CapsuleSolid solid() const { return {core_, radius_}; }

 private:
  void addCornerContacts(const ClothInBody& cloth, std::size_t t, const Corners& start, Candidates& candidates) const;

  void searchPlane(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const;
  void searchCapsule(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const;
  void addCapsuleContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Vec3& onCore,
                         double offset, Candidates& candidates) const;

  ConstraintBuilder builder_;
  std::array<Vec3, 2> core_{Vec3::Zero(), Vec3::Zero()};  // segment of a capsule; one point for a sphere [m]
  double radius_ = 0.0;                                   // [m]
  bool plane_ = false;                                    // the body is a plane
};

}  // namespace drape::sim::contact
