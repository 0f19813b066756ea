#pragma once

#include "dressing/body_parts.hpp"
#include "dressing/garment_openings.hpp"

#include <array>
#include <span>
#include <vector>

namespace drape::dressing {

/// Turns the arms of a thin body about the shoulders towards the openings of sleeves, so that a garment with steep
/// sleeves takes arms that are held higher. Under a cape or a poncho, which has a neck and no sleeves, they hang.
class ArmBend {
 public:
  /// @param body a person
  ArmBend(const ShrinkingBody& body, const BodyParts& parts);

  /// Aims the arms at the openings of the sleeves, or downwards under a cape. Otherwise they stay as they are.
  /// @param positions of the garment [m]
  void aim(const GarmentOpenings& openings, std::span<const Vec3> positions);

  /// A frame of the body with turned arms. The full body is never turned, the centre lines and thinner ones fully.
  [[nodiscard]] std::vector<Vec3> bent(std::size_t frame) const;

  /// A frame whose limbs have nearly their full length, with fully turned arms: for tests of openings.
  [[nodiscard]] std::vector<Vec3> withFullLength() const;

  /// The body whose frames are all bent.
  [[nodiscard]] ShrinkingBody bentBody() const;

 private:
  struct Arm {
    BodyPart part = BodyPart::LeftArm;
    OpeningKind sleeve = OpeningKind::LeftSleeve;
    Vec3 shoulder = Vec3::Zero();  // [m]
    Eigen::AngleAxisd turn = Eigen::AngleAxisd::Identity();
  };
  void findShoulder(Arm& arm) const;
  [[nodiscard]] std::vector<Vec3> turned(std::size_t frame, double share) const;
  [[nodiscard]] Vec3 pointOfArm(const Arm& arm, double fromShoulder) const;

  const ShrinkingBody& body_;
  const BodyParts& parts_;
  std::array<Arm, 2> arms_;
  std::vector<Vec3> weights_;  // of the two arms, 0 to 1, a vertex
};

}  // namespace drape::dressing
