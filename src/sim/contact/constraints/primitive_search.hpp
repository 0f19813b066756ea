#pragma once

#include "sim/contact/constraints/constraint_builder.hpp"
#include "sim/contact/recovery/solid.hpp"

namespace drape {

/// Looks for what is near a plane, a sphere or a capsule in one step: for every triangle a plane between it and the
/// body, and where vertices, edges and triangles are about to come nearer than they may.
class PrimitiveSearch {
 public:
  /// @param index of the body among the step's
  PrimitiveSearch(const BodyStep& step, int index, const ContactOffsets& offsets);

  /// Looks at the triangles from begin to end - 1 and adds to `candidates`.
  void search(const ClothInBody& cloth, std::size_t begin, std::size_t end, Candidates& candidates) const;

  /// From a place in the body's frame to the body [m]; negative inside.
  [[nodiscard]] double gapAt(const Vec3& position) const;

  /// Of a sphere or a capsule.
  [[nodiscard]] CapsuleSolid solid() const { return {core_, radius_}; }

 private:
  void addCornerContacts(const ClothInBody& cloth, std::size_t t, const Corners& start, Candidates& candidates) const;

  void searchPlane(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const;
  void searchCapsule(const ClothInBody& cloth, std::size_t t, Candidates& candidates) const;
  void addCapsuleContact(const ClothInBody& cloth, std::size_t t, const Vec3& weights, const Vec3& onCore, double offset,
                         Candidates& candidates) const;

  ConstraintBuilder builder_;
  std::array<Vec3, 2> core_{Vec3::Zero(), Vec3::Zero()};  // of a sphere or a capsule
  double radius_ = 0.0;
  bool plane_ = false;
};

}  // namespace drape
