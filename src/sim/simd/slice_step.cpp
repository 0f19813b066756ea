#include "sim/simd/slice_step.hpp"

#include "sim/simd/lane_vector.hpp"

#include <algorithm>

namespace drape::sim::simd {
namespace {

/// The vector of a vertex of the model.
template <typename T>
Vec3 vectorAt(const SlicedCloth<T>& cloth, const LaneVectors<T>& vectors, std::size_t vertex) {
  return laneVector(vectors, cloth.layout.indexOf[vertex]);
}

}  // namespace

template <typename T>
SliceStep<T> sliceStepOf(const CommonParameters& parameters, const JacobiOptions& jacobi) {
  SliceStep<T> step;
  step.timeStep = static_cast<T>(parameters.timeStep);
  step.stiffness = static_cast<T>(parameters.material.stiffness);
  step.damping = static_cast<T>(parameters.material.damping);
  step.gravity = static_cast<T>(parameters.gravity);
  step.drag = static_cast<T>(0.5 * parameters.air.density * parameters.air.drag);
  step.lift = static_cast<T>(0.5 * parameters.air.density * parameters.air.lift);
  step.edgeDrag = static_cast<T>(0.5 * parameters.air.density * std::min(parameters.air.edgeDrag, parameters.air.drag));
  step.airModel = parameters.air.model;
  step.windX = static_cast<T>(parameters.air.wind.x());
  step.windY = static_cast<T>(parameters.air.wind.y());
  step.windZ = static_cast<T>(parameters.air.wind.z());
  step.relaxation = static_cast<T>(jacobi.relaxation);
  step.derivative = parameters.derivative;
  step.sweeps = jacobi.sweeps;
  return step;
}

template <typename T>
void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<T>& cloth,
                   SliceStep<T>& step) {
  const AttachedCorners corners = attachedCorners(model, attachment);
  const Vec3 point =
      corners.interpolated([&](std::size_t v) { return Vec3(cloth.origin + vectorAt(cloth, cloth.position, v)); });
  const Vec3 velocity = corners.interpolated([&](std::size_t v) { return vectorAt(cloth, cloth.velocity, v); });
  const AttachmentForce pull = attachmentForce(corners, attachment, point, velocity);
  const Vec3 force = pull.implicitForce(static_cast<double>(step.timeStep));
  auto lanes = step.attachedCorners.begin();
  corners.forEach([&](std::size_t vertex, double weight) {
    const int index = cloth.layout.indexOf[vertex];
    *lanes++ = {.slice = index / sliceLanes,
                .lane = index % sliceLanes,
                .forceX = static_cast<T>(weight * force.x()),
                .forceY = static_cast<T>(weight * force.y()),
                .forceZ = static_cast<T>(weight * force.z()),
                .stiffness = static_cast<T>(weight * pull.stiffness)};
  });
}

template <typename T>
void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                            SlicedCloth<T>& cloth) {
  const double h = timeStep;
  const AttachedCorners corners = attachedCorners(model, attachment);
  const auto velocityOf = [&](std::size_t v) { return vectorAt(cloth, cloth.velocity, v); };
  const auto shareOf = [&](std::size_t v, double weight) {  // w_c / m_c [1/kg]
    return model.pinned[v] ? 0.0 : weight / model.vertexMass[v];
  };
  const Vec3 offset = corners.subtracted(attachment.target, [&](std::size_t v) {
    return Vec3(cloth.origin + vectorAt(cloth, cloth.position, v) + 0.5 * h * velocityOf(v));
  });
  double inverseMass = 0.0;
  corners.forEach([&](std::size_t v, double weight) { inverseMass += weight * shareOf(v, weight); });
  const Vec3 impulse = attachment.implicitImpulse(h, offset, inverseMass);
  corners.forEach([&](std::size_t v, double weight) {
    setLaneVector(cloth.velocity, cloth.layout.indexOf[v], Vec3(velocityOf(v) + shareOf(v, weight) * impulse));
  });
}

template void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                                     SlicedCloth<float>& cloth);
template void applyAttachmentImpulse(const ClothModel& model, double timeStep, const Attachment& attachment,
                                     SlicedCloth<double>& cloth);
template SliceStep<float> sliceStepOf(const CommonParameters& parameters, const JacobiOptions& jacobi);
template SliceStep<double> sliceStepOf(const CommonParameters& parameters, const JacobiOptions& jacobi);
template void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<float>& cloth,
                            SliceStep<float>& step);
template void setAttachment(const ClothModel& model, const Attachment& attachment, const SlicedCloth<double>& cloth,
                            SliceStep<double>& step);

}  // namespace drape::sim::simd
