#include "sim/forces/attachment.hpp"

#include "sim/model/cloth_model.hpp"
#include "sim/model/cloth_state.hpp"

#include <algorithm>
#include <limits>

namespace drape::sim {
namespace {

/// A vector shortened to at most that length.
Vec3 shortened(const Vec3& vector, double maxLength) {
  return vector * std::min(1.0, maxLength / std::max(vector.norm(), std::numeric_limits<double>::min()));
}

}  // namespace

Vec3 AttachmentSpring::force(const Vec3& offset) const {
  const double distance = offset.norm();
  return isSaturated(distance) ? Vec3(offset * (stiffness * maxForce / (stiffness * distance)))
                               : Vec3(stiffness * offset);
}

double AttachmentSpring::secantStiffness(const Vec3& offset) const {
  const double distance = offset.norm();
  return distance > 0.0 ? force(offset).norm() / distance : stiffness;
}

Mat3 AttachmentSpring::forceDerivative(const Vec3& offset) const {
  const double distance = offset.norm();
  if (!isSaturated(distance)) {
    return stiffness * Mat3::Identity();
  }
  const Vec3 direction = offset / distance;
  return (maxForce / distance) * (Mat3::Identity() - direction * direction.transpose());
}

double AttachmentSpring::energy(double distance) const {
  if (!isSaturated(distance)) {
    return 0.5 * stiffness * distance * distance;
  }
  const double linearFrom = maxForce / stiffness;  // distance at which the bound begins [m]
  return maxForce * (distance - 0.5 * linearFrom);
}

Vec3 AttachmentSpring::implicitImpulse(double timeStep, const Vec3& offset, double inverseMass) const {
  const double h = timeStep;
  return shortened((h * stiffness / (1.0 + 0.5 * h * h * stiffness * inverseMass)) * offset, h * maxForce);
}

std::optional<double> AttachedCorners::weightOf(std::size_t vertex) const {
  const auto found = std::find(vertices.begin(), vertices.end(), vertex);
  return found == vertices.end() ? std::nullopt : std::optional(weights[found - vertices.begin()]);
}

std::size_t AttachedCorners::nearestVertex() const {
  Eigen::Index heaviest = 0;
  weights.maxCoeff(&heaviest);
  return vertices[static_cast<std::size_t>(heaviest)];
}

AttachedCorners attachedCorners(const ClothModel& model, const AttachmentEnds& ends) {
  AttachedCorners corners;
  corners.weights = ends.barycentric;
  const Triangle& triangle = model.triangles[static_cast<std::size_t>(ends.triangle)];
  std::transform(triangle.begin(), triangle.end(), corners.vertices.begin(),
                 [](int vertex) { return static_cast<std::size_t>(vertex); });
  return corners;
}

Vec3 attachedPointMotion(const AttachedCorners& corners, const ClothState& before, const ClothState& after) {
  return corners.interpolated([&](std::size_t v) { return Vec3(after.positions[v] - before.positions[v]); });
}

AttachmentForce attachmentForce(const AttachedCorners& corners, const Attachment& attachment, const Vec3& point,
                                const Vec3& velocity) {
  const Vec3 offset = attachment.target - point;
  return {corners, attachment.force(offset), velocity, attachment.secantStiffness(offset)};
}

AttachmentForce attachmentForce(const ClothModel& model, const Attachment& attachment, const ClothState& state) {
  const AttachedCorners corners = attachedCorners(model, attachment);
  return attachmentForce(corners, attachment, corners.interpolatedFrom(state.positions),
                         corners.interpolatedFrom(state.velocities));
}

std::array<Vec3, 3> AttachmentConstraint::correct(const AttachmentSpring& spring, const AttachedCorners& corners,
                                                  double timeStep, const Vec3& offset, const Vec3& inverseMasses) {
  const double h = timeStep;
  const double inverseCompliance = h * h * spring.stiffness;
  double inverseMass = 0.0;  // of the attached point [1/kg]
  for (Eigen::Index c = 0; c < 3; ++c) {
    inverseMass += corners.weights[c] * corners.weights[c] * inverseMasses[c];
  }
  const Vec3 next =
      shortened(multiplier_ + (inverseCompliance * offset - multiplier_) / (inverseCompliance * inverseMass + 1.0),
                h * h * spring.maxForce);
  const Vec3 change = next - multiplier_;
  multiplier_ = next;
  std::array<Vec3, 3> moves;
  for (Eigen::Index c = 0; c < 3; ++c) {
    moves[static_cast<std::size_t>(c)] = (corners.weights[c] * inverseMasses[c]) * change;
  }
  return moves;
}

}  // namespace drape::sim
