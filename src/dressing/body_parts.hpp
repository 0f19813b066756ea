#pragma once

#include "dressing/shrinking_body.hpp"

#include <optional>
#include <vector>

namespace drape::dressing {

/// A part of a body that stands upright. Left is the person's left.
enum class BodyPart { Whole, Head, Trunk, LeftArm, RightArm, LeftLeg, RightLeg };

/// What a garment is placed by.
struct BodyLandmarks {
  Vec3 neck = Vec3::Zero();   ///< the middle of the neck where it meets the shoulders [m]
  Vec3 waist = Vec3::Zero();  ///< the middle of the trunk where it is narrowest [m]
  double top = 0.0;           ///< height of the top of the head [m]
};

/// The parts of a body, from its shape. A person has two thin limbs beside the trunk.
class BodyParts {
 public:
  explicit BodyParts(const ShrinkingBody& body);

  /// Whether the body was recognised as a person. If not, every vertex belongs to BodyPart::Whole.
  [[nodiscard]] bool isPerson() const { return landmarks_.has_value(); }
  [[nodiscard]] const std::optional<BodyLandmarks>& landmarks() const { return landmarks_; }
  [[nodiscard]] BodyPart ofVertex(int vertex) const { return parts_[vertex]; }
  [[nodiscard]] BodyPart ofTriangle(const Triangle& triangle) const;
  /// Whether it looks along -z, by its feet. Otherwise along +z.
  [[nodiscard]] bool facesBack() const { return facesBack_; }

 private:
  std::vector<BodyPart> parts_;
  std::optional<BodyLandmarks> landmarks_;
  bool facesBack_ = false;
};

}  // namespace drape::dressing
