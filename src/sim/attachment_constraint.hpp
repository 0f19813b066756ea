#pragma once

#include "sim/step_parameters.hpp"

#include <algorithm>
#include <limits>

namespace drape {

/// The attachment as XPBD's constraint p - target = 0 of three components, with p the attached point, of compliance one
/// over the attachment's stiffness. Its multiplier is h^2 times the force on p, which is bounded.
class AttachmentConstraint {
 public:
  /// One correction. Corner c of the triangle is to move by its weight and inverse mass times what is returned [kg m].
  /// @param offset target - p [m]  @param inverseMass of p, the sum of w_c^2 / m_c [1/kg]
  [[nodiscard]] Vec3 correct(const Attachment& attachment, double timeStep, const Vec3& offset, double inverseMass) {
    const double h = timeStep;
    const double inverseCompliance = h * h * attachment.stiffness;
    Vec3 next = multiplier_ + (inverseCompliance * offset - multiplier_) / (inverseCompliance * inverseMass + 1.0);
    const double maxImpulse = h * h * attachment.maxForce;
    next *= std::min(1.0, maxImpulse / std::max(next.norm(), std::numeric_limits<double>::min()));
    Vec3 change = next - multiplier_;
    multiplier_ = next;
    return change;
  }

 private:
  Vec3 multiplier_ = Vec3::Zero();  // lambda [N s^2], zero when a step begins
};

}  // namespace drape
